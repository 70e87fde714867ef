// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/thermal.hpp"

#include "fe/load_points.hpp"
#include "fe/load_rule.hpp"
#include "fe/thermal_kernel.hpp"
#include "model/loads.hpp"

namespace spricka::fe {

namespace {

// Energy of an element whose thermal strain is held back altogether.
template <shape::ElementShape S>
double held_energy(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T) {
  if constexpr (plane_quadratic<S>) {
    if (FreeExpansion<S>::wanted(X, law)) {
      const NodeVectors<S> U = FreeExpansion<S>(X, law, T).at_nodes(X);
      return 0.5 * element_force<S>(X, law, U).cwiseProduct(U).sum();
    }
  }
  const ThermalStress<S> stress(X, law, T);
  const double directions = law.heated_directions();
  // (fe.27).
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

// A temperature as an element takes it, by the usual points where they do it justice.
template <shape::ElementShape S>
CornerValues<S> taken_by(const NodeVectors<S>& X, const Law& law, const model::Load& load,
                         const FieldScale& scale, Unresolved* missed) {
  const Temperature<S> field = [&](const Eigen::Matrix<double, S::dim, 1>& x) {
    base::Vec3 at = base::Vec3::Zero();
    at.template head<S::dim>() = x;
    return load.value.front()(at);
  };
  const auto& usual = stiffness_rule<S>(law);
  // Elements that bear the rest at points of their own need no better linear part here (heat.cpp).
  if (is_constant(load) || takes_rest(law, S::type)) {
    return project_temperature<S>(X, law, usual, field);
  }
  const AdaptedRule<S::dim> rule = body_load_rule<S>(X, load, scale);
  if (missed != nullptr) {
    const auto centre = unit_cube_point<S>({0.5, 0.5, 0.5}).r;
    missed->add(rule.missed, rule.amount,
                law.depth((X * S::N(centre))[0]) * jacobian<S>(X, centre).det);
  }
  // A rule that was not divided tells that the usual points do.
  return rule.points.size() == shape::quadrature<S>(load_degree).size()
             ? project_temperature<S>(X, law, usual, field)
             : project_temperature<S>(X, law, rule.points, field);
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

bool takes_rest(const Law& law, base::ElementType type) {
  return base::info(type).dim == 2 && base::info(type).quadratic && !law.axisymmetric &&
         !law.projected;
}

base::Vector element_temperature(const model::Model& model, const model::Mesh& mesh,
                                 const model::LoadCase& load_case, Unresolved* missed) {
  base::Vector temperature;
  for (const model::Load& load : load_case.loads) {
    if (load.type != model::LoadType::temperature) {
      continue;
    }
    if (temperature.size() == 0) {
      temperature = base::Vector::Zero(static_cast<Eigen::Index>(mesh.nodes.size()));
    }
    const std::vector<base::ElementId>& elements = mesh.set(load.elements).elements;
    const FieldScale scale = load_scale(mesh, load, elements);
    for_blocks(
        mesh, elements, [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
          for (const base::ElementId e : block) {
            temperature.segment<corners<S>()>(mesh.first[e.index()]) +=
                taken_by<S>(coordinates<S>(mesh, e), law_of(model, mesh, e), load, scale, missed);
          }
        });
  }
  return temperature;
}

base::Vector thermal_load(const model::Model& model, const model::Mesh& mesh,
                          const base::Vector& temperature) {
  base::Vector f = base::Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  for_heated(mesh, temperature, [&]<shape::ElementShape S>(S, base::ElementId e, const auto& T) {
    const NodeVectors<S> F = thermal_forces<S>(coordinates<S>(mesh, e), law_of(model, mesh, e), T);
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
    // 1/2 (eps - eps_T) D (eps - eps_T) = 1/2 u K u - u f + 1/2 eps_T D eps_T (fe.27).
    energy[e.index()] += held_energy<S>(X, law, T) -
                         thermal_forces<S>(X, law, T).cwiseProduct(gather<S>(mesh, e, u)).sum();
  });
}

} // namespace spricka::fe
