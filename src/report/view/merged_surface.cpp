// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/merged_surface.hpp"

#include "geometry/box.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

namespace spricka::report {
namespace {

constexpr std::uint32_t no_point = 0xFFFFFFFFU;

/// Hands out each face of a surface: its points and its number.
template <class Use> void for_each_outline(const ShownSurface& surface, Use use) {
  std::size_t first = 0;
  for (std::size_t f = 0; f < surface.kind.size(); ++f) {
    const std::size_t count = surface.kind[f] % ShownSurface::has_mid_nodes;
    use(std::span<const std::uint32_t>(surface.outline).subspan(first, count), f);
    first += count;
  }
}

/// Points without those that no face has.
ShownSurface without_idle_points(const ShownSurface& surface) {
  std::vector<std::uint32_t> kept(surface.node.size(), no_point);
  ShownSurface out;
  out.kind = surface.kind;
  out.body = surface.body;
  for (const std::uint32_t p : surface.outline) {
    if (kept[p] == no_point) {
      kept[p] = static_cast<std::uint32_t>(out.node.size());
      out.node.push_back(surface.node[p]);
      out.source.push_back(surface.source[p]);
    }
    out.outline.push_back(kept[p]);
  }
  for (std::size_t i = 0; i + 1 < surface.coincident.size(); i += 2) {
    const std::uint32_t a = kept[surface.coincident[i]];
    const std::uint32_t b = kept[surface.coincident[i + 1]];
    if (a != no_point && b != no_point) {
      out.coincident.insert(out.coincident.end(), {a, b});
    }
  }
  return out;
}

/// Whether a mid node is where a straight edge has it.
bool is_straight(const base::Vec3& a, const base::Vec3& mid, const base::Vec3& b) {
  constexpr double bow = 2e-3; // of the edge
  return (mid - 0.5 * (a + b)).norm() < bow * (b - a).norm();
}

} // namespace

ShownSurface without_straight_mid_nodes(const model::Mesh& mesh, const ShownSurface& surface) {
  ShownSurface out = surface;
  out.outline.clear();
  const auto place = [&](std::uint32_t p) -> const base::Vec3& {
    return mesh.x[surface.node[p].index()];
  };
  for_each_outline(surface, [&](std::span<const std::uint32_t> points, std::size_t f) {
    const std::size_t before = out.outline.size();
    const std::size_t n = points.size();
    const bool curved = surface.kind[f] >= ShownSurface::has_mid_nodes;
    for (std::size_t i = 0; i < n; ++i) {
      if (!curved || i % 2 == 0 ||
          !is_straight(place(points[i - 1]), place(points[i]), place(points[(i + 1) % n]))) {
        out.outline.push_back(points[i]);
      }
    }
    out.kind[f] = static_cast<std::uint32_t>(out.outline.size() - before);
  });
  return without_idle_points(out);
}

ShownSurface merge_points(const model::Mesh& mesh, const ShownSurface& surface, std::size_t cubes) {
  geometry::Box<3> box;
  for (const base::NodeId n : surface.node) {
    box.extend({mesh.x[n.index()], mesh.x[n.index()]});
  }
  const double size = (box.high - box.low).maxCoeff() / static_cast<double>(cubes);
  std::vector<bool> fixed(surface.node.size(), false);
  for (const std::uint32_t p : surface.coincident) {
    fixed[p] = true;
  }
  std::unordered_map<std::uint64_t, std::uint32_t> first; // point of a cube
  std::vector<std::uint32_t> merged(surface.node.size(), no_point);
  ShownSurface out = surface;
  out.outline.clear();
  out.kind.clear();
  out.body.clear();
  for_each_outline(surface, [&](std::span<const std::uint32_t> points, std::size_t f) {
    std::vector<std::uint32_t> left;
    for (const std::uint32_t p : points) {
      if (merged[p] == no_point) {
        const base::Vec3 d = (mesh.x[surface.node[p].index()] - box.low) / size;
        std::uint64_t key = surface.body[f];
        for (int c = 0; c < 3; ++c) { // at most 1024 cubes in a row
          key = (key << 12U) | static_cast<std::uint64_t>(std::llround(d[c]));
        }
        merged[p] = fixed[p] ? p : first.try_emplace(key, p).first->second;
      }
      if (std::ranges::find(left, merged[p]) == left.end()) {
        left.push_back(merged[p]);
      }
    }
    if (left.size() >= 3) {
      out.outline.insert(out.outline.end(), left.begin(), left.end());
      out.kind.push_back(static_cast<std::uint32_t>(left.size()));
      out.body.push_back(surface.body[f]);
    }
  });
  return without_idle_points(out);
}

} // namespace spricka::report
