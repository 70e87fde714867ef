// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"
#include "program/study/deck_answers.hpp"
#include "program/study/deck_edits.hpp"
#include "sense/section.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// A solid's deck as one of the plane: bodies that are the same along an axis, or round it, by
/// their section.
namespace spricka::program {

/// How answers of the solid are asked of its section.
struct SectionMapping {
  sense::SectionPlane plane;
  /// [crack, upper case] K2 of the section has the sign of K2 in space, or the other one.
  std::map<std::string, double> sign_of_K2;
};

/// A plane deck, or why there is none.
struct SectionDeck : RewrittenDeck {
  SectionMapping view;
};

/// The section of bodies along an axis in plane stress or strain ("STRESS", "STRAIN"), or of round
/// ones ("AXI"): their meshes and sets written out, other cards as of `text`, the deck of the
/// model. Refused is what differs along the axis, or round it.
SectionDeck make_section_deck(const model::Model& model, const deck::DeckCardList& text,
                              const std::string& state);

/// How the deck of a simpler model asks for an answer.
struct SectionCounterpart {
  std::optional<model::ResultCheck> check; ///< empty: that model does not have it
  double factor = 1.0;                     ///< its value over that of the solid
};

/// How the section's deck asks for each answer of the solid. [answer]
std::vector<SectionCounterpart> section_counterparts(const SectionMapping& view,
                                                     const std::vector<AnswerRequest>& answers);

/// What a run of the section's `model` says of them, as the solid's. [answer]
std::vector<AnswerReading> read_section_answers(const model::Model& model,
                                                const std::vector<SectionCounterpart>& asked,
                                                const results::RunResult& run);

} // namespace spricka::program
