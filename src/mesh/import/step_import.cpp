// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/step_import.hpp"

#include "mesh/import/mesher_file.hpp"
#include "mesh/import/step_check.hpp"
#include "mesh/link/mesher_limits.hpp"
#include "mesh/link/mesher_request.hpp"
#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace spricka::mesh {
namespace {

/// Names that decks can write, each once; by number where the file has none.
void name_solids(std::vector<StepSolid>& solids) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const std::string own =
        solids[i].name.empty() ? fmt::format("V{}", i + 1) : make_valid_set_name(solids[i].name);
    std::string name = own;
    for (int more = 2; !taken.insert(name).second; ++more) {
      name = fmt::format("{}_{}", own, more);
    }
    solids[i].name = std::move(name);
  }
}

std::string without_solids(const StepFileContents& contents,
                           const std::vector<std::string>& files) {
  if (!files.empty()) {
    return fmt::format("it holds no solid, but names files that do: {}", fmt::join(files, ", "));
  }
  return contents.free_faces > 0
             ? fmt::format("it holds {} faces, but no solid", contents.free_faces)
             : "it holds no solid";
}

} // namespace

std::optional<StepFileContents> describe_step_file(const ImportRequest& request,
                                                   base::Diagnostics& diagnostics) {
  MesherFile file(request, diagnostics);
  const std::optional<std::string> text = file.read_text(mesher_limits().memory / 4);
  if (!text) {
    return std::nullopt;
  }
  if (const std::string trouble = find_step_format_error(*text); !trouble.empty()) {
    file.report_error("E331", trouble);
    return std::nullopt;
  }
  const std::optional<std::string> answer =
      file.ask(encode_describe_request({file.plain_name(".step"), *text}), "the file is damaged");
  if (!answer) {
    return std::nullopt;
  }
  StepFileContents contents;
  ByteReader in(*answer);
  if (in.read_value<MesherFrameKind>() != MesherFrameKind::solids ||
      !decode_solids_answer(in, contents)) {
    file.refuse_answer();
    return std::nullopt;
  }
  if (!file.report_gmsh_errors(contents.errors, contents.gave_up)) {
    return std::nullopt;
  }
  file.report_gmsh_warnings(contents.warnings);
  const std::vector<std::string> files = files_named_by_step(*text);
  if (contents.solids.empty()) {
    file.report_error("E333", without_solids(contents, files),
                      "export the part as a solid, with all of it in one file");
    return std::nullopt;
  }
  if (!files.empty()) {
    diagnostics.warning(request.span, "W483",
                        fmt::format("{}: it names other files, which are not read: {}",
                                    request.file.filename().string(), fmt::join(files, ", ")),
                        "export all of it into one file where parts are missing");
  }
  if (const int described = count_solids_in_step(*text);
      described > static_cast<int>(contents.solids.size())) {
    diagnostics.warning(request.span, "W485",
                        fmt::format("{}: it describes {} solids, of which gmsh makes {}",
                                    request.file.filename().string(), described,
                                    contents.solids.size()),
                        "is the file damaged? The table of solids shows what there is");
  }
  name_solids(contents.solids);
  return contents;
}

StepMeshRequest make_step_mesh_request(const StepFileContents& contents, std::vector<int> solids) {
  StepMeshRequest request;
  request.size = usual_step_size(contents, solids);
  request.solids = std::move(solids);
  const bool alone = request.solids.size() == 1;
  for (const int i : request.solids) {
    const StepSolid& solid = contents.solids[static_cast<std::size_t>(i)];
    request.groups.push_back({.name = alone ? "BODY" : solid.name, .solid = i, .faces = {}});
    for (int f = 0; f < static_cast<int>(solid.faces.size()); ++f) {
      request.groups.push_back(
          {.name = fmt::format("{}F{}", alone ? "" : solid.name + "_", f + 1), .faces = {{i, f}}});
    }
  }
  return request;
}

double usual_step_size(const StepFileContents& contents, const std::vector<int>& solids) {
  constexpr double part = 15.0;
  double diagonal = 0.0;
  for (const int i : solids) {
    const StepSolid& solid = contents.solids[static_cast<std::size_t>(i)];
    diagonal = std::max(diagonal, (solid.high - solid.low).norm());
  }
  return diagonal / part;
}

} // namespace spricka::mesh
