// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/patch.hpp"

#include "mesh/graft.hpp"
#include "mesh/path.hpp"
#include "mesh/quality.hpp"
#include "mesh/split.hpp"
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

/// Rosette radius, as a part of the crack's length or of the room round its tip, and growth of its
/// rings from the tip outward.
constexpr double radius_part = 0.4;
constexpr double ring_growth = 1.5;

/// The worst element of a patch, empty if all are good.
std::optional<BadElement> worst_element(const Patch& patch) {
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
  const std::vector<BadElement> bad = bad_elements(mesh);
  if (bad.empty()) {
    return std::nullopt;
  }
  return *std::min_element(bad.begin(), bad.end(), [](const BadElement& a, const BadElement& b) {
    return a.jacobian < b.jacobian;
  });
}

/// Everything about one crack on its way into the mesh.
struct Work {
  const CrackLine* line = nullptr;
  const TipMesh* tip = nullptr;
  base::Span span;
  std::size_t graft = 0; ///< number of its placement and graft, with a patch
  std::vector<NodeId> path;
};

class Inserter {
public:
  Inserter(const model::Mesh& mesh, base::Diagnostics& diagnostics)
      : mesh_(mesh), host_(mesh), diagnostics_(diagnostics) {}

  std::optional<CrackedMesh> insert(std::span<const CrackLine> lines, std::span<const TipMesh> tips,
                                    std::span<const base::Span> spans) {
    bool good = true;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      Work& work = work_.emplace_back(Work{&lines[i], &tips[i], spans[i], 0, {}});
      good = (tips[i].patch ? find_place(work) : find_path(work)) && good;
    }
    if (!good || !cut() || !make_patches()) {
      return std::nullopt;
    }
    result_ = graft(mesh_, grafts_);
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
    auto placement = place(host_, *work.line, *work.tip, work.span, diagnostics_);
    if (placement) {
      work.graft = placements_.size();
      placements_.push_back(std::move(*placement));
    }
    return placement.has_value();
  }

  bool cut() {
    Cavities cavities = find_cavities(host_, placements_);
    std::vector<const Work*> with_patch;
    for (const Work& work : work_) {
      if (work.tip->patch) {
        with_patch.push_back(&work);
      }
    }
    if (cavities.clash) {
      const Work& work = *with_patch[cavities.clash->second];
      diagnostics_.error(work.span, "E428",
                         fmt::format("the patches of {} and {} meet",
                                     with_patch[cavities.clash->first]->line->title(),
                                     work.line->title()),
                         "refine the net there, or give a smaller RADIUS on $TIPNET");
      return false;
    }
    bool good = true;
    for (const Work* work : with_patch) {
      Cavity& cavity = cavities.each[work->graft];
      good =
          check_cavity(host_, placements_[work->graft], cavity, work->span, diagnostics_) && good;
      grafts_.push_back({{}, std::move(cavity), placements_[work->graft].frame, {}});
    }
    return good;
  }

  bool make_patches() {
    bool good = true;
    for (const Work& work : work_) {
      if (work.tip->patch) {
        good = make_patch(work, grafts_[work.graft]) && good;
      }
    }
    return good;
  }

  /// Finer edges bend less: the remedy for elements that the host's curves fold.
  bool make_patch(const Work& work, Graft& graft) {
    std::string trouble;
    for (const double fineness : {1.0, 2.0, 4.0}) {
      graft.patch = build_patch(host_, placements_[work.graft], graft.cavity, *work.tip, fineness);
      trouble = graft.patch.trouble;
      if (trouble.empty()) {
        const auto bad = worst_element(graft.patch);
        if (!bad) {
          return true;
        }
        trouble = fmt::format("an element at ({:.6g}, {:.6g}) is folded", bad->at.x(), bad->at.y());
      }
    }
    diagnostics_.error(
        work.span, "E429",
        fmt::format("no patch could be made round {}: {}", work.line->title(), trouble));
    return false;
  }

  void tie_rims() {
    for (const Work& work : work_) {
      if (!work.tip->patch) {
        continue;
      }
      const Graft& g = grafts_[work.graft];
      for (const Patch::Tied& tied : g.patch.tied) {
        const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(tied.xi));
        result_.ties.push_back({g.node[static_cast<std::size_t>(tied.node)],
                                {tied.edge.a, tied.edge.b, tied.edge.mid},
                                {N[0], N[1], N[2]},
                                work.line->crack});
      }
    }
  }

  bool open_cracks() {
    std::vector<std::pair<NodeId, NodeId>> twins;
    for (Work& work : work_) {
      if (work.tip->patch) {
        const Graft& g = grafts_[work.graft];
        for (const int n : g.patch.path) {
          work.path.push_back(g.node[static_cast<std::size_t>(n)]);
        }
      }
      if (work.line->symmetric_half) {
        add_half_lip(work);
      } else if (auto lips = split_along(result_.mesh, work.path, work.line->embedded, twins)) {
        result_.lips.push_back(std::move(*lips));
      } else {
        diagnostics_.error(work.span, "E427",
                           fmt::format("{} does not start on the boundary", work.line->title()));
        return false;
      }
      add_tips(work);
    }
    add_twins(result_.mesh, twins);
    return true;
  }

  void add_half_lip(const Work& work) {
    CrackedMesh::Lips lips;
    const bool left = work.tip->patch
                          ? placements_[work.graft].half > 0
                          : body_on_left(host_, work.path[0], work.path[path_step(work)]);
    (left ? lips.left : lips.right) = work.path;
    result_.lips.push_back(std::move(lips));
  }
  /// Places from one corner of a path without a patch to the next: 2 on quadratic edges.
  [[nodiscard]] std::size_t path_step(const Work& work) const {
    const auto around = host_.around(work.path[0]);
    return base::info(mesh_.type[around.front().index()]).quadratic ? 2 : 1;
  }

  void add_tips(const Work& work) {
    Tip tip;
    tip.crack = work.line->crack;
    tip.a = frame_of(*work.line).a;
    tip.symmetric_half = work.line->symmetric_half;
    result_.notes.push_back(work.tip->patch ? add_patch_tips(work, tip) : add_own_tip(work, tip));
  }

  std::string add_patch_tips(const Work& work, Tip tip) {
    const Placement& placement = placements_[work.graft];
    const CrackFrame& frame = placement.frame;
    tip.size = work.tip->size;
    tip.radius = work.tip->radius;
    for (std::size_t i = 0; i < placement.tips.size(); ++i) {
      tip.number = static_cast<int>(i) + 1;
      tip.node = i + 1 == placement.tips.size() ? work.path.back() : work.path.front();
      tip.x = result_.mesh.x[tip.node.index()];
      tip.direction = (frame.global(placement.tips[i].ahead()) - frame.origin).normalized();
      result_.tips.push_back(tip);
    }
    const Graft& g = grafts_[work.graft];
    return fmt::format("{}: a = {:.6g}{}, patch of {} elements for {} of the net, {} of radius "
                       "{:.6g} with {} rings of {} sectors, tip elements {:.6g}{}",
                       work.line->title(), tip.a, work.line->embedded ? " (half its length)" : "",
                       g.patch.elements.size(), g.cavity.elements.size(),
                       placement.tips.size() > 1 ? "rosettes" : "rosette", tip.radius,
                       work.tip->rings, work.tip->sectors, tip.size,
                       g.patch.tied.empty()
                           ? ""
                           : fmt::format(", {} nodes of its rim tied", g.patch.tied.size()));
  }

  std::string add_own_tip(const Work& work, Tip tip) {
    tip.node = work.path.back();
    const std::size_t before = work.path.size() - 1 - path_step(work);
    const Vec3 last = mesh_.x[tip.node.index()] - mesh_.x[work.path[before].index()];
    tip.direction = last.normalized();
    tip.size = last.norm();
    tip.radius = tip.size;
    const int moved = work.tip->quarter_point ? move_quarter_points(result_.mesh, tip.node) : 0;
    tip.x = result_.mesh.x[tip.node.index()];
    result_.tips.push_back(tip);
    return fmt::format("{}: a = {:.6g}, tip at node {} of the net, elements of {:.6g}, {}",
                       work.line->title(), tip.a, mesh_.node_label[tip.node.index()], tip.size,
                       moved > 0 ? "quarter points moved" : "no quarter points");
  }

  const model::Mesh& mesh_;
  Host host_;
  base::Diagnostics& diagnostics_;
  std::vector<Work> work_;
  std::vector<Placement> placements_;
  std::vector<Graft> grafts_;
  CrackedMesh result_;
};

} // namespace

