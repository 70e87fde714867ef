// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/bulk_table.hpp"

#include "base/label.hpp"
#include "grammar/builder.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/slips.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

// By byte: what ends a field, a blank, a comma or the end of the line.
constexpr std::array<bool, 256> field_end_bytes = [] {
  std::array<bool, 256> ends{};
  for (std::size_t c = 0; c < ends.size(); ++c) {
    const char byte = static_cast<char>(c);
    ends[c] = is_blank(byte) || byte == ',' || is_line_end_or_comment(byte);
  }
  return ends;
}();

bool field_ends(const char* p, const char* last) {
  return p >= last || field_end_bytes[static_cast<unsigned char>(*p)];
}

// Blanks, at most one comma, blanks.
const char* skip_separator(const char* p, const char* last) {
  while (p < last && is_blank(*p)) {
    ++p;
  }
  if (p < last && *p == ',') {
    ++p;
    while (p < last && is_blank(*p)) {
      ++p;
    }
  }
  // comments and continued lines are rare: leave the short way only for them
  return p < last && is_line_end_or_comment(*p) ? skip_blanks_and_comments(p, last) : p;
}

// Rows that are handed over together: a block of them stays in the processor's cache.
constexpr std::size_t k_block = 2048;

template <class Value> class TableReader {
public:
  TableReader(const BulkRowFormat& form, base::SourceSpan data, const ExpressionScope& scope,
              base::Diagnostics& diagnostics)
      : form_(form), scope_(scope), diagnostics_(diagnostics), file_(data.file),
        origin_(scope.sources->text(data.file).data()), p_(origin_ + data.begin),
        last_(origin_ + data.end) {
    table_.columns = form.columns;
    table_.label.reserve(k_block);
    table_.offset.reserve(k_block);
    table_.value.reserve(k_block * form_.columns);
  }

  void run(const RowBlockCallback<Value>& take) {
    while (true) {
      p_ = skip_blanks_and_comments(p_, last_);
      if (p_ >= last_ || table_.label.size() == k_block) {
        hand_over(take);
      }
      if (p_ >= last_) {
        return;
      }
      if (*p_ == '\n') {
        ++p_;
      } else if (!row()) {
        table_.value.resize(table_.label.size() * form_.columns);
        p_ = logical_line_end(p_, last_);
      }
    }
  }

private:
  void hand_over(const RowBlockCallback<Value>& take) {
    if (!table_.label.empty()) {
      take(table_);
    }
    table_.label.clear();
    table_.offset.clear();
    table_.value.clear();
  }

  bool row() {
    const char* const begin = p_;
    base::Label label = 0;
    if (!integer(label, form_.row)) {
      return false;
    }
    if (label < 1) {
      return fail(begin, p_, "E103", fmt::format("a {} is 1 or more", form_.row));
    }
    if (label > base::largest_label) {
      return fail(begin, p_, "E103", fmt::format("a {} has 18 digits at most", form_.row));
    }
    for (std::size_t c = 0; c < form_.columns; ++c) {
      p_ = skip_separator(p_, last_);
      Value value{};
      if (!field(value)) {
        return false;
      }
      table_.value.push_back(value);
    }
    const char* const end = skip_separator(p_, last_);
    if (end < last_ && *end != '\n') {
      p_ = end;
      return surplus(begin);
    }
    p_ = end;
    table_.label.push_back(label);
    table_.offset.push_back(static_cast<std::uint32_t>(begin - origin_));
    return true;
  }

  bool field(Value& value) {
    if (p_ < last_ && *p_ == '(') {
      return slow(value);
    }
    if constexpr (std::is_same_v<Value, double>) {
      return real(value);
    } else {
      return integer(value, "node number");
    }
  }

  bool real(double& value) {
    const char* digits = p_;
    if (digits < last_ && (*digits == '-' || *digits == '+')) {
      ++digits;
    }
    // from_chars would take inf and nan, and a sign of its own
    if (digits >= last_ || !(is_digit(*digits) || *digits == '.')) {
      return no_number("a number");
    }
    const auto [end, failure] = std::from_chars(digits, last_, value);
    if (failure != std::errc{} || !field_ends(end, last_)) {
      return end < last_ && *end == '[' ? slow(value) : bad_number(digits);
    }
    if (*p_ == '-') {
      value = -value;
    }
    p_ = end;
    return true;
  }

  bool integer(base::Label& value, std::string_view what) {
    // nearly every number: some digits, and the field ends
    const char* q = p_;
    base::Label plain = 0;
    while (q < last_ && q - p_ < 18 && is_digit(*q)) {
      plain = 10 * plain + (*q++ - '0');
    }
    if (q > p_ && field_ends(q, last_)) {
      value = plain;
      p_ = q;
      return true;
    }
    return long_integer(value, what);
  }

  bool long_integer(base::Label& value, std::string_view what) {
    if (p_ < last_ && *p_ == '(') {
      return slow(value);
    }
    const char* const begin = p_ < last_ && *p_ == '+' ? p_ + 1 : p_;
    if (begin >= last_ || !(is_digit(*begin) || *begin == '-')) {
      return no_number(what);
    }
    const auto [end, failure] = std::from_chars(begin, last_, value);
    if (failure == std::errc{} && field_ends(end, last_)) {
      p_ = end;
      return true;
    }
    const char* const stop = std::max(scan_token(p_, last_), p_ + 1);
    return fail(p_, stop, "E103",
                fmt::format("expected a {}, not '{}'", what, std::string_view(p_, stop)),
                "node and element numbers are whole numbers");
  }

  // A field in parentheses or with a unit.
  template <class T> bool slow(T& value) {
    SyntaxBuilder builder(file_, origin_);
    const char* const begin = p_;
    const char* const stop = logical_line_end(p_, last_);
    const bool ok = *p_ == '(' ? builder.parse_expression_field(p_, stop)
                               : builder.parse_number_field(p_, stop, false);
    builder.errors.report(diagnostics_);
    if (!ok) {
      return false;
    }
    const CardField parsed = builder.take_fields().front();
    const auto result = evaluate_constant(parsed.expression, scope_, diagnostics_);
    if (!result) {
      return false;
    }
    const base::SourceSpan unit = explicit_unit_span(parsed.expression);
    if (unit.valid() && std::is_same_v<T, double>) {
      const auto known = base::parse_unit(scope_.sources->text(unit));
      const bool fits = known && (known->dimension == base::PhysicalDimension{1.0, 0.0, 0.0} ||
                                  known->dimension == base::PhysicalDimension{0.0, 0.0, 1.0});
      if (!fits) {
        return fail(begin, p_, "E205", "a coordinate is a length");
      }
    }
    if (std::is_integral_v<T> && *result != std::floor(*result)) {
      return fail(begin, p_, "E108", fmt::format("a whole number is expected, not {}", *result));
    }
    value = static_cast<T>(*result);
    return true;
  }

  bool no_number(std::string_view what) {
    if (p_ >= last_ || is_line_end_or_comment(*p_)) {
      const char* end = p_;
      while (end > origin_ && (is_blank(end[-1]) || end[-1] == '\r')) {
        --end;
      }
      return fail(end, end, "E120", fmt::format("expected {}, the line ends early", what),
                  form_.missing);
    }
    const char* const stop = std::max(scan_token(p_, last_), p_ + 1);
    return fail(p_, stop, "E120",
                fmt::format("expected {}, not '{}'", what, std::string_view(p_, stop)),
                is_letter(*p_) ? "an expression stands in parentheses"
                               : std::string(foreign_syntax_hint(origin_, p_, last_)));
  }

  bool bad_number(const char* digits) {
    const char* const begin = p_;
    const ScannedNumber n = scan_number(digits, last_);
    const char* const token = scan_token(begin, last_);
    const std::string_view text(begin, std::max(token, n.end));
    if (n.error == NumberError::too_large) {
      return fail(begin, n.end, "E103",
                  fmt::format("'{}' lies outside the range of double precision", text));
    }
    const bool sign = n.error == NumberError::none && n.end < last_ &&
                      (*n.end == '-' || *n.end == '+') && token - n.end > 1 && is_digit(n.end[1]);
    if (n.error == NumberError::fortran_exponent || sign) {
      return fail(begin, begin + text.size(), "E103", fmt::format("'{}': a Fortran exponent", text),
                  "write 1.0e-3, not 1.0d-3 or 1.0-3");
    }
    return fail(begin, begin + text.size(), "E103", fmt::format("'{}' is not a number", text));
  }

  bool surplus(const char* begin) {
    // digit,digit without a blank anywhere in the line: most likely a decimal comma
    bool comma = false;
    for (const char* q = begin; q + 2 < last_ && *q != '\n'; ++q) {
      comma = comma || (is_digit(q[0]) && q[1] == ',' && is_digit(q[2]));
    }
    const char* const stop = std::max(scan_token(p_, last_), p_ + 1);
    return fail(p_, stop, "E121", fmt::format("unexpected '{}'", std::string_view(p_, stop)),
                comma ? "a comma separates fields; the decimal sign is a point" : form_.surplus);
  }

  bool fail(const char* begin, const char* end, std::string_view code, std::string text,
            std::string hint = {}) {
    diagnostics_.error({file_, static_cast<std::uint32_t>(begin - origin_),
                        static_cast<std::uint32_t>(end - origin_)},
                       std::string(code), std::move(text), std::move(hint));
    return false;
  }

  const BulkRowFormat& form_;
  const ExpressionScope& scope_;
  base::Diagnostics& diagnostics_;
  std::int32_t file_;
  const char* origin_;
  const char* p_;
  const char* last_;
  BulkTableBlock<Value> table_;
};

} // namespace

