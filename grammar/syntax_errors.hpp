// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "grammar/ast.hpp"
#include "grammar/lexeme.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace spricka::grammar {

/// The first mistake of syntax in a piece of a source, its place and what was probably meant.
/// Functions that find one return false, so that a terminal can return it.
class FirstSyntaxError {
public:
  /// `origin`: the first byte of the source.
  FirstSyntaxError(std::int32_t file, const char* origin) : file_(file), origin_(origin) {}

  /// The place in the source of the bytes from `begin` to `end`.
  [[nodiscard]] base::SourceSpan span(const char* begin, const char* end) const;

  /// Keeps the first failure only.
  bool record_error(base::SourceSpan place, std::string code, std::string text,
                    std::string hint = {});
  /// "expected ..." at `at`, with the carets under the token there.
  void record_expected(const char* at, const char* last, std::string_view what);
  /// What scan_number() did not accept.
  bool record_bad_number(const char* begin, const char* end, const char* last, NumberError error);
  /// Whether a field may end at `p`; a failure that says how to write it if not.
  bool check_field_end(const char* p, const char* last, const CardField& field);

  /// Hands the first failure, if there is one, on as an error of the deck.
  void report(base::Diagnostics& diagnostics) const;

private:
  struct SyntaxErrorRecord {
    base::SourceSpan span;
    std::string code;
    std::string text;
    std::string hint;
  };
  std::int32_t file_;
  const char* origin_;
  std::optional<SyntaxErrorRecord> failure_;
};

} // namespace spricka::grammar
