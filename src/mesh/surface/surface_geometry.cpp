// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_geometry.hpp"

#include "base/disjoint_sets.hpp"
#include "mesh/boundary.hpp"
#include "model/mesh_side.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace spricka::mesh {
namespace {

using base::NodeId;
using base::Vec2;
using base::Vec3;

/// The nearest place on faces that come one by one; ties go to the lower number.
class NearestFaceSearch {
public:
  NearestFaceSearch(const SurfaceGeometry& surface, const Vec3& x) : surface_(surface), x_(x) {}

  [[nodiscard]] double distance() const { return distance_; }
  void look_at(std::size_t face) {
    const geometry::ElementSide& f = surface_.face(face);
    const Vec2 r = f.nearest_local_coordinates(x_, geometry::ClampedFootPolicy::replaced);
    const double distance = (f.position(r) - x_).norm();
    const double same = 1e-12 * surface_.diagonal();
    if (distance < distance_ - same || (distance < distance_ + same && face < face_)) {
      distance_ = std::min(distance, distance_);
      face_ = face;
      r_ = r;
    }
  }
  [[nodiscard]] SurfacePlace place() const {
    return face_ == nowhere ? SurfacePlace{} : surface_.place_at_coordinates(face_, r_);
  }

private:
  const SurfaceGeometry& surface_;
  const Vec3& x_;
  double distance_ = std::numeric_limits<double>::max();
  std::size_t face_ = nowhere;
  Vec2 r_ = Vec2::Zero();
};

} // namespace

SurfaceGeometry::SurfaceGeometry(const model::Mesh& mesh, std::span<const base::FaceSetId> kept,
                                 bool borders, std::span<const base::NodeSetId> lines) {
  std::vector<geometry::Box<3>> boxes;
  geometry::Box<3> all;
  for (const model::Face& face : boundary_faces(mesh)) {
    if (base::element_info(mesh.type[face.element.index()]).dim != 3) {
      continue;
    }
    faces_.push_back(model::element_side(mesh, face));
  }
  std::ranges::sort(faces_, {}, model::face_of_side);
  for (const geometry::ElementSide& face : faces_) {
    boxes.push_back(face.bounding_box());
    all.extend(boxes.back());
  }
  extent_ = faces_.empty() ? 0.0 : all.diagonal();
  boxes_ = geometry::BoxTree<3>(boxes);
  find_edges();
  find_sets(mesh, kept);
  find_lines(mesh, lines);
  find_pieces(borders);
}

std::size_t SurfaceGeometry::face_index(const model::Face& face) const {
  const auto at = std::ranges::lower_bound(faces_, face, {}, model::face_of_side);
  return at != faces_.end() && model::face_of_side(*at) == face
             ? static_cast<std::size_t>(at - faces_.begin())
             : nowhere;
}

SurfacePlace SurfaceGeometry::place_at_coordinates(std::size_t face, const Vec2& r) const {
  const geometry::SidePoint point = faces_[face].point(r);
  return {face, r, point.x, point.normal()};
}

SurfacePlace SurfaceGeometry::nearest_place(const Vec3& x) const {
  NearestFaceSearch nearest(*this, x);
  boxes_.visit_nearest(x, [&](std::size_t face) {
    nearest.look_at(face);
    return nearest.distance() + 1e-12 * extent_;
  });
  return nearest.place();
}

SurfacePlace SurfaceGeometry::nearest_place(const Vec3& x,
                                            std::span<const std::size_t> among) const {
  NearestFaceSearch nearest(*this, x);
  for (const std::size_t face : among) {
    if (faces_[face].bounding_box().distance(x) <= nearest.distance() + 1e-12 * extent_) {
      nearest.look_at(face);
    }
  }
  return nearest.place();
}

namespace {

NodeId mid_of_side(const geometry::ElementSide& face, int i) {
  return face.is_quadratic() ? face.nodes[static_cast<std::size_t>(face.corner_count() + i)]
                             : NodeId();
}

/// Walks along feature edges from node to node.
class ChainWalk {
public:
  ChainWalk(const std::vector<SurfaceEdge>& edges, const std::vector<std::size_t>& which,
            const std::set<NodeId>& stops)
      : edges_(edges), stops_(stops) {
    for (const std::size_t e : which) {
      at_[edges[e].ends[0]].push_back(e);
      at_[edges[e].ends[1]].push_back(e);
    }
  }

  std::vector<FeatureChain> chains() {
    std::vector<FeatureChain> all;
    for (const bool rings : {false, true}) {
      for (const auto& [node, around] : at_) {
        for (const std::size_t e : around) {
          if (!used_.contains(e) && (rings || !passes(node))) {
            all.push_back(from(node, e));
          }
        }
      }
    }
    return all;
  }

private:
  [[nodiscard]] bool passes(NodeId node) const {
    return at_.at(node).size() == 2 && !stops_.contains(node);
  }
  FeatureChain from(NodeId node, std::size_t edge) {
    FeatureChain chain{{}, {node}};
    for (std::size_t e = edge; e != nowhere;) {
      used_.insert(e);
      chain.edges.push_back(e);
      const auto& ends = edges_[e].ends;
      node = ends[0] == node ? ends[1] : ends[0];
      chain.nodes.push_back(node);
      const std::vector<std::size_t>& around = at_.at(node);
      e = nowhere;
      for (const std::size_t next : around) {
        e = passes(node) && !used_.contains(next) ? next : e;
      }
    }
    return chain;
  }

