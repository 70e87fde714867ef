// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/load_rule.hpp"

#include "fe/element.hpp"
#include "model/loads.hpp"
#include "model/mesh.hpp"

#include <cmath>
#include <limits>

namespace spricka::fe {

namespace {

// Calls f(element, X) for the part-th face or element of a load.
template <class F>
void with_part(const model::Mesh& mesh, const model::Load& load,
               const std::vector<base::ElementId>& elements, std::size_t part, F&& f) {
  if (load.faces.valid()) {
    geometry::with_reference_element(
        model::element_side(mesh, mesh.set_with_id(load.faces).faces[part]), f);
  } else {
    with_any_element(mesh, elements[part], [&]<int dim>(const AnyElement<dim>& element) {
      f(element, embed_nodes_in_space<dim>(element_coordinates(element, mesh, elements[part])));
    });
  }
}

} // namespace

FieldMagnitude load_scale(const model::Mesh& mesh, const model::Load& load,
                          const std::vector<base::ElementId>& elements) {
  if (is_constant(load)) {
    const double value = load_value(load, base::Vec3::Zero()).norm();
    return {value, value};
  }
  const std::size_t parts =
      load.faces.valid() ? mesh.set_with_id(load.faces).faces.size() : elements.size();
  FieldMagnitude scale;
  for (std::size_t i = 0; i < parts; ++i) {
    with_part(mesh, load, elements, i,
              [&]<int dim>(const AnyElement<dim>& element, const SpaceNodes<dim>& X) {
                double amount = 0.0;
                double size = 0.0;
                for (const auto& point : shape::quadrature<dim>(element.domain, load_degree)) {
                  const double value = load_value(load, X * element.N(point.r)).norm();
                  scale.largest = std::max(scale.largest, value);
                  amount += point.weight * value;
                  size += point.weight;
                }
                scale.mean += amount / (size * static_cast<double>(parts));
              });
  }
  return scale;
}

template <int dim>
FieldAdaptedRule<dim> load_rule(const AnyElement<dim>& element, const SpaceNodes<dim>& X,
                                const model::Load& load, const FieldMagnitude& scale) {
  if (is_constant(load)) {
    const auto usual = shape::quadrature<dim>(element.domain, load_degree);
    return {{usual.begin(), usual.end()}, 0.0, 0.0, false};
  }
  return make_adapted_rule<dim>(
      whole_element_domain<dim>(element.domain, load_degree),
      [&](const shape::Point<dim>& r) { return load_value(load, X * element.N(r)); },
      {adaptive_rule_limits<dim>.load_tolerance, scale, is_smooth(load)});
}

FieldAdaptedRule<2> load_rule(const geometry::ElementSide& side, const model::Load& load,
                              const FieldMagnitude& scale) {
  FieldAdaptedRule<2> rule;
  geometry::with_reference_element(side, [&]<int dim>(const shape::ReferenceElement<dim>& reference,
                                                      const geometry::SidePositions& X) {
    const FieldAdaptedRule<dim> found = load_rule<dim>(reference, X, load, scale);
    rule = {{}, found.missed, found.amount, found.jumps};
    for (const auto& [r, weight] : found.points) {
      base::Vec2 at = base::Vec2::Zero();
      at.head<dim>() = r;
      rule.points.push_back({at, weight});
    }
  });
  return rule;
}

template <int dim>
void add_load_sample_points(const AnyElement<dim>& element, const SpaceNodes<dim>& X,
                            const model::Load& load, std::vector<LoadEvaluationPoint>& places) {
  for (const auto& point : load_rule<dim>(element, X, load, {}).points) {
    const Eigen::Matrix<double, 3, dim> J = X.lazyProduct(element.dN(point.r));
    const double size = std::sqrt((J.transpose() * J).determinant());
    places.push_back({X * element.N(point.r), point.weight * size});
  }
}

std::vector<LoadEvaluationPoint> load_sample_points(const model::Mesh& mesh,
                                                    const model::Load& load) {
  std::vector<LoadEvaluationPoint> places;
  if (is_constant(load)) {
    return {{base::Vec3::Zero(), 1.0}};
  }
  if (load.nodes.valid()) {
    for (const base::NodeId n : mesh.set_with_id(load.nodes).nodes) {
      places.push_back({mesh.x[n.index()], 1.0});
    }
    return places;
  }
  static const std::vector<base::ElementId> none;
  const std::vector<base::ElementId>& elements =
      load.faces.valid() ? none : mesh.set_with_id(load.elements).elements;
  const std::size_t parts =
      load.faces.valid() ? mesh.set_with_id(load.faces).faces.size() : elements.size();
  for (std::size_t i = 0; i < parts; ++i) {
    with_part(mesh, load, elements, i,
              [&]<int dim>(const AnyElement<dim>& element, const SpaceNodes<dim>& X) {
                add_load_sample_points<dim>(element, X, load, places);
              });
  }
  return places;
}

#define LOAD_RULE(dim)                                                                             \
  template FieldAdaptedRule<dim> load_rule<dim>(const AnyElement<dim>&, const SpaceNodes<dim>&,    \
                                                const model::Load&, const FieldMagnitude&);        \
  template void add_load_sample_points<dim>(const AnyElement<dim>&, const SpaceNodes<dim>&,        \
                                            const model::Load&,                                    \
                                            std::vector<LoadEvaluationPoint>&);
LOAD_RULE(1)
LOAD_RULE(2)
LOAD_RULE(3)

} // namespace spricka::fe
