// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/import_card.hpp"

#include "deck/import_step.hpp"
#include "mesh/import/gmsh_import.hpp"
#include "mesh/import/inp_import.hpp"
#include "mesh/import/nastran_import.hpp"
#include "mesh/import/recognise_mesh_file.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

// Materials of a file stand behind those of the cards and are known by their names.
void adopt_physics(DeckContext& c, const CheckedCard& card,
                   mesh::ImportedMaterialsAndEquations physics) {
  auto next = static_cast<std::size_t>(std::ranges::count_if(c.cards, [](const CheckedCard& other) {
    return other.spec->name == "MATERIAL" && !other.bad;
  }));
  for (const mesh::ImportedMaterialsAndEquations& before : c.imported) {
    next += before.materials.size();
  }
  for (const model::ElasticMaterial& material : physics.materials) {
    const NameDefinition* before = c.names.define(
        material.name, {.kind = EntityKind::material, .index = next++, .span = card.span});
    if (before != nullptr && !before->poisoned) {
      c.error(card.span, "E302", fmt::format("there is a material {} already", material.name),
              "put each file into a $NET of its own, or rename the material");
    }
  }
  if (!physics.files.empty()) { // with what the file includes
    c.model.imported_files.insert(c.model.imported_files.end(), physics.files.begin() + 1,
                                  physics.files.end());
  }
  c.imported.push_back(std::move(physics));
}

mesh::InpSkip skipped_cards(const CheckedCard& card) {
  return card.key_has_word("SKIP", "ALL")     ? mesh::InpSkip::all
         : card.key_has_word("SKIP", "LOADS") ? mesh::InpSkip::loads
                                              : mesh::InpSkip::nothing;
}

// Keys that the format of the file has no use for.
bool refuse_keys_of_solver_files(DeckContext& c, const CheckedCard& card, std::string_view format) {
  const bool skips = card.word_value("SKIP") != "NOTHING" && format != "INP" && format != "NASTRAN";
  if (skips) {
    c.error(card.find("SKIP")->span, "E110", "SKIP is for FORMAT=INP and NASTRAN",
            "meshes of gmsh hold no loads");
  }
  const bool selects = card.has_key("ESET") && format != "INP";
  if (selects) {
    c.error(card.find("ESET")->span, "E110", "ESET is for FORMAT=INP",
            "of other files take the sets that are wanted");
  }
  return skips || selects;
}

bool took_too_long(const DeckContext& c) {
  const std::vector<base::Diagnostic>& all = c.diagnostics.messages();
  return std::ranges::any_of(
      all, [](const base::Diagnostic& d) { return d.code == "E481" || d.code == "E482"; });
}

// FORMAT, or what the file holds or its ending says; empty after an error, and of no file.
std::string import_format(DeckContext& c, const CheckedCard& card,
                          const std::filesystem::path& file) {
  const CheckedValue* const given = card.find("FORMAT");
  const mesh::MeshFileKind* const kind = mesh::recognise_mesh_file(file);
  if (kind != nullptr &&
      (kind->format.empty() || (given != nullptr && kind->format != card.word_value("FORMAT")))) {
    c.error(given != nullptr ? given->span : card.find("FILE")->span, "E337",
            fmt::format("'{}' is {}", file.filename().string(), kind->name),
            kind->format.empty() ? mesh::mesh_file_remedy(*kind, file)
                                 : fmt::format("FORMAT={}", kind->format));
    return {};
  }
  if (given != nullptr) {
    return std::string(card.word_value("FORMAT"));
  }
  if (kind != nullptr) {
    return std::string(kind->format);
  }
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char ch) { return static_cast<char>(std::toupper(ch)); });
  for (const auto& [known, format] :
       {std::pair(".GEO", "GEO"), std::pair(".MSH", "MSH"), std::pair(".INP", "INP"),
        std::pair(".BDF", "NASTRAN"), std::pair(".NAS", "NASTRAN"), std::pair(".STEP", "STEP"),
        std::pair(".STP", "STEP")}) {
    if (ending == known) {
      return format;
    }
  }
  if (std::filesystem::exists(file)) {
    c.error(card.find("FILE")->span, "E110",
            fmt::format("the name of {} does not tell what the file is", file.filename().string()),
            fmt::format("FORMAT={}", card.spec->find("FORMAT")->words));
  }
  return {};
}

