// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/array_task.hpp"

#include <filesystem>
#include <optional>
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
  std::optional<ArrayTask> array; ///< the decks of this task alone, without page and table
  bool collect = false;           ///< run nothing: page and table of what tasks have run
};

/// Runs decks against their references and writes verification.html and verification.csv. Returns
/// the worst end of a deck: check_failed where a tolerance is missed. Tasks of a job array share
/// the decks in the folder `runs`; whoever collects them gets stopped where some are missing.
base::ProgramOutcome verify_decks(const VerifyOptions& options);

} // namespace spricka::program
