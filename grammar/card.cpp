// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/builder.hpp"
#include "grammar/parse.hpp"
#include "grammar/terminals.hpp"

#include <cstring>
#include <utility>

namespace spricka::grammar {

namespace {

bool take_card_name(const char*& p, const char* last, SyntaxBuilder& builder) {
  const char* end = scan_name(p, last);
  if (end == p) {
    return false;
  }
  builder.card.name = to_upper(std::string_view(p, end));
  builder.card.name_span = builder.errors.span(p - 1, end);
  p = skip_blanks_and_comments(end, last);
  return true;
}

bool take_key(const char*& p, const char* last, SyntaxBuilder& builder) {
  const char* end = scan_name(p, last);
  if (end == p) {
    return false;
  }
  HeaderParameter& parameter = builder.card.parameters.emplace_back();
  parameter.key = to_upper(std::string_view(p, end));
  parameter.key_span = builder.errors.span(p, end);
  p = skip_blanks_and_comments(end, last);
  return true;
}

bool end_key(const char*& /*p*/, const char* /*last*/, SyntaxBuilder& builder) {
  HeaderParameter& parameter = builder.card.parameters.back();
  parameter.values = builder.take_fields();
  parameter.span = parameter.values.front().span;
  parameter.span.end = parameter.values.back().span.end;
  return true;
}

bool take_assigned(const char*& p, const char* last, SyntaxBuilder& builder) {
  const char* end = scan_name(p, last);
  if (end == p) {
    return false;
  }
  builder.assignment.written = std::string(p, end);
  builder.assignment.name = to_upper(builder.assignment.written);
  builder.assignment.name_span = builder.errors.span(p, end);
  p = skip_blanks_and_comments(end, last);
  return true;
}

bool take_assigned_value(const char*& p, const char* last, SyntaxBuilder& builder) {
  const char* begin = p;
  if (!read_expression(p, last, builder)) {
    return false;
  }
  builder.assignment.value = builder.take_expression(begin);
  return true;
}

// A field by a method of the builder, and the blanks behind it.
template <auto Read, auto... InRow>
bool take_field(const char*& p, const char* last, SyntaxBuilder& builder) {
  const bool ok = (builder.*Read)(p, last, InRow...);
  p = skip_blanks_and_comments(p, last);
  return ok;
}

bool take_separator(const char*& p, const char* last, SyntaxBuilder& builder) {
  if (p >= last || (*p != ',' && *p != '=')) {
    return false;
  }
  builder.note_field_separator(*p);
  p = skip_blanks_and_comments(p + 1, last);
  return true;
}

bool at_end(const char*& p, const char* last, SyntaxBuilder& /*builder*/) {
  p = skip_blanks_and_comments(p, last);
  return p >= last;
}

const Terminal dollar{"'$'", [](const char*& p, const char* last, SyntaxBuilder&) {
                        return p < last && *p == '$' && ++p != nullptr;
                      }};
const Terminal card_name{"the name of a card", take_card_name};
const Terminal key{"a key", take_key};
const Terminal key_end{"a value", end_key};
const Terminal equals{"'='", match_character<'='>};
const Terminal comma{"','", match_character<','>};
const Terminal header_number{"a number", take_field<&SyntaxBuilder::parse_number_field, false>};
const Terminal header_name{"a name", take_field<&SyntaxBuilder::parse_name_field, false>};
const Terminal row_number{"a number", take_field<&SyntaxBuilder::parse_number_field, true>};
const Terminal row_name{"a name", take_field<&SyntaxBuilder::parse_name_field, true>};
const Terminal text{"a text", take_field<&SyntaxBuilder::parse_text_field>};
const Terminal paren{"an expression in parentheses",
                     take_field<&SyntaxBuilder::parse_expression_field>};
const Terminal separator{"','", take_separator};
const Terminal assigned{"the name of a parameter", take_assigned};
const Terminal assigned_value{"an expression", take_assigned_value};
const Terminal header_end{"KEY=value or the end of the line", at_end};
const Terminal row_end{"a number, a name, a text or '('", at_end};
const Terminal line_done{"the end of the line", at_end};

const x3::rule<class header_id> header = "a card";
const x3::rule<class value_id> value = "a value";
const x3::rule<class field_id> field = "a field";
const x3::rule<class row_id> row = "a data line";
const x3::rule<class assignment_id> assigning = "NAME = expression";

const auto value_def = paren | header_number | header_name | text;
const auto header_def = dollar > card_name >
                        *(key > equals > value > *(comma > value) > key_end) > header_end;
const auto field_def = paren | row_number | row_name | text;
const auto row_def = *(field >> -separator) > row_end;
const auto assigning_def = assigned > equals > assigned_value > line_done;

BOOST_SPIRIT_DEFINE(header, value, field, row, assigning)

// Calls `read(begin, end)` for every logical line of `data` that holds more than blanks.
template <class Read>
void for_each_line(const base::SourceTexts& sources, base::SourceSpan data, const Read& read) {
  const std::string_view all = sources.text(data.file);
  const char* p = all.data() + data.begin;
  const char* const last = all.data() + data.end;
  while (p < last) {
    const char* const first = skip_blanks_and_comments(p, last);
    if (first < last && *first == '\n') {
      p = first + 1;
      continue;
    }
    const char* const end = logical_line_end(first, last);
    if (first < end) {
      read(first, end);
    }
    p = end < last ? end + 1 : last;
  }
}

// The next line that starts with $, or `last`.
const char* next_card(const char* p, const char* origin, const char* last) {
  while (p < last) {
    const void* found = std::memchr(p, '$', static_cast<std::size_t>(last - p));
    if (found == nullptr) {
      return last;
    }
    const char* dollar_at = static_cast<const char*>(found);
    const char* before = dollar_at;
    while (before > origin && is_blank(before[-1])) {
      --before;
    }
    if (before == origin || before[-1] == '\n') {
      return dollar_at;
    }
    p = dollar_at + 1;
  }
  return last;
}

const char* after_byte_order_mark(std::string_view all) {
  return all.data() + (all.starts_with("\xEF\xBB\xBF") ? 3 : 0);
}

} // namespace

std::vector<CardHeader> parse_cards(const base::SourceTexts& sources, std::int32_t file,
                                    base::Diagnostics& diagnostics) {
  std::vector<CardHeader> cards;
  const std::string_view all = sources.text(file);
  const char* const origin = all.data();
  const char* const last = origin + all.size();
  const char* const start = after_byte_order_mark(all);
  const char* p = next_card(start, start, last);
  const FirstSyntaxError place(file, origin);
  for (const char* line = start; line < p; line = line_end(line, p) + 1) {
    const char* q = line;
    while (q < p && is_blank(*q)) {
      ++q;
    }
    if (q < p && !is_line_end_or_comment(*q)) { // also an & that continues nothing
      diagnostics.error(place.span(q, scan_token(q, p)), "E102", "text before the first card",
                        "a comment starts with !");
      break;
    }
  }
  while (p < last) {
    SyntaxBuilder builder(file, origin);
    const char* const begin = p;
    const char* const end = logical_line_end(p, last);
    builder.card.bad = !parse_rule(header, p, end, builder);
    builder.errors.report(diagnostics);
    CardHeader card = std::move(builder.card);
    card.header = builder.errors.span(begin, end);
    if (!card.name_span.valid()) { // a $ without a name still has a place
      card.name_span = builder.errors.span(begin, begin + 1);
    }
    const char* const data = end < last ? end + 1 : last;
    p = next_card(data, origin, last);
    card.data = builder.errors.span(data, p);
    std::erase_if(card.parameters, [](const HeaderParameter& q) { return q.values.empty(); });
    cards.push_back(std::move(card));
  }
  return cards;
}

std::vector<DataRow> parse_data_rows(const base::SourceTexts& sources, base::SourceSpan data,
                                     base::Diagnostics& diagnostics) {
  std::vector<DataRow> rows;
  const char* const origin = sources.text(data.file).data();
  for_each_line(sources, data, [&](const char* begin, const char* end) {
    SyntaxBuilder builder(data.file, origin);
    const char* p = begin;
    if (parse_rule(row, p, end, builder)) {
      rows.push_back({builder.take_fields(), builder.errors.span(begin, end)});
      rows.back().span.end = rows.back().fields.back().span.end;
    }
    builder.errors.report(diagnostics);
  });
  return rows;
}

std::vector<ParameterAssignment> parse_parameter_assignments(const base::SourceTexts& sources,
                                                             base::SourceSpan data,
                                                             base::Diagnostics& diagnostics) {
  std::vector<ParameterAssignment> assignments;
  const char* const origin = sources.text(data.file).data();
  for_each_line(sources, data, [&](const char* begin, const char* end) {
    SyntaxBuilder builder(data.file, origin);
    const char* p = begin;
    if (parse_rule(assigning, p, end, builder)) {
      assignments.push_back(std::move(builder.assignment));
    } else {
      builder.errors.record_expected(begin, end, "NAME = expression");
      builder.assignment.value = {};
      if (!builder.assignment.name.empty()) {
        assignments.push_back(std::move(builder.assignment)); // without a value
      }
    }
    builder.errors.report(diagnostics);
  });
  return assignments;
}

std::optional<ParsedExpression> parse_expression(const base::SourceTexts& sources,
                                                 base::SourceSpan text_span,
                                                 base::Diagnostics& diagnostics) {
  const char* const origin = sources.text(text_span.file).data();
  SyntaxBuilder builder(text_span.file, origin);
  const char* p = origin + text_span.begin;
  const char* const last = origin + text_span.end;
  const char* const begin = skip_blanks_and_comments(p, last);
  if (read_expression(p, last, builder)) {
    if (skip_blanks_and_comments(p, last) == last) {
      return builder.take_expression(begin);
    }
    builder.errors.record_expected(p, last, "the end of the expression");
  }
  builder.errors.report(diagnostics);
  return std::nullopt;
}

} // namespace spricka::grammar
