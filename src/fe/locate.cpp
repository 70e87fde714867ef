// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/locate.hpp"

#include "fe/inverse_map.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace spricka::fe {

namespace {

using base::ElementId;
using base::Vec3;

// A point of the exact boundary may lie off the sides of the mesh by their sagitta: so far, in
// reference coordinates, it still belongs to the nearest element.
constexpr double boundary_tolerance = 0.05;
// Points this close to a side, in reference coordinates, lie on it.
constexpr double on_side = 1e-7;

Eigen::AlignedBox3d box_about(const model::Mesh& mesh, ElementId e) {
  Eigen::AlignedBox3d box;
  for (const base::NodeId n : mesh.element_nodes(e)) {
    box.extend(mesh.x[n.index()]);
  }
  // Curved sides bulge beyond their nodes.
  const Vec3 margin = Vec3::Constant(0.25 * box.sizes().maxCoeff());
  return {box.min() - margin, box.max() + margin};
}

// A point beside the reference domain put onto it: shape functions are not asked outside.
template <int dim>
shape::Point<dim> into_domain(const AnyElement<dim>& element, shape::Point<dim> r) {
  if (element.corners == 1 << dim) {
    return r.cwiseMax(-1.0).cwiseMin(1.0);
  }
  const bool prism = element.domain == shape::ReferenceDomain::prism;
  const int flat = dim - (prism ? 1 : 0); // coordinates that share a simplex
  r.head(flat) = r.head(flat).cwiseMax(0.0).eval();
  const double sum = r.head(flat).sum();
  r.head(flat) /= std::max(sum, 1.0);
  if (prism) {
    r[dim - 1] = std::clamp(r[dim - 1], -1.0, 1.0);
  }
  return r;
}

// Of a point in its box.
std::optional<ElementHit> hit_in(const model::Mesh& mesh, ElementId e, const Vec3& point) {
  std::optional<ElementHit> found;
  with_any_element(mesh, e, [&]<int dim>(const AnyElement<dim>& element) {
    const shape::Point<dim> x = point.head<dim>();
    if (const auto r = inverse_map<dim>(element, element_coordinates(element, mesh, e), x)) {
      const double outside = element.distance_outside(*r);
      if (outside <= boundary_tolerance) {
        found = ElementHit{e, Vec3::Zero(), outside};
        found->r.head<dim>() = into_domain<dim>(element, *r);
      }
    }
  });
  return found;
}

} // namespace

bool have_common_node(const model::Mesh& mesh, ElementId a, ElementId b) {
  const auto nodes = mesh.element_nodes(b);
  return std::ranges::any_of(mesh.element_nodes(a), [&](base::NodeId n) {
    return std::ranges::find(nodes, n) != nodes.end();
  });
}

std::vector<ElementHit> elements_at_point(const model::Mesh& mesh, const Vec3& point) {
  std::vector<ElementHit> hits;
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const ElementId e(i);
    if (!box_about(mesh, e).contains(point)) {
      continue;
    }
    if (const std::optional<ElementHit> hit = hit_in(mesh, e, point)) {
      hits.push_back(*hit);
    }
  }
  return hits;
}

ElementBoxes::ElementBoxes(const model::Mesh& mesh, std::span<const ElementId> elements)
    : mesh_(mesh) {
  boxes_.reserve(elements.size());
  for (const ElementId e : elements) {
    boxes_.push_back({e, box_about(mesh, e)});
  }
}

std::vector<ElementHit> ElementBoxes::elements_at(const Vec3& point) const {
  std::vector<ElementHit> hits;
  for (const ElementBox& box : boxes_) {
    if (!box.around.contains(point)) {
      continue;
    }
    if (const std::optional<ElementHit> hit = hit_in(mesh_, box.element, point)) {
      hits.push_back(*hit);
    }
  }
  return hits;
}

std::vector<PointElementGroup> group_elements_at_point(const model::Mesh& mesh,
                                                       const std::vector<ElementHit>& hits) {
  double least = boundary_tolerance;
  for (const ElementHit& hit : hits) {
    least = std::min(least, hit.outside);
  }
  std::vector<PointElementGroup> sides;
  for (const ElementHit& hit : hits) {
    // Where some element holds the point, those that it only comes near to do not count.
    if (hit.outside > std::max(least, on_side)) {
      continue;
    }
    PointElementGroup joined{hit};
    std::erase_if(sides, [&](const PointElementGroup& side) {
      const bool same = std::ranges::any_of(side, [&](const ElementHit& h) {
        return have_common_node(mesh, h.element, hit.element);
      });
      if (same) {
        joined.insert(joined.end(), side.begin(), side.end());
      }
      return same;
    });
    std::ranges::sort(joined, {}, &ElementHit::element);
    sides.push_back(std::move(joined));
  }
  std::ranges::sort(sides, {}, [](const PointElementGroup& side) { return side.front().element; });
  return sides;
}

Vec3 displacement_at(const model::Mesh& mesh, const base::Vector& u,
                     const PointElementGroup& side) {
  // Displacements are continuous on one side: the element nearest to the point tells them.
  const ElementHit& hit = *std::ranges::min_element(side, {}, &ElementHit::outside);
  Vec3 value = Vec3::Zero();
  with_any_element(mesh, hit.element, [&]<int dim>(const AnyElement<dim>& element) {
    value.head<dim>() =
        gather_element_values(element, mesh, hit.element, u) * element.N(hit.r.head<dim>());
  });
  return value;
}

} // namespace spricka::fe
