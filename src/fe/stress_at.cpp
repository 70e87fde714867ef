// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/inverse_map.hpp"
#include "fe/stress_kernel.hpp"

#include <algorithm>
#include <limits>

namespace spricka::fe {

namespace {

using base::ElementId;
using base::Vec3;

// A point of the exact boundary may lie off the sides of the mesh by their sagitta: so far, in
// reference coordinates, it still belongs to the nearest element.
constexpr double boundary_tolerance = 0.05;
constexpr double round_off = 1e-9;

struct Hit {
  ElementId element;
  Vec3 r = Vec3::Zero();
  double outside = std::numeric_limits<double>::infinity();
};

bool in_box(const model::Mesh& mesh, ElementId e, const Vec3& point) {
  Vec3 low = mesh.x[mesh.nodes_of(e).front().index()];
  Vec3 high = low;
  for (const base::NodeId n : mesh.nodes_of(e)) {
    low = low.cwiseMin(mesh.x[n.index()]);
    high = high.cwiseMax(mesh.x[n.index()]);
  }
  // Curved sides bulge beyond their nodes.
  const double margin = 0.25 * (high - low).maxCoeff();
  return ((point - low).array() >= -margin).all() && ((high - point).array() >= -margin).all();
}

template <shape::ElementShape S> shape::Point<S::dim> into_domain(shape::Point<S::dim> r) {
  if constexpr (S::domain == shape::Domain::triangle) {
    r = r.cwiseMax(0.0);
    const double sum = r.sum();
    return sum > 1.0 ? shape::Point<S::dim>(r / sum) : r;
  } else {
    return r.cwiseMax(-1.0).cwiseMin(1.0);
  }
}

// The elements that hold the point within the tolerance, in mesh order.
std::vector<Hit> find(const model::Mesh& mesh, const Vec3& point) {
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const ElementId e(i);
    if (!in_box(mesh, e, point)) {
      continue;
    }
    shape::with_plane_shape(mesh.type[i], [&]<shape::ElementShape S>(S) {
      const shape::Point<S::dim> x = point.head<S::dim>();
      if (const auto r = inverse_map<S>(coordinates<S>(mesh, e), x)) {
        const double outside = shape::outside<S>(*r);
        if (outside <= boundary_tolerance) {
          Hit hit{e, Vec3::Zero(), outside};
          hit.r.head<S::dim>() = into_domain<S>(*r);
          hits.push_back(hit);
        }
      }
    });
  }
  return hits;
}

bool share_node(const model::Mesh& mesh, ElementId a, ElementId b) {
  const auto nodes = mesh.nodes_of(b);
  return std::ranges::any_of(
      mesh.nodes_of(a), [&](base::NodeId n) { return std::ranges::find(nodes, n) != nodes.end(); });
}

} // namespace

std::optional<Stress> stress_at(const model::Model& model, const model::Mesh& mesh,
                                const base::Vector& u, const Vec3& point) {
  const std::vector<Hit> hits = find(mesh, point);
  if (hits.empty()) {
    return std::nullopt;
  }
  const auto nearest = std::ranges::min_element(
      hits, {}, [](const Hit& h) { return std::max(h.outside, round_off); });
  Stress sum = Stress::Zero();
  int count = 0;
  for (const Hit& hit : hits) {
    // On a side or node, the mean of the neighbours in the same material; never the other body of
    // a contact or the other lip of a crack.
    const bool counts =
        hit.element == nearest->element ||
        (hit.outside <= round_off &&
         mesh.property[hit.element.index()] == mesh.property[nearest->element.index()] &&
         share_node(mesh, hit.element, nearest->element));
    if (!counts) {
      continue;
    }
    shape::with_plane_shape(mesh.type[hit.element.index()], [&]<shape::ElementShape S>(S) {
      sum += StressElement<S>(model, mesh, hit.element, u).at(hit.r.head<S::dim>());
    });
    ++count;
  }
  return Stress(sum / count);
}

} // namespace spricka::fe
