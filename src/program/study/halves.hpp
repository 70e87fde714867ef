// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"
#include "program/study/deck_answers.hpp"

#include <optional>
#include <string>
#include <vector>

/// A deck whose model is one of two, four or eight mirror images.
namespace spricka::program {

struct PartOfModel {
  std::optional<deck::DeckText> text; ///< empty: the model has no plane of symmetry
  std::string mirrored;               ///< across which axes, "XY"
  std::string name;                   ///< "half by symmetry"
  std::string words;                  ///< "y >= 0 alone"
  std::string reason;                 ///< why there is no text
};

/// Puts a $SYMMETRY card for each plane that all of the model respects.
PartOfModel part_of_model(const model::Model& model, const deck::DeckText& text);

/// Of how many mirror images a model is one that is `mirrored` across these axes.
inline int parts_of(const std::string& mirrored) {
  return 1 << mirrored.size();
}

/// Answers of the whole from those of a part: energies are as many times as large; of contact arcs,
/// which may lie across, and of extremes that change their sign across a plane, nothing is told.
void tell_of_whole(std::vector<Reading>& readings, const std::vector<Answer>& answers,
                   const std::string& mirrored);

} // namespace spricka::program
