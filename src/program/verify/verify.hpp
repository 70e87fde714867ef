// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace spricka::program {

struct VerifyOptions {
  std::vector<std::string> asked;             ///< tiers, names, patterns; empty: quick
  std::filesystem::path decks;                ///< empty: those that ship
  std::filesystem::path out = "verification"; ///< folder of page and table
  std::filesystem::path before;               ///< the last table; empty: the one in `out`
  std::filesystem::path markdown;             ///< empty: no chapter, and no table beside it
  std::string engine = {};                    ///< of the equations; empty: as each run chooses
  int at_once = 0;                            ///< decks at a time; 0: as many as cores
  bool keep = false;                          ///< keep the run folders, in a folder beside the page
  bool costs = false;                         ///< renew the table of costs beside the decks
  bool list = false;                          ///< print what would be run, and run nothing
  bool quiet = false;
};

/// Runs decks against their references and writes verification.html and verification.csv. Returns
/// the worst end of a deck: check_failed where a tolerance is missed.
base::ProgramOutcome verify_decks(const VerifyOptions& options);

} // namespace spricka::program
