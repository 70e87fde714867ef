// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Text in upper case; letters beyond ASCII stay.
inline std::string upper_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return result;
}

/// A name from a file as the deck can write it: upper case, what is neither letter nor digit
/// becomes an underscore, and so begins a name that would begin with a digit.
inline std::string make_valid_set_name(std::string_view text) {
  std::string name = upper_case(text);
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return (c < 'A' || c > 'Z') && (c < '0' || c > '9') && c != '_'; }, '_');
  if (name.empty() || (name.front() >= '0' && name.front() <= '9')) {
    name.insert(name.begin(), '_');
  }
  return name;
}

} // namespace spricka::mesh
