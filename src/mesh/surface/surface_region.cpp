// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_region.hpp"

#include "base/disjoint_sets.hpp"
#include "geometry/polyline.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace spricka::mesh {

using base::NodeId;
using base::Vec3;

SmoothSurfacePatches::SmoothSurfacePatches(const SurfaceGeometry& surface,
                                           std::span<const std::size_t> faces)
    : surface_(surface), all_(faces.begin(), faces.end()) {
  std::ranges::sort(all_);
  all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
  for (std::size_t i = 0; i < all_.size(); ++i) {
    patch_[all_[i]] = i;
  }
  base::DisjointSets smooth(all_.size());
  for (const auto& [face, i] : patch_) {
    for (int s = 0; s < surface_.face(face).corner_count(); ++s) {
      const auto next = patch_.find(across(face, s));
      if (next != patch_.end() && !surface_.edges()[surface_.face_edge_index(face, s)].feature) {
        smooth.join_sets(i, next->second);
      }
    }
  }
  const base::DisjointSets::SetNumbers patches = smooth.set_numbers();
  faces_.resize(patches.count);
  for (std::size_t i = 0; i < all_.size(); ++i) {
    patch_[all_[i]] = patches.of[i];
    faces_[patches.of[i]].push_back(all_[i]);
  }
  sort_edges();
  loops_.resize(faces_.size());
  for (std::size_t p = 0; p < faces_.size() && !trouble_; ++p) {
    string_loops(p);
  }
}

std::size_t SmoothSurfacePatches::patch_containing(std::size_t face) const {
  const auto at = patch_.find(face);
  return at == patch_.end() ? nowhere : at->second;
}

/// The face beyond a side, if there is exactly one.
std::size_t SmoothSurfacePatches::across(std::size_t face, int side) const {
  const SurfaceEdge& edge = surface_.edges()[surface_.face_edge_index(face, side)];
  return edge.count != 2 ? nowhere : edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
}

void SmoothSurfacePatches::sort_edges() {
  std::set<std::size_t> features;
  std::set<std::size_t> rim;
  for (const std::size_t face : all_) {
    for (int s = 0; s < surface_.face(face).corner_count(); ++s) {
      const std::size_t e = surface_.face_edge_index(face, s);
      if (surface_.edges()[e].count != 2) {
        trouble_ = {"more than two faces of the body meet in one edge",
                    surface_.place_on_edge(e, 0.0).x};
      } else if (!patch_.contains(across(face, s))) {
        rim.insert(e);
      } else if (surface_.edges()[e].feature) {
        features.insert(e);
      }
    }
  }
  features_.assign(features.begin(), features.end());
  rim_.assign(rim.begin(), rim.end());
}

bool SmoothSurfacePatches::is_border(std::size_t face, int side) const {
  const std::size_t other = across(face, side);
  return other == nowhere || patch_containing(other) != patch_containing(face);
}

/// The next side of the border: round the node at the end of this one, over the faces of the patch.
PatchBorderSide SmoothSurfacePatches::side_after(const PatchBorderSide& at) const {
  std::size_t face = at.face;
  int side = (at.side + 1) % surface_.face(face).corner_count();
  while (!is_border(face, side)) {
    const std::size_t e = surface_.face_edge_index(face, side);
    const SurfaceEdge& edge = surface_.edges()[e];
    const std::size_t way = edge.faces[0] == face ? 1 : 0;
    face = edge.faces[way];
    side = (edge.side[way] + 1) % surface_.face(face).corner_count();
  }
  return {face, side, surface_.face_edge_index(face, side), !patch_.contains(across(face, side))};
}

void SmoothSurfacePatches::string_loops(std::size_t patch) {
  std::set<std::pair<std::size_t, int>> used;
  for (const std::size_t face : faces_[patch]) {
    for (int s = 0; s < surface_.face(face).corner_count(); ++s) {
      if (!is_border(face, s) || used.contains({face, s})) {
        continue;
      }
      std::vector<PatchBorderSide> loop;
      PatchBorderSide at{face, s, surface_.face_edge_index(face, s),
                         !patch_.contains(across(face, s))};
      while (used.insert({at.face, at.side}).second) {
        loop.push_back(at);
        at = side_after(at);
      }
      loops_[patch].push_back(std::move(loop));
    }
  }
  if (loops_[patch].empty()) {
    trouble_ = {"the cavity takes away a closed surface",
                surface_.face(faces_[patch].front()).X.col(0)};
  }
}

namespace {

constexpr double sharp = 0.985;   // cosine of 10 degrees: a chain's corner stays one
constexpr double least_gap = 0.4; // of the wanted size: nearer to others a node is not kept

} // namespace

/// A chain with its lengths.
struct FeatureLines::Chain {
  static constexpr int steps = 8; ///< in which the length of an edge is measured

