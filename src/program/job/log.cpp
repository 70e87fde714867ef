// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/log.hpp"

#include "base/printable.hpp"
#include "base/source_index.hpp"
#include "program/job/standard_streams.hpp"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace spricka::program {

namespace {

using Json = nlohmann::ordered_json;

// One record, one line. Bytes of a deck that are not UTF-8 are replaced.
void write_record(const Json& record) {
  write_to_stderr(record.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Json record_of(const base::SourceTexts& sources, base::SourceIndex& places,
               const base::Diagnostic& d) {
  Json record;
  record["type"] = "diagnostic";
  record["severity"] = base::display_word(d.severity);
  record["code"] = d.code;
  if (d.span.valid()) {
    const base::SourceLocation begin = places.locate(d.span.file, d.span.begin);
    const base::SourceLocation end = places.locate(d.span.file, d.span.end);
    record["file"] = sources.file_name(d.span.file);
    record["line"] = begin.line;
    record["column"] = begin.column;
    record["end_line"] = end.line;
    record["end_column"] = end.column;
  }
  record["text"] = d.text;
  if (!d.hint.empty()) {
    record["hint"] = d.hint;
  }
  return record;
}

} // namespace

Log::Log(LogFormat format) : format_(format), colour_(message_colour()) {}

void Log::report_diagnostics(const base::SourceTexts& sources,
                             const base::Diagnostics& diagnostics) const {
  if (format_ == LogFormat::text) {
    write_to_stderr(base::format_messages(sources, diagnostics, colour_));
    return;
  }
  base::SourceIndex places(sources);
  for (const base::Diagnostic* d : base::messages_by_severity(diagnostics)) {
    write_record(record_of(sources, places, *d));
  }
}

void Log::report_message(base::Severity severity, std::string_view code, std::string_view text,
                         std::string_view file) const {
  if (format_ == LogFormat::text) {
    base::Diagnostics one;
    const auto add = severity == base::Severity::error     ? &base::Diagnostics::error
                     : severity == base::Severity::warning ? &base::Diagnostics::warning
                                                           : &base::Diagnostics::note;
    (one.*add)({}, std::string(code), std::string(text), {});
    write_to_stderr(fmt::format("{}{}{}", base::make_printable(file), file.empty() ? "" : ": ",
                                base::format_messages({}, one, colour_)));
    return;
  }
  Json record{{"type", "diagnostic"}, {"severity", base::display_word(severity)}, {"code", code}};
  if (!file.empty()) {
    record["file"] = file;
  }
  record["text"] = text;
  write_record(record);
}

void Log::report_failed_check(const results::CheckResult& check) const {
  if (format_ == LogFormat::json) {
    Json record{{"type", "check"}, {"passed", false}, {"quantity", check.text}};
    if (check.trouble.empty()) {
      record.update({{"found", check.found},
                     {"wanted", check.wanted},
                     {"tolerance_kind", check.relative ? "REL" : "ABS"},
                     {"error", check.error},
                     {"tolerance", check.tolerance}});
    } else {
      record["trouble"] = check.trouble;
    }
    write_record(record);
  } else if (!check.trouble.empty()) {
    write_to_stderr(fmt::format("check failed: {}: {}\n", check.text, check.trouble));
  } else {
    write_to_stderr(fmt::format(
        "check failed: {} = {:.8g}, wanted {:.8g}: {} {:.2e} > {:.2e}\n", check.text, check.found,
        check.wanted, check.relative ? "REL" : "ABS", std::abs(check.error), check.tolerance));
  }
}

bool check_streams_written(LogFormat format) {
  errno = 0;
  std::cout.flush();
  const bool missing =
      std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || std::cout.fail() || std::cout.bad();
  if (missing) {
    const std::string why = errno != 0 ? fmt::format(": {}", std::strerror(errno)) : "";
    Log(format).report_message(base::Severity::error, "E468",
                               "standard output is incomplete" + why);
  }
  const bool silent = std::ferror(stderr) != 0;
  return !missing && !silent;
}

} // namespace spricka::program
