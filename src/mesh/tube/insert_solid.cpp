// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/insert_solid.hpp"

#include "mesh/tube/front_points.hpp"
#include "mesh/tube/lay_tubes.hpp"
#include "mesh/tube/solid_graft.hpp"
#include "mesh/tube/solid_mouths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec3;

/// Cracks that share a cavity, in the frame of the first.
struct Group {
  std::vector<std::size_t> members;
  SolidFrame frame{};
  std::vector<PatchSolidCrack> cracks{};
  SolidGraft graft{};
};

class SolidInserter {
public:
  SolidInserter(const SolidHost& host, base::Diagnostics& diagnostics)
      : host_(host), diagnostics_(diagnostics) {}

  std::optional<CrackedMesh> insert(std::span<const SolidCrack> cracks,
                                    std::span<const TubeMesh> tubes,
                                    std::span<const base::Span> spans) {
    bool good = true;
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      requests_.push_back({&cracks[i], &tubes[i], spans[i]});
      good = place_in_host(host_, requests_.back(), diagnostics_) && good;
      groups_.push_back({{i}});
    }
    // Each stage looks at all cracks before it fails, so that one run tells all that is wrong.
    if (!good || !dig() || !make_patches()) {
      return std::nullopt;
    }
    std::vector<SolidGraft> grafts;
    for (Group& group : groups_) {
      grafts.push_back(std::move(group.graft));
    }
    result_ = graft_solids(host_, grafts);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      groups_[g].graft = std::move(grafts[g]);
      tie(groups_[g]);
    }
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      finish(i);
    }
    return std::move(result_);
  }

