// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/convert.hpp"

#include "archive/safe_file.hpp"
#include "base/diagnostics.hpp"
#include "deck/read_deck.hpp"
#include "fe/assemble.hpp"
#include "fe/dof_map.hpp"
#include "mesh/boundary.hpp"
#include "mesh/export/write_inp.hpp"
#include "mesh/export/write_msh.hpp"
#include "mesh/import/gmsh_import.hpp"
#include "mesh/import/inp_import.hpp"
#include "model/model.hpp"
#include "program/job/run_options.hpp"
#include "program/job/standard_streams.hpp"
#include "report/drawing/file.hpp"
#include "report/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
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

bool is_mesh_file(const std::filesystem::path& file) {
  const std::string kind = extension(file);
  return kind == ".msh" || kind == ".geo" || kind == ".inp";
}

/// The model of a mesh file, in the units of whoever wrote it.
model::Model read_mesh(const std::filesystem::path& file, base::Diagnostics& diagnostics) {
  model::Model model;
  model.nets.emplace_back();
  mesh::ImportRequest request;
  request.file = file;
  request.net = base::NetId(std::size_t{0});
  if (extension(file) == ".inp") {
    const mesh::ImportedPhysics physics = mesh::import_inp(model.mesh, request, diagnostics);
    mesh::append_physics(model, physics);
    if (!physics.equations.empty()) {
      model.unavailable.push_back({"*EQUATION", request.span});
    }
  } else {
    request.format = extension(file) == ".msh" ? mesh::ImportFormat::msh : mesh::ImportFormat::geo;
    mesh::import_mesh(model.mesh, request, diagnostics);
  }
  return model;
}

/// Whether the model holds all that a card says though it has no analysis yet: elements in space,
/// axial symmetry.
bool is_in_model(const model::Unavailable& u) {
  static constexpr std::array<std::string_view, 5> held{
      "elements in 3D", "$ELEMENT TYPE", "$MESH TYPE", "$PROPERTY STATE", "axial symmetry"};
  return std::any_of(held.begin(), held.end(),
                     [&](std::string_view begin) { return u.what.starts_with(begin); });
}

class ToInp {
public:
  ToInp(const model::Model& model, base::Diagnostics& refusals)
      : model_(model), refusals_(refusals) {}

  std::string text() {
    for (const model::Contact& contact : model_.contacts) {
      refuse(contact.span, "$CONTACT");
    }
    for (const model::Crack& crack : model_.cracks) {
      refuse(crack.span, "$CRACK");
    }
    for (const model::Unavailable& u : model_.unavailable) {
      if (!is_in_model(u)) {
        refuse(u.span, u.what);
      }
    }
    for (const std::string& type : mesh::types_without_inp(model_.mesh)) {
      refuse({}, fmt::format("the element {}", type));
    }
    if (model_.steps.empty() || refusals_.has_errors()) {
      return refusals_.has_errors() ? "" : mesh::inp_text(model_, nullptr);
    }
    const mesh::InpStep step = first_step();
    return refusals_.has_errors() ? "" : mesh::inp_text(model_, &step);
  }

private:
  void refuse(base::Span span, std::string_view what) {
    refusals_.error(span, "E540", fmt::format("{} cannot be written as Abaqus input", what));
  }

  mesh::InpStep first_step() {
    const model::Mesh& mesh = model_.mesh;
    const model::Step& from = model_.steps.front();
    const auto dim = static_cast<std::size_t>(mesh.dim);
    const auto size = static_cast<Eigen::Index>(dim * mesh.node_count());
    base::Vector f = base::Vector::Zero(size);
    base::Vector u = base::Vector::Zero(size);
    base::Vector T; // [connectivity index]
    for (const model::Action& action : from.actions) {
      const auto* load = std::get_if<model::ApplyLoad>(&action);
      if (load == nullptr) {
        refuse(from.span, "a $STEP that mounts, dismounts or fits");
        continue;
      }
      const model::LoadCase& with_heat = model_.cases[load->load_case.index()];
      model::LoadCase load_case = with_heat; // nodal_load holds the forces of heat as well
      std::erase_if(load_case.loads,
                    [](const model::Load& l) { return l.type == model::LoadType::temperature; });
      f += load->factor * fe::nodal_load(model_, mesh, load_case);
      u += load->factor * fe::prescribed_displacement(model_, mesh, load_case);
      heat(with_heat, load->factor, T);
    }
    mesh::InpStep step;
    step.name = from.name;
    step.temperature = at_nodes(T);
    step.force.assign(mesh.node_count(), base::Vec3::Zero());
    const std::vector<model::FreedomClass> cls = fe::classify_freedoms(model_, mesh);
    for (std::size_t i = 0; i < cls.size(); ++i) {
      const base::NodeId node(i / dim);
      const auto c = static_cast<int>(i % dim);
      step.force[node.index()][c] = f[static_cast<Eigen::Index>(i)];
      if (cls[i] == model::FreedomClass::suppressed) {
        step.fixed.push_back({node, c, 0.0});
      } else if (cls[i] == model::FreedomClass::prescribed) {
        step.fixed.push_back({node, c, u[static_cast<Eigen::Index>(i)]});
      }
    }
    return step;
  }

