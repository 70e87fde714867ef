// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/import_step.hpp"

#include "deck/face_choice.hpp"
#include "mesh/import/gmsh_import.hpp"
#include "mesh/import/step_import.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

/// The solids of a file, read once for all cards that name it; null after an error.
std::shared_ptr<const mesh::StepFileContents> solids_of(DeckContext& c,
                                                        const mesh::ImportRequest& request) {
  const auto [at, fresh] = c.step_contents.try_emplace(request.file.string());
  if (fresh) {
    if (auto contents = mesh::describe_step_file(request, c.diagnostics)) {
      at->second = std::make_shared<const mesh::StepFileContents>(*std::move(contents));
    }
  }
  return at->second;
}

/// Those of SOLID, by name or V1, V2 ..; without it all of them. Empty after an error.
std::vector<int> chosen_solids(DeckContext& c, const CheckedCard& card,
                               const mesh::StepFileContents& contents) {
  std::vector<int> chosen;
  if (!card.has_key("SOLID")) {
    chosen.resize(contents.solids.size());
    std::iota(chosen.begin(), chosen.end(), 0);
    return chosen;
  }
  std::vector<std::string> names;
  for (const mesh::StepSolid& solid : contents.solids) {
    names.push_back(solid.name);
  }
  for (const NameReference& wanted : card.find("SOLID")->names) {
    int found = -1;
    for (std::size_t i = names.size(); i-- > 0;) {
      if (names[i] == wanted.name || (found < 0 && wanted.name == fmt::format("V{}", i + 1))) {
        found = static_cast<int>(i);
      }
    }
    if (found < 0) {
      c.error(wanted.span, "E332", fmt::format("the file has no solid {}", wanted.name),
              base::make_spelling_hint(wanted.name, names));
      return {};
    }
    if (std::ranges::find(chosen, found) == chosen.end()) {
      chosen.push_back(found);
    }
  }
  return chosen;
}

/// A face of two solids is meshed once, and joins them.
void warn_of_shared_faces(DeckContext& c, const CheckedCard& card,
                          const mesh::StepFileContents& contents, const std::vector<int>& solids) {
  for (std::size_t a = 0; a < solids.size(); ++a) {
    for (std::size_t b = a + 1; b < solids.size(); ++b) {
      const mesh::StepSolid& one = contents.solids[static_cast<std::size_t>(solids[a])];
      const mesh::StepSolid& other = contents.solids[static_cast<std::size_t>(solids[b])];
      const auto in_other = [&](const mesh::StepFace& face) {
        return std::ranges::any_of(
            other.faces, [&](const mesh::StepFace& f) { return f.entity == face.entity; });
      };
      if (std::ranges::any_of(one.faces, in_other)) {
        c.warning(card.span, "W484",
                  fmt::format("solids {} and {} have a face in common, so that they are one body "
                              "here",
                              one.name, other.name),
                  "two bodies that touch are two $NET, each with its SOLID=");
      }
    }
  }
}

/// Data lines: faces = NAME [size]. False after an error.
bool name_faces(DeckContext& c, const CheckedCard& card, const FaceChoices& faces,
                mesh::StepMeshRequest& request) {
  bool ok = true;
  std::vector<mesh::StepMeshGroup> groups;
  for (const grammar::DataRow& row : card.rows) {
    const std::optional<NamedFaces> named = faces.read_row(c, row);
    if (!named) {
      ok = false;
      continue;
    }
    const auto of_this_name = [&](const auto& group) { return group.name == named->name; };
    if (std::ranges::any_of(request.groups, of_this_name) ||
        std::ranges::any_of(groups, of_this_name)) {
      c.error(row.span, "E302", fmt::format("there is a set {} already", named->name));
      ok = false;
      continue;
    }
    groups.push_back({.name = named->name,
                      .faces = named->faces,
                      .size = named->size / (faces.scale() * request.finer)});
  }
  // in front, as messages name a face by the first set that has it
  request.groups.insert(request.groups.begin(), groups.begin(), groups.end());
  return ok;
}

} // namespace

void import_step_file(DeckContext& c, const CheckedCard& card, mesh::ImportRequest request) {
  request.format = mesh::ImportFormat::step;
  constexpr double millimetre = 1e-3;
  request.scale *= millimetre / c.scope.units.metre_per_length;
  const std::shared_ptr<const mesh::StepFileContents> contents = solids_of(c, request);
  if (contents == nullptr) {
    return;
  }
  const std::vector<int> solids = chosen_solids(c, card, *contents);
  if (solids.empty()) {
    return;
  }
  request.step = mesh::make_step_mesh_request(*contents, solids);
  if (const std::optional<double> size = card.optional_number("SIZE")) {
    request.step.size = *size / request.scale;
  }
  request.step.finer = card.number_value("FINER");
  request.step.size /= request.step.finer;
  warn_of_shared_faces(c, card, *contents, solids);
  const bool sound =
      !card.rows_bad && name_faces(c, card, {*contents, request.step, request.scale}, request.step);
  c.step_files.push_back({.file = request.file.string(),
                          .net = card.net,
                          .contents = contents,
                          .request = request.step,
                          .scale = request.scale});
  if (sound) {
    mesh::import_gmsh_mesh_or_script(c.model.mesh, request, c.diagnostics);
  }
}

} // namespace spricka::deck
