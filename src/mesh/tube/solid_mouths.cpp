// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_mouths.hpp"

#include <fmt/format.h>

namespace spricka::mesh {

using base::Vec3;

bool find_mouths(const SolidHost& host, const SolidFrame& frame, const SolidRequest& request,
                 PatchSolidCrack& crack, base::Diagnostics& diagnostics) {
  const SurfaceGeometry& surface = host.surface(request.seed).geometry();
  const auto size = [&](const Vec3& x) {
    return frame.a *
           size_at(crack.reach.distance(frame.local(x)), CrackReach::usual_growth / crack.finer) /
           crack.finer;
  };
  const auto corner = [&](std::size_t tube, std::size_t end) {
    const Tube& t = crack.tubes[tube];
    const int node = end == 0 ? t.lower.corner.front() : t.lower.corner.back();
    return surface.nearest(frame.global(t.x[static_cast<std::size_t>(node)]));
  };
  const auto fail = [&](const SurfaceTrouble& trouble) {
    diagnostics.error(request.span, "E425",
                      fmt::format("{}: its mouth cannot be followed: {}, at {}",
                                  request.crack->title(), trouble.why, text_of(trouble.at)));
    return false;
  };
  for (std::size_t t = 0; t < crack.tubes.size(); ++t) {
    if (crack.tubes[t].closed) {
      continue;
    }
    const std::size_t next = request.fronts[t].next;
    const Vec3 back = -(frame.axes * crack.tubes[t].stations.back().m);
    const Traced traced =
        trace(surface, plane_of(*request.crack), corner(t, 1), corner(next, 0), back);
    if (traced.trouble) {
      return fail(traced.trouble);
    }
    crack.mouths.push_back({t, next, divide(traced.trace.front(), size)});
  }
  for (const SolidHole& hole : request.holes) {
    const Traced traced =
        trace(surface, plane_of(*request.crack), hole.from, hole.from, hole.towards);
    if (traced.trouble) {
      return fail(traced.trouble);
    }
    crack.holes.push_back(divide(traced.trace.front(), size));
  }
  return true;
}

} // namespace spricka::mesh
