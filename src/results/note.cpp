// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/note.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace spricka::results {

namespace {

constexpr std::string_view warning_mark = "warning: ";

} // namespace

std::vector<Note> notes_of(const std::vector<std::string>& texts) {
  std::vector<Note> notes;
  std::ranges::transform(texts, std::back_inserter(notes), note);
  return notes;
}

std::string marked(const Note& note) {
  return note.severity == base::Severity::warning ? std::string(warning_mark) + note.text
                                                  : note.text;
}

std::vector<std::string> marked(const std::vector<Note>& notes) {
  std::vector<std::string> texts;
  std::ranges::transform(notes, std::back_inserter(texts),
                         [](const Note& note) { return marked(note); });
  return texts;
}

std::vector<Note> notes_from(const std::vector<std::string>& texts) {
  std::vector<Note> notes;
  notes.reserve(texts.size());
  for (const std::string& text : texts) {
    notes.push_back(text.starts_with(warning_mark) ? warning(text.substr(warning_mark.size()))
                                                   : note(text));
  }
  return notes;
}

} // namespace spricka::results
