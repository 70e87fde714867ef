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
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace spricka::program {

namespace {

using Json = nlohmann::ordered_json;

// One record, one line. Bytes of a deck that are not UTF-8 are replaced.
void write_record(const Json& record) {
  write_to_stderr(record.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

LoggedMessage message_of(const base::SourceTexts& sources, base::SourceIndex& places,
                         const base::Diagnostic& d) {
  LoggedMessage message{
      .severity = d.severity, .code = d.code, .text = d.text, .hint = d.hint, .file = {}};
  if (d.span.valid()) {
    message.file = sources.file_name(d.span.file);
    message.begin = places.locate(d.span.file, d.span.begin);
    message.end = places.locate(d.span.file, d.span.end);
  }
  return message;
}

Json record_of(const LoggedMessage& message) {
  Json record;
  record["type"] = "diagnostic";
  record["severity"] = base::display_word(message.severity);
  record["code"] = message.code;
  if (!message.file.empty()) {
    record["file"] = message.file;
  }
  if (message.begin.line > 0) {
    record["line"] = message.begin.line;
    record["column"] = message.begin.column;
    record["end_line"] = message.end.line;
    record["end_column"] = message.end.column;
  }
  record["text"] = message.text;
  if (!message.hint.empty()) {
    record["hint"] = message.hint;
  }
  return record;
}

std::string failed_check_text(const results::CheckResult& check, const base::OutputUnit& unit) {
  const base::OutputUnit of_error = check.relative ? base::OutputUnit() : unit;
  return check.trouble.empty()
             ? fmt::format("check failed: {} = {:.8g}, wanted {:.8g}: {} {:.2e} > {:.2e}",
                           check.text, unit.from_deck(check.found), unit.from_deck(check.wanted),
                           check.relative ? "REL" : "ABS",
                           std::abs(of_error.from_deck(check.error)),
                           of_error.from_deck(check.tolerance))
             : fmt::format("check failed: {}: {}", check.text, check.trouble);
}

} // namespace

Log::Log(LogFormat format) : format_(format), colour_(message_colour()) {}

Log::Log(std::function<void(const LoggedMessage&)> receive)
    : format_(LogFormat::json), colour_(base::MessageColour::none), receive_(std::move(receive)) {}

void Log::report_diagnostics(const base::SourceTexts& sources,
                             const base::Diagnostics& diagnostics) const {
  if (format_ == LogFormat::text) {
    write_to_stderr(base::format_messages(sources, diagnostics, colour_));
    return;
  }
  base::SourceIndex places(sources);
  for (const base::Diagnostic* d : base::messages_by_severity(diagnostics)) {
    const LoggedMessage message = message_of(sources, places, *d);
    if (receive_) {
      receive_(message);
    } else {
      write_record(record_of(message));
    }
  }
}

void Log::report_message(base::Severity severity, std::string_view code, std::string_view text,
                         std::string_view file) const {
  const LoggedMessage message{.severity = severity,
                              .code = std::string(code),
                              .text = std::string(text),
                              .hint = {},
                              .file = std::string(file)};
  if (receive_) {
    receive_(message);
    return;
  }
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
  write_record(record_of(message));
}

void Log::report_failed_check(const results::CheckResult& check,
                              const base::OutputUnit& unit) const {
  if (receive_) {
    receive_({.severity = base::Severity::error,
              .code = {},
              .text = failed_check_text(check, unit),
              .hint = {},
              .file = {}});
  } else if (format_ == LogFormat::json) {
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
  } else {
    write_to_stderr(failed_check_text(check, unit) + "\n");
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
