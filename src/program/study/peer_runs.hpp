// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/job/ready_deck.hpp"
#include "program/study/verdict.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// The settings of a study once more, by CalculiX on the same meshes.
namespace spricka::program {

/// What is asked of CalculiX, and of which decks.
struct PeerTask {
  std::filesystem::path program; ///< ccx
  const CheckedDeck* ready = nullptr;
  const std::vector<AnswerRequest>* answers = nullptr;
  double seconds = 0.0; ///< CPU time of all its runs together
};

/// The trials that CalculiX makes of those of `own` that are meshes of the deck as it is, coarse to
/// fine, as long as there is time; inputs and results are left beside their decks. What it cannot
/// be asked, or has no time for, goes to `notes`.
std::vector<StudyTrial> run_calculix_trials(ChildRunner& children, const PeerTask& task,
                                            const std::vector<StudyTrial>& own,
                                            std::vector<std::string>& notes);

} // namespace spricka::program
