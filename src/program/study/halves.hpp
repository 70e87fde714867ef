// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"
#include "program/study/deck_answers.hpp"
#include "program/study/deck_edits.hpp"

#include <string>
#include <vector>

/// A deck whose model is one of two, four or eight mirror images.
namespace spricka::program {

/// Without a text the model has no plane of symmetry.
struct SymmetricPart : RewrittenDeck {
  std::string mirrored; ///< across which axes, "XY"
  std::string name;     ///< "half by symmetry"
  std::string words;    ///< "y >= 0 alone"
};

/// Puts a $SYMMETRY card for each plane that all of the model respects.
SymmetricPart reduce_by_symmetry(const model::Model& model, const deck::DeckCardList& text);

/// Of how many mirror images a model is one that is `mirrored` across these axes.
inline int mirror_image_count(const std::string& mirrored) {
  return 1 << mirrored.size();
}

/// Answers of the whole from those of a part: energies are as many times as large; of contact arcs,
/// which may lie across, and of extremes that change their sign across a plane, nothing is told.
void convert_answers_to_whole_model(std::vector<AnswerReading>& readings,
                                    const std::vector<AnswerRequest>& answers,
                                    const std::string& mirrored);

} // namespace spricka::program
