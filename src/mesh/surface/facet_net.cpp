// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/facet_net.hpp"

#include <algorithm>

namespace spricka::mesh {

using base::Vec2;

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
  return (face.quadratic() ? divisions : 1) * finer_;
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
    return corner(f, (i + k / n) % f.corners());
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
  const FaceGrid grid{f.corners() == 3, steps(f)};
  const int n = grid.n;
  const auto points = static_cast<std::size_t>(n + 1);
  std::vector<std::vector<int>> vertex(points, std::vector<int>(points, -1));
  const auto at = [&](int i, int j) -> int& {
    return vertex[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
  };
  for (int s = 0; s < f.corners(); ++s) {
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
