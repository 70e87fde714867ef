// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/note.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

namespace spricka::results {

namespace {

constexpr std::array concerns{base::ResultConcern::no_answer, base::ResultConcern::less_exact,
                              base::ResultConcern::odd};

std::string mark_of(base::ResultConcern kind) {
  return fmt::format("warning {}: ", warning_code(kind));
}

template <class Marked> std::vector<std::string> all_marked(const std::vector<Marked>& list) {
  std::vector<std::string> texts;
  std::ranges::transform(list, std::back_inserter(texts),
                         [](const Marked& one) { return text_with_code(one); });
  return texts;
}

} // namespace

std::string_view warning_code(base::ResultConcern kind) {
  switch (kind) {
  case base::ResultConcern::no_answer:
    return "W508";
  case base::ResultConcern::less_exact:
    return "W507";
  case base::ResultConcern::odd:
    break;
  }
  return "W502";
}

std::vector<Note> make_plain_notes(const std::vector<std::string>& texts) {
  std::vector<Note> notes;
  std::ranges::transform(texts, std::back_inserter(notes), make_note);
  return notes;
}

std::string text_with_code(const Note& note) {
  return note.kind ? mark_of(*note.kind) + note.text : note.text;
}

std::vector<std::string> text_with_code(const std::vector<Note>& notes) {
  return all_marked(notes);
}

std::vector<Note> parse_notes(const std::vector<std::string>& texts) {
  std::vector<Note> notes;
  notes.reserve(texts.size());
  for (const std::string& text : texts) {
    Note found = make_note(text);
    for (const base::ResultConcern kind : concerns) {
      if (const std::string mark = mark_of(kind); text.starts_with(mark)) {
        found = {kind, text.substr(mark.size())};
      }
    }
    notes.push_back(std::move(found));
  }
  return notes;
}

std::string text_with_code(const Warning& warning) {
  return fmt::format("{}: {}", warning.code, warning.text);
}

std::vector<std::string> text_with_code(const std::vector<Warning>& warnings) {
  return all_marked(warnings);
}

std::vector<Warning> parse_warnings(const std::vector<std::string>& texts) {
  std::vector<Warning> warnings;
  warnings.reserve(texts.size());
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(": ");
    warnings.push_back(colon == std::string::npos ? Warning{.code = {}, .text = text}
                                                  : Warning{.code = text.substr(0, colon),
                                                            .text = text.substr(colon + 2)});
  }
  return warnings;
}

} // namespace spricka::results
