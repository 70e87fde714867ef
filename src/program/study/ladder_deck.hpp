// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/run_options.hpp"

namespace spricka::program {

/// What the command line asks of a ladder.
struct HierarchyOptions {
  RunOptions deck;         ///< out empty: the deck's name with .ladder
  double tolerance = 0.02; ///< of the answers, as a part
  int jobs = 1;            ///< runs at once
};

/// Runs ever simpler models of a deck's joint, compares their answers with those of the deck and
/// names the cheapest that is within the tolerance. Writes ladder.csv, ladder.html, the decks of
/// all variants, and that of the cheapest with the deck's answers as checks, into a folder. The
/// outcome is that of the deck itself where it cannot be solved.
base::Outcome run_hierarchy(const HierarchyOptions& given);

} // namespace spricka::program
