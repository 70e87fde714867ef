// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/thermal.hpp"

#include "fe/load_points.hpp"
#include "fe/load_rule.hpp"
#include "fe/thermal_kernel.hpp"
#include "model/loads.hpp"

namespace spricka::fe {

namespace {

// Energy of an element whose thermal strain is held back altogether.
template <int dim>
double held_energy(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                   const ConstitutiveLaw& law, const CornerValues<dim>& T) {
  if (const auto U = free_expansion_displacements(element, X, law, T)) {
    return 0.5 * element_force(element, X, law, *U).cwiseProduct(*U).sum();
  }
  const ThermalStress<dim> stress(element, X, law, T);
  const double directions = law.heated_direction_count();
  // (fe.27).
  double energy = 0.0;
  for (const auto& point : stiffness_rule(element, law)) {
    const auto at = jacobian(element, X, point.r);
    const HoopStrain<AnyElement<dim>> hoop(element, X, law, point.r);
    const double t = law.expansion * stress.temperature(point.r);
    const double v = law.expansion * directions * stress.volumetric_temperature(point.r);
    energy += 0.5 * point.weight * at.det * law.depth(hoop.x) *
              (law.lambda * v * v + 2.0 * law.mu * directions * t * t);
  }
  return energy;
}

/// What the rules of a temperature tell of it.
struct RuleNews {
  UnresolvedLoad missed;
  bool jumps = false; ///< inside the last element
};

// A temperature as an element takes it, by the usual points where they do it justice.
template <int dim>
CornerValues<dim> taken_by(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                           const ConstitutiveLaw& law, const model::Load& load,
                           const FieldMagnitude& scale, RuleNews& news) {
  const auto nearest_by = [&](std::span<const shape::QuadraturePoint<dim>> rule) {
    std::vector<WeightedTemperature<dim>> samples;
    for (const auto& point : rule) {
      base::Vec3 x = base::Vec3::Zero();
      x.template head<dim>() = X * element.N(point.r);
      const double w = point.weight * jacobian(element, X, point.r).det * law.depth(x[0]);
      samples.push_back({point.r, w, load.value.front()(x)});
    }
    return project_temperature<dim>(element, X, law, samples);
  };
  const auto usual = stiffness_rule(element, law);
  // Elements that bear the rest at points of their own need no better linear part here (heat.cpp).
  if (is_constant(load) || has_residual_temperature(law, dim, element.quadratic)) {
    return nearest_by(usual);
  }
  const FieldAdaptedRule<dim> rule = body_load_rule<dim>(element, X, load, scale);
  const auto centre = map_from_unit_cube<dim>(element.domain, {0.5, 0.5, 0.5}).r;
  news.missed.add(rule.missed, rule.amount,
                  law.depth(X.row(0) * element.N(centre)) * jacobian(element, X, centre).det);
  news.jumps = rule.jumps;
  // A rule that was not divided tells that the usual points do.
  const std::size_t undivided = shape::quadrature<dim>(element.domain, load_degree).size();
  return nearest_by(rule.points.size() == undivided ? usual : std::span(rule.points));
}

// Calls use(element, e, T) with the corner temperatures of each element that is heated.
template <class Use>
void for_heated(const model::Mesh& mesh, const base::Vector& temperature, Use&& use) {
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    with_any_element(mesh, e, [&]<int dim>(const AnyElement<dim>& element) {
      const CornerValues<dim> T = gather_corner_temperatures(element, mesh, e, temperature);
      if ((T.array() != 0.0).any()) {
        use(element, e, T);
      }
    });
  }
}

} // namespace

bool has_residual_temperature(const ConstitutiveLaw& law, int dim, bool quadratic) {
  return dim == 2 && quadratic && !law.axisymmetric && !law.projected;
}

base::Vector corner_temperatures_of_case(const model::Model& model, const model::Mesh& mesh,
                                         const model::LoadCase& load_case, UnresolvedLoad* missed,
                                         std::vector<bool>* jumps) {
  base::Vector temperature;
  RuleNews news;
  for (const model::Load& load : load_case.loads) {
    if (load.type != model::LoadType::temperature) {
      continue;
    }
    if (temperature.size() == 0) {
      temperature = base::Vector::Zero(static_cast<Eigen::Index>(mesh.nodes.size()));
    }
    const std::vector<base::ElementId>& elements = mesh.set_with_id(load.elements).elements;
    const FieldMagnitude scale = load_scale(mesh, load, elements);
    for (const base::ElementId e : elements) {
      with_any_element(mesh, e, [&]<int dim>(const AnyElement<dim>& element) {
        temperature.segment(mesh.first[e.index()], element.corners) +=
            taken_by<dim>(element, element_coordinates(element, mesh, e),
                          constitutive_law(model, mesh, e), load, scale, news);
      });
      if (news.jumps && jumps != nullptr) {
        jumps->resize(mesh.element_count(), false);
        (*jumps)[e.index()] = true;
      }
      news.jumps = false;
    }
  }
  if (missed != nullptr) {
    missed->add(news.missed.missed, news.missed.amount, 1.0);
  }
  return temperature;
}

base::Vector thermal_load(const model::Model& model, const model::Mesh& mesh,
                          const base::Vector& temperature) {
  base::Vector f = base::Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  for_heated(
      mesh, temperature,
      [&]<int dim>(const AnyElement<dim>& element, base::ElementId e, const CornerValues<dim>& T) {
        add_at_nodes(mesh, e,
                     thermal_forces<dim>(element, element_coordinates(element, mesh, e),
                                         constitutive_law(model, mesh, e), T),
                     f);
      });
  return f;
}

void add_thermal_energy(const model::Model& model, const model::Mesh& mesh,
                        const base::Vector& temperature, const base::Vector& u,
                        std::vector<double>& energy) {
  for_heated(
      mesh, temperature,
      [&]<int dim>(const AnyElement<dim>& element, base::ElementId e, const CornerValues<dim>& T) {
        const AnyNodeVectors<dim> X = element_coordinates(element, mesh, e);
        const ConstitutiveLaw law = constitutive_law(model, mesh, e);
        // 1/2 (eps - eps_T) D (eps - eps_T) = 1/2 u K u - u f + 1/2 eps_T D eps_T (fe.27).
        energy[e.index()] += held_energy<dim>(element, X, law, T) -
                             thermal_forces<dim>(element, X, law, T)
                                 .cwiseProduct(gather_element_values(element, mesh, e, u))
                                 .sum();
      });
}

} // namespace spricka::fe
