// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/heat.hpp"

#include "base/by_dimension.hpp"
#include "fe/corner_rule.hpp"
#include "fe/load_points.hpp"
#include "fe/load_rule.hpp"
#include "fe/thermal.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::fe {

namespace {

using base::ElementId;
using base::Vec2;

// A rest below this part of the largest temperature is round-off of the linear part.
constexpr double heat_round_off = 1e-9;

/// An element that has a rest.
struct RestElement {
  ElementId e;
  const AnyElement<2>& shape;
  AnyNodeVectors<2> X;
  ConstitutiveLaw law;
  std::span<const ResidualTemperaturePoint> points;
};

// Calls use(element) for all elements that have a rest.
template <class Use>
void for_rest(const model::Model& model, const model::Mesh& mesh, const CaseTemperature& heat,
              Use&& use) {
  for (std::size_t i = 0; i < mesh.element_count() && !heat.first.empty(); ++i) {
    const ElementId e(i);
    const std::span<const ResidualTemperaturePoint> points = heat.residual_points_in_element(e);
    if (points.empty()) {
      continue;
    }
    const AnyElement<2>& shape = shape::reference_element<2>(mesh.type[i]);
    use(RestElement{e, shape, element_coordinates(shape, mesh, e), constitutive_law(model, mesh, e),
                    points});
  }
}

void add_points(const model::Model& model, const PatchedMesh& patched, const FieldMagnitude& scale,
                CaseTemperature& heat, UnresolvedLoad* missed) {
  const model::Mesh& mesh = patched.mesh;
  heat.first.assign(1, 0);
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const ElementId e(i);
    const ConstitutiveLaw law = constitutive_law(model, mesh, e);
    if (has_residual_temperature(law, mesh.dim, base::element_info(mesh.type[i]).quadratic) &&
        heat.field.may_vary_inside(e)) {
      const AnyElement<2>& element = shape::reference_element<2>(mesh.type[i]);
      const AnyNodeVectors<2> X = element_coordinates(element, mesh, e);
      SampledTemperature sampled = sample_temperature(
          element, X, heat.field, e, scale, find_tip_corner(mesh, e, patched.front_nodes));
      std::vector<ResidualTemperaturePoint>& points = sampled.points;
      if (missed != nullptr) {
        missed->add(sampled.missed, sampled.amount, law.thickness);
      }
      if (sampled.discontinuous) {
        heat.discontinuous.resize(mesh.element_count(), false);
        heat.discontinuous[i] = true;
      }
      std::vector<WeightedTemperature<2>> samples;
      samples.reserve(points.size());
      for (const ResidualTemperaturePoint& p : points) {
        samples.push_back({p.r, p.area, p.T});
      }
      const CornerValues<2> T = project_temperature<2>(element, X, law, samples);
      double most = 0.0;
      for (ResidualTemperaturePoint& p : points) {
        // From here on points hold the rest, T - T_e of (fe.39).
        p.T -= projected_temperature(element, X, law, T, p.r);
        most = std::max(most, std::abs(p.T));
      }
      // Elsewhere the element keeps what corner_temperatures_of_case found, and has no points.
      if (most > heat_round_off * scale.largest) {
        heat.temperature.segment(mesh.first[i], element.corners) = T;
        heat.points.insert(heat.points.end(), points.begin(), points.end());
      }
    }
    heat.first.push_back(heat.points.size());
  }
  if (heat.points.empty()) {
    heat.first.clear();
  }
}

} // namespace

double projected_temperature(const AnyElement<2>& element, const AnyNodeVectors<2>& X,
                             const ConstitutiveLaw& law, const CornerValues<2>& T,
                             const shape::Point<2>& r) {
  if (FreeExpansion::must_remove_beforehand(element, X, law)) {
    return FreeExpansion(element, X, law, T).temperature(X * element.N(r));
  }
  return T.dot(element.linear_element().N(r));
}