private:
  /// Cavities of all groups; those that want the same elements become one, and all begin anew.
  bool dig() {
    for (bool more = true; more;) {
      more = false;
      std::vector<std::size_t> owner(host_.mesh().element_count(), groups_.size());
      for (std::size_t g = 0; g < groups_.size() && !more; ++g) {
        if (!dig(groups_[g])) {
          return false;
        }
        for (const ElementId e : groups_[g].graft.cavity.elements) {
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
    for (Group& group : groups_) {
      group = Group{std::move(group.members)};
    }
  }

  bool dig(Group& group) {
    const SolidRequest& first = requests_[group.members.front()];
    group.frame = frame_of(*first.crack);
    std::vector<CrackReach> reach;
    std::vector<ElementId> seeds;
    bool good = true;
    for (const std::size_t i : group.members) {
      auto crack = lay_tubes(host_, group.frame, requests_[i], requests_, diagnostics_);
      if (crack && find_mouths(host_, group.frame, requests_[i], *crack, diagnostics_)) {
        reach.push_back(crack->reach);
        seeds.push_back(requests_[i].seed);
        group.cracks.push_back(std::move(*crack));
      } else {
        good = false;
      }
    }
    if (good) {
      group.graft.cavity = find_solid_cavity(host_, group.frame, reach, seeds);
      if (!group.graft.cavity.trouble.empty()) {
        refuse(group, group.graft.cavity.trouble);
        good = false;
      }
    }
    return good;
  }

  bool make_patches() {
    bool good = true;
    for (Group& group : groups_) {
      make_patch(group);
      if (!group.graft.patch.trouble.empty()) {
        refuse(group, group.graft.patch.trouble);
        good = false;
      }
    }
    return good;
  }

  /// Where a curved surface or a curved rim of the cavity folds elements there are three remedies:
  /// the surface meshed anew, a larger cavity, whose rim is others', and finer elements, which bend
  /// less.
  void make_patch(Group& group) {
    constexpr double finer = 1.3;
    constexpr int most_finer = 2;
    SolidPatch& patch = group.graft.patch;
    PatchWish wish;
    bool renewed = false;
    bool widened = false;
    for (int refined = 0; refined <= most_finer;) {
      patch = build_solid_patch(host_, group.frame, group.cracks, group.graft.cavity, wish);
      if (!patch.trouble.empty() && patch.at_border && wish.borders != Borders::none) {
        wish.borders = wish.borders == Borders::all ? Borders::used : Borders::none;
        continue;
      }
      if (!patch.folded && !(wish.renew && !patch.trouble.empty())) {
        break;
      }
      wish.renew = !renewed && patch.old_surface;
      renewed = renewed || wish.renew;
      if (wish.renew) {
        continue;
      }
      widened = refined > 0 && !widened && widen(group);
      if (!widened) {
        ++refined;
        for (PatchSolidCrack& crack : group.cracks) {
          crack.finer *= finer;
        }
      }
    }
    if (patch.trouble.empty()) {
      tell_of_sets(group);
    }
  }

  void tell_of_sets(const Group& group) {
    const SolidRequest& first = requests_[group.members.front()];
    const auto name = [](const std::string& set) {
      return set.empty() ? std::string("a set") : "the set " + set;
    };
    for (const SetShift& shift : group.graft.patch.shifts) {
      diagnostics_.warning(
          first.span, "W425",
          fmt::format("{}: its elements cover the border of {} at {} and move it by up to {:.3g}: "
                      "what is loaded or held there is a little another part of the surface",
                      first.crack->title(), name(shift.set), text_of(shift.at), shift.by),
          "let the border keep off the end of the front, or give a smaller RADIUS on $TIPNET");
    }
    for (const SplitSet& set : split_sets(host_, group.graft.cavity)) {
      if (!SetUse::uses(host_.use().elements, set.index)) {
        continue;
      }
      diagnostics_.warning(
          first.span, "W425",
          fmt::format("{}: the border of {}, elements, runs through its patch near {}: there it "
                      "goes along new elements, up to one of them beside where it was",
                      first.crack->title(), name(set.name), text_of(set.at)),
          "loads per volume and results of the set are off by as much");
    }
  }

  /// Takes in the elements behind folded ones, but not those of other groups.
  bool widen(Group& group) {
    std::vector<ElementId> seeds;
    std::vector<CrackReach> reach;
    for (std::size_t i = 0; i < group.members.size(); ++i) {
      seeds.push_back(requests_[group.members[i]].seed);
      reach.push_back(group.cracks[i].reach);
    }
    const SolidCavity& before = group.graft.cavity;
    seeds.insert(seeds.end(), before.elements.begin(), before.elements.end());
    for (const NodeId n : group.graft.patch.folded_at) {
      const auto around = host_.around(n);
      seeds.insert(seeds.end(), around.begin(), around.end());
    }
    SolidCavity cavity = find_solid_cavity(host_, group.frame, reach, seeds);
    const auto has = [](const Group& other, ElementId e) {
      return std::ranges::binary_search(other.graft.cavity.elements, e);
    };
    const bool free = std::ranges::none_of(groups_, [&](const Group& other) {
      return &other != &group &&
             std::ranges::any_of(cavity.elements, [&](ElementId e) { return has(other, e); });
    });
    if (!free || !cavity.trouble.empty() || cavity.elements.size() == before.elements.size()) {
      return false;
    }
    group.graft.cavity = std::move(cavity);
    return true;
  }

  void refuse(const Group& group, const std::string& why) {
    std::string names;
    for (const std::size_t i : group.members) {
      names += (names.empty() ? "" : ", ") + requests_[i].crack->title();
    }
    for (const PatchSolidCrack& crack : group.cracks) {
      for (const Tube& tube : crack.tubes) {
        names += fmt::format(" (tube of radius {:.3g} to {:.3g}, {} elements long)",
                             group.frame.a * *std::ranges::min_element(tube.radius),
                             group.frame.a * *std::ranges::max_element(tube.radius),
                             tube.stations.size() - 1);
      }
    }
    diagnostics_.error(requests_[group.members.front()].span, "E429",
                       fmt::format("no patch could be made round {}: {}", names, why));
  }

  void tie(const Group& group) {
    const auto node = [&](int n) { return group.graft.node[static_cast<std::size_t>(n)]; };
    for (const SolidTie& tie : group.graft.patch.ties) {
      RimTie& made = result_.ties.emplace_back();
      made.slave = node(tie.slave);
      std::ranges::transform(tie.master, std::back_inserter(made.master), node);
      made.weight = tie.weight;
      made.crack = requests_[group.members.front()].crack->crack;
    }
  }

  void finish(std::size_t i) {
    for (const Group& group : groups_) {
      const auto at = std::ranges::find(group.members, i);
      if (at != group.members.end()) {
        const auto c = static_cast<std::size_t>(at - group.members.begin());
        add_faces(group, c);
        add_fronts(group, c);
      }
    }
  }

  void add_faces(const Group& group, std::size_t c) {
    const SolidPatch::Crack& crack = group.graft.patch.cracks[c];
    CrackFaces& faces = result_.faces.emplace_back();
    for (const auto& [upper, lower] : crack.twins) {
      faces.left.push_back(group.graft.node[static_cast<std::size_t>(upper)]);
      faces.right.push_back(group.graft.node[static_cast<std::size_t>(lower)]);
    }
    const auto side = [&](const SolidPatch::Side& s) {
      return model::Face{group.graft.element[s.element], s.side};
    };
    std::ranges::transform(crack.upper, std::back_inserter(faces.left_sides), side);
    std::ranges::transform(crack.lower, std::back_inserter(faces.right_sides), side);
  }

  void add_fronts(const Group& group, std::size_t c) {
    const SolidRequest& request = requests_[group.members[c]];
    const SolidCrack& crack = *request.crack;
    const double unit = group.frame.a;
    for (std::size_t t = 0; t < group.cracks[c].tubes.size(); ++t) {
      const Tube& tube = group.cracks[c].tubes[t];
      Front front;
      front.crack = crack.crack;
      front.number = static_cast<int>(t) + 1;
      front.kind = kind_of(group, c);
      front.a = frame_of(crack).a;
      front.size = unit * *std::ranges::min_element(tube.size);
      front.radius = unit * *std::ranges::min_element(tube.radius);
      front.curve = request.fronts[t].curve;
      front.points.clear();
      const std::size_t n = tube.stations.size();
      for (std::size_t k = 0; k < n; ++k) {
        FrontPoint& point = front.points.emplace_back();
        point.node =
            group.graft.node[static_cast<std::size_t>(group.graft.patch.cracks[c].fronts[t][k])];
        point.x = result_.mesh.x[point.node.index()];
        point.growth = group.frame.axes * tube.stations[k].m;
        point.s = unit * tube.stations[k].s;
        point.size = unit * tube.size[k];
        point.radius = unit * tube.radius[k];
        point.at_surface = !tube.closed && (k == 0 || k + 1 == n);
      }
      weigh_points(tube.closed, front);
      note(group, c, front, tube);
      result_.fronts.push_back(std::move(front));
    }
  }

  /// By the edges of the body that its mouth passes.
  [[nodiscard]] CrackKind kind_of(const Group& group, std::size_t c) const {
    const PatchSolidCrack& crack = group.cracks[c];
    const SurfaceGeometry& surface = host_.surface(requests_[group.members[c]].seed).geometry();
    std::ptrdiff_t passed = 0;
    for (const CrackMouth& mouth : crack.mouths) {
      passed += std::ranges::count_if(mouth.line.corners, [&](const LinePoint& corner) {
        return corner.edge != nowhere && !surface.edges()[corner.edge].border;
      });
    }
    const std::size_t mouths = crack.mouths.size() + crack.holes.size();
    return mouths == 0                ? CrackKind::embedded
           : mouths > 1 || passed > 1 ? CrackKind::through
           : passed == 1              ? CrackKind::corner
                                      : CrackKind::surface;
  }

  void note(const Group& group, std::size_t c, const Front& front, const Tube& tube) {
    const SolidRequest& request = requests_[group.members[c]];
    const double widest = group.frame.a * *std::ranges::max_element(tube.radius);
    result_.notes.push_back(fmt::format(
        "{}: as large as a circle of radius {:.4g}, {}, front of length {:.6g} with {} "
        "elements, tube of radius {:.6g}{} with {} rings of {} sectors, patch of {} elements for "
        "{} "
        "of the net{}",
        request.crack->title(), front.a,
        front.kind == CrackKind::embedded
            ? "embedded, inside the body"
            : fmt::format("a {} crack, from surface to surface", name_of(front.kind)),
        front.curve->length(), tube.closed ? tube.stations.size() : tube.stations.size() - 1,
        front.radius, widest > 1.001 * front.radius ? fmt::format(" to {:.6g}", widest) : "",
        request.mesh->rings, request.mesh->sectors, group.graft.patch.elements.size(),
        group.graft.cavity.elements.size(),
        group.members.size() > 1 ? ", shared with others" : ""));
  }

  const SolidHost& host_;
  base::Diagnostics& diagnostics_;
  std::vector<SolidRequest> requests_;
  std::vector<Group> groups_;
  CrackedMesh result_;
};

} // namespace

std::optional<CrackedMesh> insert_solid_cracks(const SolidHost& host,
                                               std::span<const SolidCrack> cracks,
                                               std::span<const TubeMesh> tubes,
                                               std::span<const base::Span> spans,
                                               base::Diagnostics& diagnostics) {
  assert(cracks.size() == tubes.size() && cracks.size() == spans.size());
  return SolidInserter(host, diagnostics).insert(cracks, tubes, spans);
}

std::optional<CrackedMesh> insert_solid_cracks(const model::Mesh& host,
                                               std::span<const SolidCrack> cracks,
                                               std::span<const TubeMesh> tubes,
                                               std::span<const base::Span> spans,
                                               base::Diagnostics& diagnostics) {
  return insert_solid_cracks(SolidHost(host), cracks, tubes, spans, diagnostics);
}

} // namespace spricka::mesh
