// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/place_crack.hpp"

#include "mesh/surface/surface_hits.hpp"
#include "mesh/tube/tube_room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace spricka::mesh {
namespace {

using base::Vec3;

/// Limits of a radius that is given; sizes chosen keep them.
constexpr double most_of_room = 0.45;
constexpr double most_of_curvature = 0.8;
/// A distance that is none, as a part of the crack's size.
constexpr double same_place = 1e-6;
constexpr double most_elements = 800.0; // along a front
/// How far a front may lean from the surface's normal where it ends: 65 degrees; a tube that is
/// sheared further has elements too flat.
constexpr double most_lean = 2.1445;
/// Tetrahedra go on to 10 degrees from the surface.
constexpr double most_lean_free = 5.6713;
/// They are shorter than elements of a tube.
constexpr double most_free_elements = 2000.0;

// Fronts without a tube: edges of tetrahedra, where no tube fits or none is wanted.

/// Size of the elements at a free front over the radius of the tube that it stands for.
constexpr double size_of_radius = 0.5;
/// Elements along the front over those across it.
constexpr double shortest_edge = 0.5;

double size_at_front(double radius, const TubeMeshParameters& given) {
  return given.size > 0.0 ? std::min(given.size / given.finer, radius) : size_of_radius * radius;
}

/// Elements along a front without a tube as long as those round it are large (mesh.13).
TubeSizes tubeless_front_sizes(TubeSizes sizes, const TubeMeshParameters& given) {
  for (std::size_t i = 0; i < sizes.s.size(); ++i) {
    const double size = size_at_front(sizes.radius[i], given);
    sizes.length[i] = std::clamp(sizes.length[i], shortest_edge * size, size);
  }
  return sizes;
}

/// The front alone, as a tube without elements.
Tube make_tubeless_front(const FrontCurve& curve, const TubeSizes& sizes,
                         const TubeMeshParameters& given) {
  Tube tube;
  tube.closed = curve.closed();
  tube.free = true;
  tube.quarter_point = given.quarter_point;
  const std::vector<double> at = sizes.stations(curve.closed());
  const auto add = [&](const Vec3& x) {
    tube.x.push_back(x);
    const int node = static_cast<int>(tube.x.size()) - 1;
    tube.twins.emplace_back(node, node);
    return node;
  };
  for (const double s : at) {
    tube.stations.push_back(curve.at(s));
    tube.radius.push_back(sizes.radius_at(s));
    tube.size.push_back(size_at_front(tube.radius.back(), given));
    tube.front.push_back(add(tube.stations.back().x));
  }
  for (std::size_t i = 0; i + (tube.closed ? 0 : 1) < at.size(); ++i) {
    const double end = i + 1 < at.size() ? at[i + 1] : curve.length();
    // On the curve: with chords K1 of a penny scatters by 1.7 % in place of 0.9 %.
    tube.front_mid.push_back(add(curve.at(0.5 * (at[i] + end)).x));
  }
  tube.upper = tube.front;
  tube.lower = tube.front;
  if (!tube.closed) {
    tube.ends[0].corner = {tube.front.front()};
    tube.ends[1].corner = {tube.front.back()};
  }
  return tube;
}

class TubePlacement {
public:
  TubePlacement(const SolidHostMesh& host, const CrackFrame& frame,
                const LocatedSolidCrack& request, base::Diagnostics& diagnostics)
      : host_(host), frame_(frame), request_(request), diagnostics_(diagnostics),
        mesh_(*request.mesh) {
    mesh_.radius /= frame.a;
    mesh_.size /= frame.a;
    mesh_.length /= frame.a;
  }