  // Adds the temperatures of a case, by connectivity index as elements at a node may differ.
  void heat(const model::LoadCase& load_case, double factor, base::Vector& T) const {
    const model::Mesh& mesh = model_.mesh;
    for (const model::Load& load : load_case.loads) {
      if (load.type != model::LoadType::temperature) {
        continue;
      }
      if (T.size() == 0) {
        T = base::Vector::Zero(static_cast<Eigen::Index>(mesh.nodes.size()));
      }
      for (const base::ElementId e : mesh.set(load.elements).elements) {
        Eigen::Index k = mesh.first[e.index()];
        for (const base::NodeId n : mesh.nodes_of(e)) {
          T[k++] += factor * load.value.front()(mesh.x[n.index()]);
        }
      }
    }
  }

  /// Temperatures belong to nodes there: elements that expand must agree on them. [node]
  std::vector<double> at_nodes(const base::Vector& T) {
    const model::Mesh& mesh = model_.mesh;
    std::vector<double> node(T.size() > 0 ? mesh.node_count() : 0, 0.0);
    std::vector<bool> known(node.size(), false);
    const double tolerance = T.size() > 0 ? 1e-9 * T.lpNorm<Eigen::Infinity>() : 0.0;
    for (std::size_t e = 0; e < mesh.element_count() && !node.empty(); ++e) {
      Eigen::Index k = mesh.first[e];
      const bool expands = model_.material_of(mesh, base::ElementId(e)).alpha != 0.0;
      for (const base::NodeId n : mesh.nodes_of(base::ElementId(e))) {
        const double here = T[k++];
        if (!expands) {
          continue;
        }
        if (known[n.index()] && std::abs(node[n.index()] - here) > tolerance) {
          refuse(model_.steps.front().span, "a temperature that jumps between elements");
          return {};
        }
        node[n.index()] = here;
        known[n.index()] = true;
      }
    }
    return node;
  }

  const model::Model& model_;
  base::Diagnostics& refusals_;
};

/// The mesh with its face sets as node sets too: points can carry a mark, faces cannot.
model::Mesh with_face_nodes(const model::Mesh& mesh) {
  model::Mesh marked = mesh;
  for (const model::FaceSet& set : mesh.face_sets) {
    marked.node_sets.push_back({set.name, mesh::nodes_of_faces(mesh, set.faces), set.span});
  }
  return marked;
}

/// Throws FileTrouble when the file to be written is one that was read.
void refuse_to_replace_input(const ConvertOptions& options, const base::Sources& sources,
                             const model::Model& model) {
  std::vector<std::filesystem::path> read{options.in};
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    read.emplace_back(sources.name(f));
  }
  read.insert(read.end(), model.imported_files.begin(), model.imported_files.end());
  for (const std::filesystem::path& file : read) {
    std::error_code unknown;
    if (std::filesystem::equivalent(file, options.out, unknown)) {
      throw archive::FileTrouble("E464",
                                 fmt::format("{} is read here, and is not overwritten; give OUT "
                                             "another name",
                                             options.out.string()));
    }
  }
}

/// Throws FileTrouble when there is such a file already and nobody said that it may go.
void refuse_to_replace_output(const ConvertOptions& options) {
  std::error_code unknown;
  if (!options.replace && std::filesystem::is_regular_file(options.out, unknown)) {
    throw archive::FileTrouble("E464",
                               fmt::format("there is a file {} already, and it is left as it is; "
                                           "give OUT another name, or --replace",
                                           options.out.string()));
  }
}

base::Outcome write(const ConvertOptions& options, const base::Sources& sources,
                    const model::Model& model, const Log& log) {
  const std::string kind = extension(options.out);
  if (kind == ".msh") {
    report::write_file(options.out, mesh::msh_text(model.mesh));
  } else if (kind == ".vtu") {
    report::write_mesh_vtu(options.out, with_face_nodes(model.mesh));
  } else {
    base::Diagnostics refusals;
    const std::string text = ToInp(model, refusals).text();
    log.diagnostics(sources, refusals);
    if (refusals.has_errors()) {
      return base::Outcome::not_solvable;
    }
    report::write_file(options.out, text);
    if (model.steps.size() > 1) {
      log.message(base::Severity::warning, "W540",
                  fmt::format("only the first of {} steps is written", model.steps.size()),
                  options.out.string());
    }
  }
  return base::Outcome::done;
}

} // namespace

base::Outcome convert(const ConvertOptions& options) {
  const Log log(options.log_format);
  const std::string kind = extension(options.out);
  if (kind != ".msh" && kind != ".vtu" && kind != ".inp") {
    to_stderr(fmt::format("spricka convert: OUT ends with .msh, .vtu or .inp, not '{}'\n",
                          options.out.string()));
    return base::Outcome::usage;
  }
  try {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(options.in, unknown)) {
      log.message(base::Severity::error, "E530",
                  fmt::format("there is no file '{}'", options.in.string()));
      return base::Outcome::file_trouble;
    }
    base::Sources sources;
    base::Diagnostics diagnostics;
    std::optional<model::Model> model;
    if (is_mesh_file(options.in)) {
      model = read_mesh(options.in, diagnostics);
    } else {
      model = deck::read_deck(options.in, {options.defines}, sources, diagnostics);
    }
    log.diagnostics(sources, diagnostics);
    if (!model || diagnostics.has_errors()) {
      return base::Outcome::deck_error;
    }
    refuse_to_replace_input(options, sources, *model);
    refuse_to_replace_output(options);
    return write(options, sources, *model, log);
  } catch (const archive::FileTrouble& trouble) {
    log.message(base::Severity::error, trouble.code(), trouble.what());
    return base::Outcome::file_trouble;
  } catch (const std::system_error& trouble) {
    log.message(base::Severity::error, "E530", trouble.what());
    return base::Outcome::file_trouble;
  }
}

} // namespace spricka::program
