// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What a restart file keeps of a deck's cards, so that a later deck can be told from it.
namespace spricka::archive {

/// A card that results depend on.
struct CardFingerprint {
  std::string name; ///< without the $
  std::string hash; ///< of its text without comments and superfluous blanks, and of files it names
  std::string uses; ///< parameters in it with their values, "F = 75000, R = 36"
  std::string file; ///< where it stands
  int line = 0;
  base::SourceSpan span; ///< in the deck that is read now
};

/// All cards with their includes' but those that change no solution ($TEST, $OUTPUT, $CHECK,
/// $RESTART, $CONTROL, $TASK, $SWEEP) or only carry others ($PARAMETER, $INCLUDE, $END). The deck
/// is read anew. Throws std::system_error where that fails.
std::vector<CardFingerprint> fingerprints_of_result_cards(const std::filesystem::path& deck,
                                                          const model::Model& model);

/// The first card that is another one, was added or is missing; empty: all are the same.
struct CardDifference {
  base::SourceSpan span; ///< in the deck `now`, of its last card where one is missing at the end
  std::string text;      ///< "$LOAD uses F = 80000, it was F = 75000"
};
/// Compares the cards of two decks in their order and says in words what is different first. Empty:
/// all are the same.
std::optional<CardDifference> first_card_difference(const std::vector<CardFingerprint>& before,
                                                    const std::vector<CardFingerprint>& now);

/// Those of these names only, in their order; or all but those.
std::vector<CardFingerprint> select_cards(const std::vector<CardFingerprint>& cards,
                                          const std::vector<std::string>& names);
/// The cards of all names but these, in their order.
std::vector<CardFingerprint> exclude_cards(const std::vector<CardFingerprint>& cards,
                                           const std::vector<std::string>& names);

} // namespace spricka::archive
