// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace spricka::results {

using Values =
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>>;

/// Named columns of one length: numbers, whole numbers or texts.
struct ColumnTable {
  struct NamedColumn {
    std::string name;
    Values values;
  };
  std::vector<NamedColumn> columns;

  /// Length of the first column, which all others have too; 0 without columns.
  [[nodiscard]] std::size_t rows() const {
    return columns.empty() ? 0
                           : std::visit([](const auto& v) { return v.size(); }, columns[0].values);
  }
};

} // namespace spricka::results