// Keys that other formats have no use for.
bool check_step_keys(DeckContext& c, const CheckedCard& card, bool step) {
  bool ok = true;
  for (const std::string_view key : {"SIZE", "SOLID", "FINER"}) {
    if (!step && card.has_key(key)) {
      c.error(card.find(key)->span, "E110", fmt::format("{} is for FORMAT=STEP", key),
              "meshes have their sizes, scripts say theirs");
      ok = false;
    }
  }
  return ok;
}

} // namespace

void import_mesh_file(DeckContext& c, const CheckedCard& card) {
  mesh::ImportRequest request;
  // Relative to the file that the card stands in, as $INCLUDE is.
  request.file = std::filesystem::path(c.sources.file_name(card.span.file)).parent_path() /
                 std::string(card.word_value("FILE"));
  const std::string format = import_format(c, card, request.file);
  const bool step = format == "STEP";
  request.format = format == "GEO" ? mesh::ImportFormat::geo : mesh::ImportFormat::msh;
  request.scale = card.number_value("SCALE");
  request.quadratic = card.key_has_word("TYPE", "QUADRATIC");
  request.skip = skipped_cards(card);
  request.element_set = card.find("ESET") == nullptr ? "" : std::string(card.word_value("ESET"));
  request.prefix = card.net.empty() ? "" : card.net + ".";
  request.net = card.net_id;
  request.parameters = c.parameters;
  request.span = card.span;
  const NetRefinement* finer = c.net_refinement(card.net);
  if (request.format == mesh::ImportFormat::geo && finer != nullptr && finer->size) {
    c.remeshed.insert(card.net);
    request.size = {finer->size.map, request.scale};
  }
  if (!format.empty() && !check_step_keys(c, card, step)) {
    return;
  }
  for (const grammar::DataRow& row : step ? std::vector<grammar::DataRow>() : card.rows) {
    using FieldKind = grammar::CardField::CardFieldKind;
    const auto named = [](const grammar::CardField& f) {
      return f.kind == FieldKind::text || f.is_name();
    };
    if (row.fields.size() != 2 || !named(row.fields[0]) || row.fields[0].separator != '=' ||
        !row.fields[1].is_name()) {
      c.error(row.span, "E115", "a line is 'name in the file' = NEW_NAME");
      continue;
    }
    request.renames.emplace_back(row.fields[0].kind == FieldKind::text
                                     ? row.fields[0].text
                                     : std::string(c.sources.text(row.fields[0].span)),
                                 row.fields[1].text);
  }
  const bool of_solver = format == "INP" || format == "NASTRAN";
  if (!format.empty() && refuse_keys_of_solver_files(c, card, format)) {
    return;
  }
  std::error_code unknown;
  request.contact_elsewhere = std::ranges::any_of(
      c.cards, [](const CheckedCard& other) { return other.spec->name == "CONTACT"; });
  request.reported = std::ranges::find(c.model.imported_files, request.file.string()) !=
                     c.model.imported_files.end();
  c.model.imported_files.push_back(request.file.string());
  if (!std::filesystem::is_regular_file(request.file, unknown)) {
    c.error(card.find("FILE")->span, "E308",
            fmt::format("there is no file '{}'", request.file.string()));
  } else if (format.empty() || (!of_solver && took_too_long(c))) {
    return; // reported; or one file has taken all the time there is: the others wait for its repair
  } else if (step) {
    import_step_file(c, card, request);
  } else if (!of_solver) {
    std::vector<mesh::GeometryScriptConstant> constants =
        mesh::import_gmsh_mesh_or_script(c.model.mesh, request, c.diagnostics);
    if (request.format == mesh::ImportFormat::geo) {
      c.scripts.push_back({request.file.string(), card.net, card.span, std::move(constants)});
    }
  } else if (request.quadratic) {
    c.error(card.find("TYPE")->span, "E110", "TYPE=QUADRATIC is for FORMAT=GEO and MSH",
            "node sets of the file would not hold the new nodes");
  } else if (format == "NASTRAN") {
    adopt_physics(c, card, mesh::import_nastran(c.model.mesh, request, c.diagnostics));
  } else {
    adopt_physics(c, card, mesh::import_inp(c.model.mesh, request, c.diagnostics));
  }
}

} // namespace spricka::deck
