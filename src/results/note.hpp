// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"

#include <string>
#include <utility>
#include <vector>

namespace spricka::results {

/// What a reader of the results should know: a note, or a warning where numbers are in doubt.
struct Note {
  base::Severity severity = base::Severity::note;
  std::string text;

  bool operator==(const Note&) const = default;
};

inline Note note(std::string text) {
  return {base::Severity::note, std::move(text)};
}
inline Note warning(std::string text) {
  return {base::Severity::warning, std::move(text)};
}

/// Texts of which none is a warning.
std::vector<Note> notes_of(const std::vector<std::string>& texts);

/// "warning: text", of a note the text alone: as listings show it and files keep it.
std::string marked(const Note& note);
std::vector<std::string> marked(const std::vector<Note>& notes);
/// Back from what files keep.
std::vector<Note> notes_from(const std::vector<std::string>& texts);

} // namespace spricka::results
