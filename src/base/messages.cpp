// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"

#include "base/printable.hpp"
#include "base/result_concern.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace spricka::base {

namespace {

/// Terminal sequences; empty where there is no colour.
struct Paint {
  std::string_view bold;
  std::string_view severity;
  std::string_view caret;
  std::string_view off;
};

Paint paint_for(Severity severity, MessageColour colour) {
  if (colour == MessageColour::none) {
    return {};
  }
  const std::string_view red = "\033[1;31m";
  const std::string_view yellow = "\033[1;33m";
  return {"\033[1m", severity == Severity::error ? red : yellow, "\033[1;32m", "\033[0m"};
}

// Blanks up to the token (tabs copied as tabs), then carets under the whole of it.
std::string caret_line(const SourceTexts& sources, SourceSpan span) {
  const std::string_view line = sources.line_at(span.file, span.begin);
  const std::size_t first = sources.locate(span.file, span.begin).column - 1;
  std::string result;
  std::size_t column = 0;
  std::size_t byte = 0;
  for (; byte < line.size() && column < first; ++byte) {
    if ((static_cast<unsigned char>(line[byte]) & 0xC0U) == 0x80U) {
      continue;
    }
    result += line[byte] == '\t' ? '\t' : ' ';
    ++column;
  }
  result.append(first - column, ' ');
  std::size_t carets = 0;
  const std::string_view token =
      sources.text(span.file).substr(span.begin, span.end > span.begin ? span.end - span.begin : 0);
  for (const char c : token) {
    if (c == '\n' || c == '\r') {
      break;
    }
    carets += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1U : 0U;
  }
  return result + std::string(std::max<std::size_t>(carets, 1), '^');
}

constexpr std::size_t k_longest_line = 160; ///< characters of a source line that are shown
constexpr std::size_t k_longest_text = 400; ///< bytes of a message that are shown

// Leaves `count` characters from the one at `first` on.
std::string cut(const std::string& text, std::size_t first, std::size_t count) {
  std::string out;
  std::size_t column = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    column += is_utf8_continuation_byte(text[i]) ? 0U : 1U;
    if (column > first && column <= first + count) {
      out += text[i];
    }
  }
  return out;
}

// The line and its carets; of a long line the part round the token.
std::pair<std::string, std::string> excerpt(const SourceTexts& sources, const Diagnostic& d) {
  std::string line = make_printable(sources.line_at(d.span.file, d.span.begin));
  std::string carets = caret_line(sources, d.span);
  const auto length = static_cast<std::size_t>(std::count_if(
      line.begin(), line.end(), [](char c) { return !is_utf8_continuation_byte(c); }));
  if (std::max(length, carets.size()) > k_longest_line) {
    const std::size_t column = sources.locate(d.span.file, d.span.begin).column - 1;
    const std::size_t first = column > k_longest_line / 2 ? column - k_longest_line / 2 : 0;
    line = (first > 0 ? ".." : "") + cut(line, first, k_longest_line) +
           (length > first + k_longest_line ? ".." : "");
    carets = (first > 0 ? "  " : "") + cut(carets, first, k_longest_line);
  }
  return {std::move(line), std::move(carets)};
}

std::string shortened(std::string text) {
  text = make_printable(text);
  if (text.size() > k_longest_text) {
    std::size_t end = k_longest_text;
    while (end > 0 && is_utf8_continuation_byte(text[end])) {
      --end;
    }
    text.resize(end);
    text += "..";
  }
  return text;
}

std::string format_one(const SourceTexts& sources, const Diagnostic& d, MessageColour colour) {
  const Paint paint = paint_for(d.severity, colour);
  std::string out;
  const std::string kind = fmt::format("{}{} {}:{} {}\n", paint.severity, display_word(d.severity),
                                       d.code, paint.off, shortened(d.text));
  if (d.span.valid()) {
    const SourceLocation at = sources.locate(d.span.file, d.span.begin);
    out +=
        fmt::format("{}{}:{}:{}:{} {}", paint.bold, make_printable(sources.file_name(d.span.file)),
                    at.line, at.column, paint.off, kind);
    const std::string number = fmt::format("{:>6}", at.line);
    const auto [line, carets] = excerpt(sources, d);
    out += fmt::format("{} | {}\n", number, line);
    out += fmt::format("{} | {}{}{}\n", std::string(number.size(), ' '), paint.caret, carets,
                       paint.off);
  } else {
    out += kind;
  }
  if (!d.hint.empty()) {
    out += fmt::format("       = {}\n", shortened(d.hint));
  }
  return out;
}

} // namespace

std::string_view display_word(Severity severity) {
  switch (severity) {
  case Severity::note:
    return "note";
  case Severity::warning:
    return "warning";
  case Severity::error:
    break;
  }
  return "error";
}

std::vector<const Diagnostic*> messages_by_severity(const Diagnostics& diagnostics) {
  std::vector<const Diagnostic*> order;
  for (const Diagnostic& d : diagnostics.messages()) {
    order.push_back(&d);
  }
  std::ranges::stable_sort(order, {}, [](const Diagnostic* d) {
    return std::tuple(-static_cast<int>(d->severity), concern_of_warning_code(d->code),
                      d->span.file, d->span.begin);
  });
  return order;
}

std::string format_messages(const SourceTexts& sources, const Diagnostics& diagnostics,
                            std::size_t limit) {
  return format_messages(sources, diagnostics, MessageColour::none, limit);
}

std::string format_messages(const SourceTexts& sources, const Diagnostics& diagnostics,
                            MessageColour colour, std::size_t limit) {
  std::string out;
  std::size_t errors = 0;
  std::size_t warnings = 0;
  for (const Diagnostic* d : messages_by_severity(diagnostics)) {
    if ((d->severity == Severity::error && ++errors > limit) ||
        (d->severity == Severity::warning && ++warnings > limit)) {
      continue;
    }
    out += format_one(sources, *d, colour);
  }
  if (errors > limit) {
    out += fmt::format("... and {} more errors\n", errors - limit);
  }
  if (warnings > limit) {
    out += fmt::format("... and {} more warnings\n", warnings - limit);
  }
  return out;
}

} // namespace spricka::base
