// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"

#include <map>
#include <string>
#include <vector>

/// What a sweep has found so far, as plain records.
namespace spricka::results {

/// One number of a point: K1 of tip TOP at the end of step LOAD in increment 1, in units of output.
/// What does not apply is empty, or 0 for the increment.
struct SweepResultValue {
  std::string quantity;
  std::string name;
  std::string step;
  int increment = 0;
  double value = 0.0;

  /// Heading of the column of this number, "K1:TOP:LOAD:1"; parts that do not apply are left out.
  [[nodiscard]] std::string column_name() const {
    std::string text = quantity;
    for (const std::string& part :
         {name, step, increment > 0 ? std::to_string(increment) : std::string()}) {
      text += part.empty() ? "" : ":" + part;
    }
    return text;
  }
};

struct SweepPoint {
  std::size_t number = 1;     ///< from 1, in the order of the sweep
  std::string folder;         ///< "001", in the sweep's run folder
  std::vector<double> values; ///< [parameter]
  base::ProgramOutcome outcome = base::ProgramOutcome::done;
  std::string error; ///< why there is no result, or which checks failed; empty normally
  int checks = 0;
  int passed = 0;
  int warnings = 0;
  bool reused = false; ///< taken over from an earlier run of the sweep
  bool taken = false;  ///< another process computes it at this moment
  std::vector<SweepResultValue> cells;
  /// [file of a card $OUTPUT EVERY=END] what the card asks for
  std::map<std::string, std::vector<SweepResultValue>> requested;
};

struct SweepResult {
  std::vector<std::string> parameters; ///< as the deck writes them
  std::size_t count = 0;               ///< of all points
  std::vector<SweepPoint> points;      ///< tried so far, ascending
};

} // namespace spricka::results
