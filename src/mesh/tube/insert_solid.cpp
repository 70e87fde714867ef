// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/insert_solid.hpp"

#include "mesh/tube/crack_extent.hpp"
#include "mesh/tube/place_crack.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "mesh/tube/solid_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec3;

/// Patches of all groups in the host's mesh, with the places of their nodes and elements noted.
CrackedMesh graft_groups(const SolidHostMesh& host, const std::vector<LocatedSolidCrack>& requests,
                         std::vector<CavityCrackGroup>& groups) {
  std::vector<PatchGraft> grafts;
  for (const CavityCrackGroup& group : groups) {
    const std::vector<ElementId>& elements = group.cavity.elements;
    // Where all of them are in the same sets, whatever is of some is of all.
    const bool uniform = find_sets_cut_by_cavity(host, group.cavity).empty();
    grafts.push_back({group.patch, elements, [&host, &elements, uniform](const PatchNode& middle) {
                        return uniform ? elements.front()
                                       : host.nearest_element(elements, middle.x);
                      }});
  }
  GraftedMesh grafted = graft_patches(host.mesh(), grafts);
  CrackedMesh result = std::move(grafted.cracked);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].placed = std::move(grafted.patches[g]);
    add_patch_ties(groups[g].patch, groups[g].placed,
                   requests[groups[g].members.front()].crack->crack, result);
  }
  return result;
}

void add_faces(const CavityCrackGroup& group, std::size_t c, CrackedMesh& result) {
  const SolidPatch::OpenedPatchCrack& crack = group.patch.cracks[c];
  CrackFaceNodes& faces = result.faces.emplace_back();
  for (const auto& [upper, lower] : crack.twins) {
    faces.left.push_back(group.placed.node_in_mesh(upper));
    faces.right.push_back(group.placed.node_in_mesh(lower));
  }
  const auto side = [&](const SolidPatch::PatchElementSide& s) {
    return model::Face{group.placed.element[s.element], s.side};
  };
  std::ranges::transform(crack.upper, std::back_inserter(faces.left_sides), side);
  std::ranges::transform(crack.lower, std::back_inserter(faces.right_sides), side);
}

void add_fronts(const LocatedSolidCrack& request, const CavityCrackGroup& group, std::size_t c,
                CrackedMesh& result) {
  const SolidCrack& crack = *request.crack;
  const double unit = group.frame.a;
  for (std::size_t t = 0; t < group.cracks[c].tubes.size(); ++t) {
    const Tube& tube = group.cracks[c].tubes[t];
    CrackFront front;
    front.crack = crack.crack;
    front.number = static_cast<int>(t) + 1;
    front.kind = classify_crack(request);
    front.a = make_crack_frame(crack).a;
    front.size = unit * *std::ranges::min_element(tube.size);
    front.radius = unit * *std::ranges::min_element(tube.radius);
    front.points.clear();
    const std::size_t n = tube.stations.size();
    for (std::size_t k = 0; k < n; ++k) {
      FrontPoint& point = front.points.emplace_back();
      point.node = group.placed.node_in_mesh(group.patch.cracks[c].fronts[t][k]);
      point.x = result.mesh.x[point.node.index()];
      point.size = unit * tube.size[k];
      point.radius = unit * tube.radius[k];
      point.at_surface = !tube.closed && (k == 0 || k + 1 == n);
    }
    front.curve = fit_front_curve(front, crack);
    recompute_front_point_geometry(result.mesh, front);
    result.notes.push_back(front_mesh_note(request, group, {c, t}, front));
    result.fronts.push_back(std::move(front));
  }
}

class SolidInserter {
public:
  SolidInserter(const SolidHostMesh& host, base::Diagnostics& diagnostics)
      : host_(host), diagnostics_(diagnostics) {}

  std::optional<CrackedMesh> insert(std::span<const SolidCrack> cracks,
                                    std::span<const TubeMeshParameters> tubes,
                                    std::span<const base::SourceSpan> spans) {
    bool good = true;
    tubes_.assign(tubes.begin(), tubes.end());
    why_free_.resize(cracks.size());
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      requests_.push_back({&cracks[i], &tubes_[i], spans[i]});
      good = locate_crack_in_host(host_, requests_.back(), diagnostics_) && good;
      groups_.push_back({{i}});
    }
    // Each stage looks at all cracks before it fails, so that one run tells all that is wrong.
    if (!good || !mesh_groups()) {
      return std::nullopt;
    }
    CrackedMesh result = graft_groups(host_, requests_, groups_);
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      for (const CavityCrackGroup& group : groups_) {
        const auto at = std::ranges::find(group.members, i);
        if (at != group.members.end()) {
          const auto c = static_cast<std::size_t>(at - group.members.begin());
          add_faces(group, c, result);
          add_fronts(requests_[i], group, c, result);
        }
      }
    }
    return result;
  }

