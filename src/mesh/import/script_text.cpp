// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/script_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

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

/// The constants that a parameter means.
std::vector<std::string> meant_by(const std::string& parameter, const ScriptScan& scan) {
  std::vector<std::string> alike;
  for (const ScriptAssignment& constant : scan.constants) {
    if (constant.name == parameter) {
      return {parameter};
    }
    if (in_case(constant.name, std::toupper) == in_case(parameter, std::toupper)) {
      alike.push_back(constant.name);
    }
  }
  return alike;
}

} // namespace

PreparedScript prepare_script_with_parameters(const std::string& text, const ScriptScan& scan,
                                              const ImportRequest& request,
                                              base::Diagnostics& diagnostics) {
  PreparedScript result;
  std::set<std::string> from_deck;
  std::set<std::string> constants;
  for (const ScriptAssignment& constant : scan.constants) {
    constants.insert(constant.name);
  }
  std::set<std::string> assigned;
  for (const ScriptAssignment& own : scan.assigned) {
    assigned.insert(own.name);
  }
  std::vector<GeometryScriptConstant> used; // without being defined
  result.text = "/**/";                     // so that nothing but a script can begin here
  for (const auto& [name, value] : request.parameters) {
    if (!can_be_set(name)) {
      continue;
    }
    const std::vector<std::string> meant = meant_by(name, scan);
    if (meant.size() > 1) {
      diagnostics.error(request.span, "E485",
                        fmt::format("{}: the parameter {} may mean the constants {}",
                                    request.file.filename().string(), name,
                                    fmt::join(meant, " or ")),
                        "write it as the one that is meant");
      continue;
    }
    std::set<std::string> names(meant.begin(), meant.end());
    from_deck.insert(meant.begin(), meant.end());
    for (const std::string& other : {in_case(name, std::toupper), in_case(name, std::tolower)}) {
      if (!constants.contains(other)) { // it may be used without a definition
        names.insert(other);
        if (scan.words.contains(other) && !assigned.contains(other)) {
          used.push_back({.name = other, .from_deck = true, .value = value, .text = {}});
        }
      }
    }
    for (const std::string& each : names) {
      result.text += fmt::format("{} = {:.17g};", each, value);
    }
  }
  std::string heard = text;
  for (const auto& [begin, end] : scan.passed_over_at) { // lines keep their numbers
    std::replace_if(
        heard.begin() + static_cast<std::ptrdiff_t>(begin),
        heard.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; }, ' ');
  }
  result.text += heard;
  for (const ScriptAssignment& constant : scan.constants) {
    result.constants.push_back({.name = constant.name,
                                .from_deck = from_deck.contains(constant.name),
                                .value = std::nullopt,
                                .text = constant.text});
  }
  for (GeometryScriptConstant& constant : used) {
    const bool met = std::any_of(result.constants.begin(), result.constants.end(),
                                 [&](const auto& c) { return c.name == constant.name; });
    if (!met) {
      result.constants.push_back(std::move(constant));
    }
  }
  for (const ScriptAssignment& own : scan.assigned) {
    const bool is_parameter =
        std::any_of(request.parameters.begin(), request.parameters.end(),
                    [&](const auto& parameter) { return parameter.first == own.name; });
    if (is_parameter && !constants.contains(own.name)) {
      result.constants.push_back(
          {.name = own.name, .defined = false, .value = std::nullopt, .text = {}});
    }
  }
  return result;
}

} // namespace spricka::mesh
