// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace spricka::mesh {
namespace {

std::string what_and_where(const SolidCrack& crack, const CrackFront& front) {
  return fmt::format(
      "{}: as large as a circle of radius {:.4g}, {}, front of length {:.6g}", crack.display_name(),
      front.a,
      front.kind == CrackConfiguration::embedded
          ? "embedded, inside the body"
          : fmt::format("a {} crack, from surface to surface", configuration_name(front.kind)),
      front.curve->length());
}

std::string patch_of(const CavityCrackGroup& group) {
  return fmt::format("patch of {} elements for {} of the net{}", group.patch.elements.size(),
                     group.cavity.elements.size(),
                     group.members.size() > 1 ? ", shared with others" : "");
}

/// "1" or "1 to 2".
std::string range_text(double least, double most, const char* number) {
  const auto text = [&](double x) { return fmt::format(fmt::runtime(number), x); };
  return most > 1.001 * least ? text(least) + " to " + text(most) : text(least);
}

std::string free_text(const CavityCrackGroup& group, const Tube& tube) {
  const auto [finest, coarsest] = std::ranges::minmax(tube.size);
  const QuarterPointCounts& quarters = group.patch.quarters;
  std::string mids = "mid nodes in the middle";
  if (tube.quarter_point) {
    mids = fmt::format("mid nodes at a quarter of {} edges from it", quarters.moved);
    mids += quarters.left > 0 ? fmt::format(", in the middle of {}", quarters.left) : "";
  }
  return fmt::format(
      "{} edges of tetrahedra and no tube (K1 scatters by 2 to 4 %), elements of {} at it, {}",
      tube.front_mid.size(), range_text(group.frame.a * finest, group.frame.a * coarsest, "{:.3g}"),
      mids);
}

} // namespace

void warn_of_moved_set_borders(const SolidHostMesh& host,
                               std::span<const LocatedSolidCrack> requests,
                               const CavityCrackGroup& group, base::Diagnostics& diagnostics) {
  const LocatedSolidCrack& first = requests[group.members.front()];
  const auto name = [](const std::string& set) {
    return set.empty() ? std::string("a set") : "the set " + set;
  };
  for (const SetBorderShift& shift : group.patch.shifts) {
    diagnostics.warning(
        first.span, "W425",
        fmt::format("{}: its elements cover the border of {} at {} and move it by up to {:.3g}: "
                    "what is loaded or held there is a little another part of the surface",
                    first.crack->display_name(), name(shift.set), coordinate_text(shift.at),
                    shift.by),
        "let the border keep off the end of the front, or give a smaller RADIUS on $TIPNET");
  }
  for (const SetCutByCavity& set : find_sets_cut_by_cavity(host, group.cavity)) {
    if (!SetUsage::is_used(host.set_usage().elements, set.index)) {
      continue;
    }
    diagnostics.warning(
        first.span, "W425",
        fmt::format("{}: the border of {}, elements, runs through its patch near {}: there it "
                    "goes along new elements, up to one of them beside where it was",
                    first.crack->display_name(), name(set.name), coordinate_text(set.at)),
        "loads per volume and results of the set are off by as much");
  }
}

std::string crack_group_title(std::span<const LocatedSolidCrack> requests,
                              const CavityCrackGroup& group) {
  std::string names;
  for (const std::size_t i : group.members) {
    names += (names.empty() ? "" : ", ") + requests[i].crack->display_name();
  }
  for (const PatchSolidCrack& crack : group.cracks) {
    for (const Tube& tube : crack.tubes) {
      if (tube.free) {
        names += fmt::format(" (tetrahedra up to its front, {} edges long)", tube.front_mid.size());
        continue;
      }
      names += fmt::format(" (tube of radius {:.3g} to {:.3g}, {} elements long)",
                           group.frame.a * *std::ranges::min_element(tube.radius),
                           group.frame.a * *std::ranges::max_element(tube.radius),
                           tube.stations.size() - 1);
    }
  }
  return names;
}

std::string front_mesh_note(const LocatedSolidCrack& request, const CavityCrackGroup& group,
                            std::pair<std::size_t, std::size_t> at, const CrackFront& front) {
  const Tube& tube = group.cracks[at.first].tubes[at.second];
  const double widest = group.frame.a * *std::ranges::max_element(tube.radius);
  const std::string elements =
      tube.free ? free_text(group, tube)
                : fmt::format("{} elements, tube of radius {} with {} rings of {} sectors",
                              tube.closed ? tube.stations.size() : tube.stations.size() - 1,
                              range_text(front.radius, widest, "{:.6g}"), request.mesh->rings,
                              request.mesh->sectors);
  const std::string left_out =
      request.left_out
          ? fmt::format("; what its ellipse encloses elsewhere, as at {}, is no part of it",
                        coordinate_text(*request.left_out))
          : std::string();
  return fmt::format("{} with {}, {}{}", what_and_where(*request.crack, front), elements,
                     patch_of(group), left_out);
}

} // namespace spricka::mesh
