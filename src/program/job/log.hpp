// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/messages.hpp"
#include "base/output_unit.hpp"
#include "program/job/log_format.hpp"
#include "results/results.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace spricka::program {

/// A message on its way out, with its place in a deck where it has one.
struct LoggedMessage {
  base::Severity severity = base::Severity::error;
  std::string code, text, hint; ///< the code of a failed check and some hints are empty
  std::string file;             ///< may be empty
  base::SourceLocation begin = {}, end = {}; ///< line 0: no place in the file
};

/// Where the messages of a run go: stderr, as text for people or as one JSON object a line for
/// programs (manual/command_line.md names the members), or to who calls the library.
class Log {
public:
  explicit Log(LogFormat format);
  /// Hands each message to `receive` and writes nothing.
  explicit Log(std::function<void(const LoggedMessage&)> receive);

  /// Text: with source line and carets, at most 20 errors. JSON: all of them.
  void report_diagnostics(const base::SourceTexts& sources,
                          const base::Diagnostics& diagnostics) const;
  /// A message without a place in a deck; `file` may be empty.
  void report_message(base::Severity severity, std::string_view code, std::string_view text,
                      std::string_view file = {}) const;
  /// A check that has failed: value found and wanted with the tolerance, or why there is no value.
  void report_failed_check(const results::CheckResult& check, const base::OutputUnit& unit) const;

private:
  LogFormat format_;
  base::MessageColour colour_;
  std::function<void(const LoggedMessage&)> receive_; ///< empty: stderr
};

/// Whether all that was written to stdout and stderr has got there; what stdout lacks is told.
bool check_streams_written(LogFormat format);

} // namespace spricka::program