  const std::vector<SurfaceEdge>& edges_;
  std::map<NodeId, std::vector<std::size_t>> at_; ///< feature edges of a node
  const std::set<NodeId>& stops_;
  std::set<std::size_t> used_;
};

} // namespace

void SurfaceGeometry::find_edges() {
  face_edges_.assign(faces_.size(), {nowhere, nowhere, nowhere, nowhere});
  std::map<std::pair<NodeId, NodeId>, std::size_t> known;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const geometry::ElementSide& face = faces_[f];
    for (int i = 0; i < face.corner_count(); ++i) {
      const NodeId a = face.nodes[static_cast<std::size_t>(i)];
      const NodeId b = face.nodes[static_cast<std::size_t>((i + 1) % face.corner_count())];
      const auto [at, fresh] = known.try_emplace(std::minmax(a, b), edges_.size());
      if (fresh) {
        edges_.push_back({{std::min(a, b), std::max(a, b)}, mid_of_side(face, i)});
      }
      SurfaceEdge& edge = edges_[at->second];
      face_edges_[f][static_cast<std::size_t>(i)] = at->second;
      const std::size_t way = a < b ? 0 : 1;
      ++edge.count;
      if (edge.faces[way] == nowhere) {
        edge.faces[way] = f;
        edge.side[way] = i;
      }
    }
  }
}

void SurfaceGeometry::find_sets(const model::Mesh& mesh, std::span<const base::FaceSetId> kept) {
  sets_.resize(faces_.size());
  for (std::size_t s = 0; s < kept.size(); ++s) {
    for (const model::Face& face : mesh.set_with_id(kept[s]).faces) {
      const std::size_t f = face_index(face);
      if (f != nowhere && (sets_[f].empty() || sets_[f].back() != s)) {
        sets_[f].push_back(s);
      }
    }
  }
}

void SurfaceGeometry::find_lines(const model::Mesh& mesh, std::span<const base::NodeSetId> lines) {
  lines_.assign(edges_.size(), {});
  bare_.assign(edges_.size(), false);
  for (std::size_t s = 0; s < lines.size(); ++s) {
    const std::vector<NodeId>& nodes = mesh.set_with_id(lines[s]).nodes;
    const std::vector<bool> member = model::mark_members(mesh.node_count(), nodes);
    for (const NodeId n : nodes) {
      line_nodes_[n].push_back(s);
    }
    const auto has = [&](NodeId n) { return member[n.index()]; };
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const SurfaceEdge& edge = edges_[e];
      if (!std::ranges::all_of(edge.ends, has) || (edge.mid.valid() && !has(edge.mid))) {
        continue;
      }
      lines_[e].push_back(s);
      bare_[e] = bare_[e] || std::ranges::none_of(edge.faces, [&](std::size_t f) {
                   return f != nowhere && std::ranges::all_of(faces_[f].nodes, has);
                 });
    }
  }
}

const std::vector<std::size_t>& SurfaceGeometry::node_sets(NodeId node) const {
  static const std::vector<std::size_t> none;
  const auto at = line_nodes_.find(node);
  return at == line_nodes_.end() ? none : at->second;
}

void SurfaceGeometry::find_pieces(bool borders) {
  const double least = std::cos(most_turn);
  base::DisjointSets smooth(faces_.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    SurfaceEdge& edge = edges_[e];
    const auto [one, two] = edge.faces;
    edge.feature = edge.count != 2 || one == nowhere || two == nowhere;
    if (!edge.feature) {
      const Vec3 n1 =
          place_at_coordinates(one, faces_[one].edge_coordinates(edge.side[0], 0.0)).normal;
      const Vec3 n2 =
          place_at_coordinates(two, faces_[two].edge_coordinates(edge.side[1], 0.0)).normal;
      edge.feature = !(n1.dot(n2) > least);
    }
    edge.border = borders && !edge.feature && (sets_[one] != sets_[two] || bare_[e]);
    edge.feature = edge.feature || edge.border;
    if (!edge.feature) {
      smooth.join_sets(one, two);
    }
  }
  base::DisjointSets::SetNumbers pieces = smooth.set_numbers();
  piece_ = std::move(pieces.of);
  pieces_ = pieces.count;
}

SurfacePlace SurfaceGeometry::place_on_edge(std::size_t edge, double t) const {
  const SurfaceEdge& e = edges_[edge];
  const std::size_t way = e.faces[0] != nowhere ? 0 : 1;
  const std::size_t f = e.faces[way];
  return place_at_coordinates(f, faces_[f].edge_coordinates(e.side[way], way == 0 ? t : -t));
}

std::vector<FeatureChain> chain_edges(const std::vector<SurfaceEdge>& all,
                                      const std::vector<std::size_t>& which,
                                      const std::set<NodeId>& stops) {
  return ChainWalk(all, which, stops).chains();
}