double unresolved_temperature_fraction(const model::Model& model, const model::Mesh& mesh,
                                       const model::Load& load) {
  UnresolvedLoad missed;
  if (!is_constant(load)) {
    const model::LoadCase alone{"", {load}};
    make_case_temperature(model, {mesh, mesh, nullptr, {}}, alone, &missed);
  }
  return missed.missed_fraction();
}

CaseTemperature make_case_temperature(const model::Model& model, const PatchedMesh& patched,
                                      const model::LoadCase& load_case, UnresolvedLoad* missed) {
  CaseTemperature heat;
  // In the plane points of their own tell whether a temperature jumps.
  const base::ByDimension<std::vector<bool>*> jumps{nullptr, &heat.discontinuous};
  heat.temperature = corner_temperatures_of_case(model, patched.mesh, load_case, missed,
                                                 jumps.at(patched.mesh.dim));
  if (heat.temperature.size() == 0) {
    return heat;
  }
  heat.field = TemperatureField(patched, load_case);
  // Loads of a case add up in an element, and so do the sizes that they are measured by.
  FieldMagnitude scale;
  for (const model::Load& load : load_case.loads) {
    if (load.type == model::LoadType::temperature) {
      const FieldMagnitude own =
          load_scale(patched.mesh, load, patched.mesh.set_with_id(load.elements).elements);
      scale.largest += own.largest;
      scale.mean += own.mean;
    }
  }
  add_points(model, patched, scale, heat, missed);
  return heat;
}

void add_residual_temperature_load(const model::Model& model, const model::Mesh& mesh,
                                   const ScaledTemperature& acting, base::MaterialId only,
                                   base::Vector& f) {
  for_rest(model, mesh, *acting.heat, [&](const RestElement& own) {
    if (only.valid() && model.element_property(mesh, own.e).material != only) {
      return;
    }
    AnyNodeVectors<2> F = AnyNodeVectors<2>::Zero(2, own.shape.nodes);
    // (fe.39).
    const double beta = acting.factor * own.law.thickness * thermal_modulus(own.law);
    for (const ResidualTemperaturePoint& p : own.points) {
      F += (beta * p.area * p.T) * jacobian(own.shape, own.X, p.r).dNdx.transpose();
    }
    add_at_nodes(mesh, own.e, F, f);
  });
}

// 1/2 (alpha T)^T D (alpha T) is half of alpha beta T^2 in each heated direction. Of two cases each
// has its own points, where the other one's rest is what its field leaves.
void add_residual_temperature_energy(const model::Model& model, const model::Mesh& mesh,
                                     std::span<const ScaledTemperature> acting,
                                     const base::Vector& u, std::vector<double>& energy) {
  for (const ScaledTemperature& one : acting) {
    for_rest(model, mesh, *one.heat, [&](const RestElement& own) {
      const AnyNodeVectors<2> U = gather_element_values(own.shape, mesh, own.e, u);
      const double beta = one.factor * own.law.thickness * thermal_modulus(own.law);
      const double square = 0.5 * own.law.expansion * own.law.heated_direction_count();
      for (const ResidualTemperaturePoint& p : own.points) {
        const Vec2 x = own.X * own.shape.N(p.r);
        double all = 0.0;
        for (const ScaledTemperature& other : acting) {
          if (!other.heat->residual_points_in_element(own.e).empty()) {
            const CornerValues<2> T =
                gather_corner_temperatures(own.shape, mesh, own.e, other.heat->temperature);
            all += other.factor * (other.heat->field(own.e, x) -
                                   projected_temperature(own.shape, own.X, own.law, T, p.r));
          }
        }
        const double div =
            Eigen::Matrix2d(U.lazyProduct(jacobian(own.shape, own.X, p.r).dNdx)).trace();
        energy[own.e.index()] += beta * p.area * p.T * (square * all - div);
      }
    });
  }
}

} // namespace spricka::fe
