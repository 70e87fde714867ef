// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh_preamble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <system_error>
#include <unistd.h>

namespace spricka::mesh {
namespace {

std::string in_case(std::string text, int (*convert)(int)) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [&](unsigned char c) { return static_cast<char>(convert(c)); });
  return text;
}

/// gmsh's own newp, newl .. cannot be assigned.
bool can_be_set(const std::string& name) {
  return std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }) &&
         !in_case(name, std::tolower).starts_with("new");
}

} // namespace

GmshPreamble::GmshPreamble(const ImportRequest& request) {
  std::string text;
  for (const auto& [name, value] : request.parameters) {
    if (can_be_set(name)) {
      text += fmt::format("{} = {:.17g};\n{} = {:.17g};\n", in_case(name, std::toupper), value,
                          in_case(name, std::tolower), value);
    }
  }
  text += fmt::format("Include \"{}\";\n", std::filesystem::absolute(request.file).string());
  std::string name = (std::filesystem::temp_directory_path() / "spricka-XXXXXX.geo").string();
  const int file = mkstemps(name.data(), 4);
  if (file >= 0) {
    path_ = name;
    const auto written = ::write(file, text.data(), text.size());
    complete_ = ::close(file) == 0 && written == static_cast<ssize_t>(text.size());
  }
}

GmshPreamble::~GmshPreamble() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

} // namespace spricka::mesh
