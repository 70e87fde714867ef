// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/msh_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace spricka::mesh {
namespace {

/// The next number of the format line; moves `text` behind it.
std::optional<double> number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc()) {
    return std::nullopt;
  }
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

std::string format_trouble(std::string_view head) {
  const std::size_t line_end = head.find('\n');
  std::string_view line = head.substr(0, line_end);
  const auto version = number(line);
  const auto binary = number(line);
  const auto size = number(line);
  if (line_end == std::string_view::npos || !version || !binary || !size ||
      (*binary != 0.0 && *binary != 1.0)) {
    return "its $MeshFormat is damaged";
  }
  if (*version != 2.2 && *version != 4.1) {
    return fmt::format("it has format version {}; 2.2 and 4.1 are read", *version);
  }
  if (*size != 8.0) {
    return fmt::format("its numbers have {} bytes, not 8", *size);
  }
  if (*binary == 0.0) {
    return {};
  }
  const std::string_view raw = head.substr(line_end + 1, sizeof(std::uint32_t));
  std::uint32_t one = 0;
  if (raw.size() < sizeof one) {
    return "its $MeshFormat is damaged";
  }
  std::memcpy(&one, raw.data(), sizeof one);
  if (one == 0x01000000U) {
    return "its binary numbers have the byte order of another machine; let gmsh write it anew";
  }
  return one == 1 ? "" : "its $MeshFormat is damaged";
}

} // namespace

std::string find_msh_format_error(std::string_view text) {
  if (text.empty()) {
    return "it is empty";
  }
  static constexpr std::string_view format = "$MeshFormat";
  std::size_t at = text.find(format);
  const std::size_t line = at == std::string_view::npos ? at : text.find('\n', at);
  if (line == std::string_view::npos) {
    return "it is no gmsh mesh: there is no $MeshFormat";
  }
  if (at != 0 && !text.starts_with("$Comments")) {
    return "it is no gmsh mesh: it does not begin with $MeshFormat";
  }
  if (std::string trouble = format_trouble(text.substr(line + 1)); !trouble.empty()) {
    return trouble;
  }
  for (const std::string_view section :
       {"$EndMeshFormat", "$Nodes", "$EndNodes", "$Elements", "$EndElements"}) {
    at = text.find(section, at);
    if (at == std::string_view::npos) {
      return fmt::format("there is no {}: is it truncated?", section);
    }
  }
  return {};
}

} // namespace spricka::mesh