  struct ChainPosition {
    std::size_t i = 0; ///< edge of the chain
    double t = 0.0;    ///< on it, from its lower node
  };

  Chain(const SurfaceGeometry& s, const FeatureChain& c) : surface(s), chain(c) {
    Vec3 before = surface.place_on_edge(c.edges[0], way(0) < 0.0 ? 1.0 : -1.0).x;
    for (std::size_t i = 0; i < c.edges.size(); ++i) {
      for (int k = 1; k <= steps; ++k) {
        const Vec3 x = surface.place_on_edge(c.edges[i], way(i) * (2.0 * k / steps - 1.0)).x;
        arc.push_back(arc.back() + (x - before).norm());
        before = x;
      }
    }
  }

  /// +1 where the chain runs on edge i from its lower node.
  [[nodiscard]] double way(std::size_t i) const {
    return surface.edges()[chain.edges[i]].ends[0] == chain.nodes[i] ? 1.0 : -1.0;
  }
  [[nodiscard]] double length() const { return arc.back(); }
  [[nodiscard]] double at_node(std::size_t i) const { return arc[i * steps]; }
  [[nodiscard]] double at(const ChainPosition& place) const {
    const double u = 0.5 * steps * (1.0 + way(place.i) * place.t);
    const auto k = static_cast<std::size_t>(std::clamp(std::floor(u), 0.0, steps - 1.0));
    const std::size_t j = place.i * steps + k;
    return arc[j] + (u - static_cast<double>(k)) * (arc[j + 1] - arc[j]);
  }
  [[nodiscard]] ChainPosition place(double s) const {
    const auto [j, part] = geometry::position_at_length(arc, s);
    const double u = (static_cast<double>(j % steps) + part) / steps;
    return {j / steps, way(j / steps) * (2.0 * u - 1.0)};
  }
  [[nodiscard]] SurfacePlace surface_place(const ChainPosition& p) const {
    return surface.place_on_edge(chain.edges[p.i], p.t);
  }
  /// The place half way: by the edge's own parameter if both lie on one, which keeps its shape.
  [[nodiscard]] SurfacePlace middle(double s0, double s1) const {
    const double s = 0.5 * (s0 + s1);
    const std::size_t i = place(s).i;
    const double room = 1e-9 * length();
    if (s0 < at_node(i) - room || s1 > at_node(i + 1) + room) {
      return surface_place(place(s));
    }
    const auto t = [&](double end) {
      return end <= at_node(i) + room       ? -way(i)
             : end >= at_node(i + 1) - room ? way(i)
                                            : place(end).t;
    };
    return surface_place({i, 0.5 * (t(s0) + t(s1))});
  }
  /// Unit tangents before and after node i of the chain, and half way along its edges.
  [[nodiscard]] Vec3 direction(std::size_t i, double u) const {
    const double d = 1e-4;
    const Vec3 a = surface_place({i, way(i) * (u - (u > 0.0 ? d : 0.0))}).x;
    const Vec3 b = surface_place({i, way(i) * (u + (u > 0.0 ? 0.0 : d))}).x;
    return (b - a).normalized();
  }

  const SurfaceGeometry& surface;
  const FeatureChain& chain;
  std::vector<double> arc{0.0};
};

FeatureLines::FeatureLines(const SurfaceGeometry& surface, const SmoothSurfacePatches& patches,
                           const SizeFunction& size,
                           std::map<std::size_t, std::vector<FeatureEdgePoint>> crossings,
                           RemeshedSurface& out)
    : surface_(surface), patches_(patches), size_(size), on_edge_(std::move(crossings)), out_(out) {
  add_rim();
  take_nodes();
  std::set<NodeId> stops;
  for (const auto& [node, point] : on_node_) {
    stops.insert(node);
  }
  add_ends_of_lines(stops);
  for (const FeatureChain& chain : chain_edges(surface_.edges(), patches_.feature_edges(), stops)) {
    divide(chain);
  }
  for (auto& [edge, points] : on_edge_) {
    std::ranges::sort(points, {}, &FeatureEdgePoint::t);
  }
}

int FeatureLines::point_at_node(NodeId node) const {
  const auto at = on_node_.find(node);
  return at == on_node_.end() ? -1 : at->second;
}

const std::vector<FeatureEdgePoint>& FeatureLines::points_on_edge(std::size_t edge) const {
  static const std::vector<FeatureEdgePoint> none;
  const auto at = on_edge_.find(edge);
  return at == on_edge_.end() ? none : at->second;
}

void FeatureLines::add_rim() {
  for (const std::size_t e : patches_.rim_edges()) {
    const SurfaceEdge& edge = surface_.edges()[e];
    RemeshedEdge made;
    for (const std::size_t k : {0U, 1U}) {
      const SurfacePlace place = surface_.place_on_edge(e, k == 0 ? -1.0 : 1.0);
      const auto [at, fresh] =
          on_node_.try_emplace(edge.ends[k], static_cast<int>(out_.points.size()));
      if (fresh) {
        out_.points.push_back({place, edge.ends[k]});
      }
      made.points[k] = at->second;
    }
    made.kind = RemeshedEdgeKind::rim;
    made.mid = surface_.place_on_edge(e, 0.0);
    made.host_mid = edge.mid;
    out_.edges.push_back(made);
  }
}

