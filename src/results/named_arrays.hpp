// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/damaged_field.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace spricka::results {

/// What a loop must know to go on, as arrays by name: "mount.offset".
struct NamedArrays {
  std::map<std::string, std::vector<double>> reals;
  std::map<std::string, std::vector<std::int64_t>> integers;
  std::map<std::string, std::vector<std::string>> texts;
};

/// One of these arrays. Throws base::CorruptStoredField where it is missing or has fewer values
/// than `least`.
template <class T>
const std::vector<T>& required_array(const std::map<std::string, std::vector<T>>& arrays,
                                     const std::string& name, std::size_t least = 0) {
  const auto found = arrays.find(name);
  if (found == arrays.end() || found->second.size() < least) {
    throw base::CorruptStoredField(name, "values are missing");
  }
  return found->second;
}

} // namespace spricka::results
