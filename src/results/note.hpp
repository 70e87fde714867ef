// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/doubt.hpp"

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
  std::optional<base::ResultConcern> doubt;
  std::string text;

  bool operator==(const Note&) const = default;
};

inline Note note(std::string text) {
  return {std::nullopt, std::move(text)};
}
/// As the deck asks for it: is it what is meant?
inline Note odd(std::string text) {
  return {base::ResultConcern::odd, std::move(text)};
}
/// The text says by how much.
inline Note less_exact(std::string text) {
  return {base::ResultConcern::less_exact, std::move(text)};
}
inline Note no_answer(std::string text) {
  return {base::ResultConcern::no_answer, std::move(text)};
}

inline bool warns(const Note& note) {
  return note.doubt.has_value();
}

/// The code of warnings in notes: "W502" odd, "W507" less exact, "W508" no answer.
std::string_view code_of(base::ResultConcern doubt);

/// Texts of which none is a warning.
std::vector<Note> notes_of(const std::vector<std::string>& texts);

/// "warning W508: text", of a note the text alone: as listings show it and files keep it.
std::string marked(const Note& note);
std::vector<std::string> marked(const std::vector<Note>& notes);
/// Back from what files keep.
std::vector<Note> notes_from(const std::vector<std::string>& texts);

/// A warning of the whole run: of the deck, of a mesh or of results.
struct Warning {
  std::string code; ///< "W508"
  std::string text;

  auto operator<=>(const Warning&) const = default;
};

/// "W508: text", as listings show it and files keep it.
std::string marked(const Warning& warning);
std::vector<std::string> marked(const std::vector<Warning>& warnings);
/// Back from what files keep.
std::vector<Warning> warnings_from(const std::vector<std::string>& texts);

} // namespace spricka::results
