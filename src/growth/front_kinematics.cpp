// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/front_kinematics.hpp"

#include "base/damaged_field.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

using base::Vec3;

/// Planes that are one: sine of their angle, and distance as a part of the way between the cracks'
/// places.
constexpr double one_plane = 1e-6;

} // namespace

FrontKinematics::FrontKinematics(const model::Model& model) : model_(model), around_(model.mesh) {}

double FrontKinematics::remaining_growth_length(const GrowthState& state, std::size_t tip) const {
  return model_.growth->last_length.value_or(std::numeric_limits<double>::infinity()) -
         state.stations.back().tips[tip].a;
}

AdvanceLimit FrontKinematics::advance_limit(const GrowthState& state, std::size_t tip, double share,
                                            double ds) const {
  AdvanceLimit limit{.ds = std::min({ds, remaining_growth_length(state, tip) / share,
                                     longest_advance(tip) / share})};
  if (const std::optional<NeighbourCrack> other = neighbour(tip)) {
    limit_advance_by_obstacle(
        front_policy,
        {.distance = other->gap,
         .part = other->gap / crack_depth_behind_tip(tip),
         .reason = fmt::format("{} meets crack {}: {:.3g} is left between them", tips_[tip].name,
                               model_.cracks[other->crack].name, other->gap),
         .crack = other->crack,
         .goes_on = [&] { return coalesces_with(tip, *other); }},
        share, must_break_through_early_, limit);
  }
  const std::optional<LigamentDepths> before = ligament(tip);
  if (before && !limit.event) {
    limit_advance_by_obstacle(
        surface_policy,
        {.distance = before->left,
         .part = before->ligament_to_depth_ratio(),
         .reason = fmt::format("{} reaches the surface: {:.3g} is left of the ligament, "
                               "in which K grows without bound",
                               tips_[tip].name, before->left),
         .goes_on = [&] { return goes_beyond_surface(tip, *before); }},
        share, must_break_through_early_, limit);
  }
  return limit;
}

void FrontKinematics::accept_cracks(const std::vector<model::CrackDefinition>& cracks,
                                    GrowthState& state) {
  must_break_through_early_ = false;
  state.cracks.clear();
  for (const model::CrackDefinition& crack : cracks) {
    state.cracks.push_back({crack.kind, crack.points, crack.plane, crack.front_history});
  }
}

void FrontKinematics::restore_cracks(const GrowthState& state,
                                     std::vector<model::CrackDefinition>& cracks) const {
  if (state.cracks.size() != cracks.size() || state.tips.size() != tips_.size()) {
    throw base::CorruptStoredField("tip.crack", "it has other cracks or tips than the deck");
  }
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const GrownCrack& grown = state.cracks[c];
    cracks[c].kind = grown.kind;
    cracks[c].points = grown.points;
    cracks[c].plane = grown.plane;
    cracks[c].front_history = grown.history;
  }
  for (const PartMovedByTip& tip : state.tips) {
    if (is_merged(cracks[tip.crack])) {
      throw base::CorruptStoredField("tip.crack", "a tip of a crack that has no front");
    }
  }
}

// What may differ between two cracks that join is nothing that counts behind that.
bool FrontKinematics::may_join(const model::CrackDefinition& one,
                               const model::CrackDefinition& other) const {
  const model::PlanarCrack& a = one.plane;
  const model::PlanarCrack& b = other.plane;
  const Vec3 way = b.place - a.place;
  const bool coplanar = a.normal.cross(b.normal).norm() < one_plane &&
                        std::abs(a.normal.dot(way)) < one_plane * way.norm();
  const bool loaded = std::ranges::any_of(model_.cases, [&](const model::LoadCase& load_case) {
    return std::ranges::any_of(load_case.loads, [&](const model::Load& load) {
      return load.faces.valid() && (load.faces == one.left || load.faces == one.right ||
                                    load.faces == other.left || load.faces == other.right);
    });
  });
  // Heights over a plane are those behind one front.
  const bool stay = model_.growth->direction == model::GrowthDirection::path;
  return stay && coplanar && !loaded && one.net == other.net && one.mu == other.mu &&
         one.faces_in_contact == other.faces_in_contact;
}

std::optional<GrowthEvent> FrontKinematics::handle_unmeshable_advance(bool passage,
                                                                      const std::string& why) {
  std::optional<LigamentDepths> least;
  std::size_t at = 0;
  const bool may_pass_early = !passage && !must_break_through_early_;
  bool meets = false;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    std::optional<LigamentDepths> before = ligament(tip);
    before = before ? before : ligament_in_corner(tip);
    if (before &&
        (!least || before->ligament_to_depth_ratio() < least->ligament_to_depth_ratio())) {
      least = before;
      at = tip;
    }
    const std::optional<NeighbourCrack> other = may_pass_early ? neighbour(tip) : std::nullopt;
    meets =
        meets || (other && other->gap < front_policy.passed_early * crack_depth_behind_tip(tip) &&
                  coalesces_with(tip, *other));
  }
  if (may_pass_early &&
      (meets || (least && least->ligament_to_depth_ratio() < surface_policy.passed_early &&
                 goes_beyond_surface(at, *least)))) {
    must_break_through_early_ = true;
    return std::nullopt;
  }
  if (least && least->ligament_to_depth_ratio() < surface_left_unmeshed) {
    return GrowthEvent{.kind = GrowthEventKind::surface_reached,
                       .reason = fmt::format("{} is {:.3g} from the surface, and no front can be "
                                             "meshed in what is left: {}",
                                             tips_[at].name, least->left, why)};
  }
  return GrowthEvent{.reason = fmt::format("the next advance could not be meshed: {}", why)};
}

} // namespace spricka::growth
