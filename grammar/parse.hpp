// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "grammar/ast.hpp"

#include <optional>
#include <vector>

/// Syntax, the first of the four passes. Recovery: after a bad header at the next line that starts
/// with $, after a bad data line at the next line.
namespace spricka::grammar {

/// The cards of one file, in order, with their headers read and their data lines found. Text before
/// the first card is an error.
std::vector<CardHeader> parse_cards(const base::SourceTexts& sources, std::int32_t file,
                                    base::Diagnostics& diagnostics);

/// The data lines of a card as fields; lines without a field are left out, as are bad ones.
std::vector<DataRow> parse_data_rows(const base::SourceTexts& sources, base::SourceSpan data,
                                     base::Diagnostics& diagnostics);

/// Data lines of the form NAME = expression. A bad line whose name could be read is there with an
/// empty expression.
std::vector<ParameterAssignment> parse_parameter_assignments(const base::SourceTexts& sources,
                                                             base::SourceSpan data,
                                                             base::Diagnostics& diagnostics);

/// A whole text as one expression (a definition on the command line).
std::optional<ParsedExpression> parse_expression(const base::SourceTexts& sources,
                                                 base::SourceSpan text,
                                                 base::Diagnostics& diagnostics);

} // namespace spricka::grammar
