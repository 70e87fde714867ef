// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "model/requests.hpp"
#include "program/study/deck_variant.hpp"
#include "results/results.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// The numbers that a deck is asked for, and what one run of a variant of it says of them. They are
/// lines of $CHECK: the deck's own, or made where it has none.
namespace spricka::program {

/// What an answer is of: they are judged together, and shown in this order.
enum class AnswerGroup { K, T, pressure, stress, displacement, energy, arc, life, other };

/// "K", "pressure": for headings.
const char* display_name(AnswerGroup group);

struct AnswerRequest {
  model::ResultCheck check;
  std::string text; ///< "K(TOP,LOAD,10.8)"
  AnswerGroup group = AnswerGroup::other;
  std::optional<double> reference; ///< of the deck; empty: it has none, or asks for zero
};

/// One answer of one run; what there is not, is no number.
struct AnswerReading {
  double value = std::numeric_limits<double>::quiet_NaN(); ///< as it is printed
  double bar = std::numeric_limits<double>::quiet_NaN();   ///< half width of the error bar of K
  double raw = std::numeric_limits<double>::quiet_NaN();   ///< K as the mesh has it

  [[nodiscard]] bool has_bar() const { return std::isfinite(bar) && std::isfinite(raw); }
  /// What the mesh has, and what converges as theory says.
  [[nodiscard]] double of_mesh() const { return has_bar() ? raw : value; }
};

/// The deck's own checks, but for equilibrium, derivatives, bars and what says nothing of a mesh.
/// Of a deck that checks no K of its cracks K1 and K2 of each tip at the end of each step and
/// length, along fronts at eight points; without cracks and checks mean pressures of its contacts,
/// and the energy.
std::vector<AnswerRequest> collect_answer_requests(const model::Model& model,
                                                   const results::RunResult& run);

/// What $CHECK finds of a line in a run; not a number where there is nothing.
double find_check_value(const model::Model& model, const model::ResultCheck& check,
                        const results::RunResult& run);

/// How the deck of a variant is asked for an answer.
struct VariantCheckAndFactor {
  std::optional<model::ResultCheck> check; ///< empty: its model does not have it
  double factor = 1.0;                     ///< its value over that of the deck given
};

/// How a variant is asked for each answer of the deck given: a section for what that plane model
/// has, with the sign of K2 and the energy of the whole; a part by symmetry for its part of the
/// energy, and not for what its images would change. [answer]
std::vector<VariantCheckAndFactor>
checks_asked_of_variant(const DeckVariant& variant, const std::vector<AnswerRequest>& answers);

/// Values in a run of a `model` that is asked so, as those of the deck given, with error bar and
/// raw value of those that have them. [answer]
std::vector<AnswerReading> read_answers(const model::Model& model,
                                        const std::vector<VariantCheckAndFactor>& asked,
                                        const results::RunResult& run);

/// What errors of each answer are parts of: the amount of `found`, or where an answer may be zero
/// (an absolute tolerance, none at all) the largest amount in the answers of its group about the
/// same crack, contact or set. 0: there is no such thing. [answer]
std::vector<double> answer_scales(const std::vector<AnswerRequest>& answers,
                                  const std::vector<double>& found);

} // namespace spricka::program
