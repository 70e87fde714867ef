// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/front_kinematics.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

using base::Vec3;

/// Advance as a part of the way to the surface, and to another front, which may come the other way.
constexpr double part_to_surface = 0.6;
constexpr double part_to_front = 0.35;
/// Part of the way that is gone in one go where nothing nearer can be meshed.
constexpr double gone_through_refused = 0.45;
/// Where no front would be left behind the surface, this part of the way counts as cut through.
constexpr double nothing_left = 0.03;
constexpr double next_to_nothing_left = 0.2;
/// Fronts that meet both come nearer.
constexpr double own_part_of_gap = 0.5;
/// Planes that are one: sine of their angle, and distance as a part of the way between the cracks'
/// places.
constexpr double one_plane = 1e-6;

} // namespace

FrontKinematics::FrontKinematics(const model::Model& model) : model_(model), around_(model.mesh) {}

double FrontKinematics::remaining_ligament(const GrowthState& state, std::size_t tip) const {
  return model_.growth->last_length.value_or(std::numeric_limits<double>::infinity()) -
         state.stations.back().tips[tip].a;
}

AdvanceLimit FrontKinematics::step_limit(const GrowthState& state, std::size_t tip, double share,
                                         double ds) const {
  AdvanceLimit limit{
      .ds = std::min({ds, remaining_ligament(state, tip) / share, longest_advance(tip) / share})};
  limit_by_front(tip, share, limit);
  const std::optional<SurfaceLigament> before = ligament(tip);
  if (limit.end || limit.breakthrough || !before) {
    return limit;
  }
  const double gap = must_break_through_early_ ? gone_through_refused : gone_through;
  if (before->left_fraction() < gap && goes_on_behind(tip, *before)) {
    limit.breakthrough = before->left / share;
  } else if (before->left_fraction() < nothing_left) {
    limit.end = GrowthStop{"EDGE", fmt::format("{} reaches the surface: {:.3g} is left of the "
                                               "ligament, in which K grows without bound",
                                               tips_[tip].name, before->left)};
  }
  limit.ds = std::min(limit.ds, part_to_surface * before->left / share);
  return limit;
}

void FrontKinematics::limit_by_front(std::size_t tip, double share, AdvanceLimit& limit) const {
  const std::optional<NeighbourCrack> other = neighbour(tip);
  if (!other) {
    return;
  }
  limit.ds = std::min(limit.ds, part_to_front * other->gap / share);
  const double met = fronts_met * behind(tip);
  if (other->gap < (must_break_through_early_ ? gone_through_refused * behind(tip) : met) &&
      joins(tip, *other)) {
    limit.breakthrough = own_part_of_gap * other->gap / share;
    limit.meets = other->crack + 1;
  } else if (other->gap < met) {
    limit.end = GrowthStop{"LINK-UP", fmt::format("{} meets crack {}: {:.3g} is left between them",
                                                  tips_[tip].name, model_.cracks[other->crack].name,
                                                  other->gap)};
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

std::optional<GrowthStop> FrontKinematics::reject_advance(const GrowthState& /*state*/,
                                                          bool broke_through,
                                                          const std::string& why) {
  std::optional<SurfaceLigament> least;
  std::size_t at = 0;
  bool meets = false;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    std::optional<SurfaceLigament> before = ligament(tip);
    before = before ? before : left_in_corner(tip);
    if (before && (!least || before->left_fraction() < least->left_fraction())) {
      least = before;
      at = tip;
    }
    const std::optional<NeighbourCrack> other =
        broke_through || must_break_through_early_ ? std::nullopt : neighbour(tip);
    meets =
        meets || (other && other->gap < gone_through_refused * behind(tip) && joins(tip, *other));
  }
  const bool through =
      least && least->left_fraction() < gone_through_refused && goes_on_behind(at, *least);
  if (!broke_through && !must_break_through_early_ && (through || meets)) {
    must_break_through_early_ = true;
    return std::nullopt;
  }
  if (least && least->left_fraction() < next_to_nothing_left) {
    return GrowthStop{"EDGE",
                      fmt::format("{} is {:.3g} from the surface, and no front can be meshed "
                                  "in what is left: {}",
                                  tips_[at].name, least->left, why)};
  }
  return GrowthStop{"MESH", fmt::format("the next advance could not be meshed: {}", why)};
}

} // namespace spricka::growth
