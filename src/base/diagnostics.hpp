// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace spricka::base {

enum class Severity { note, warning, error };

/// One message about the deck, with the place it speaks of and, where there is one, a remedy.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string code; ///< "E108"; stable, documented in the manual
  SourceSpan span;
  std::string text;
  std::string hint; ///< printed after "= "; may be empty
};

/// Collects messages; nothing is thrown, so that one run shows every mistake of a deck.
class Diagnostics {
public:
  /// Adds an error with its place in the deck; a run with errors is not solved.
  void error(SourceSpan span, std::string code, std::string text, std::string hint = {});
  /// Adds a warning with its place in the deck; the run goes on.
  void warning(SourceSpan span, std::string code, std::string text, std::string hint = {});
  /// Adds a note with its place in the deck.
  void note(SourceSpan span, std::string code, std::string text, std::string hint = {});

  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] std::size_t error_count() const { return errors_; }
  [[nodiscard]] const std::vector<Diagnostic>& messages() const { return all_; }

private:
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
};

/// "did you mean 'STRESS'?" for the nearest word within a third of the length
/// (Damerau-Levenshtein), else "one of: A, B, C" while the list is short, else empty.
std::string make_spelling_hint(std::string_view word, const std::vector<std::string>& valid);

/// Whether a suggestion for one more error is worth its search through all names: who has made so
/// many mistakes does not read them, and with as many names it takes for ever.
inline bool is_below_hint_error_limit(const Diagnostics& diagnostics) {
  constexpr std::size_t many = 100;
  return diagnostics.error_count() < many;
}

} // namespace spricka::base
