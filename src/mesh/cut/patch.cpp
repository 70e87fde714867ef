// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch.hpp"

#include "mesh/cut/cavity_check.hpp"
#include "mesh/cut/crack_check.hpp"
#include "mesh/cut/crack_face_sets.hpp"
#include "mesh/cut/graft.hpp"
#include "mesh/cut/path.hpp"
#include "mesh/cut/split.hpp"
#include "mesh/quality.hpp"
#include "shape/shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec2;
using base::Vec3;

/// A middle node this far from the quarter of its edge, and from the middle, is neither; at a
/// hundredth K has changed by 0.06 %.
constexpr double neither = 0.02;

/// The worst element of a patch, empty if all are good.
std::optional<InvalidElement> worst_element(const Patch& patch) {
  model::Mesh mesh;
  for (const PatchNode& node : patch.nodes) {
    model::add_node(mesh, node.x, 0, {});
  }
  std::vector<NodeId> nodes;
  for (const PatchElement& element : patch.elements) {
    nodes.clear();
    for (const int n : element.nodes) {
      nodes.emplace_back(static_cast<std::size_t>(n));
    }
    model::add_element(mesh, element.type, nodes, 0, {});
  }
  const std::vector<InvalidElement> bad = bad_elements(mesh);
  if (bad.empty()) {
    return std::nullopt;
  }
  return *std::min_element(
      bad.begin(), bad.end(),
      [](const InvalidElement& a, const InvalidElement& b) { return a.jacobian < b.jacobian; });
}

/// Everything about one crack on its way into the mesh.
struct Work {
  const CrackLine* line = nullptr;
  const TipMeshParameters* tip = nullptr;
  base::SourceSpan span;
  std::size_t place = 0;  ///< with a patch: number of its placement,
  std::size_t graft = 0;  ///< of the graft it is in
  std::size_t member = 0; ///< and which one of that graft's cracks it is
  std::vector<NodeId> path;
};

class Inserter {
public:
  Inserter(const HostMesh& host, base::Diagnostics& diagnostics)
      : mesh_(host.mesh()), host_(host), diagnostics_(diagnostics) {}

  std::optional<CrackedMesh> insert(std::span<const CrackLine> lines,
                                    std::span<const TipMeshParameters> tips,
                                    std::span<const base::SourceSpan> spans) {
    if (!check_crack_lines(lines, spans, diagnostics_)) {
      return std::nullopt;
    }
    bool good = true;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      Work& work = work_.emplace_back(Work{&lines[i], &tips[i], spans[i], 0, 0, 0, {}});
      good = (tips[i].patch ? find_place(work) : find_path(work)) && good;
    }
    // Each stage looks at all cracks before it fails, so that one run tells all that is wrong.
    if (!good || !rosettes_are_apart() || !cut() || !make_patches()) {
      return std::nullopt;
    }
    result_ = graft_patches(mesh_, grafts_);
    tie_rims();
    if (!open_cracks()) {
      return std::nullopt;
    }
    return std::move(result_);
  }

