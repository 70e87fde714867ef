// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "grammar/compile.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// Bulk tables, $COOR and $ELEMENT: millions of lines, so no syntax tree and no Spirit. Numbers are
/// exactly rounded; a field in parentheses takes the slow way through the expression rules.
namespace spricka::grammar {

/// A stretch of rows.
template <class Value> struct BulkTableBlock {
  std::size_t columns = 0;           ///< values in a row, the label not counted
  std::vector<base::Label> label;    ///< [row]
  std::vector<Value> value;          ///< [row * columns]
  std::vector<std::uint32_t> offset; ///< [row] of its first byte in the source, for messages
};

/// What a row holds, in words for messages.
struct BulkRowFormat {
  std::size_t columns = 3;
  std::string row = "node number"; ///< what the label is
  std::string missing;             ///< hint when a line ends early
  std::string surplus;             ///< hint when a line goes on
};

/// Takes rows in the order of the deck, some thousands at a time, so that a big table never stands
/// in memory twice. The block is valid during the call only.
template <class Value> using RowBlockCallback = std::function<void(const BulkTableBlock<Value>&)>;

/// Reads `label v1 .. vn` lines of a data block. Bad lines are reported and left out.
void parse_node_lines(const BulkRowFormat& form, base::SourceSpan data,
                      const ExpressionScope& scope, base::Diagnostics& diagnostics,
                      const RowBlockCallback<double>& take);
/// Reads lines `label label1 .. labeln` of elements, as parse_node_lines those of nodes.
void parse_element_lines(const BulkRowFormat& form, base::SourceSpan data,
                         const ExpressionScope& scope, base::Diagnostics& diagnostics,
                         const RowBlockCallback<base::Label>& take);

/// At least as many as the rows of a data block: its lines.
std::size_t count_lines(const base::SourceTexts& sources, base::SourceSpan data);

/// Place of field `index` (0: the label) of the row that starts at `offset`: for messages after the
/// table was read.
base::SourceSpan table_field_span(const base::SourceTexts& sources, base::SourceSpan data,
                                  std::uint32_t offset, std::size_t index);

/// Place of the label of row `index` of a table without mistakes.
base::SourceSpan table_label_span(const base::SourceTexts& sources, base::SourceSpan data,
                                  std::size_t index);

} // namespace spricka::grammar
