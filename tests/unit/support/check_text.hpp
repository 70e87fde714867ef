// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/unit/support/run_text.hpp"

#include <nlohmann/json.hpp>

namespace spricka::test {

/// What `spricka check --json` says of a deck.
// NOLINTNEXTLINE(bugprone-exception-escape): moving json checks itself by assertions that may throw
struct Checked {
  Outcome outcome;
  nlohmann::json found; ///< null when nothing could be shown
};

inline Checked check_text(const Folder& folder, const std::string& deck, int threads = 1,
                          bool exact_forecast = false) {
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << deck;
  program::RunOptions options;
  options.deck = file;
  options.threads = threads;
  options.check_only = true;
  options.exact_forecast = exact_forecast;
  options.json = true;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  Checked checked;
  checked.outcome.exit_code = base::exit_code(program::run_deck(options));
  const std::string text = testing::internal::GetCapturedStdout();
  checked.outcome.messages = testing::internal::GetCapturedStderr();
  checked.found = text.empty() ? nlohmann::json() : nlohmann::json::parse(text);
  return checked;
}

/// Plate with an edge crack that grows.
inline std::string growing_crack(int n, const std::string& lengths) {
  const std::string count = std::to_string(n);
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=20 NX=)" +
         count + " NY=" + count + R"(
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 1
$CRACK NAME=C A0=1 ANGLE=0
  0 10
$STEP NAME=PULL
  LOAD PULL 1
$GROW LAW=INCREMENT KMAX=PULL
  )" + lengths +
         "\n$END\n";
}

} // namespace spricka::test
