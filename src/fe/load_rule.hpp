// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"
#include "fe/adaptive_rule.hpp"
#include "fe/element.hpp"
#include "model/forward.hpp"
#include "model/loads.hpp"
#include "model/mesh_side.hpp"

/// Quadrature rules for loads given as expressions: one for the loads, K and error bars.
namespace spricka::fe {

/// Degree of exactness of loads: fields of x y z and the roots in the length of curved sides are no
/// polynomials, so that more is taken than the stiffness needs.
inline constexpr int load_degree = 9;

/// Components of a load at a point; missing ones are zero.
inline base::Vec3 load_value(const model::Load& load, const base::Vec3& x) {
  base::Vec3 value = base::Vec3::Zero();
  for (std::size_t c = 0; c < load.value.size(); ++c) {
    value[static_cast<Eigen::Index>(c)] = load.value[c](x);
  }
  return value;
}

/// Whether no component of a load varies with the place.
inline bool is_constant(const model::Load& load) {
  return std::ranges::all_of(load.value,
                             [](const base::CompiledExpression& v) { return v.is_constant(); });
}

/// Whether nothing in a load's expressions can jump or kink: no comparison, abs, min or max.
inline bool is_smooth(const model::Load& load) {
  using base::OpCode;
  return std::ranges::all_of(load.value, [](const base::CompiledExpression& v) {
    return std::ranges::none_of(v.code, [](const base::ExpressionInstruction& i) {
      return (i.op >= OpCode::less && i.op <= OpCode::logical_or) || i.op == OpCode::abs ||
             i.op == OpCode::min || i.op == OpCode::max || i.op == OpCode::atan2 ||
             i.op == OpCode::sqrt || i.op == OpCode::theta;
    });
  });
}

/// The rule that a load wants over a side or an element; `scale` as load_scale gives it. Compiled
/// in load_rule.cpp for each dimension.
template <int dim>
FieldAdaptedRule<dim> load_rule(const AnyElement<dim>& element, const SpaceNodes<dim>& X,
                                const model::Load& load, const FieldMagnitude& scale);

/// The same over a side, by its two local coordinates.
FieldAdaptedRule<2> load_rule(const geometry::ElementSide& side, const model::Load& load,
                              const FieldMagnitude& scale);

/// The same with nodes in the plane or in space [dim, nodes].
template <int dim>
FieldAdaptedRule<dim> body_load_rule(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                                     const model::Load& load, const FieldMagnitude& scale) {
  return load_rule<dim>(element, embed_nodes_in_space<dim>(X), load, scale);
}

/// A place that a load is integrated at, and the length, area or volume that it stands for.
struct LoadEvaluationPoint {
  base::Vec3 x = base::Vec3::Zero();
  double size = 0.0;
};

/// The places of a load of a deck on its mesh: of nodes themselves, with a size of 1; of a constant
/// load any one.
std::vector<LoadEvaluationPoint> load_sample_points(const model::Mesh& mesh,
                                                    const model::Load& load);

/// Adds the places of one side or element. Compiled in load_rule.cpp for each dimension.
template <int dim>
void add_load_sample_points(const AnyElement<dim>& element, const SpaceNodes<dim>& X,
                            const model::Load& load, std::vector<LoadEvaluationPoint>& places);

/// Part of a load's total magnitude that no rule could follow, 1 at most; 0 where all agree to
/// AdaptiveRuleLimits::load_tolerance.
double unresolved_load_fraction(const model::Model& model, const model::Mesh& mesh,
                                const model::Load& load);

/// How large a load spread over faces or elements is anywhere and in the mean: what counts as
/// small. `elements`: those it acts on, where it acts on elements.
FieldMagnitude load_scale(const model::Mesh& mesh, const model::Load& load,
                          const std::vector<base::ElementId>& elements = {});

} // namespace spricka::fe
