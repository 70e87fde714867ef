// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/remesh_surface.hpp"
#include "mesh/surface/surface_hits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

/// Plane cracks that come out of a surface: caps and mouths as a tube would bring them, and the
/// faces that a cavity would take away.
namespace spricka::test {

using base::Vec3;

struct Ellipse {
  Vec3 centre, u, v; ///< half axes
  [[nodiscard]] Vec3 normal() const { return u.cross(v).normalized(); }
  [[nodiscard]] double length() const { return std::min(u.norm(), v.norm()); }
};

/// In the order of t = m x b: from u against v.
inline mesh::FrontCurve front_of(const Ellipse& e, int count = 96) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    points.push_back(e.centre + std::cos(angle) * e.u - std::sin(angle) * e.v);
  }
  return {points, std::vector<Vec3>(points.size(), e.normal()), true};
}

struct SurfaceCut {
  mesh::SurfaceRegion region;
  mesh::RemeshedSurface made;
  std::string trouble;    ///< before the surface was meshed anew
  std::vector<Vec3> ends; ///< of the fronts, on the surface
};

/// A cap of radius R round the end of an arc: corner 0 on the mouth, eight in all.
inline std::vector<Vec3> cap_round(const mesh::SurfaceGeometry& surface,
                                   const mesh::SurfacePlace& end, const Vec3& on_mouth,
                                   const Vec3& normal) {
  const Vec3 d = on_mouth - end.x;
  const Vec3 across = (normal - normal.dot(end.normal) * end.normal).normalized() * d.norm();
  std::vector<Vec3> cap{on_mouth};
  for (int i = 1; i < 8; ++i) {
    const double angle = 0.25 * std::numbers::pi * i;
    cap.push_back(surface.nearest_place(end.x + std::cos(angle) * d + std::sin(angle) * across).x);
  }
  return cap;
}

/// Faces nearer than their own size and the wanted one to a line.
inline std::vector<std::size_t> faces_round(const mesh::SurfaceGeometry& surface,
                                            const std::vector<Vec3>& line,
                                            const mesh::SizeFunction& size) {
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < surface.faces().size(); ++f) {
    const geometry::Box<3> box = surface.face(f).bounding_box();
    double edge = 0.0;
    const auto& X = surface.face(f).X;
    for (int i = 0; i < surface.face(f).corner_count(); ++i) {
      edge = std::max(edge, (X.col(i) - X.col((i + 1) % surface.face(f).corner_count())).norm());
    }
    const bool coarse = edge > size(surface.place_at_coordinates(f, {1.0 / 3.0, 1.0 / 3.0}).x);
    const bool near =
        std::ranges::any_of(line, [&](const Vec3& x) { return box.distance(x) < size(x); });
    if (near || coarse) {
      faces.push_back(f);
    }
  }
  return faces;
}

inline SurfaceCut cut_surface(const mesh::SurfaceGeometry& surface, const Ellipse& crack,
                              double radius, double growth = 0.5) {
  SurfaceCut cut;
  const mesh::FrontCurve front = front_of(crack);
  const mesh::InteriorFrontArcs arcs = find_interior_front_arcs(surface, front);
  if (arcs.trouble) {
    cut.trouble = arcs.trouble.why;
    return cut;
  }
  mesh::SurfaceRegion& region = cut.region;
  region.plane = {crack.centre, crack.normal(), crack.length()};
  region.growth = growth;
  // Finest along the whole front: a tube of this radius.
  std::vector<Vec3> line;
  line.reserve(200);
  for (int i = 0; i < 200; ++i) {
    line.push_back(front.at(front.length() * i / 200.0).x);
  }
  region.size = [line, radius, growth](const Vec3& x) {
    double away = 1e300;
    for (const Vec3& p : line) {
      away = std::min(away, (x - p).norm());
    }
    return radius + growth * std::max(0.0, away - radius);
  };
  for (const mesh::InteriorFrontArc& arc : arcs.arcs) {
    if (arc.whole) {
      continue;
    }
    // The surface is left to the crack's side, which is that of -m.
    // It ends at the first arc that it comes to.
    mesh::TraceResult mouth;
    std::size_t reached = 0;
    for (std::size_t k = 0; k < arcs.arcs.size(); ++k) {
      mesh::TraceResult traced = trace_crack_plane(surface, region.plane, arc.place[1],
                                                   arcs.arcs[k].place[0], -front.at(arc.s[1]).m);
      if (k == 0 || (!traced.trouble && (mouth.trouble || traced.trace.front().length() <
                                                              mouth.trace.front().length()))) {
        mouth = std::move(traced);
        reached = k;
      }
    }
    if (mouth.trouble) {
      cut.trouble = mouth.trouble.why;
      return cut;
    }
    const mesh::SurfaceTrace& trace = mouth.trace.front();
    const mesh::InteriorFrontArc& next = arcs.arcs[reached];
    const int cap = static_cast<int>(region.caps.size());
    cut.ends.insert(cut.ends.end(), {arc.place[1].x, next.place[0].x});
    const double L = trace.length();
    const Vec3 a = trace.at(std::min(radius, 0.3 * L)).x;
    const Vec3 b = trace.at(L - std::min(radius, 0.3 * L)).x;
    region.caps.push_back(cap_round(surface, arc.place[1], a, crack.normal()));
    region.caps.push_back(cap_round(surface, next.place[0], b, crack.normal()));
    const Vec3 on = trace.at(0.31 * L).x - a;
    const mesh::TraceResult traced = trace_crack_plane(
        surface, region.plane, surface.nearest_place(a), surface.nearest_place(b), on);
    if (traced.trouble) {
      cut.trouble = traced.trouble.why;
      return cut;
    }
    region.mouths.push_back(
        {divide_trace_by_size(traced.trace[0], region.size), {{{cap, 0}, {cap + 1, 0}}}});
    for (int k = 0; k <= 100; ++k) {
      line.push_back(traced.trace[0].at(traced.trace[0].length() * k / 100.0).x);
    }
  }
  region.faces = faces_round(surface, line, region.size);
  cut.made = remesh_surface(surface, region);
  return cut;
}

} // namespace spricka::test
