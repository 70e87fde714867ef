// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/judge_faces.hpp"

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
// K1 of the rings at a closed tip should be what the mesh cannot tell from 0, over that of k_scale.
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

// FACES=FREE: what overlaps is told, and K1 < 0 is no answer even so, but as K_min of a law.
void tell_overlap(const TipState& at, results::TipResult& result, results::StepResult& out) {
  const double part = crack_face_overlap(at.scene.cracked, at.front.crack.index(), at.state.u).lone;
  const bool negative = result.K1 < 0.0 && std::abs(result.K1) > small_K1 * std::abs(result.K2);
  if (negative && is_smallest_of_law(at.model, out.step)) {
    out.notes.push_back(
        results::note(fmt::format("{}: K1 is negative, as FACES=FREE lets the crack faces "
                                  "overlap: the law of $GROW takes it as its K_min",
                                  result.name)));
  } else if (negative) {
    result.invalid_reason =
        "K1 is negative: the crack faces overlap, which FACES=FREE lets them, so this K "
        "is not an answer";
    out.notes.push_back(results::invalid_result_note(
        fmt::format("{}: {}; FACES=CONTACT holds them apart", result.name, result.invalid_reason)));
  } else if (part > overlap_of_round_off) {
    out.notes.push_back(results::less_exact_note(
        fmt::format("{}: the crack faces overlap over a part of the crack, "
                    "by {:.1e} of their largest displacement, which FACES=FREE "
                    "lets them: K is that of faces that do not bear on each other; "
                    "FACES=CONTACT holds them apart",
                    result.name, part)));
  }
}

// Less than an element that overlaps is no contact, and less than one that touches no good one.
void tell_lone_nodes(const TipState& at, const TipFaces& faces, const results::TipResult& result,
                     results::StepResult& out) {
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
          : crack_face_overlap(at.scene.cracked, at.front.crack.index(), at.state.u).lone;
  if (part > overlap_of_round_off) {
    out.notes.push_back(results::less_exact_note(
        fmt::format("{}: the crack faces overlap at single nodes, by {:.1e} of their largest "
                    "displacement: less than the mesh resolves, and left open; K may be off by a "
                    "part of that order, and a smaller SIZE on $TIPNET shows it",
                    result.name, part)));
  }
}

// Where the faces touch at the tip they do not part there: K1 is 0, and so is K2 where they have
// not slipped either. What the rings find instead is the error of the mesh.
void close_tip(const TipFaces& faces, double scale, results::TipResult& result,
               results::StepResult& out) {
  const double K1 = result.K1;
  if (faces.closed) {
    result.closed = true;
    result.K1 = 0.0;
    const double all = K1 * K1 + result.K2 * result.K2;
    result.K2 = faces.held ? 0.0 : result.K2;
    result.G = faces.held ? 0.0 : result.G;
    // Of (K1^2 + K2^2)/E' the part of K2 stays.
    result.G_from_K *= all > 0.0 ? result.K2 * result.K2 / all : 0.0;
    if (std::abs(K1) > worst_closed_K1 * scale) {
      out.notes.push_back(results::less_exact_note(
          fmt::format("{}: the crack faces touch at the tip, but the rings "
                      "find K1 = {:.3g}: the mesh there is too coarse, and K2 off by as much; "
                      "take a smaller SIZE on $TIPNET",
                      result.name, K1)));
    }
    out.notes.push_back(
        results::note(fmt::format("{}: the crack faces touch at the tip{}", result.name,
                                  faces.held ? " and have not slipped: K1 = K2 = 0" : ": K1 = 0")));
  } else if (faces.open_nodes > 0 && faces.open_nodes < least_open_nodes) {
    out.notes.push_back(results::less_exact_note(
        fmt::format("{}: the crack faces are open at the tip over less "
                    "than two elements: K is known by its order alone; take a smaller SIZE "
                    "on $TIPNET",
                    result.name)));
  }
  if (!faces.closed && K1 < 0.0 && std::abs(K1) <= small_K1 * scale) {
    result.K1 = 0.0;
  } else if (!faces.closed && K1 < 0.0) {
    result.invalid_reason =
        "K1 is negative though the crack faces do not overlap: the mesh at the tip is "
        "too coarse, so this K is not an answer";
    out.notes.push_back(results::invalid_result_note(
        fmt::format("{}: {}; take a smaller SIZE on $TIPNET", result.name, result.invalid_reason)));
  }
}

// Whether K is nothing but the round-off of displacements that a crack is carried along with.
bool is_round_off(const TipState& at) {
  const double scale =
      at.K.E_effective * at.state.u.lpNorm<Eigen::Infinity>() / std::sqrt(at.front.a);
  return std::hypot(at.K.K1, at.K.K2) <= 1e-9 * scale;
}

// K of the size that pressure between the faces, or their largest displacement against each other,
// has at a crack of this length under uniform stress; no less than what round-off makes of it.
double k_scale(const TipState& at, const TipFaces& faces) {
  const double a = at.front.a;
  const double E = at.K.E_effective;
  const double pressed = faces.pressure * std::sqrt(std::numbers::pi * a);
  const double jump = crack_face_jump(at.scene.cracked, at.front.crack.index(), at.state.u);
  // Faces of a crack of half length a under uniform stress part by 4 sigma a / E' in its middle.
  const double open = 0.25 * E * jump * std::sqrt(std::numbers::pi / a);
  const double least = 1e-6 * E * at.state.u.lpNorm<Eigen::Infinity>() / std::sqrt(a);
  return std::max({pressed, open, least});
}

} // namespace

void check_crack_faces(const TipState& at, results::TipResult& result, results::StepResult& out) {
  if (at.K.two_materials) {
    result.invalid_reason =
        "the tip lies between two materials, where stresses oscillate: it has no K1 and "
        "K2, only G";
    // No table has a K of it.
    out.notes.push_back(results::note(fmt::format("{}: {}", result.name, result.invalid_reason)));
    return;
  }
  if (is_round_off(at)) { // nothing loads the crack
    result.K1 = result.K2 = result.G = result.G_from_K = 0.0;
    result.closed = at.model.cracks[at.front.crack.index()].faces_in_contact &&
                    tip_faces(at.scene, at.front, at.state).closed;
    return;
  }
  if (!at.model.cracks[at.front.crack.index()].faces_in_contact) {
    tell_overlap(at, result, out);
    return;
  }
  const TipFaces faces = tip_faces(at.scene, at.front, at.state);
  close_tip(faces, k_scale(at, faces), result, out);
  tell_lone_nodes(at, faces, result, out);
}

} // namespace spricka::analysis
