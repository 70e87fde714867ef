// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/judge_faces.hpp"

#include "analysis/recover/face_overlap.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "analysis/steps/crack_face_overlap.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Fewer open nodes than these between the tip and the closed part of the faces: two elements.
constexpr int least_open_nodes = 4;
// K1 of the domains where faces touch should be what the mesh cannot tell from 0, over K of that
// size of crack and load.
constexpr double worst_closed_K1 = 0.05;

// Faces that do not overlap have no negative K1; where one is found it is 0 but for so much. Beside
// that much of K2 no mesh tells K1 from 0.
constexpr double small_K1 = 1e-3;

// Whether a law of $GROW is given this step's K, for which K1 < 0 has a meaning: as its K_min, or
// as an end of the load path of its spectrum.
bool is_smallest_of_law(const model::Model& model, const std::string& step) {
  const std::optional<model::CrackGrowthSettings>& growth = model.growth;
  const auto is = [&](base::StepId id) {
    return id.valid() && model.steps[id.index()].name == step;
  };
  if (!growth || growth->law == model::CrackGrowthLaw::increment) {
    return false;
  }
  if (growth->spectrum) {
    const model::LoadPathDefinition& path = model.load_paths[model.spectra[*growth->spectrum].path];
    return is(path.from) || is(path.to);
  }
  return is(growth->kmin);
}

double largest_of(const std::vector<crack::StressIntensity>& K) {
  double most = 0.0;
  for (const crack::StressIntensity& at : K) {
    most = std::max(most, std::hypot(at.K1, at.K2, at.K3));
  }
  return most;
}