TipMesh choose_tip_mesh(const model::Mesh& host, const CrackLine& line,
                        const model::TipNet* wishes) {
  TipMesh tip;
  if (wishes != nullptr) {
    tip.rings = wishes->rings;
    tip.sectors = wishes->sectors;
    tip.quarter_point = wishes->quarter_point;
    tip.patch = wishes->patch;
    tip.transition = wishes->join == model::Join::transition;
  }
  const CrackFrame frame = frame_of(line);
  if (wishes != nullptr && wishes->radius) {
    tip.radius = *wishes->radius;
  } else {
    std::vector<Vec2> local;
    for (const Vec3& p : line.points) {
      local.push_back(frame.local(p));
    }
    const Host neighbours(host);
    double room = 1.0;
    for (int end = 0; end < (line.embedded ? 2 : 1); ++end) {
      const double last = (local.back() - local[local.size() - 2]).norm();
      room = std::min({room, tip_clearance(neighbours, frame, local, line.symmetric_half, line.net),
                       1.5 * last / (line.embedded && local.size() == 2 ? 2.0 : 1.0)});
      std::reverse(local.begin(), local.end());
    }
    tip.radius = radius_part * frame.a * room;
  }
  if (wishes != nullptr && wishes->size) {
    tip.size = *wishes->size;
  } else {
    tip.size = tip.radius * (ring_growth - 1.0) / (std::pow(ring_growth, tip.rings) - 1.0);
  }
  return tip;
}