namespace {

/// Points of a face's grid: (i, j) counts steps from the first corner; i + j <= n on triangles.
struct FaceGrid {
  bool triangle;
  int n;

  [[nodiscard]] int width(int j) const { return triangle ? n - j : n; } ///< steps in row j
  [[nodiscard]] Vec2 r(int i, int j) const {
    const Vec2 part(static_cast<double>(i) / n, static_cast<double>(j) / n);
    return triangle ? part : Vec2(2.0 * part - Vec2::Ones());
  }
  /// The point k steps along the side from corner s.
  [[nodiscard]] std::array<int, 2> at(int s, int k) const {
    if (triangle) {
      return s == 0 ? std::array{k, 0} : s == 1 ? std::array{n - k, k} : std::array{0, n - k};
    }
    switch (s) {
    case 0:
      return {k, 0};
    case 1:
      return {n, k};
    case 2:
      return {n - k, n};
    default:
      return {0, n - k};
    }
  }
};

} // namespace

FacetTriangulation::FacetTriangulation(const SurfaceGeometry& surface,
                                       std::span<const std::size_t> faces, int finer)
    : finer_(finer) {
  for (const std::size_t face : faces) {
    first_.push_back(facets_.size());
    add_face(surface, face);
  }
  first_.push_back(facets_.size());
}

int FacetTriangulation::steps(const geometry::ElementSide& face) const {
  return (face.is_quadratic() ? divisions : 1) * finer_;
}

int FacetTriangulation::corner(const geometry::ElementSide& face, int i) {
  const auto [at, fresh] =
      corner_.try_emplace(face.nodes[static_cast<std::size_t>(i)], static_cast<int>(x_.size()));
  if (fresh) {
    x_.emplace_back(face.X.col(i));
  }
  return at->second;
}

/// The vertex k steps along side i of a face.
int FacetTriangulation::on_side(const SurfaceGeometry& surface, std::size_t face, int i, int k) {
  const geometry::ElementSide& f = surface.face(face);
  const int n = steps(f);
  if (k == 0 || k == n) {
    return corner(f, (i + k / n) % f.corner_count());
  }
  const std::size_t e = surface.face_edge_index(face, i);
  const bool along = f.nodes[static_cast<std::size_t>(i)] == surface.edges()[e].ends[0];
  const int step = along ? k : n - k;
  const auto [at, fresh] = inner_.try_emplace({e, step}, static_cast<int>(x_.size()));
  if (fresh) {
    x_.push_back(surface.place_on_edge(e, 2.0 * step / n - 1.0).x);
  }
  return at->second;
}

void FacetTriangulation::add_face(const SurfaceGeometry& surface, std::size_t face) {
  const geometry::ElementSide& f = surface.face(face);
  const FaceGrid grid{f.corner_count() == 3, steps(f)};
  const int n = grid.n;
  const auto points = static_cast<std::size_t>(n + 1);
  std::vector<std::vector<int>> vertex(points, std::vector<int>(points, -1));
  const auto at = [&](int i, int j) -> int& {
    return vertex[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
  };
  for (int s = 0; s < f.corner_count(); ++s) {
    const std::size_t e = surface.face_edge_index(face, s);
    const bool along = f.nodes[static_cast<std::size_t>(s)] == surface.edges()[e].ends[0];
    for (int k = 0; k <= n; ++k) {
      const auto [i, j] = grid.at(s, k);
      at(i, j) = on_side(surface, face, s, k);
      if (k > 0) {
        const auto [i0, j0] = grid.at(s, k - 1);
        std::array<double, 2> t{2.0 * (k - 1) / n - 1.0, 2.0 * k / n - 1.0};
        if (!along) {
          t = {-t[0], -t[1]};
        }
        const int v = at(i0, j0);
        const int w = at(i, j);
        sides_[std::minmax(v, w)] = {e, v < w ? t : std::array{t[1], t[0]}};
      }
    }
  }
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= grid.width(j); ++i) {
      if (at(i, j) < 0) {
        at(i, j) = static_cast<int>(x_.size());
        x_.push_back(surface.place_at_coordinates(face, grid.r(i, j)).x);
      }
    }
  }
  const auto add = [&](std::array<std::array<int, 2>, 3> p) {
    SurfaceFacet facet{face, {}, {}};
    for (std::size_t c = 0; c < 3; ++c) {
      facet.vertex[c] = at(p[c][0], p[c][1]);
      facet.r[c] = grid.r(p[c][0], p[c][1]);
    }
    facets_.push_back(facet);
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < grid.width(j); ++i) {
      const bool half = grid.triangle && i + j + 1 == n;
      add({{{i, j}, {i + 1, j}, {i, j + 1}}});
      if (!half) {
        add({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
      }
    }
  }
}

const FacetTriangulation::FacetEdgeSegment* FacetTriangulation::edge_segment(int v, int w) const {
  const auto found = sides_.find(std::minmax(v, w));
  return found == sides_.end() ? nullptr : &found->second;
}

} // namespace spricka::mesh
