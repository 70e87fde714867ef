// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "grammar/compile.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// Bulk tables, $COOR and $ELEMENT: millions of lines, so no syntax tree and no Spirit. Numbers are
/// exactly rounded; a field in parentheses takes the slow way through the expression rules.
namespace spricka::grammar {

template <class Value> struct Table {
  std::size_t columns = 0;           ///< values in a row, the label not counted
  std::vector<base::Label> label;    ///< [row]
  std::vector<Value> value;          ///< [row * columns]
  std::vector<std::uint32_t> offset; ///< [row] of its first byte in the source, for messages
};

/// What a row holds, in words for messages.
struct TableForm {
  std::size_t columns = 3;
  std::string row = "node number"; ///< what the label is
  std::string missing;             ///< hint when a line ends early
  std::string surplus;             ///< hint when a line goes on
};

/// Reads `label v1 .. vn` lines of a data block. Bad lines are reported and left out.
Table<double> parse_coordinates(const TableForm& form, base::Span data, const Scope& scope,
                                base::Diagnostics& diagnostics);
Table<base::Label> parse_connectivity(const TableForm& form, base::Span data, const Scope& scope,
                                      base::Diagnostics& diagnostics);

/// Place of field `index` (0: the label) of the row that starts at `offset`: for messages after the
/// table was read.
base::Span table_field(const base::Sources& sources, base::Span data, std::uint32_t offset,
                       std::size_t index);

} // namespace spricka::grammar
