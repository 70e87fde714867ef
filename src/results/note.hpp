// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/result_concern.hpp"

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::results {

/// What a reader of the results should know: a note, or a warning, which says what of them is in
/// doubt.
struct Note {
  std::optional<base::ResultConcern> kind;
  std::string text;

  bool operator==(const Note&) const = default;
};

/// A text for the reader that puts nothing of the results in doubt.
inline Note make_note(std::string text) {
  return {std::nullopt, std::move(text)};
}
/// As the deck asks for it: is it what is meant?
inline Note questionable_input_note(std::string text) {
  return {base::ResultConcern::odd, std::move(text)};
}
/// The text says by how much.
inline Note less_exact_note(std::string text) {
  return {base::ResultConcern::less_exact, std::move(text)};
}
/// A warning that a result asked for has no valid answer, with the reason.
inline Note invalid_result_note(std::string text) {
  return {base::ResultConcern::no_answer, std::move(text)};
}

/// Whether a note says that something is in doubt.
inline bool is_warning(const Note& note) {
  return note.kind.has_value();
}

/// The code of warnings in notes: "W502" odd, "W507" less exact, "W508" no answer.
std::string_view warning_code(base::ResultConcern kind);

/// Texts of which none is a warning.
std::vector<Note> make_plain_notes(const std::vector<std::string>& texts);

/// "warning W508: text", of a note the text alone: as listings show it and files keep it.
std::string text_with_code(const Note& note);
/// The same of each note, in their order.
std::vector<std::string> text_with_code(const std::vector<Note>& notes);
/// Back from what files keep.
std::vector<Note> parse_notes(const std::vector<std::string>& texts);

/// A warning of the whole run: of the deck, of a mesh or of results.
struct Warning {
  std::string code; ///< "W508"
  std::string text;

  auto operator<=>(const Warning&) const = default;
};

/// "W508: text", as listings show it and files keep it.
std::string text_with_code(const Warning& warning);
/// The same of each warning, in their order.
std::vector<std::string> text_with_code(const std::vector<Warning>& warnings);
/// Back from what files keep.
std::vector<Warning> parse_warnings(const std::vector<std::string>& texts);

} // namespace spricka::results
