// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/messages.hpp"
#include "program/job/log_format.hpp"
#include "results/results.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace spricka::program {

/// Where the messages of a run go: stderr, as text for people or as one JSON object a line for
/// programs (manual/command_line.md names the members).
class Log {
public:
  explicit Log(LogFormat format);

  /// Text: with source line and carets, at most 20 errors. JSON: all of them.
  void report_diagnostics(const base::SourceTexts& sources,
                          const base::Diagnostics& diagnostics) const;
  /// A message without a place in a deck; `file` may be empty.
  void report_message(base::Severity severity, std::string_view code, std::string_view text,
                      std::string_view file = {}) const;
  /// A check that has failed: value found and wanted with the tolerance, or why there is no value.
  void report_failed_check(const results::CheckResult& check) const;

private:
  LogFormat format_;
  base::MessageColour colour_;
};

/// Whether all that was written to stdout and stderr has got there; what stdout lacks is told.
bool check_streams_written(LogFormat format);

} // namespace spricka::program
