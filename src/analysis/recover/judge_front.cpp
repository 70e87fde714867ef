// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/judge_front.hpp"

#include "analysis/recover/face_overlap.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// As at a tip (judge_faces.cpp): what domains may find for K1 where faces touch, over K of that
// size of crack and load.
constexpr double worst_closed_front = 0.05;
constexpr double small_front_K1 = 1e-3;

double largest_of(const std::vector<crack::StressIntensity>& K) {
  double most = 0.0;
  for (const crack::StressIntensity& at : K) {
    most = std::max(most, std::hypot(at.K1, at.K2, at.K3));
  }
  return most;
}

// K of the size that the pressure between the faces has at a crack of this size.
double pressed_scale(const FrontState& at) {
  double pressure = 0.0;
  if (const auto& pair = at.scene.crack_face_pairs[at.front.crack.index()]) {
    const std::size_t rows = at.scene.pairs[pair->pair].normal.size();
    for (std::size_t r = 0; r < rows; ++r) {
      pressure = std::max(pressure, at.state.pair_lambda[pair->pair][static_cast<Eigen::Index>(r)]);
    }
  }
  const double size = at.front.a > 0.0 ? at.front.a : at.front.radius;
  return 2.0 * pressure * std::sqrt(size / std::numbers::pi);
}

// K that displacements leave by round-off where a crack is carried along.
double round_off_scale(const FrontState& at) {
  const double size = at.front.a > 0.0 ? at.front.a : at.front.radius;
  return at.K.empty() ? 0.0
                      : 1e-6 * at.K.front().E_effective * at.state.u.lpNorm<Eigen::Infinity>() /
                            std::sqrt(size);
}

// Faces that may lie in one another: what overlaps is told, and where K1 < 0 K is no answer.
void tell_front_overlap(const FrontState& at, results::FrontResult& result,
                        results::StepResult& out) {
  const std::string overlap = face_overlap(at.scene, at.front, at.state);
  if (overlap.empty()) {
    return;
  }
  const double least = -small_front_K1 * largest_of(at.K);
  const bool negative = std::ranges::any_of(
      result.points, [&](const results::FrontPointResult& place) { return place.K1 < least; });
  if (negative) {
    result.invalid_reason = overlap + ", which FACES=FREE lets them: K1 < 0 is not an answer";
  }
  out.notes.push_back(
      negative ? results::invalid_result_note(fmt::format("{}: {}; FACES=CONTACT holds them apart",
                                                          result.name, result.invalid_reason))
               : results::less_exact_note(
                     fmt::format("{}: {}, which FACES=FREE lets them: K is that of "
                                 "faces that do not bear on each other; FACES=CONTACT "
                                 "holds them apart",
                                 result.name, overlap)));
}

// K1 is 0 where the faces touch, and all of K where they have not slipped either. G of such a point
// is that of the modes that are left.
void close_place(const FrontFaces& faces, const crack::StressIntensity& K,
                 results::FrontPointResult& place) {
  place.closed = true;
  place.K1 = 0.0;
  place.smooth[0] = 0.0;
  if (faces.held) {
    place.K2 = place.K3 = place.G = 0.0;
    place.smooth = {};
  }
  const double E = K.E_effective;
  const double all = K.G_from_K;
  const double of_K1 = E > 0.0 ? K.K1 * K.K1 / E : 0.0;
  place.G_from_K = faces.held ? 0.0 : std::max(0.0, all - of_K1);
}

void note_front(std::size_t closed, std::size_t held, const results::FrontResult& result,
                results::StepResult& out) {
  const std::size_t count = result.points.size();
  if (closed == 0) {
    return;
  }
  const std::string where = closed == count
                                ? "all round the front"
                                : fmt::format("at {} of {} points of the front", closed, count);
  std::string left = ": K1 = 0 there";
  if (held > 0) {
    left = fmt::format(" and have not slipped at {}: K = 0 there", held);
  }
  out.notes.push_back(
      results::note(fmt::format("{}: the crack faces touch {}{}", result.name, where, left)));
}

} // namespace

void check_front_faces(const FrontState& at, results::FrontResult& result,
                       results::StepResult& out) {
  if (!at.model.cracks[at.front.crack.index()].faces_in_contact) {
    tell_front_overlap(at, result, out);
    return;
  }
  if (at.faces.empty()) { // no rows have been violated: nodes must say the same
    if (const std::string overlap = face_overlap(at.scene, at.front, at.state); !overlap.empty()) {
      result.invalid_reason = overlap;
      out.notes.push_back(
          results::invalid_result_note(fmt::format("{}: {}", result.name, overlap)));
    }
  }
  const double scale = std::max({largest_of(at.K), pressed_scale(at), round_off_scale(at)});
  std::size_t closed = 0;
  std::size_t held = 0;
  double worst = 0.0;  // K1 of closed points
  double lowest = 0.0; // K1 of open ones
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    results::FrontPointResult& place = result.points[i];
    if (i < at.faces.size() && at.faces[i].closed) {
      worst = place.at_surface ? worst : std::max(worst, std::abs(place.K1));
      close_place(at.faces[i], at.K[i], place);
      ++closed;
      held += at.faces[i].held ? 1 : 0;
      continue;
    }
    lowest = place.at_surface ? lowest : std::min(lowest, place.K1);
    place.K1 = place.K1 < 0.0 ? 0.0 : place.K1;
    place.smooth[0] = std::max(0.0, place.smooth[0]);
  }
  if (worst > worst_closed_front * scale) {
    out.notes.push_back(results::less_exact_note(fmt::format(
        "{}: the crack faces touch at the front, but the domains find K1 = {:.3g} there: the mesh "
        "is too coarse, and K elsewhere along the front off by as much; take a smaller SIZE on "
        "$TIPNET",
        result.name, worst)));
  }
  if (lowest < -worst_open_front * scale) {
    result.invalid_reason =
        fmt::format("K1 is {:.3g} though the crack faces do not overlap: the mesh at the "
                    "front is too coarse, so this K is not an answer",
                    lowest);
    out.notes.push_back(results::invalid_result_note(
        fmt::format("{}: {}; take a smaller SIZE on $TIPNET", result.name, result.invalid_reason)));
  }
  note_front(closed, held, result, out);
}

} // namespace spricka::analysis
