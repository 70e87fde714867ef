// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch.hpp"

#include "mesh/cut/cavity_check.hpp"
#include "mesh/cut/crack_check.hpp"
#include "mesh/cut/crack_face_sets.hpp"
#include "mesh/cut/graft.hpp"
#include "mesh/cut/patch_mesh.hpp"
#include "mesh/cut/patch_net.hpp"
#include "mesh/cut/path.hpp"
#include "mesh/cut/split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec2;
using base::Vec3;

/// A middle node this far from the quarter of its edge, and from the middle, is neither; at a
/// hundredth K has changed by 0.06 %.
constexpr double neither = 0.02;

/// A cavity and what fills it, in the frame of its first crack.
struct FilledCavity {
  Cavity cavity;
  CrackFrame frame;
  PlanePatch patch{};
};

/// Everything about one crack on its way into the mesh.
struct Work {
  const CrackLine* line = nullptr;
  const TipMeshParameters* tip = nullptr;
  base::SourceSpan span;
  std::size_t place = 0;  ///< with a patch: number of its placement,
  std::size_t cavity = 0; ///< of the cavity it is in
  std::size_t member = 0; ///< and which one of that cavity's cracks it is
  std::vector<NodeId> path;
};

class Inserter {
public:
  Inserter(const HostMesh& host, base::Diagnostics& diagnostics)
      : mesh_(host.mesh()), host_(host), diagnostics_(diagnostics) {}

  std::optional<CrackedMesh> insert(std::span<const CrackLine> lines,
                                    std::span<const TipMeshParameters> parameters,
                                    std::span<const base::SourceSpan> spans) {
    if (!check_crack_lines(lines, spans, diagnostics_)) {
      return std::nullopt;
    }
    bool good = true;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      Work& work = work_.emplace_back(Work{&lines[i], &parameters[i], spans[i], 0, 0, 0, {}});
      good = (parameters[i].patch ? find_place(work) : find_path(work)) && good;
    }
    // Each stage looks at all cracks before it fails, so that one run tells all that is wrong.
    if (!good || !rosettes_are_apart() || !cut() || !make_patches()) {
      return std::nullopt;
    }
    graft();
    tie_rims();
    if (!open_cracks()) {
      return std::nullopt;
    }
    return std::move(result_);
  }

