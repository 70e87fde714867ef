// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/script_constants.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace spricka::program {

std::vector<results::ReportedScriptConstant> report_script_constants(const CheckedDeck& deck) {
  std::vector<results::ReportedScriptConstant> result;
  for (const deck::ImportedScript& script : deck.scripts) {
    std::string file = std::filesystem::path(script.file).filename().string();
    if (!script.net.empty()) {
      file += fmt::format(" ({})", script.net);
    }
    for (const mesh::GeometryScriptConstant& c : script.constants) {
      if (c.defined) {
        result.push_back({.file = file,
                          .name = c.name,
                          .value = c.value ? fmt::format("{:.10g}", *c.value) : c.text,
                          .from = c.from_deck ? "deck" : "file"});
      }
    }
  }
  return result;
}

} // namespace spricka::program