void parse_node_lines(const BulkRowFormat& form, base::SourceSpan data,
                      const ExpressionScope& scope, base::Diagnostics& diagnostics,
                      const RowBlockCallback<double>& take) {
  TableReader<double>(form, data, scope, diagnostics).run(take);
}

void parse_element_lines(const BulkRowFormat& form, base::SourceSpan data,
                         const ExpressionScope& scope, base::Diagnostics& diagnostics,
                         const RowBlockCallback<base::Label>& take) {
  TableReader<base::Label>(form, data, scope, diagnostics).run(take);
}

std::size_t count_lines(const base::SourceTexts& sources, base::SourceSpan data) {
  const std::string_view text = sources.text(data);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
}

base::SourceSpan table_field_span(const base::SourceTexts& sources, base::SourceSpan data,
                                  std::uint32_t offset, std::size_t index) {
  const char* const origin = sources.text(data.file).data();
  const char* const last = origin + data.end;
  const char* p = origin + offset;
  const auto end_of = [&](const char* q) {
    int depth = 0;
    while (q < last && (depth > 0 || !field_ends(q, last))) {
      depth += *q == '(' ? 1 : (*q == ')' ? -1 : 0);
      ++q;
    }
    return q;
  };
  for (std::size_t i = 0; i < index; ++i) {
    p = skip_separator(end_of(p), last);
  }
  return {data.file, static_cast<std::uint32_t>(p - origin),
          static_cast<std::uint32_t>(end_of(p) - origin)};
}

base::SourceSpan table_label_span(const base::SourceTexts& sources, base::SourceSpan data,
                                  std::size_t index) {
  const char* const origin = sources.text(data.file).data();
  const char* const last = origin + data.end;
  const char* p = origin + data.begin;
  for (std::size_t row = 0; p < last; p = logical_line_end(p, last) + 1) {
    p = skip_blanks_and_comments(p, last);
    if (p < last && *p != '\n' && row++ == index) {
      break;
    }
  }
  return table_field_span(sources, data, static_cast<std::uint32_t>(p - origin), 0);
}

} // namespace spricka::grammar