private:
  /// Cavities of all groups; those that want the same elements become one, and all begin anew.
  bool build_cavities() {
    for (bool more = true; more;) {
      more = false;
      std::vector<std::size_t> owner(host_.mesh().element_count(), groups_.size());
      for (std::size_t g = 0; g < groups_.size() && !more; ++g) {
        if (!build_cavities(groups_[g])) {
          return false;
        }
        for (const ElementId e : groups_[g].cavity.elements) {
          if (owner[e.index()] < g) {
            join(owner[e.index()], g);
            more = true;
            break;
          }
          owner[e.index()] = g;
        }
      }
    }
    return true;
  }

  void join(std::size_t a, std::size_t b) {
    std::vector<std::size_t>& members = groups_[a].members;
    members.insert(members.end(), groups_[b].members.begin(), groups_[b].members.end());
    std::sort(members.begin(), members.end());
    groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(b));
    for (CavityCrackGroup& group : groups_) {
      group = CavityCrackGroup{std::move(group.members)};
    }
  }

  bool build_cavities(CavityCrackGroup& group) {
    const LocatedSolidCrack& first = requests_[group.members.front()];
    group.frame = make_crack_frame(*first.crack);
    std::vector<CrackDistanceField> reach;
    std::vector<ElementId> seeds;
    bool good = true;
    for (const std::size_t i : group.members) {
      auto crack = place(group.frame, i);
      if (crack) {
        reach.push_back(crack->reach);
        seeds.push_back(requests_[i].seed);
        group.cracks.push_back(std::move(*crack));
      } else {
        good = false;
      }
    }
    if (good) {
      group.cavity = find_solid_cavity(host_, group.frame, reach, seeds);
      if (!group.cavity.trouble.empty()) {
        refuse(group, group.cavity.trouble);
        good = false;
      }
    }
    return good;
  }

  /// A crack with its tubes and mouths; without tubes where they do not fit.
  std::optional<PatchSolidCrack> place(const CrackFrame& frame, std::size_t i) {
    base::Diagnostics found;
    std::optional<PatchSolidCrack> crack =
        place_tubes_and_mouths(host_, frame, requests_[i], requests_, found);
    if (!crack && grow_slower(tubes_[i].growth)) {
      return place(frame, i);
    }
    if (!crack && may_be_free(i)) {
      base::Diagnostics without;
      tubes_[i].tube = false;
      crack = place_tubes_and_mouths(host_, frame, requests_[i], requests_, without);
      tubes_[i].tube = !crack;
      if (crack) {
        const std::string title = requests_[i].crack->display_name() + ": ";
        const std::string& why = found.messages().front().text;
        why_free_[i] = why.starts_with(title) ? why.substr(title.size()) : why;
      }
    }
    for (const base::Diagnostic& d : crack ? std::vector<base::Diagnostic>() : found.messages()) {
      diagnostics_.error(d.span, d.code, d.text, d.hint);
    }
    return crack;
  }

  /// A radius that the deck gives is for a tube: where it does not fit another is wanted.
  [[nodiscard]] bool may_be_free(std::size_t i) const {
    return tubes_[i].tube && tubes_[i].radius <= 0.0;
  }

  /// Sizes that grow as usual; false if they do.
  static bool grow_slower(double& growth) {
    const bool wide = growth > TubeMeshParameters::usual_growth;
    growth = std::min(growth, TubeMeshParameters::usual_growth);
    return wide;
  }
  static bool grow_slower(std::vector<PatchSolidCrack>& cracks) {
    bool any = false;
    for (PatchSolidCrack& crack : cracks) {
      any = grow_slower(crack.fill.growth) || any;
    }
    return any;
  }
  bool grow_slower(const CavityCrackGroup& group) {
    bool any = false;
    for (const std::size_t i : group.members) {
      any = grow_slower(tubes_[i].growth) || any;
    }
    return any;
  }

  /// Where no patch can be made with sizes that grow fast it is tried with usual ones, and then
  /// without tubes. Cavities then are others, too: all begins anew.
  bool mesh_groups() {
    for (bool more = true; more;) {
      if (!build_cavities()) {
        return false;
      }
      more = false;
      bool good = true;
      for (CavityCrackGroup& group : groups_) {
        make_patch(group);
        const std::string& trouble = group.patch.trouble;
        good = good && trouble.empty();
        more = (!trouble.empty() && (grow_slower(group) || free_fronts(group, trouble))) || more;
      }
      for (CavityCrackGroup& group : groups_) {
        if (more) {
          group = CavityCrackGroup{std::move(group.members)};
        } else if (!group.patch.trouble.empty()) {
          refuse(group, group.patch.trouble);
        } else if (good) {
          warn_of_moved_set_borders(host_, requests_, group, diagnostics_);
        }
      }
      if (!good && !more) {
        return false;
      }
    }
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      tell_of_free(i);
    }
    return true;
  }

  /// Takes the tubes of a group away; false if there is none that may go.
  bool free_fronts(const CavityCrackGroup& group, const std::string& why) {
    bool any = false;
    for (const std::size_t i : group.members) {
      if (may_be_free(i)) {
        tubes_[i].tube = false;
        why_free_[i] = "no patch could be made with one: " + why;
        any = true;
      }
    }
    return any;
  }

  void tell_of_free(std::size_t i) {
    if (!why_free_[i].empty()) {
      diagnostics_.warning(
          requests_[i].span, "W423",
          fmt::format("{}: tetrahedra up to its front, as no tube of elements fits round it: {}",
                      requests_[i].crack->display_name(), why_free_[i]),
          "K along it is less exact: K1 scatters by 2 to 4 % from point to point and by 1.3 to 2.6 "
          "% "
          "as a smooth curve, where tubes have 0.5 % (manual/solid_crack.md)");
    }
  }

  /// Where a curved surface or a curved rim of the cavity folds elements there are three remedies:
  /// the surface meshed anew, a larger cavity, whose rim is others', and finer elements, which bend
  /// less.
  void make_patch(CavityCrackGroup& group) {
    constexpr double finer = 1.3;
    constexpr int most_finer = 2;
    SolidPatch& patch = group.patch;
    BodySurfaceTreatment request;
    bool renewed = false;
    bool widened = false;
    for (int refined = 0; refined <= most_finer;) {
      patch = mesh_solid_cavity(host_, group.frame, group.cracks, group.cavity, request);
      if (!patch.trouble.empty() && patch.at_border &&
          request.borders != SetBorderPreservation::none) {
        request.borders = request.borders == SetBorderPreservation::all
                              ? SetBorderPreservation::used
                              : SetBorderPreservation::none;
        continue;
      }
      if (!patch.folded && !(request.renew && !patch.trouble.empty())) {
        break;
      }
      request.renew = !renewed && patch.old_surface;
      renewed = renewed || request.renew;
      if (request.renew) {
        continue;
      }
      widened = refined > 0 && !widened && widen(group);
      if (!widened) {
        if (!grow_slower(group.cracks)) {
          ++refined;
          for (PatchSolidCrack& crack : group.cracks) {
            crack.fill.finer *= finer;
          }
        }
      }
    }
  }

  /// Takes in the elements behind folded ones, but not those of other groups.
  bool widen(CavityCrackGroup& group) {
    std::vector<ElementId> seeds;
    std::vector<CrackDistanceField> reach;
    for (std::size_t i = 0; i < group.members.size(); ++i) {
      seeds.push_back(requests_[group.members[i]].seed);
      reach.push_back(group.cracks[i].reach);
    }
    const SolidCavity& before = group.cavity;
    seeds.insert(seeds.end(), before.elements.begin(), before.elements.end());
    for (const NodeId n : group.patch.folded_at) {
      const auto around = host_.elements_around(n);
      seeds.insert(seeds.end(), around.begin(), around.end());
    }
    SolidCavity cavity = find_solid_cavity(host_, group.frame, reach, seeds);
    const auto has = [](const CavityCrackGroup& other, ElementId e) {
      return std::ranges::binary_search(other.cavity.elements, e);
    };
    const bool free = std::ranges::none_of(groups_, [&](const CavityCrackGroup& other) {
      return &other != &group &&
             std::ranges::any_of(cavity.elements, [&](ElementId e) { return has(other, e); });
    });
    if (!free || !cavity.trouble.empty() || cavity.elements.size() == before.elements.size()) {
      return false;
    }
    group.cavity = std::move(cavity);
    return true;
  }

  void refuse(const CavityCrackGroup& group, const std::string& why) {
    const std::size_t first = group.members.front();
    diagnostics_.error(requests_[first].span, "E429",
                       fmt::format("no patch could be made round {}: {}",
                                   crack_group_title(requests_, group), why),
                       why_free_[first].empty()
                           ? std::string()
                           : "nor does a tube of elements fit: " + why_free_[first]);
  }

  const SolidHostMesh& host_;
  base::Diagnostics& diagnostics_;
  std::vector<TubeMeshParameters> tubes_; ///< [crack]
  std::vector<std::string> why_free_;     ///< [crack] why it has no tube, if not by the deck's wish
  std::vector<LocatedSolidCrack> requests_;
  std::vector<CavityCrackGroup> groups_;
};

} // namespace

std::optional<CrackedMesh> insert_solid_cracks(const SolidHostMesh& host,
                                               std::span<const SolidCrack> cracks,
                                               std::span<const TubeMeshParameters> tubes,
                                               std::span<const base::SourceSpan> spans,
                                               base::Diagnostics& diagnostics) {
  assert(cracks.size() == tubes.size() && cracks.size() == spans.size());
  return SolidInserter(host, diagnostics).insert(cracks, tubes, spans);
}

} // namespace spricka::mesh