  std::optional<PatchSolidCrack> place(std::span<const LocatedSolidCrack> all) {
    const Eigen::Matrix3d axes = frame_.axes.transpose() * make_crack_frame(*request_.crack).axes;
    const PlaneBasis plane{frame_.exact_local_coordinates(make_crack_frame(*request_.crack).origin),
                           axes.col(0), axes.col(1), axes.col(2),
                           nonplanar_crack_surface_in_frame(frame_, *request_.crack)};
    std::vector<std::vector<Vec3>> outlines;
    for (const std::vector<Vec3>& outline : request_.outlines) {
      outlines.push_back(local(outline));
    }
    PatchSolidCrack made{CrackDistanceField(PlanePolygons(plane, outlines)),
                         {},
                         {request_.mesh->finer, request_.mesh->growth},
                         {},
                         {}};
    for (const InteriorFront& front : request_.fronts) {
      const FrontCurve curve(local(front.curve->points()),
                             plane.relief
                                 ? directions(front.curve->normals())
                                 : std::vector<Vec3>(front.curve->points().size(), plane.normal),
                             front.curve->closed());
      const TubeClearance round(host_, request_, front, all);
      if (!stands(front, round)) {
        return std::nullopt;
      }
      TubeSizes sizes =
          choose_tube_sizes(curve,
                            {[&](double s) { return round.clearance(s * frame_.a) / frame_.a; },
                             [&](double s) { return round.crack_width(s * frame_.a) / frame_.a; },
                             {round.end_inclination(0), round.end_inclination(1)},
                             straight(round)},
                            mesh_);
      if (!mesh_.tube) {
        sizes = tubeless_front_sizes(std::move(sizes), mesh_);
      }
      if (!fits(curve, sizes)) {
        return std::nullopt;
      }
      if (!mesh_.tube) {
        made.tubes.push_back(make_tubeless_front(curve, sizes, mesh_));
        made.reach.add_tube(made.tubes.back());
        continue;
      }
      made.tubes.push_back(make_tube(curve, sizes, mesh_, [&](const Vec3& p, const Vec3& t) {
        return to_surface(p, t, sizes.radius.front() + sizes.radius.back());
      }));
      if (made.tubes.back().off_surface) {
        return no_end(frame_.global(*made.tubes.back().off_surface));
      }
      made.reach.add_tube(made.tubes.back());
    }
    return made;
  }

private:
  [[nodiscard]] std::vector<Vec3> local(const std::vector<Vec3>& points) const {
    std::vector<Vec3> result;
    std::ranges::transform(points, std::back_inserter(result),
                           [&](const Vec3& x) { return frame_.exact_local_coordinates(x); });
    return result;
  }

  [[nodiscard]] std::vector<Vec3> directions(const std::vector<Vec3>& normals) const {
    std::vector<Vec3> result;
    std::ranges::transform(normals, std::back_inserter(result),
                           [&](const Vec3& b) -> Vec3 { return frame_.axes.transpose() * b; });
    return result;
  }

  /// Nothing of it for a crack that lies in its plane.
  [[nodiscard]] std::function<double(double)> straight(const TubeClearance& round) const {
    if (!request_.crack->relief) {
      return {};
    }
    return [&round, this](double s) { return round.kink_distance(s * frame_.a) / frame_.a; };
  }

  /// How far a place of a tube's end is from the surface along the front.
  [[nodiscard]] std::optional<double> to_surface(const Vec3& p, const Vec3& t, double most) const {
    const SurfaceGeometry& surface = host_.body_surface(request_.seed).geometry();
    const Vec3 d = frame_.axes * t;
    const Vec3 x = frame_.global(p) - most * frame_.a * d;
    std::optional<double> best;
    for (const SurfaceHit& hit :
         intersect_line_with_surface(surface, x, d, 2.0 * most * frame_.a)) {
      const double along = hit.along / frame_.a - most;
      best = !best || std::abs(along) < std::abs(*best) ? along : *best;
    }
    return best;
  }

  bool stands(const InteriorFront& front, const TubeClearance& round) {
    const double most = mesh_.tube ? most_lean : most_lean_free;
    for (const std::size_t end : {0U, 1U}) {
      if (!front.curve->closed() && round.end_inclination(end) > most) {
        diagnostics_.error(
            request_.span, "E423",
            fmt::format("{}: its front meets the body's surface at {} at {:.0f} degrees only",
                        request_.crack->display_name(), coordinate_text(front.end[end].x),
                        90.0 - std::atan(round.end_inclination(end)) * 180.0 / std::numbers::pi),
            mesh_.tube
                ? "a tube of elements fits round fronts that leave the body at 25 degrees or more"
                : "tetrahedra fit round fronts that leave the body at 10 degrees or more");
        return false;
      }
    }
    return true;
  }

  std::optional<PatchSolidCrack> no_end(const Vec3& at) {
    diagnostics_.error(
        request_.span, "E423",
        fmt::format(
            "{}: the end of the tube round its front does not find the body's surface at {}",
            request_.crack->display_name(), coordinate_text(at)),
        "the front meets the surface at too flat an angle, or at an edge; give a smaller RADIUS on "
        "$TIPNET");
    return std::nullopt;
  }

  /// What leaves so little room at a place.
  [[nodiscard]] const char* what_is_near(const Vec3& x) const {
    const std::size_t part = host_.property_part_index(request_.seed);
    const Vec3 at = frame_.global(x);
    // The skin has the border, too.
    const bool is_border = host_.interface_tree(part).nearest(at).distance <=
                           (1.0 + same_place) * host_.skin_tree(part).nearest(at).distance;
    return is_border ? "the border to elements of another $PROPERTY"
                     : "the body's surface or another crack";
  }

