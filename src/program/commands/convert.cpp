// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/convert.hpp"

#include "archive/safe_file.hpp"
#include "base/diagnostics.hpp"
#include "deck/read_deck.hpp"
#include "mesh/boundary.hpp"
#include "mesh/export/write_msh.hpp"
#include "mesh/import/gmsh_import.hpp"
#include "mesh/import/inp_import.hpp"
#include "mesh/import/nastran_import.hpp"
#include "mesh/import/recognise_mesh_file.hpp"
#include "mesh/import/step_import.hpp"
#include "mesh/set_name.hpp"
#include "model/model.hpp"
#include "program/job/failures.hpp"
#include "program/job/run_options.hpp"
#include "program/job/standard_streams.hpp"
#include "program/peers/deck_of_inp.hpp"
#include "program/peers/inp_of_deck.hpp"
#include "report/drawing/file.hpp"
#include "report/report.hpp"
#include "sense/half_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string extension(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The word of $IMPORT FORMAT for a mesh file, told by its contents, else by its ending; empty for
/// decks and for meshes that are not read.
std::string_view mesh_format(const std::filesystem::path& file, const mesh::MeshFileKind* kind) {
  if (kind != nullptr) {
    return kind->format;
  }
  const std::string ending = extension(file);
  return ending == ".msh"                        ? "MSH"
         : ending == ".geo"                      ? "GEO"
         : ending == ".inp"                      ? "INP"
         : ending == ".bdf" || ending == ".nas"  ? "NASTRAN"
         : ending == ".step" || ending == ".stp" ? "STEP"
                                                 : "";
}

/// The model of a mesh file, in the units of whoever wrote it; of an .inp the cards that a deck can
/// have go to `joint`, where there is one.
model::Model read_mesh(const std::filesystem::path& file, std::string_view format,
                       base::Diagnostics& diagnostics, mesh::InpJointCards* joint) {
  model::Model model;
  model.nets.emplace_back();
  mesh::ImportRequest request;
  request.file = file;
  request.net = base::NetId(std::size_t{0});
  if (format == "INP" || format == "NASTRAN") {
    request.skip = mesh::InpSkip::all;
    request.joint_taken = joint != nullptr;
    mesh::ImportedMaterialsAndEquations physics =
        format == "INP" ? mesh::import_inp(model.mesh, request, diagnostics)
                        : mesh::import_nastran(model.mesh, request, diagnostics);
    mesh::append_materials_and_equations(model, physics);
    if (!physics.equations.empty()) {
      model.unavailable.push_back({"*EQUATION", request.span});
    }
    if (joint != nullptr) {
      *joint = std::move(physics.joint);
    }
  } else if (format == "STEP") {
    request.format = mesh::ImportFormat::step;
    if (const auto contents = mesh::describe_step_file(request, diagnostics)) {
      std::vector<int> all(contents->solids.size());
      std::iota(all.begin(), all.end(), 0);
      request.step = mesh::make_step_mesh_request(*contents, std::move(all));
      mesh::import_gmsh_mesh_or_script(model.mesh, request, diagnostics);
    }
  } else {
    request.format = format == "MSH" ? mesh::ImportFormat::msh : mesh::ImportFormat::geo;
    mesh::import_gmsh_mesh_or_script(model.mesh, request, diagnostics);
  }
  return model;
}

/// Lines of a deck that say a text.
std::string as_comment(const std::string& text) {
  constexpr std::size_t full = 110;
  std::string lines;
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + word.size() > full) {
      lines += line + "\n";
      line.clear();
    }
    line += (line.empty() ? (lines.empty() ? "! - " : "!   ") : " ") + word;
  }
  return line.empty() ? lines : lines + line + "\n";
}

/// The mesh with its face sets as node sets too: points can carry a mark, faces cannot.
model::Mesh with_face_nodes(const model::Mesh& mesh) {
  model::Mesh marked = mesh;
  for (const model::FaceSet& set : mesh.face_sets) {
    marked.node_sets.push_back({set.name, mesh::nodes_of_faces(mesh, set.faces), set.span});
  }
  return marked;
}

/// Throws FileFailure when the file to be written is one that was read.
void refuse_to_replace_input(const ConvertOptions& options, const base::SourceTexts& sources,
                             const model::Model& model) {
  std::vector<std::filesystem::path> read{options.in};
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    read.emplace_back(sources.file_name(f));
  }
  read.insert(read.end(), model.imported_files.begin(), model.imported_files.end());
  for (const std::filesystem::path& file : read) {
    std::error_code unknown;
    if (std::filesystem::equivalent(file, options.out, unknown)) {
      throw archive::FileFailure("E464",
                                 fmt::format("{} is read here, and is not overwritten; give OUT "
                                             "another name",
                                             options.out.string()));
    }
  }
}

