// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_patch.hpp"

#include "mesh/cut/patch_net.hpp"
#include "mesh/link/fill.hpp"
#include "mesh/plane.hpp"
#include "mesh/tube/crack_surface.hpp"
#include "mesh/tube/solid_cavity.hpp"
#include "mesh/tube/solid_front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

namespace spricka::mesh {
namespace {

using base::NodeId;
using base::Vec3;

/// [shell of the cavity] whether tubes end on it, or cracks in a hole; with `renew` all that have
/// free faces.
std::vector<bool> find_open_shells(const SolidHostMesh& host, const CrackFrame& frame,
                                   std::span<const PatchSolidCrack> cracks,
                                   const SolidCavity& cavity, bool renew) {
  std::vector<bool> open(cavity.shells.size(), false);
  std::set<model::Face> ends;
  for (const PatchSolidCrack& crack : cracks) {
    for (const DividedTrace& hole : crack.holes) {
      const BodySurface& body = host.body_surface(cavity.elements.front());
      for (const SurfacePlace& place : hole.mids) {
        ends.insert(body.face(place.face));
      }
    }
    for (const Tube& tube : crack.tubes) {
      for (const Tube::TubeEnd& end : tube.ends) {
        for (const int n : end.corner) {
          const BodySurface& body = host.body_surface(cavity.elements.front());
          const Vec3 x = frame.global(tube.x[static_cast<std::size_t>(n)]);
          ends.insert(body.face(body.geometry().nearest_place(x).face));
        }
      }
    }
  }
  for (std::size_t s = 0; s < open.size(); ++s) {
    open[s] = std::ranges::any_of(cavity.shells[s], [&](const CavityFace& face) {
      return ends.contains(face.face) || (renew && face.free);
    });
  }
  return open;
}

/// A loop, and the holes within.
std::vector<std::vector<int>> with_holes(const std::vector<int>& loop,
                                         const std::vector<std::vector<int>>& holes,
                                         const PlaneBasis& plane, const PatchMeshBuilder& net) {
  std::vector<base::Vec2> polygon;
  polygon.reserve(loop.size());
  for (const int n : loop) {
    polygon.push_back(plane.project(net.local_position(n)));
  }
  std::vector<std::vector<int>> loops{loop};
  std::ranges::copy_if(holes, std::back_inserter(loops), [&](const std::vector<int>& hole) {
    return is_inside_polygon(plane.project(net.local_position(hole.front())), polygon);
  });
  return loops;
}

/// Nodes along the tubes and mouths of a crack, round and round; `mouths`: nodes between tubes.
std::vector<std::vector<int>> loops_of(const PatchSolidCrack& crack,
                                       const std::vector<TubeNodesInPatch>& tubes,
                                       const std::vector<std::vector<int>>& mouths) {
  std::vector<std::vector<int>> loops;
  std::vector<bool> done(crack.tubes.size(), false);
  for (std::size_t first = 0; first < done.size(); ++first) {
    std::vector<int> loop;
    for (std::size_t t = first; !done[t];) {
      done[t] = true;
      for (const int n : crack.tubes[t].upper) {
        loop.push_back(tubes[t].node[static_cast<std::size_t>(n)]);
      }
      const auto mouth = std::ranges::find(crack.mouths, t, &CrackMouth::from);
      if (mouth != crack.mouths.end()) {
        const auto& nodes = mouths[static_cast<std::size_t>(mouth - crack.mouths.begin())];
        loop.insert(loop.end(), nodes.begin(), nodes.end());
        t = mouth->to;
      }
    }
    if (!loop.empty()) {
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

/// Folded elements are the trouble of a patch.
void look_at_elements(const PatchMeshBuilder& net, SolidPatch& patch) {
  const std::vector<InvalidElement> folded = find_folded_elements(net.nodes, net.elements);
  if (!folded.empty()) {
    patch.folded = true;
    std::set<NodeId> of_host;
    for (const InvalidElement& bad : folded) {
      for (const int n : net.elements[bad.element.index()].nodes) {
        of_host.insert(net.nodes[static_cast<std::size_t>(n)].host);
      }
    }
    of_host.erase(NodeId());
    patch.folded_at.assign(of_host.begin(), of_host.end());
    const InvalidElement& worst = most_folded_element(folded);
    patch.trouble = fmt::format("{} elements are folded, a {} at {}", folded.size(),
                                base::element_info(net.elements[worst.element.index()].type).name,
                                coordinate_text(worst.at));
  }
}

class PatchBuilder {
public:
  PatchBuilder(const SolidHostMesh& host, const CrackFrame& frame,
               std::span<const PatchSolidCrack> cracks, const SolidCavity& cavity,
               BodySurfaceTreatment request)
      : host_(host), frame_(frame), cracks_(cracks), cavity_(cavity), request_(request),
        net_(host.mesh(), frame) {}

  SolidPatch build() {
    patch_.cracks.resize(cracks_.size());
    make_shells();
    for (std::size_t c = 0; c < cracks_.size() && patch_.trouble.empty(); ++c) {
      make_crack(c);
    }
    if (patch_.trouble.empty()) {
      fill_rest();
    }
    if (patch_.trouble.empty()) {
      open_cracks();
    }
    if (patch_.trouble.empty()) {
      promote();
      move_quarters();
      choose_edge_ends_by_crack_side(net_.elements, patch_.edges);
      look_at_elements(net_, patch_);
    }
    net_.move_into_patch(patch_);
    return std::move(patch_);
  }

private:
  /// Shells of the cavity that a tube ends on are joined by it, and their free faces meshed anew.
  void make_shells() {
    const std::vector<bool> open =
        find_open_shells(host_, frame_, cracks_, cavity_, request_.renew);
    const std::vector<bool> removed =
        model::mark_members(host_.mesh().element_count(), cavity_.elements);
    std::vector<PatchTriangle> joined;
    std::vector<CavityFace> free;
    for (std::size_t s = 0; s < cavity_.shells.size(); ++s) {
      std::vector<CavityFace> faces = cavity_.shells[s];
      patch_.old_surface =
          patch_.old_surface || (!open[s] && std::ranges::any_of(faces, &CavityFace::free));
      if (open[s]) {
        std::ranges::copy_if(faces, std::back_inserter(free), &CavityFace::free);
        std::erase_if(faces, [](const CavityFace& face) { return face.free; });
      }
      std::vector<PatchTriangle> shell =
          triangulate_cavity_shell(host_, removed, faces, net_, patch_.faces);
      if (open[s]) {
        joined.insert(joined.end(), shell.begin(), shell.end());
      } else {
        shells_.push_back(std::move(shell));
      }
    }
    rims_ = shells_;
    rims_.push_back(joined);
    for (std::size_t c = 0; c < cracks_.size(); ++c) {
      place_tubes_of(c, joined);
    }
    mouths_.resize(cracks_.size());
    holes_.resize(cracks_.size());
    if (!free.empty()) {
      RemeshedMouthSurface surface =
          mesh_mouth_surface({host_.body_surface(cavity_.elements.front()), frame_, cracks_, tubes_,
                              std::move(free), request_.borders},
                             net_, lower_, patch_.faces);
      patch_.trouble = surface.trouble;
      patch_.at_border = surface.at_border;
      patch_.shifts = std::move(surface.shifts);
      patch_.edges = std::move(surface.edges);
      mouths_ = std::move(surface.mouths);
      holes_ = std::move(surface.holes);
      joined.insert(joined.end(), surface.triangles.begin(), surface.triangles.end());
    }
    if (!joined.empty()) {
      // What tubes join has the outermost shell, but where they end in a hollow inside.
      shells_.insert(open.front() ? shells_.begin() : shells_.end(), std::move(joined));
    }
  }

  /// Open tubes are part of the shell that they join, closed ones have shells of their own.
  void place_tubes_of(std::size_t c, std::vector<PatchTriangle>& joined) {
    SolidPatch::OpenedPatchCrack& made = patch_.cracks[c];
    std::vector<TubeNodesInPatch>& laid = tubes_.emplace_back();
    for (const Tube& tube : cracks_[c].tubes) {
      const std::size_t first = net_.elements.size();
      std::vector<PatchTriangle> shell;
      laid.push_back({add_tube_to_patch(tube, net_, shell), first});
      if (tube.closed && !tube.free) {
        shells_.push_back(std::move(shell));
      } else {
        joined.insert(joined.end(), shell.begin(), shell.end());
      }
      const auto at = [&](int n) { return laid.back().node[static_cast<std::size_t>(n)]; };
      for (const auto& [upper, lower] : tube.twins) {
        made.twins.emplace_back(at(upper), at(lower));
      }
      for (const Tube::TubeElementSide& side : tube.upper_sides) {
        made.upper.push_back({first + side.element, side.side});
      }
      for (const Tube::TubeElementSide& side : tube.lower_sides) {
        made.lower.push_back({first + side.element, side.side});
      }
      std::vector<int>& front = made.fronts.emplace_back();
      std::ranges::transform(tube.front, std::back_inserter(front), at);
      if (tube.free) {
        free_.insert(front.begin(), front.end());
        if (tube.quarter_point) {
          quarter_.insert(front.begin(), front.end());
        }
      }
      for (std::size_t i = 0; i < tube.upper.size() && !tube.free; ++i) {
        lower_[at(tube.upper[i])] = at(tube.lower[i]);
      }
    }
  }

  /// The faces of a crack between its tubes and mouths.
  void make_crack(std::size_t c) {
    const PatchSolidCrack& crack = cracks_[c];
    SolidPatch::OpenedPatchCrack& made = patch_.cracks[c];
    for (std::size_t m = 0; m < mouths_[c].size(); ++m) {
      const CrackMouth& mouth = crack.mouths[m];
      if (mouths_[c][m].empty() && (crack.tubes[mouth.from].free || crack.tubes[mouth.to].free)) {
        patch_.trouble = "its mouth is shorter than two elements";
        return;
      }
    }
    for (const auto* lips : {&mouths_[c], &holes_[c]}) {
      for (const std::vector<int>& nodes : *lips) {
        for (const int n : nodes) {
          made.twins.emplace_back(n, lower_.at(n));
        }
      }
    }
    std::vector<PatchTriangle>& faces = faces_.emplace_back();
    for (const std::vector<int>& loop : loops_of(crack, tubes_[c], mouths_[c])) {
      CrackTriangulation surface = triangulate_crack_area(
          crack.reach, with_holes(loop, holes_[c], crack.reach.plane(), net_), crack.fill, net_);
      if (!surface.trouble.empty()) {
        patch_.trouble = "its faces: " + surface.trouble;
        return;
      }
      divide_front_chord_edges(crack.reach.plane(), free_, net_, surface);
      for (const int n : surface.nodes) {
        if (!lower_.contains(n) && !free_.contains(n)) {
          lower_[n] = net_.duplicate_node(n);
          made.twins.emplace_back(n, lower_[n]);
        }
      }
      faces.insert(faces.end(), surface.triangles.begin(), surface.triangles.end());
    }
  }

  void fill_rest() {
    SolidRegion region;
    std::vector<int> place(net_.nodes.size(), -1); // patch node -> point
    std::vector<int> node;                         // and back
    const auto points = [&](const std::vector<PatchTriangle>& triangles) {
      std::vector<PatchTriangle> result;
      for (const PatchTriangle& t : triangles) {
        PatchTriangle& made = result.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
          int& p = place[static_cast<std::size_t>(t[i])];
          if (p < 0) {
            p = static_cast<int>(node.size());
            node.push_back(t[i]);
            region.points.push_back(net_.local_position(t[i]));
          }
          made[i] = p;
        }
      }
      return result;
    };
    for (const auto& shell : shells_) {
      region.boundaries.push_back(points(shell));
    }
    for (const auto& faces : faces_) {
      region.embedded.push_back(points(faces));
    }
    const TetrahedronFill filling =
        fill_tetrahedra(region, solid_patch_grading(cracks_, rims_, net_));
    patch_.trouble = filling.trouble;
    for (const Vec3& p : filling.added) {
      node.push_back(net_.add_node_at_local_position(p));
    }
    for (const std::array<int, 4>& t : filling.cells) {
      std::array<int, 4> corners{};
      std::ranges::transform(t, corners.begin(),
                             [&](int n) { return node[static_cast<std::size_t>(n)]; });
      tetrahedra_.push_back(corners);
    }
  }

  void open_cracks() {
    std::vector<PatchTriangle> all;
    for (const auto& faces : faces_) {
      all.insert(all.end(), faces.begin(), faces.end());
    }
    const CrackSidesInFill split = open_crack_in_fill(net_, all, lower_, tetrahedra_);
    patch_.trouble = split.trouble;
    const std::size_t first = net_.elements.size();
    std::size_t k = 0;
    for (std::size_t c = 0; c < faces_.size() && split.trouble.empty(); ++c) {
      for (std::size_t i = 0; i < faces_[c].size(); ++i, ++k) {
        patch_.cracks[c].upper.push_back({first + split.upper[k].tetrahedron, split.upper[k].side});
        patch_.cracks[c].lower.push_back({first + split.lower[k].tetrahedron, split.lower[k].side});
      }
    }
  }

  void promote() {
    for (const std::array<int, 4>& t : tetrahedra_) {
      net_.add_element(base::ElementType::tet10, t);
    }
    for (std::size_t c = 0; c < faces_.size(); ++c) {
      std::set<int> known;
      for (const auto& [upper, lower] : patch_.cracks[c].twins) {
        known.insert(upper);
      }
      const auto below = [&](int n) { return free_.contains(n) ? n : lower_.at(n); };
      for (const PatchTriangle& t : faces_[c]) {
        for (std::size_t i = 0; i < 3; ++i) {
          const int a = t[i];
          const int b = t[(i + 1) % 3];
          const int upper = net_.find_or_add_mid_node(a, b);
          if (known.insert(upper).second) {
            patch_.cracks[c].twins.emplace_back(upper,
                                                net_.find_or_add_mid_node(below(a), below(b)));
          }
        }
      }
    }
  }

  void move_quarters() {
    if (quarter_.empty()) {
      return;
    }
    std::vector<std::pair<int, int>> twins;
    for (const SolidPatch::OpenedPatchCrack& crack : patch_.cracks) {
      twins.insert(twins.end(), crack.twins.begin(), crack.twins.end());
    }
    patch_.quarters = move_mid_nodes_to_quarters(net_, quarter_, twins);
  }

  const SolidHostMesh& host_;
  const CrackFrame& frame_;
  std::span<const PatchSolidCrack> cracks_;
  const SolidCavity& cavity_;
  BodySurfaceTreatment request_;
  PatchMeshBuilder net_;
  SolidPatch patch_;
  std::vector<std::vector<PatchTriangle>> shells_;    ///< closed, the outermost first
  std::vector<std::vector<PatchTriangle>> rims_;      ///< of them, what the host gives
  std::vector<std::vector<TubeNodesInPatch>> tubes_;  ///< [crack]
  std::vector<std::vector<std::vector<int>>> mouths_; ///< [crack][mouth] nodes between tubes
  std::vector<std::vector<std::vector<int>>> holes_;  ///< [crack][hole] nodes all round
  std::vector<std::vector<PatchTriangle>> faces_;     ///< [crack] between its tubes
  std::set<int> free_;                                ///< corner nodes of free fronts
  std::set<int> quarter_;                             ///< of them, with quarter points
  std::unordered_map<int, int> lower_;                ///< second nodes of those on cracks
  std::vector<std::array<int, 4>> tetrahedra_;
};

} // namespace

SolidPatch mesh_solid_cavity(const SolidHostMesh& host, const CrackFrame& frame,
                             std::span<const PatchSolidCrack> cracks, const SolidCavity& cavity,
                             BodySurfaceTreatment request) {
  return PatchBuilder(host, frame, cracks, cavity, request).build();
}

} // namespace spricka::mesh
