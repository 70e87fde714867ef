// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_mouths.hpp"

#include <fmt/format.h>

namespace spricka::mesh {

using base::Vec3;

bool divide_crack_mouths(const SolidHostMesh& host, const CrackFrame& frame,
                         const LocatedSolidCrack& request, PatchSolidCrack& crack,
                         base::Diagnostics& diagnostics) {
  const SurfaceGeometry& surface = host.body_surface(request.seed).geometry();
  const auto size = [&](const Vec3& x) {
    return frame.a *
           size_at_front_distance(crack.reach.distance(frame.rounded_local_coordinates(x)),
                                  CrackDistanceField::usual_growth / crack.finer) /
           crack.finer;
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
    crack.mouths.push_back({t, next, divide(traced.trace.front(), size)});
  }
  for (const BodyHoleInCrack& hole : request.holes) {
    const TraceResult traced = trace_crack_plane(surface, crack_reference_plane(*request.crack),
                                                 hole.from, hole.from, hole.towards);
    if (traced.trouble) {
      return fail(traced.trouble);
    }
    crack.holes.push_back(divide(traced.trace.front(), size));
  }
  return true;
}

} // namespace spricka::mesh
