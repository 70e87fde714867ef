// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/run_options.hpp"
#include "program/study/settings.hpp"

#include <vector>

namespace spricka::program {

/// What the command line asks of a study.
struct StudyOptions {
  RunOptions deck;                          ///< out empty: the deck's name with .study
  std::vector<ParameterVariation> requests; ///< in place of what is found in the deck
  int jobs = 1;                             ///< runs at once; one alone has an honest CPU time
  double budget = 600.0;                    ///< [s] CPU of all runs; what would not fit is left out
};

/// Work against precision: runs a deck in many settings, and says what each costs and how right it
/// is. Writes study.csv and study.html into a folder. The outcome is that of the deck itself where
/// it cannot be solved.
base::Outcome study_deck(const StudyOptions& given);

} // namespace spricka::program