// K of the size that the pressure between the faces has at a crack of this size.
double pressed_scale(const FrontStepState& at) {
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
double round_off_scale(const FrontStepState& at) {
  const double size = at.front.a > 0.0 ? at.front.a : at.front.radius;
  return at.K.empty() ? 0.0
                      : 1e-6 * at.K.front().E_effective * at.state.u.lpNorm<Eigen::Infinity>() /
                            std::sqrt(size);
}

// FACES=FREE: what overlaps is told (`overlap`, by how much, empty: nothing does), and K1 < 0 is no
// answer even so (`negative`, why, empty: there is none).
void tell_overlap(const std::string& overlap, const std::string& negative,
                  results::FrontResult& result, results::LoadStepResult& out) {
  if (!negative.empty()) {
    result.invalid_reason = negative;
    out.notes.push_back(results::invalid_result_note(
        fmt::format("{}: {}; FACES=CONTACT holds them apart", result.name, negative)));
  } else if (!overlap.empty()) {
    out.notes.push_back(results::less_exact_note(
        fmt::format("{}: {}, which FACES=FREE lets them: K is that of faces that do not bear on "
                    "each other; FACES=CONTACT holds them apart",
                    result.name, overlap)));
  }
}

// K1 < 0 of a tip is an answer as K_min of a law alone.
void tell_tip_overlap(const FrontStepState& at, results::FrontResult& result,
                      results::LoadStepResult& out) {
  const results::FrontPointResult& tip = result.single_point();
  const double part =
      measure_relative_face_overlap(at.scene.cracked, at.front.crack.index(), at.state.u).lone;
  const bool negative = tip.K1 < 0.0 && std::abs(tip.K1) > small_K1 * std::abs(tip.K2);
  if (negative && is_smallest_of_law(at.model, out.step)) {
    out.notes.push_back(
        results::make_note(fmt::format("{}: K1 is negative, as FACES=FREE lets the crack faces "
                                       "overlap: the law of $GROW takes it as its K_min",
                                       result.name)));
    return;
  }
  const std::string overlap =
      part > overlap_of_round_off
          ? fmt::format("the crack faces overlap over a part of the crack, by {:.1e} of their "
                        "largest displacement",
                        part)
          : "";
  tell_overlap(overlap,
               negative ? "K1 is negative: the crack faces overlap, which FACES=FREE lets them, so "
                          "this K is not an answer"
                        : "",
               result, out);
}

void tell_front_overlap(const FrontStepState& at, results::FrontResult& result,
                        results::LoadStepResult& out) {
  const std::string overlap = describe_face_overlap(at.scene, at.front, at.state);
  const double least = -small_K1 * largest_of(at.K);
  const bool negative = std::ranges::any_of(
      result.points, [&](const results::FrontPointResult& point) { return point.K1 < least; });
  tell_overlap(overlap,
               negative && !overlap.empty()
                   ? overlap + ", which FACES=FREE lets them: K1 < 0 is not an answer"
                   : "",
               result, out);
}

// Less than an element that overlaps is no contact, and less than one that touches no good one.
void tell_lone_nodes(const FrontStepState& at, const TipFaceContact& faces,
                     const results::FrontResult& result, results::LoadStepResult& out) {
  if (faces.lone) {
    out.notes.push_back(results::less_exact_note(
        fmt::format("{}: the crack faces touch at a single node between open ones, "
                    "less than the mesh resolves: K may be off by what that node is worth; a "
                    "smaller SIZE on $TIPNET shows it",
                    result.name)));
  }
  const double part =
      faces.in_contact
          ? 0.0
          : measure_relative_face_overlap(at.scene.cracked, at.front.crack.index(), at.state.u)
                .lone;
  if (part > overlap_of_round_off) {
    out.notes.push_back(results::less_exact_note(
        fmt::format("{}: the crack faces overlap at single nodes, by {:.1e} of their largest "
                    "displacement: less than the mesh resolves, and left open; K may be off by a "
                    "part of that order, and a smaller SIZE on $TIPNET shows it",
                    result.name, part)));
  }
}

// K1 < 0 where faces in contact do not touch.
void tell_coarse_mesh(std::string why, results::FrontResult& result, results::LoadStepResult& out) {
  result.invalid_reason = std::move(why);
  out.notes.push_back(results::invalid_result_note(
      fmt::format("{}: {}; take a smaller SIZE on $TIPNET", result.name, result.invalid_reason)));
}

// K1 is 0 where the faces touch, as they do not part there, and all of K where they have not
// slipped either: what the domains find instead is the error of the mesh. `G_left`: of the modes
// that are left.
void close_point(bool held, double G_left, results::FrontPointResult& point) {
  point.closed = true;
  point.K1 = 0.0;
  point.smooth[0] = 0.0;
  if (held) {
    point.K2 = point.K3 = point.G = 0.0;
    point.smooth = {};
  }
  point.G_from_K = held ? 0.0 : G_left;
}

void close_tip(const TipFaceContact& faces, double scale, results::FrontResult& result,
               results::LoadStepResult& out) {
  results::FrontPointResult& tip = result.single_point();
  const double K1 = tip.K1;
  if (faces.closed) {
    const double all = K1 * K1 + tip.K2 * tip.K2;
    // Of (K1^2 + K2^2)/E' the part of K2 stays.
    close_point(faces.held, tip.G_from_K * (all > 0.0 ? tip.K2 * tip.K2 / all : 0.0), tip);
    if (std::abs(K1) > worst_closed_K1 * scale) {
      out.notes.push_back(results::less_exact_note(
          fmt::format("{}: the crack faces touch at the tip, but the rings "
                      "find K1 = {:.3g}: the mesh there is too coarse, and K2 off by as much; "
                      "take a smaller SIZE on $TIPNET",
                      result.name, K1)));
    }
    out.notes.push_back(results::make_note(
        fmt::format("{}: the crack faces touch at the tip{}", result.name,
                    faces.held ? " and have not slipped: K1 = K2 = 0" : ": K1 = 0")));
  } else if (faces.open_nodes > 0 && faces.open_nodes < least_open_nodes) {
    out.notes.push_back(results::less_exact_note(
        fmt::format("{}: the crack faces are open at the tip over less "
                    "than two elements: K is known by its order alone; take a smaller SIZE "
                    "on $TIPNET",
                    result.name)));
  }
  if (!faces.closed && K1 < 0.0 && std::abs(K1) <= small_K1 * scale) {
    tip.K1 = tip.smooth[0] = 0.0;
  } else if (!faces.closed && K1 < 0.0) {
    tell_coarse_mesh("K1 is negative though the crack faces do not overlap: the mesh at the tip is "
                     "too coarse, so this K is not an answer",
                     result, out);
  }
}

void note_touching(std::size_t closed, std::size_t held, const results::FrontResult& result,
                   results::LoadStepResult& out) {
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
      results::make_note(fmt::format("{}: the crack faces touch {}{}", result.name, where, left)));
}

