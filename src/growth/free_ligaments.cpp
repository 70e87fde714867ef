// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/free_front_shape.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

/// What is left before free fronts.
namespace spricka::growth {

namespace {

using base::Vec3;

/// Ends on the surface look along it from a little further in, as a part of the front.
constexpr double further_in = 0.02;
/// A front that has less than this part of the way to a surface before it is looked at between its
/// points, too.
constexpr double near_surface = 0.5;
/// A crack reaches back by as much of the way from its place at least.
constexpr double least_reach = 0.3;
/// Sine of the angle below which a line runs along a surface rather than to it: 30 degrees.
constexpr double grazing = 0.5;

} // namespace

void FreeFrontShape::find_ligaments() {
  ligaments_.assign(tips_.size(), {});
  between_.assign(now_.growing.size(), {});
  for (std::size_t g = 0; g < now_.growing.size(); ++g) {
    look_ahead(g);
  }
}

// From each point; of a front that comes to a surface from places between them, too.
void FreeFrontShape::look_ahead(std::size_t growing) {
  const GrowingFront& of = now_.growing[growing];
  const BodyFrontArc& arc = of.arc;
  const base::NetId net = now_.cracks[of.crack].net;
  std::vector<std::size_t> own;
  const Vec3 middle = arc.curve.at(0.5 * arc.curve.length()).x;
  for (const double s : {0.0, arc.curve.length()}) {
    const auto piece = around_.surface_piece(arc.curve.at(s).x, middle, net);
    if (!arc.is_closed() && piece) {
      own.push_back(*piece);
    }
  }
  const std::size_t count = of.tips.size();
  bool near = false;
  for (std::size_t i = 0; i < count; ++i) {
    std::optional<SurfaceLigament>& before = ligaments_[of.tips[i]];
    before = ligament_at(of, static_cast<double>(i), own);
    near = near || (before && before->left_fraction() < near_surface);
  }
  const std::size_t places =
      arc.is_closed() ? count * looks_between : (count - 1) * looks_between + 1;
  for (std::size_t k = 0; near && k < places; ++k) {
    const double number = static_cast<double>(k) / static_cast<double>(looks_between);
    between_[growing].push_back(ligament_at(of, number, own));
  }
}

std::optional<FrontKinematics::SurfaceLigament>
FreeFrontShape::ligament_at(const GrowingFront& of, double number,
                            const std::vector<std::size_t>& own) const {
  const BodyFrontArc& arc = of.arc;
  const model::CrackDefinition& crack = now_.cracks[of.crack];
  const double edge = arc.is_closed() ? 0.0 : further_in * arc.curve.length();
  const double s =
      std::clamp(arc.arc_position(number, of.tips.size()), edge, arc.curve.length() - edge);
  const mesh::FrontFrame at = arc.curve.at(s);
  const auto tip = static_cast<std::size_t>(std::lround(number)) % of.tips.size();
  // The surface that an end lies on is none ahead: the front slides along it.
  const Vec3 way = way_on(at, of.tips[tip], 0.0);
  const auto ahead = around_.surface_ahead(at.x, way, crack.net);
  if (!ahead || std::ranges::find(own, ahead->piece) != own.end()) {
    return std::nullopt;
  }
  return SurfaceLigament{.behind = reach_back(of, at.x, way), .left = ahead->distance};
}

std::optional<FrontKinematics::SurfaceLigament>
FreeFrontShape::left_in_corner(std::size_t tip) const {
  const GrowingFront& of = place_of(tip).of;
  if (of.arc.is_closed() || std::ranges::any_of(of.tips, [&](std::size_t other) {
        return ligaments_[other].has_value();
      })) {
    return std::nullopt;
  }
  const model::CrackDefinition& crack = now_.cracks[of.crack];
  std::optional<SurfaceLigament> longest;
  for (std::size_t i = 0; i < of.tips.size(); ++i) {
    const mesh::FrontFrame at = of.frame_at(i);
    const auto ahead = around_.surface_ahead(at.x, at.m, crack.net);
    if (ahead && (!longest || ahead->distance > longest->left)) {
      longest =
          SurfaceLigament{.behind = (at.x - crack.plane.place).norm(), .left = ahead->distance};
    }
  }
  return longest;
}

// Towards a far face a wide crack reaches back by its depth, not by the way from its place.
double FreeFrontShape::reach_back(const GrowingFront& of, const Vec3& x, const Vec3& way) const {
  const model::CrackDefinition& crack = now_.cracks[of.crack];
  const Vec3 whole = x - crack.plane.place;
  if (of.arc.is_closed()) {
    return std::max(whole.dot(way), least_reach * whole.norm());
  }
  const auto back = around_.surface_ahead(x, -way, crack.net);
  // Beside an end of the front it is the surface along which that runs.
  const bool met = back && back->sine > grazing;
  return met ? std::min(whole.norm(), back->distance) : whole.norm();
}

} // namespace spricka::growth