private:
  bool find_path(Work& work) {
    if (!work.line->right_face_nodes.empty()) {
      work.path = work.line->path;
      return true;
    }
    auto path = find_crack_path_nodes(host_, *work.line, work.span, diagnostics_);
    if (path) {
      work.path = std::move(*path);
    }
    return path.has_value();
  }

  bool find_place(Work& work) {
    auto placement = place_crack_in_host(host_, *work.line, *work.tip, work.span, diagnostics_);
    if (placement) {
      work.place = placements_.size();
      placements_.push_back(std::move(*placement));
    }
    return placement.has_value();
  }

  /// Sizes that the deck gives may let rosettes reach other cracks or each other.
  bool rosettes_are_apart() {
    std::vector<CrackLine> lines;
    for (const Work& work : work_) {
      lines.push_back(*work.line);
    }
    bool good = true;
    for (const Work& work : work_) {
      const double room =
          work.tip->patch ? tip_clearance_to_cracks(*work.line, lines) : work.tip->radius;
      // Less than a half: two rosettes that face each other leave elements between them.
      if (work.tip->patch && work.tip->radius > 0.45 * room) {
        diagnostics_.error(
            work.span, "E423",
            fmt::format(
                "{}: a rosette of radius {:.6g} does not fit, another crack or another part "
                "of this one is {:.6g} from a tip",
                work.line->display_name(), work.tip->radius, room),
            "RADIUS of $TIPNET must be smaller than 0.45 of that");
        good = false;
      }
    }
    return good;
  }

  bool cut() {
    Cavities cavities = find_cavities(host_, placements_);
    std::vector<Work*> with_patch;
    for (Work& work : work_) {
      if (work.tip->patch) {
        with_patch.push_back(&work);
      }
    }
    bool good = true;
    for (std::size_t c = 0; c < cavities.each.size(); ++c) {
      const std::vector<std::size_t>& members = cavities.cracks[c];
      for (std::size_t m = 0; m < members.size(); ++m) {
        Work& work = *with_patch[members[m]];
        work.cavity = c;
        work.member = m;
        good = (members.size() == 1 || can_share(*with_patch[members.front()], work)) && good;
        good = check_crack_inside_cavity(host_, placements_[work.place], cavities.each[c],
                                         work.span, diagnostics_) &&
               good;
      }
      cavities_.push_back({std::move(cavities.each[c]), placements_[members.front()].frame});
    }
    return good;
  }

  /// A line of symmetry is meshed for one crack.
  bool can_share(const Work& first, const Work& work) {
    if (!work.line->symmetric_half && !first.line->symmetric_half) {
      return true;
    }
    if (&first != &work) {
      diagnostics_.error(
          work.span, "E428",
          fmt::format("the patches of {} and {} meet, on a line of symmetry",
                      first.line->display_name(), work.line->display_name()),
          "refine the net there, give a smaller RADIUS on $TIPNET, or model the body "
          "on both sides of the line");
    }
    return false;
  }

  bool make_patches() {
    bool good = true;
    for (std::size_t c = 0; c < cavities_.size(); ++c) {
      good = make_patch(c) && good;
    }
    return good;
  }

  /// Finer edges bend less: the remedy for elements that the host's curves fold.
  bool make_patch(std::size_t c) {
    FilledCavity& filled = cavities_[c];
    PlanePatch& patch = filled.patch;
    std::vector<PatchCrack> cracks;
    std::string names;
    base::SourceSpan span;
    for (const Work& work : work_) {
      if (work.tip->patch && work.cavity == c) {
        // All in the frame of the patch, that of its first crack.
        cracks.push_back({placement_in_frame(placements_[work.place], filled.frame), work.tip});
        span = names.empty() ? work.span : span;
        names += (names.empty() ? "" : ", ") + work.line->display_name();
      }
    }
    std::string trouble;
    for (const double fineness : {1.0, 2.0, 4.0}) {
      patch = mesh_plane_cavity(host_, cracks, filled.cavity, fineness);
      trouble = patch.trouble;
      if (trouble.empty()) {
        const std::vector<InvalidElement> folded =
            find_folded_elements(patch.nodes, patch.elements);
        if (folded.empty()) {
          return true;
        }
        const Vec3& at = most_folded_element(folded).at;
        trouble = fmt::format("an element at ({:.6g}, {:.6g}) is folded", at.x(), at.y());
      }
    }
    diagnostics_.error(span, "E429",
                       fmt::format("no patch could be made round {}: {}", names, trouble));
    return false;
  }

  void graft() {
    std::vector<PatchGraft> grafts;
    for (const FilledCavity& filled : cavities_) {
      const std::vector<ElementId>& elements = filled.cavity.elements;
      const auto outlines = std::make_shared<ElementOutlines>(mesh_, elements, filled.frame);
      grafts.push_back({filled.patch, elements, [&elements, outlines](const PatchNode& middle) {
                          // Rounded coordinates: round-off does not choose between two elements.
                          return elements[outlines->nearest_element_index(middle.local.head<2>())];
                        }});
    }
    GraftedMesh grafted = graft_patches(mesh_, grafts);
    result_ = std::move(grafted.cracked);
    placed_ = std::move(grafted.patches);
  }

  void tie_rims() {
    for (const Work& work : work_) {
      // The rim of a patch that several cracks share is tied once, in the name of the first.
      if (work.tip->patch && work.member == 0) {
        add_patch_ties(cavities_[work.cavity].patch, placed_[work.cavity], work.line->crack,
                       result_);
      }
    }
  }

  bool open_cracks() {
    for (Work& work : work_) {
      if (work.tip->patch) {
        for (const int n : cavities_[work.cavity].patch.paths[work.member]) {
          work.path.push_back(placed_[work.cavity].node_in_mesh(n));
        }
      }
      if (!work.line->right_face_nodes.empty()) {
        result_.faces.push_back({work.path, work.line->right_face_nodes});
      } else if (work.line->symmetric_half) {
        add_half_crack_face(work);
      } else if (auto crack_faces =
                     open_crack_along_path(result_.mesh, work.path, work.line->embedded)) {
        result_.faces.push_back(std::move(*crack_faces));
      } else {
        diagnostics_.error(
            work.span, "E427",
            fmt::format("{} does not start on the boundary", work.line->display_name()));
        return false;
      }
      add_fronts(work);
    }
    // Sets come after all cracks: several may double the nodes of one place.
    add_crack_face_nodes(result_.mesh, result_.faces);
    return true;
  }

  void add_half_crack_face(const Work& work) {
    CrackFaceNodes crack_faces;
    const bool left = work.tip->patch
                          ? placements_[work.place].half > 0
                          : is_body_on_left(host_, work.path[0], work.path[path_step(work)]);
    (left ? crack_faces.left : crack_faces.right) = work.path;
    result_.faces.push_back(std::move(crack_faces));
  }
  /// Places from one corner of a path without a patch to the next: 2 on quadratic edges.
  [[nodiscard]] std::size_t path_step(const Work& work) const {
    const auto around = host_.elements_around(work.path[0]);
    return base::element_info(mesh_.type[around.front().index()]).quadratic ? 2 : 1;
  }

  void add_fronts(const Work& work) {
    CrackFront front;
    front.crack = work.line->crack;
    front.a = make_crack_frame(*work.line).a;
    front.symmetric_half = work.line->symmetric_half;
    result_.notes.push_back(work.tip->patch ? add_patch_fronts(work, front)
                                            : add_own_fronts(work, front));
  }

  /// Adds a front of one point; the next of its crack has the next number.
  void add_front(CrackFront& front, NodeId node, const Vec3& growth) {
    front.points = {FrontPoint{.node = node, .x = result_.mesh.x[node.index()], .growth = growth}};
    result_.fronts.push_back(front);
    ++front.number;
  }

  std::string add_patch_fronts(const Work& work, CrackFront front) {
    const CrackPlacement& placement = placements_[work.place];
    const CrackFrame& frame = placement.frame;
    front.size = work.tip->size;
    front.radius = work.tip->radius;
    for (const PlacedTip& placed : placement.fronts) {
      const bool last = &placed == &placement.fronts.back();
      add_front(front, last ? work.path.back() : work.path.front(),
                (frame.global(base::embed_in_space(placed.growth_direction())) - frame.origin)
                    .normalized());
    }
    const FilledCavity& filled = cavities_[work.cavity];
    return fmt::format("{}: a = {:.6g}{}, patch of {} elements for {} of the net, {} of radius "
                       "{:.6g} with {} rings of {} sectors, tip elements {:.6g}{}",
                       work.line->display_name(), front.a,
                       work.line->embedded ? " (half its length)" : "",
                       filled.patch.elements.size(), filled.cavity.elements.size(),
                       placement.fronts.size() > 1 ? "rosettes" : "rosette", front.radius,
                       work.tip->rings, work.tip->sectors, front.size, more_about(work));
  }

  /// The cracks that share a patch, and its rim.
  [[nodiscard]] std::string more_about(const Work& work) const {
    std::string text;
    for (const Work& other : work_) {
      if (&other != &work && other.tip->patch && other.cavity == work.cavity) {
        text += (text.empty() ? ", one patch with " : ", ") + other.line->display_name();
      }
    }
    const std::size_t tied = cavities_[work.cavity].patch.ties.size();
    return text + (tied == 0 ? "" : fmt::format(", {} nodes of its rim tied", tied));
  }

  std::string add_own_fronts(const Work& work, CrackFront front) {
    const std::size_t step = path_step(work);
    const std::vector<NodeId>& path = work.path;
    std::string text = add_own_front(work, front, path.back(), path[path.size() - 1 - step]);
    if (work.line->embedded) {
      text += "; " + add_own_front(work, front, path.front(), path[step]);
    }
    return text;
  }

  /// A tip at a node of the net; the corner before it: growth goes on along the chord of the last
  /// edge.
  std::string add_own_front(const Work& work, CrackFront& front, NodeId tip, NodeId before) {
    const Vec3 last = mesh_.x[tip.index()] - mesh_.x[before.index()];
    front.size = last.norm();
    front.radius = front.size;
    const int moved = work.tip->quarter_point ? make_quarter_point_edges(result_.mesh, tip) : 0;
    if (const double part = worst_mid_node_position(result_.mesh, tip);
        std::min(std::abs(part - 0.25), std::abs(part - 0.5)) > neither) {
      diagnostics_.warning(work.span, "W505",
                           fmt::format("{}: middle nodes at {:.3g} of edges that leave the tip are "
                                       "neither quarter points nor middles: K is some per cent off",
                                       work.line->display_name(), part),
                           "QUARTER=YES on $TIPNET moves them to the quarter points");
    }
    add_front(front, tip, last.normalized());
    return fmt::format("{}: a = {:.6g}{}, tip at node {} of the net, elements of {:.6g}, {}",
                       work.line->display_name(), front.a,
                       work.line->embedded ? " (half its length)" : "",
                       mesh_.node_label[tip.index()], front.size,
                       moved > 0 ? "quarter points moved" : "no quarter points");
  }

  const model::Mesh& mesh_;
  const HostMesh& host_;
  base::Diagnostics& diagnostics_;
  std::vector<Work> work_;
  std::vector<CrackPlacement> placements_;
  std::vector<FilledCavity> cavities_;
  std::vector<GraftedPatch> placed_; ///< [cavity]
  CrackedMesh result_;
};

} // namespace

std::optional<CrackedMesh> insert_cracks(const HostMesh& host, std::span<const CrackLine> lines,
                                         std::span<const TipMeshParameters> parameters,
                                         std::span<const base::SourceSpan> spans,
                                         base::Diagnostics& diagnostics) {
  assert(lines.size() == parameters.size() && lines.size() == spans.size());
  return Inserter(host, diagnostics).insert(lines, parameters, spans);
}

} // namespace spricka::mesh