void close_front(const FrontStepState& at, results::FrontResult& result,
                 results::LoadStepResult& out) {
  const double scale = std::max({largest_of(at.K), pressed_scale(at), round_off_scale(at)});
  std::size_t closed = 0;
  std::size_t held = 0;
  double worst = 0.0;  // K1 of closed points
  double lowest = 0.0; // K1 of open ones
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    results::FrontPointResult& point = result.points[i];
    if (i < at.faces.size() && at.faces[i].closed) {
      worst = point.at_surface ? worst : std::max(worst, std::abs(point.K1));
      const double E = at.K[i].E_effective;
      const double of_K1 = E > 0.0 ? at.K[i].K1 * at.K[i].K1 / E : 0.0;
      close_point(at.faces[i].held, std::max(0.0, at.K[i].G_from_K - of_K1), point);
      ++closed;
      held += at.faces[i].held ? 1 : 0;
      continue;
    }
    lowest = point.at_surface ? lowest : std::min(lowest, point.K1);
    point.K1 = point.K1 < 0.0 ? 0.0 : point.K1;
    point.smooth[0] = std::max(0.0, point.smooth[0]);
  }
  if (worst > worst_closed_K1 * scale) {
    out.notes.push_back(results::less_exact_note(fmt::format(
        "{}: the crack faces touch at the front, but the domains find K1 = {:.3g} there: the mesh "
        "is too coarse, and K elsewhere along the front off by as much; take a smaller SIZE on "
        "$TIPNET",
        result.name, worst)));
  }
  if (lowest < -worst_open_front * scale) {
    tell_coarse_mesh(
        fmt::format("K1 is {:.3g} though the crack faces do not overlap: the mesh at the "
                    "front is too coarse, so this K is not an answer",
                    lowest),
        result, out);
  }
  note_touching(closed, held, result, out);
}

// K of the size that pressure between the faces, or their largest displacement against each other,
// has at a crack of this length under uniform stress; no less than what round-off makes of it.
double k_scale(const FrontStepState& at, const TipFaceContact& faces) {
  const double a = at.front.a;
  const double E = at.K.front().E_effective;
  const double pressed = faces.pressure * std::sqrt(std::numbers::pi * a);
  const double jump = largest_crack_face_jump(at.scene.cracked, at.front.crack.index(), at.state.u);
  // Faces of a crack of half length a under uniform stress part by 4 sigma a / E' in its middle.
  const double open = 0.25 * E * jump * std::sqrt(std::numbers::pi / a);
  const double least = 1e-6 * E * at.state.u.lpNorm<Eigen::Infinity>() / std::sqrt(a);
  return std::max({pressed, open, least});
}

// Whether K is nothing but the round-off of displacements that a crack is carried along with.
bool is_round_off(const FrontStepState& at) {
  const crack::StressIntensity& K = at.K.front();
  const double scale = K.E_effective * at.state.u.lpNorm<Eigen::Infinity>() / std::sqrt(at.front.a);
  return std::hypot(K.K1, K.K2) <= 1e-9 * scale;
}

void judge_tip(const FrontStepState& at, bool may_touch, results::FrontResult& result,
               results::LoadStepResult& out) {
  if (result.two_materials) {
    result.invalid_reason =
        "the tip lies between two materials, where stresses oscillate: it has no K1 and "
        "K2, only G";
    // No table has a K of it.
    out.notes.push_back(
        results::make_note(fmt::format("{}: {}", result.name, result.invalid_reason)));
    return;
  }
  if (is_round_off(at)) { // nothing loads the crack
    results::FrontPointResult& tip = result.single_point();
    tip.K1 = tip.K2 = tip.G = tip.G_from_K = 0.0;
    tip.smooth = {};
    tip.closed = may_touch && tip_face_contact(at.scene, at.front, at.state).closed;
    return;
  }
  if (!may_touch) {
    tell_tip_overlap(at, result, out);
    return;
  }
  const TipFaceContact faces = tip_face_contact(at.scene, at.front, at.state);
  close_tip(faces, k_scale(at, faces), result, out);
  tell_lone_nodes(at, faces, result, out);
}

void judge_front(const FrontStepState& at, bool may_touch, results::FrontResult& result,
                 results::LoadStepResult& out) {
  if (!may_touch) {
    tell_front_overlap(at, result, out);
    return;
  }
  if (at.faces.empty()) { // no rows have been violated: nodes must say the same
    if (const std::string overlap = describe_face_overlap(at.scene, at.front, at.state);
        !overlap.empty()) {
      result.invalid_reason = overlap;
      out.notes.push_back(
          results::invalid_result_note(fmt::format("{}: {}", result.name, overlap)));
    }
  }
  close_front(at, result, out);
}

} // namespace

void judge_K_by_faces_and_materials(const FrontStepState& at, results::FrontResult& result,
                                    results::LoadStepResult& out) {
  const bool may_touch = at.model.cracks[at.front.crack.index()].faces_in_contact;
  if (result.is_tip()) {
    judge_tip(at, may_touch, result, out);
  } else {
    judge_front(at, may_touch, result, out);
  }
}

} // namespace spricka::analysis