  bool fits(const FrontCurve& curve, const TubeSizes& sizes) {
    for (std::size_t i = 0; i < sizes.s.size(); ++i) {
      const FrontFrame at = curve.at(sizes.s[i]);
      if (sizes.room[i] < same_place) {
        diagnostics_.error(request_.span, "E423",
                           fmt::format("{}: its front touches {} at {}",
                                       request_.crack->display_name(), what_is_near(at.x),
                                       coordinate_text(frame_.global(at.x))),
                           "a crack keeps off the surface of the body or ends on it");
        return false;
      }
      const double bend = std::abs(at.curvature());
      const double free = std::min(most_of_room * sizes.room[i],
                                   bend > 0.0 ? most_of_curvature / bend : sizes.room[i]);
      if (!(sizes.radius[i] <= free) || !(sizes.radius[i] > 0.0)) {
        diagnostics_.error(
            request_.span, "E423",
            fmt::format("{}: {} of radius {:.6g} does not fit round its front at {}: there is room "
                        "for {:.6g}, {} is {:.6g} away",
                        request_.crack->display_name(),
                        mesh_.tube ? "a tube" : "a zone of even elements",
                        sizes.radius[i] * frame_.a, coordinate_text(frame_.global(at.x)),
                        free * frame_.a, what_is_near(at.x), sizes.room[i] * frame_.a),
            "give a smaller RADIUS on $TIPNET, or a crack that keeps off the surface or ends on "
            "it");
        return false;
      }
    }
    if (sizes.element_count_along_front() > (mesh_.tube ? most_elements : most_free_elements)) {
      const auto narrow = std::ranges::min_element(sizes.radius) - sizes.radius.begin();
      const auto i = static_cast<std::size_t>(narrow);
      diagnostics_.error(request_.span, "E423",
                         fmt::format("{}: its front would take {:.0f} elements, as there is room "
                                     "for {} of radius {:.3g} only at {}, beside {}",
                                     request_.crack->display_name(),
                                     sizes.element_count_along_front(),
                                     mesh_.tube ? "a tube" : "elements", sizes.radius[i] * frame_.a,
                                     coordinate_text(frame_.global(curve.at(sizes.s[i]).x)),
                                     what_is_near(curve.at(sizes.s[i]).x)),
                         "a crack keeps off the surface of the body or ends on it");
      return false;
    }
    return true;
  }

  const SolidHostMesh& host_;
  const CrackFrame& frame_;
  const LocatedSolidCrack& request_;
  base::Diagnostics& diagnostics_;
  TubeMeshParameters mesh_; ///< in the lengths of the frame
};

/// Divides the mouths of a crack between the ends of its tubes; false, with an error, where they
/// cannot be followed.
bool divide_crack_mouths(const SolidHostMesh& host, const CrackFrame& frame,
                         const LocatedSolidCrack& request, PatchSolidCrack& crack,
                         base::Diagnostics& diagnostics) {
  const SurfaceGeometry& surface = host.body_surface(request.seed).geometry();
  const auto size = [&](const Vec3& x) {
    return frame.a * crack.fill.size_at(crack.reach.distance(frame.rounded_local_coordinates(x)));
  };
  const auto corner = [&](std::size_t tube, std::size_t end) {
    const Tube& t = crack.tubes[tube];
    const int node = end == 0 ? t.lower.front() : t.lower.back();
    return surface.nearest_place(frame.global(t.x[static_cast<std::size_t>(node)]));
  };
  const auto fail = [&](const SurfaceFailure& trouble) {
    diagnostics.error(request.span, "E425",
                      fmt::format("{}: its mouth cannot be followed: {}, at {}",
                                  request.crack->display_name(), trouble.why,
                                  coordinate_text(trouble.at)));
    return false;
  };
  for (std::size_t t = 0; t < crack.tubes.size(); ++t) {
    if (crack.tubes[t].closed) {
      continue;
    }
    const std::size_t next = request.fronts[t].next;
    const Vec3 back = -(frame.axes * crack.tubes[t].stations.back().m);
    const TraceResult traced = trace_crack_plane(surface, crack_reference_plane(*request.crack),
                                                 corner(t, 1), corner(next, 0), back);
    if (traced.trouble) {
      return fail(traced.trouble);
    }
    crack.mouths.push_back({t, next, divide_trace_by_size(traced.trace.front(), size)});
  }
  for (const BodyHoleInCrack& hole : request.holes) {
    const TraceResult traced = trace_crack_plane(surface, crack_reference_plane(*request.crack),
                                                 hole.from, hole.from, hole.towards);
    if (traced.trouble) {
      return fail(traced.trouble);
    }
    crack.holes.push_back(divide_trace_by_size(traced.trace.front(), size));
  }
  return true;
}

} // namespace

std::optional<PatchSolidCrack> place_tubes_and_mouths(const SolidHostMesh& host,
                                                      const CrackFrame& frame,
                                                      const LocatedSolidCrack& request,
                                                      std::span<const LocatedSolidCrack> all,
                                                      base::Diagnostics& diagnostics) {
  auto crack = TubePlacement(host, frame, request, diagnostics).place(all);
  return crack && divide_crack_mouths(host, frame, request, *crack, diagnostics) ? std::move(crack)
                                                                                 : std::nullopt;
}

} // namespace spricka::mesh
