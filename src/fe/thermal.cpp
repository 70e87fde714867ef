// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/thermal.hpp"

#include "fe/thermal_kernel.hpp"

#include <Eigen/Cholesky>

namespace spricka::fe {

namespace {

// The field of one load at the corners of an element.
template <shape::ElementShape S>
CornerValues<S> project(const NodeVectors<S>& X, const Law& law, const base::Expression& field) {
  Eigen::Matrix<double, corners<S>(), corners<S>()> G;
  G.setZero();
  CornerValues<S> right = CornerValues<S>::Zero();
  double volume = 0.0;
  double total = 0.0;
  for (const auto& point : stiffness_rule<S>(law)) {
    const Jacobian<S> at = jacobian<S>(X, point.r);
    base::Vec3 x = base::Vec3::Zero();
    x.template head<S::dim>() = X * S::N(point.r);
    const double w = point.weight * at.det * law.depth(x.x());
    const CornerValues<S> N = Linear<S>::N(point.r);
    const double T = field(x);
    G.noalias() += (w * N) * N.transpose();
    right += (w * T) * N;
    volume += w;
    total += w * T;
  }
  if constexpr (!base::info(S::type).quadratic) {
    return CornerValues<S>::Constant(total / volume);
  } else {
    return G.ldlt().solve(right);
  }
}

// Consistent forces of an element's temperatures.
template <shape::ElementShape S>
NodeVectors<S> element_load(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T) {
  const ThermalStress<S> stress(X, law, T);
  NodeVectors<S> F = NodeVectors<S>::Zero();
  for (const auto& point : stiffness_rule<S>(law)) {
    const Jacobian<S> at = jacobian<S>(X, point.r);
    const Hoop<S> hoop(X, law, point.r);
    const double w = point.weight * at.det * law.depth(hoop.x) * stress.at(point.r);
    F.noalias() += w * at.dNdx.transpose();
    F.row(0) += w * hoop.h.transpose();
  }
  return F;
}

// Energy of an element whose thermal strain is held back altogether.
template <shape::ElementShape S>
double held_energy(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T) {
  const ThermalStress<S> stress(X, law, T);
  const double directions = law.heated_directions();
  double energy = 0.0;
  for (const auto& point : stiffness_rule<S>(law)) {
    const Jacobian<S> at = jacobian<S>(X, point.r);
    const Hoop<S> hoop(X, law, point.r);
    const double t = law.expansion * stress.temperature(point.r);
    const double v = law.expansion * directions * stress.of_volume(point.r);
    energy += 0.5 * point.weight * at.det * law.depth(hoop.x) *
              (law.lambda * v * v + 2.0 * law.mu * directions * t * t);
  }
  return energy;
}

// Calls use(S{}, e, T) with the corner temperatures of each element that is heated.
template <class Use>
void for_heated(const model::Mesh& mesh, const base::Vector& temperature, Use&& use) {
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    shape::with_shape(mesh.type[i], [&]<shape::ElementShape S>(S shape) {
      const CornerValues<S> T = corner_temperature<S>(mesh, e, temperature);
      if ((T.array() != 0.0).any()) {
        use(shape, e, T);
      }
    });
  }
}

} // namespace

base::Vector element_temperature(const model::Model& model, const model::Mesh& mesh,
                                 const model::LoadCase& load_case) {
  base::Vector temperature;
  for (const model::Load& load : load_case.loads) {
    if (load.type != model::LoadType::temperature) {
      continue;
    }
    if (temperature.size() == 0) {
      temperature = base::Vector::Zero(static_cast<Eigen::Index>(mesh.nodes.size()));
    }
    for_blocks(mesh, mesh.set(load.elements).elements,
               [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                 for (const base::ElementId e : block) {
                   temperature.segment<corners<S>()>(mesh.first[e.index()]) += project<S>(
                       coordinates<S>(mesh, e), law_of(model, mesh, e), load.value.front());
                 }
               });
  }
  return temperature;
}

base::Vector thermal_load(const model::Model& model, const model::Mesh& mesh,
                          const base::Vector& temperature) {
  base::Vector f = base::Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  for_heated(mesh, temperature, [&]<shape::ElementShape S>(S, base::ElementId e, const auto& T) {
    const NodeVectors<S> F = element_load<S>(coordinates<S>(mesh, e), law_of(model, mesh, e), T);
    Eigen::Index i = 0;
    for (const base::NodeId n : mesh.nodes_of(e)) {
      f.segment<S::dim>(S::dim * static_cast<Eigen::Index>(n.index())) += F.col(i++);
    }
  });
  return f;
}

double thermal_energy(const model::Model& model, const model::Mesh& mesh,
                      const base::Vector& temperature) {
  double energy = 0.0;
  for_heated(mesh, temperature, [&]<shape::ElementShape S>(S, base::ElementId e, const auto& T) {
    energy += held_energy<S>(coordinates<S>(mesh, e), law_of(model, mesh, e), T);
  });
  return energy;
}

void add_thermal_energy(const model::Model& model, const model::Mesh& mesh,
                        const base::Vector& temperature, const base::Vector& u,
                        std::vector<double>& energy) {
  for_heated(mesh, temperature, [&]<shape::ElementShape S>(S, base::ElementId e, const auto& T) {
    const NodeVectors<S> X = coordinates<S>(mesh, e);
    const Law law = law_of(model, mesh, e);
    energy[e.index()] += held_energy<S>(X, law, T) -
                         element_load<S>(X, law, T).cwiseProduct(gather<S>(mesh, e, u)).sum();
  });
}

} // namespace spricka::fe