/// Throws FileFailure when there is such a file already and nobody said that it may go.
void refuse_to_replace_output(const ConvertOptions& options) {
  std::error_code unknown;
  if (!options.replace && std::filesystem::is_regular_file(options.out, unknown)) {
    throw archive::FileFailure("E464",
                               fmt::format("there is a file {} already, and it is left as it is; "
                                           "give OUT another name, or --replace",
                                           options.out.string()));
  }
}

/// A deck that imports the file; what it says otherwise stands in its first lines too.
void write_deck(const ConvertOptions& options, const model::Model& model,
                const mesh::InpJointCards& joint, const base::Diagnostics& words, const Log& log) {
  const std::filesystem::path folder =
      options.out.has_parent_path() ? options.out.parent_path() : ".";
  DeckOfInp deck =
      deck_of_inp(model, joint, std::filesystem::proximate(options.in, folder).string(),
                  mesh::make_valid_set_name(options.in.stem().string()));
  std::string head = fmt::format("! made of {} by spricka convert; look at this first:\n",
                                 options.in.filename().string());
  for (const base::Diagnostic& d : words.messages()) {
    head += as_comment(d.text);
  }
  for (const std::string& remark : deck.remarks) {
    head += as_comment(remark);
    log.report_message(base::Severity::warning, "W541", remark, options.out.string());
  }
  report::write_file(options.out, head + deck.text);
}

base::ProgramOutcome write(const ConvertOptions& options, const base::SourceTexts& sources,
                           const model::Model& model, const Log& log) {
  const std::string kind = extension(options.out);
  if (kind == ".msh") {
    report::write_file(options.out, mesh::write_msh(model.mesh));
  } else if (kind == ".vtu") {
    report::write_mesh_sets_vtu(options.out, with_face_nodes(model.mesh));
  } else {
    base::Diagnostics refusals;
    const std::string text = abaqus_input_text(model, refusals);
    log.report_diagnostics(sources, refusals);
    if (refusals.has_errors()) {
      return base::ProgramOutcome::not_solvable;
    }
    report::write_file(options.out, text);
    if (model.steps.size() > 1) {
      log.report_message(base::Severity::warning, "W540",
                         fmt::format("only the first of {} steps is written", model.steps.size()),
                         options.out.string());
    }
  }
  return base::ProgramOutcome::done;
}

} // namespace

base::ProgramOutcome convert_mesh_or_deck(const ConvertOptions& options) {
  const Log log(options.log_format);
  const std::string kind = extension(options.out);
  const bool to_deck = kind == ".deck" && extension(options.in) == ".inp";
  if (kind != ".msh" && kind != ".vtu" && kind != ".inp" && !to_deck) {
    write_to_stderr(
        fmt::format("spricka convert: OUT ends with .msh, .vtu or .inp, of an .inp with "
                    ".deck too, not '{}'\n",
                    options.out.string()));
    return base::ProgramOutcome::usage;
  }
  return run_reporting_file_failures(log, [&] {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(options.in, unknown)) {
      log.report_message(base::Severity::error, "E530",
                         fmt::format("there is no file '{}'", options.in.string()));
      return base::ProgramOutcome::file_trouble;
    }
    base::SourceTexts sources;
    base::Diagnostics diagnostics;
    std::optional<model::Model> model;
    const mesh::MeshFileKind* kind = mesh::recognise_mesh_file(options.in);
    mesh::InpJointCards joint;
    if (const std::string_view format = mesh_format(options.in, kind); !format.empty()) {
      model = read_mesh(options.in, format, diagnostics, to_deck ? &joint : nullptr);
    } else {
      model = deck::read_deck(options.in, {options.defines}, sources, diagnostics);
      if (model) {
        sense::reduce_to_half_model(*model, diagnostics);
      }
    }
    log.report_diagnostics(sources, diagnostics);
    if (!model || diagnostics.has_errors()) {
      return base::ProgramOutcome::deck_error;
    }
    refuse_to_replace_input(options, sources, *model);
    refuse_to_replace_output(options);
    if (to_deck) {
      write_deck(options, *model, joint, diagnostics, log);
      return base::ProgramOutcome::done;
    }
    return write(options, sources, *model, log);
  });
}

} // namespace spricka::program