/// Where a set has a node, and not the edges on both sides of it, a new edge ends.
void FeatureLines::add_ends_of_lines(std::set<NodeId>& stops) const {
  for (const std::size_t e : patches_.feature_edges()) {
    for (const NodeId n : surface_.edges()[e].ends) {
      if (surface_.node_sets(e) != surface_.node_sets(n)) {
        stops.insert(n);
      }
    }
  }
}

/// Points given at the ends of edges are points of nodes.
void FeatureLines::take_nodes() {
  for (auto& [e, points] : on_edge_) {
    const auto& ends = surface_.edges()[e].ends;
    std::erase_if(points, [&](const FeatureEdgePoint& point) {
      const bool at_node = std::abs(point.t) >= 1.0 - coordinate_tolerance;
      if (at_node) {
        on_node_.try_emplace(ends[point.t < 0.0 ? 0 : 1], point.point);
      }
      return at_node;
    });
  }
}

/// Corners of the chain, crossings, and on curved chains nodes of the host are points; between them
/// sizes decide.
void FeatureLines::divide(const FeatureChain& feature) {
  const Chain chain(surface_, feature);
  const std::size_t count = feature.edges.size();
  std::vector<double> fixed{0.0, chain.length()};
  for (std::size_t i = 0; i < count; ++i) {
    for (const FeatureEdgePoint& point : points_on_edge(feature.edges[i])) {
      fixed.push_back(chain.at({i, point.t}));
    }
  }
  const auto clear = [&](double s) {
    double gap = chain.length();
    for (const double other : fixed) {
      gap = std::min(gap, std::abs(s - other));
    }
    return gap > least_gap * size_(chain.surface_place(chain.place(s)).x);
  };
  for (std::size_t i = 1; i < count; ++i) {
    const double turn = chain.direction(i - 1, 1.0).dot(chain.direction(i, -1.0));
    const double bend = chain.direction(i, -1.0).dot(chain.direction(i, 1.0));
    const bool curved = std::min(turn, bend) < 1.0 - 1e-10;
    const double s = chain.at_node(i);
    if (turn < sharp || (curved && clear(s))) {
      fixed.push_back(s);
    }
  }
  std::ranges::sort(fixed);
  std::vector<double> s{0.0};
  for (std::size_t i = 0; i + 1 < fixed.size(); ++i) {
    if (fixed[i + 1] - fixed[i] <= 1e-9 * chain.length()) {
      continue;
    }
    const std::vector<double> part = divide_line_by_size(fixed[i], fixed[i + 1], [&](double at) {
      return size_(chain.surface_place(chain.place(at)).x);
    });
    s.insert(s.end(), part.begin() + 1, part.end());
  }
  if (feature.closed() && s.size() < 4) {
    s = {0.0, chain.length() / 3.0, chain.length() / 1.5, chain.length()};
  }
  for (std::size_t i = 0; i + 1 < s.size(); ++i) {
    RemeshedEdge made;
    made.points = {point_at(chain, s[i]), point_at(chain, s[i + 1])};
    made.kind = RemeshedEdgeKind::feature;
    made.mid = chain.middle(s[i], s[i + 1]);
    made.host_edge = feature.edges[chain.place(0.5 * (s[i] + s[i + 1])).i];
    out_.edges.push_back(made);
  }
}

int FeatureLines::point_at(const Chain& chain, double s) {
  const double room = 1e-9 * chain.length();
  for (std::size_t i = 0; i < chain.chain.nodes.size(); ++i) {
    if (std::abs(s - chain.at_node(i)) <= room) {
      return point_on_node(chain.chain.nodes[i], chain.surface_place(chain.place(s)));
    }
  }
  const Chain::ChainPosition place = chain.place(s);
  std::vector<FeatureEdgePoint>& points = on_edge_[chain.chain.edges[place.i]];
  for (const FeatureEdgePoint& other : points) {
    if (std::abs(chain.at({place.i, other.t}) - s) <= room) {
      return other.point;
    }
  }
  points.push_back({place.t, static_cast<int>(out_.points.size())});
  out_.points.push_back({chain.surface_place(place), NodeId()});
  return points.back().point;
}

int FeatureLines::point_on_node(NodeId node, const SurfacePlace& place) {
  const auto [at, fresh] = on_node_.try_emplace(node, static_cast<int>(out_.points.size()));
  if (fresh) {
    out_.points.push_back({place, surface_.node_sets(node).empty() ? NodeId() : node});
  }
  return at->second;
}

} // namespace spricka::mesh
