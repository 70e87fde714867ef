// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace spricka::results {

/// The name of a column as $OUTPUT FORMAT=CSV writes it: "K1_BAR" of "K1_bar".
inline std::string uppercase_column_name(std::string name) {
  for (char& c : name) {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return name;
}

} // namespace spricka::results