std::optional<CrackedMesh> insert_cracks(const model::Mesh& host, std::span<const CrackLine> lines,
                                         std::span<const TipMesh> tips,
                                         std::span<const base::Span> spans,
                                         base::Diagnostics& diagnostics) {
  assert(lines.size() == tips.size() && lines.size() == spans.size());
  return Inserter(host, diagnostics).insert(lines, tips, spans);
}

std::vector<ElementId> crack_region(const model::Mesh& host, std::span<const CrackLine> lines,
                                    std::span<const TipMesh> tips) {
  const Host neighbours(host);
  std::vector<bool> in(host.element_count(), false);
  base::Diagnostics ignored; // insert_cracks reports
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<ElementId> core;
    if (tips[i].patch) {
      if (const auto placement = place(neighbours, lines[i], tips[i], {}, ignored)) {
        core = find_cavities(neighbours, {&*placement, 1}).each.front().elements;
      }
    } else if (const auto path = path_nodes(neighbours, lines[i], {}, ignored)) {
      for (const NodeId n : *path) {
        core.insert(core.end(), neighbours.around(n).begin(), neighbours.around(n).end());
      }
    }
    for (const ElementId e : core) {
      for (const NodeId n : host.nodes_of(e)) {
        for (const ElementId next : neighbours.around(n)) {
          in[next.index()] = true;
        }
      }
    }
  }
  std::vector<ElementId> result;
  for (std::size_t e = 0; e < in.size(); ++e) {
    if (in[e]) {
      result.emplace_back(e);
    }
  }
  return result;
}

} // namespace spricka::mesh
