// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/geometry_report.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

void add_constants(const deck::ImportedScript& script,
                   std::vector<results::ReportedScriptConstant>& constants) {
  std::string file = file_name(script.file);
  if (!script.net.empty()) {
    file += fmt::format(" ({})", script.net);
  }
  for (const mesh::GeometryScriptConstant& c : script.constants) {
    if (c.defined) {
      constants.push_back({.file = file,
                           .name = c.name,
                           .value = c.value ? fmt::format("{:.10g}", *c.value) : c.text,
                           .from = c.from_deck ? "deck" : "file"});
    }
  }
}

std::string name_outside(const std::string& net, const std::string& name) {
  return net.empty() ? name : net + "." + name;
}

/// The solids of a file, each with the sets that any card of the deck has made of it.
void add_solids(const deck::ImportedGeometry& imported, const deck::ImportedStepFile& file,
                std::vector<results::ReportedSolid>& solids) {
  const double scale = file.scale;
  int number = 0;
  for (const mesh::StepSolid& solid : file.contents->solids) {
    results::ReportedSolid row{.file = file_name(file.file),
                               .number = ++number,
                               .name = solid.name,
                               .volume = scale * scale * scale * solid.volume,
                               .low = scale * solid.low,
                               .high = scale * solid.high,
                               .sets = {}};
    for (const deck::ImportedStepFile& card : imported.step_files) {
      for (const mesh::StepMeshGroup& group : card.request.groups) {
        if (card.file == file.file && group.solid == number - 1) {
          row.sets.push_back(name_outside(card.net, group.name));
        }
      }
    }
    solids.push_back(std::move(row));
  }
}

std::string describe_kind(const mesh::StepFace& face) {
  return face.kind + (face.hollow ? face.kind == "cylinder" ? ", bore" : ", hollow" : "");
}

void add_faces(const deck::ImportedStepFile& file, std::vector<results::ReportedSolidFace>& faces) {
  const double scale = file.scale;
  for (const int i : file.request.solids) {
    const std::vector<mesh::StepFace>& all =
        file.contents->solids[static_cast<std::size_t>(i)].faces;
    for (std::size_t f = 0; f < all.size(); ++f) {
      results::ReportedSolidFace row{.sets = {},
                                     .kind = describe_kind(all[f]),
                                     .radius = scale * all[f].radius,
                                     .direction = all[f].direction,
                                     .area = scale * scale * all[f].area,
                                     .centre = scale * all[f].centre};
      const std::array<int, 2> place{i, static_cast<int>(f)};
      const std::vector<mesh::StepMeshGroup>& groups = file.request.groups;
      for (auto group = groups.rbegin(); group != groups.rend(); ++group) { // numbers are last
        if (std::ranges::find(group->faces, place) != group->faces.end()) {
          row.sets.push_back(name_outside(file.net, group->name));
        }
      }
      faces.push_back(std::move(row));
    }
  }
}

} // namespace

results::ReportedGeometry report_imported_geometry(const deck::ImportedGeometry& imported) {
  results::ReportedGeometry result;
  for (const deck::ImportedScript& script : imported.scripts) {
    add_constants(script, result.scripts);
  }
  std::vector<std::string> met;
  for (const deck::ImportedStepFile& file : imported.step_files) {
    if (std::ranges::find(met, file.file) == met.end()) {
      met.push_back(file.file);
      add_solids(imported, file, result.solids);
    }
    add_faces(file, result.faces);
  }
  return result;
}

} // namespace spricka::program