private:
  bool find_path(Work& work) {
    auto path = path_nodes(host_, *work.line, work.span, diagnostics_);
    if (path) {
      work.path = std::move(*path);
    }
    return path.has_value();
  }

  bool find_place(Work& work) {
    auto placement = place_crack(host_, *work.line, *work.tip, work.span, diagnostics_);
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
          work.tip->patch ? clearance_to_cracks(*work.line, lines) : work.tip->radius;
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
        work.graft = c;
        work.member = m;
        good = (members.size() == 1 || can_share(*with_patch[members.front()], work)) && good;
        good = check_cavity(host_, placements_[work.place], cavities.each[c], work.span,
                            diagnostics_) &&
               good;
      }
      grafts_.push_back({{}, std::move(cavities.each[c]), placements_[members.front()].frame, {}});
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
    for (std::size_t g = 0; g < grafts_.size(); ++g) {
      good = make_patch(g) && good;
    }
    return good;
  }

  /// Finer edges bend less: the remedy for elements that the host's curves fold.
  bool make_patch(std::size_t g) {
    PatchGraft& graft = grafts_[g];
    std::vector<PatchCrack> cracks;
    std::string names;
    base::SourceSpan span;
    for (const Work& work : work_) {
      if (work.tip->patch && work.graft == g) {
        // All in the frame of the patch, that of its first crack.
        cracks.push_back({seen_from(placements_[work.place], graft.frame), work.tip});
        span = names.empty() ? work.span : span;
        names += (names.empty() ? "" : ", ") + work.line->display_name();
      }
    }
    std::string trouble;
    for (const double fineness : {1.0, 2.0, 4.0}) {
      graft.patch = mesh_cavity(host_, cracks, graft.cavity, fineness);
      trouble = graft.patch.trouble;
      if (trouble.empty()) {
        const auto bad = worst_element(graft.patch);
        if (!bad) {
          return true;
        }
        trouble = fmt::format("an element at ({:.6g}, {:.6g}) is folded", bad->at.x(), bad->at.y());
      }
    }
    diagnostics_.error(span, "E429",
                       fmt::format("no patch could be made round {}: {}", names, trouble));
    return false;
  }

  void tie_rims() {
    for (const Work& work : work_) {
      // The rim of a patch that several cracks share is tied once, in the name of the first.
      if (!work.tip->patch || work.member != 0) {
        continue;
      }
      const PatchGraft& g = grafts_[work.graft];
      for (const Patch::TiedPatchNode& tied : g.patch.tied) {
        const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(tied.xi));
        result_.ties.push_back({g.node[static_cast<std::size_t>(tied.node)],
                                {tied.edge.a, tied.edge.b, tied.edge.mid},
                                {N[0], N[1], N[2]},
                                work.line->crack});
      }
    }
  }

  bool open_cracks() {
    for (Work& work : work_) {
      if (work.tip->patch) {
        const PatchGraft& g = grafts_[work.graft];
        for (const int n : g.patch.paths[work.member]) {
          work.path.push_back(g.node[static_cast<std::size_t>(n)]);
        }
      }
      if (work.line->symmetric_half) {
        add_half_crack_face(work);
      } else if (auto crack_faces = split_along(result_.mesh, work.path, work.line->embedded)) {
        result_.faces.push_back(std::move(*crack_faces));
      } else {
        diagnostics_.error(
            work.span, "E427",
            fmt::format("{} does not start on the boundary", work.line->display_name()));
        return false;
      }
      add_tips(work);
    }
    // Sets come after all cracks: several may double the nodes of one place.
    add_crack_face_nodes(result_.mesh, result_.faces);
    return true;
  }

  void add_half_crack_face(const Work& work) {
    CrackFaces crack_faces;
    const bool left = work.tip->patch
                          ? placements_[work.place].half > 0
                          : body_on_left(host_, work.path[0], work.path[path_step(work)]);
    (left ? crack_faces.left : crack_faces.right) = work.path;
    result_.faces.push_back(std::move(crack_faces));
  }
  /// Places from one corner of a path without a patch to the next: 2 on quadratic edges.
  [[nodiscard]] std::size_t path_step(const Work& work) const {
    const auto around = host_.elements_around(work.path[0]);
    return base::element_info(mesh_.type[around.front().index()]).quadratic ? 2 : 1;
  }

  void add_tips(const Work& work) {
    CrackFront front;
    front.crack = work.line->crack;
    front.a = make_crack_frame(*work.line).a;
    front.symmetric_half = work.line->symmetric_half;
    result_.notes.push_back(work.tip->patch ? add_patch_tips(work, front)
                                            : add_own_tip(work, front));
  }

  std::string add_patch_tips(const Work& work, CrackFront front) {
    const CrackPlacement& placement = placements_[work.place];
    const PlanarCrackFrame& frame = placement.frame;
    front.size = work.tip->size;
    front.radius = work.tip->radius;
    for (std::size_t i = 0; i < placement.tips.size(); ++i) {
      front.number = static_cast<int>(i) + 1;
      front.tip_point().node =
          i + 1 == placement.tips.size() ? work.path.back() : work.path.front();
      front.tip_point().x = result_.mesh.x[front.tip_point().node.index()];
      front.tip_point().growth =
          (frame.global(placement.tips[i].growth_direction()) - frame.origin).normalized();
      result_.fronts.push_back(front);
    }
    const PatchGraft& g = grafts_[work.graft];
    return fmt::format("{}: a = {:.6g}{}, patch of {} elements for {} of the net, {} of radius "
                       "{:.6g} with {} rings of {} sectors, tip elements {:.6g}{}",
                       work.line->display_name(), front.a,
                       work.line->embedded ? " (half its length)" : "", g.patch.elements.size(),
                       g.cavity.elements.size(), placement.tips.size() > 1 ? "rosettes" : "rosette",
                       front.radius, work.tip->rings, work.tip->sectors, front.size,
                       more_about(work));
  }

  /// The cracks that share a patch, and its rim.
  [[nodiscard]] std::string more_about(const Work& work) const {
    std::string text;
    for (const Work& other : work_) {
      if (&other != &work && other.tip->patch && other.graft == work.graft) {
        text += (text.empty() ? ", one patch with " : ", ") + other.line->display_name();
      }
    }
    const std::size_t tied = grafts_[work.graft].patch.tied.size();
    return text + (tied == 0 ? "" : fmt::format(", {} nodes of its rim tied", tied));
  }

  std::string add_own_tip(const Work& work, CrackFront front) {
    front.tip_point().node = work.path.back();
    // The last corner before the tip: growth goes on along the chord of the last edge.
    const std::size_t before = work.path.size() - 1 - path_step(work);
    const Vec3 last = mesh_.x[front.tip_point().node.index()] - mesh_.x[work.path[before].index()];
    front.tip_point().growth = last.normalized();
    front.size = last.norm();
    front.radius = front.size;
    const int moved =
        work.tip->quarter_point ? move_quarter_points(result_.mesh, front.tip_point().node) : 0;
    if (const double part = worst_mid_node(result_.mesh, front.tip_point().node);
        std::min(std::abs(part - 0.25), std::abs(part - 0.5)) > neither) {
      diagnostics_.warning(work.span, "W505",
                           fmt::format("{}: middle nodes at {:.3g} of edges that leave the tip are "
                                       "neither quarter points nor middles: K is some per cent off",
                                       work.line->display_name(), part),
                           "QUARTER=YES on $TIPNET moves them to the quarter points");
    }
    front.tip_point().x = result_.mesh.x[front.tip_point().node.index()];
    result_.fronts.push_back(front);
    return fmt::format("{}: a = {:.6g}, tip at node {} of the net, elements of {:.6g}, {}",
                       work.line->display_name(), front.a,
                       mesh_.node_label[front.tip_point().node.index()], front.size,
                       moved > 0 ? "quarter points moved" : "no quarter points");
  }

  const model::Mesh& mesh_;
  const HostMesh& host_;
  base::Diagnostics& diagnostics_;
  std::vector<Work> work_;
  std::vector<CrackPlacement> placements_;
  std::vector<PatchGraft> grafts_;
  CrackedMesh result_;
};

} // namespace

std::optional<CrackedMesh> insert_cracks(const HostMesh& host, std::span<const CrackLine> lines,
                                         std::span<const TipMeshParameters> tips,
                                         std::span<const base::SourceSpan> spans,
                                         base::Diagnostics& diagnostics) {
  assert(lines.size() == tips.size() && lines.size() == spans.size());
  return Inserter(host, diagnostics).insert(lines, tips, spans);
}

} // namespace spricka::mesh
