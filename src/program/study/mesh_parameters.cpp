// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/mesh_parameters.hpp"

#include "base/input_file.hpp"
#include "grammar/compile.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"
#include "program/study/deck_edits.hpp"
#include "report/drawing/file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// Names of a text, upper case.
std::set<std::string> names_in(std::string_view text) {
  std::set<std::string> names;
  transform_names_in_text(
      text, [&](std::string_view name) { return *names.insert(grammar::to_upper(name)).first; });
  return names;
}

using NamedBox = std::pair<std::string, Eigen::AlignedBox3d>;

// Extents of all sets with elements or faces; of faces whole elements are measured.
std::vector<NamedBox> extents(const model::Mesh& mesh) {
  std::vector<NamedBox> boxes;
  const auto extend = [&](base::ElementId e) {
    for (const base::NodeId n : mesh.element_nodes(e)) {
      boxes.back().second.extend(mesh.x[n.index()]);
    }
  };
  for (const model::ElementSet& set : mesh.element_sets) {
    boxes.emplace_back(set.name, Eigen::AlignedBox3d());
    std::ranges::for_each(set.elements, extend);
  }
  for (const model::FaceSet& set : mesh.face_sets) {
    boxes.emplace_back(set.name, Eigen::AlignedBox3d());
    std::ranges::for_each(set.faces, extend, &model::Face::element);
  }
  return boxes;
}

// The depth of elements behind a face changes with their size.
bool is_same_extent(const NamedBox& a, const NamedBox& b) {
  constexpr double moved = 0.15; // of the set's size
  if (a.second.isEmpty() || b.second.isEmpty()) {
    return a.first == b.first && a.second.isEmpty() == b.second.isEmpty();
  }
  const double change = std::max((a.second.min() - b.second.min()).cwiseAbs().maxCoeff(),
                                 (a.second.max() - b.second.max()).cwiseAbs().maxCoeff());
  return a.first == b.first && change <= moved * a.second.diagonal().norm();
}

/// How many times as many elements `after` has as `before`, where sizes alone have changed: by more
/// than 15 %, in sets of the same names and extents. Else empty.
std::optional<double> element_count_ratio(const model::Mesh& before, const model::Mesh& after) {
  constexpr double more = 1.15; // elements, or as many fewer
  const double ratio = static_cast<double>(after.element_count()) /
                       static_cast<double>(std::max<std::size_t>(before.element_count(), 1));
  const bool changed = ratio > more || ratio < 1.0 / more;
  return changed && std::ranges::equal(extents(before), extents(after), is_same_extent)
             ? std::optional(ratio)
             : std::nullopt;
}

// A parameter with its value, where the deck as it is read with another value has more elements, or
// fewer.
std::optional<MeshParameter> try_parameter(const StudiedDeck& deck, const std::string& name,
                                           double value, const CheckedDeck& changed) {
  const auto ratio = changed.model
                         ? element_count_ratio(deck.ready->model->mesh, changed.model->mesh)
                         : std::nullopt;
  return ratio ? std::optional(MeshParameter{name, value, *ratio > 1.0}) : std::nullopt;
}

// A script takes its constants from parameters of the deck.
void set_constant(deck::DeckCardList& text, const std::string& name, double value) {
  append_card(text, deck::make_card("PARAMETER", {}, fmt::format("  {} = {:.9g}\n", name, value)));
}

// Cards whose elements one of the parameters decides.
std::set<std::size_t> reached_cards(const std::vector<MeshParameter>& parameters,
                                    const std::map<std::string, ParameterUse>& uses) {
  std::set<std::size_t> reached;
  for (const MeshParameter& parameter : parameters) {
    const ParameterUse& use = uses.at(grammar::to_upper(parameter.name));
    reached.insert(use.counts.begin(), use.counts.end());
  }
  return reached;
}

bool is_among(const std::vector<MeshParameter>& parameters, const std::string& name) {
  return std::ranges::any_of(parameters, [&](const MeshParameter& parameter) {
    return grammar::to_upper(name) == grammar::to_upper(parameter.name);
  });
}

std::string name_of_file(const std::string& file) {
  return fs::path(file).filename().string();
}

// Scripts that take one of the parameters, or have one of the constants, by file.
std::set<std::string> reached_scripts(const MeshRefinementControls& mesh_parameter,
                                      const CheckedDeck& ready) {
  std::set<std::string> reached;
  for (const deck::ImportedScript& script : ready.imported.scripts) {
    for (const mesh::GeometryScriptConstant& constant : script.constants) {
      if (constant.from_deck
              ? is_among(mesh_parameter.parameters, constant.name)
              : constant.defined && is_among(mesh_parameter.constants, constant.name)) {
        reached.insert(name_of_file(script.file));
      }
    }
  }
  return reached;
}

std::string file_of(const deck::DeckCard& card) {
  const std::string* value = card.find("FILE");
  return value == nullptr || value->size() < 2 ? std::string()
                                               : value->substr(1, value->size() - 2);
}

std::vector<MeshParameter> find_parameters(const StudiedDeck& deck,
                                           const std::map<std::string, ParameterUse>& uses) {
  std::set<std::string> taken; // by scripts
  for (const deck::ImportedScript& script : deck.ready->imported.scripts) {
    for (const mesh::GeometryScriptConstant& constant : script.constants) {
      if (constant.from_deck) {
        taken.insert(grammar::to_upper(constant.name));
      }
    }
  }
  const auto made_of = parameter_dependencies(deck.text, deck.ready->sources);
  std::vector<MeshParameter> found;
  std::set<std::string> names;
  for (const auto& [written, value] : deck.ready->model->parameters) {
    const std::string name = grammar::to_upper(written);
    const auto use = uses.find(name);
    if (use == uses.end() || use->second.elsewhere ||
        (use->second.counts.empty() && !taken.contains(name))) {
      continue;
    }
    const bool follows = // it changes with the other
        std::ranges::any_of(made_of.at(name),
                            [&](const auto& part) { return names.contains(part); });
    if (follows || value <= 0.0) {
      continue;
    }
    const ParameterDefinitions twice{{name, fmt::format("{:.9g}", 2.0 * value)}};
    const CheckedDeck changed =
        read_deck_silently(deck.file, {.defines = merge_defines(deck.defines, twice)});
    if (const std::optional<MeshParameter> parameter =
            try_parameter(deck, written, value, changed)) {
      names.insert(name);
      found.push_back(*parameter);
    }
  }
  return found;
}

// Of scripts that no parameter of the deck reaches.
std::vector<MeshParameter> find_constants(const StudiedDeck& deck,
                                          const MeshRefinementControls& mesh_parameter,
                                          const fs::path& folder) {
  const std::set<std::string> reached = reached_scripts(mesh_parameter, *deck.ready);
  std::vector<MeshParameter> found;
  for (const deck::ImportedScript& script : deck.ready->imported.scripts) {
    for (const mesh::GeometryScriptConstant& constant : script.constants) {
      const bool free =
          constant.defined && !constant.from_deck && constant.value.value_or(0.0) > 0.0;
      if (!free || reached.contains(name_of_file(script.file)) || is_among(found, constant.name)) {
        continue;
      }
      deck::DeckCardList text = deck.text;
      set_constant(text, constant.name, 2.0 * *constant.value);
      if (const auto parameter = try_parameter(deck, constant.name, *constant.value,
                                               read_trial_deck(text, deck.defines, folder))) {
        found.push_back(*parameter);
      }
    }
  }
  return found;
}

void multiply_counts(const StudiedDeck& deck, double fineness, deck::DeckCard& card) {
  grammar::ExpressionScope scope;
  scope.sources = &deck.ready->sources;
  scope.units = deck.ready->model->units;
  for (const auto& [name, value] : deck.ready->model->parameters) {
    scope.values[grammar::to_upper(name)] = value;
  }
  for (const grammar::HeaderParameter& parameter : card.card.parameters) {
    base::Diagnostics ignored;
    const auto count =
        is_element_sizing_key(parameter.key) && parameter.key != "BIAS"
            ? grammar::evaluate_constant(parameter.values.front().expression, scope, ignored)
            : std::nullopt;
    if (count) {
      const double least = parameter.key == "NT" ? 3.0 : 1.0;
      card.set_key(parameter.key,
                   fmt::format("{}", std::lround(std::max(least, std::round(*count * fineness)))));
    }
  }
}

// gmsh multiplies all sizes by it; numbers of Transfinite lines stay. Scripts in which that changes
// nothing are found by it, too.
void copy_finer(deck::DeckCard& card, double fineness, const fs::path& folder) {
  import_script_with_added_line(card, fmt::format("{:g}", fineness),
                                fmt::format("Mesh.MeshSizeFactor = {:.9g};", 1.0 / fineness),
                                folder);
}

bool follows_factor(const StudiedDeck& deck, std::size_t card, const fs::path& folder) {
  constexpr double finer = 2.0;
  deck::DeckCardList text = deck.text;
  copy_finer(text[card], finer, folder);
  const auto found = try_parameter(deck, {}, finer, read_trial_deck(text, deck.defines, folder));
  return found && found->larger_is_finer;
}

} // namespace

MeshRefinementControls find_mesh_parameters(const StudiedDeck& deck, const fs::path& folder) {
  MeshRefinementControls mesh_parameter;
  const std::map<std::string, ParameterUse> uses =
      find_parameter_uses(deck.text, deck.ready->sources);
  mesh_parameter.parameters = find_parameters(deck, uses);
  mesh_parameter.constants = find_constants(deck, mesh_parameter, folder);
  const std::set<std::size_t> reached = reached_cards(mesh_parameter.parameters, uses);
  const std::set<std::string> scripts = reached_scripts(mesh_parameter, *deck.ready);
  for (std::size_t i = 0; i < deck.text.size(); ++i) {
    const deck::DeckCard& card = deck.text[i];
    const std::string file = name_of_file(file_of(card));
    if ((card.name == "MESH" && !reached.contains(i)) || imports_step_file(card)) {
      mesh_parameter.counts = true;
    } else if (imports_geometry_script(card) && scripts.contains(file)) {
      continue;
    } else if (imports_geometry_script(card) && follows_factor(deck, i, folder)) {
      mesh_parameter.scaled.insert(file);
    } else if (card.name == "IMPORT") {
      mesh_parameter.fixed.push_back(fmt::format("the mesh of {} stays as it is", file));
    } else if (card.name == "ELEMENT") {
      mesh_parameter.fixed.push_back(
          fmt::format("the elements of {} stay as the deck writes them",
                      card.net.empty() ? "$ELEMENT" : "net " + card.net));
    }
  }
  return mesh_parameter;
}

DeckVariant refine_deck_mesh(const StudiedDeck& deck, const MeshRefinementControls& mesh_parameter,
                             double fineness, const deck::DeckCardList& text,
                             const fs::path& folder) {
  DeckVariant finer{.text = text};
  const std::map<std::string, ParameterUse> uses = find_parameter_uses(text, deck.ready->sources);
  const std::set<std::size_t> reached = reached_cards(mesh_parameter.parameters, uses);
  for (std::size_t i = 0; i < text.size() && fineness != 1.0; ++i) {
    if (text[i].name == "MESH" && !reached.contains(i)) {
      multiply_counts(deck, fineness, (*finer.text)[i]);
    } else if (imports_step_file(text[i])) {
      const std::string* before = text[i].find("FINER");
      (*finer.text)[i].set_key(
          "FINER", fmt::format("({}*{:.6g})", before == nullptr ? "1" : *before, fineness));
    } else if (imports_geometry_script(text[i]) &&
               mesh_parameter.scaled.contains(name_of_file(file_of(text[i])))) {
      copy_finer((*finer.text)[i], fineness, folder);
    }
  }
  const auto add_words = [&](const MeshParameter& parameter) {
    const double value =
        parameter.larger_is_finer ? parameter.value * fineness : parameter.value / fineness;
    finer.words +=
        fmt::format("{}{}={:.6g}", finer.words.empty() ? "" : " ", parameter.name, value);
    return value;
  };
  for (const MeshParameter& parameter : mesh_parameter.parameters) {
    finer.defines.emplace_back(parameter.name, fmt::format("{:.6g}", add_words(parameter)));
  }
  for (const MeshParameter& constant : mesh_parameter.constants) {
    set_constant(*finer.text, constant.name, add_words(constant));
  }
  if (finer.words.empty()) {
    finer.words = fmt::format("elements*{:.6g}", fineness);
  }
  return finer;
}

ParameterDefinitions merge_defines(ParameterDefinitions defines, const ParameterDefinitions& more) {
  for (const auto& define : more) {
    std::erase_if(defines, [&](const auto& given) {
      return grammar::to_upper(given.first) == grammar::to_upper(define.first);
    });
    defines.push_back(define);
  }
  return defines;
}

CheckedDeck read_trial_deck(const deck::DeckCardList& text, const ParameterDefinitions& defines,
                            const fs::path& folder) {
  const fs::path file = folder / "probe.deck";
  report::write_file(file, format_deck_card_list(text, folder));
  CheckedDeck ready = read_deck_silently(file, {.defines = defines});
  fs::remove(file);
  return ready;
}

bool imports_geometry_script(const deck::DeckCard& card) {
  return import_format(card) == "GEO";
}

bool imports_step_file(const deck::DeckCard& card) {
  return import_format(card) == "STEP" || import_format(card) == "STP";
}

void import_script_with_added_line(deck::DeckCard& card, const std::string& suffix,
                                   const std::string& line, const fs::path& folder) {
  const fs::path file = file_of(card);
  const fs::path copy = folder / fmt::format("{}_{}.geo", file.stem().string(), suffix);
  report::write_file(copy, base::read_file(file, base::largest_mesh_file) + "\n" + line + "\n");
  card.set_key("FILE", "'" + fs::absolute(copy).lexically_normal().string() + "'");
}

bool is_element_sizing_key(std::string_view key) {
  constexpr std::array keys{"NX", "NY", "NZ", "NR", "NT", "BIAS"};
  return std::ranges::find(keys, key) != keys.end();
}

std::map<std::string, std::set<std::string>>
parameter_dependencies(const deck::DeckCardList& text, const base::SourceTexts& sources) {
  std::map<std::string, std::set<std::string>> made_of;
  base::Diagnostics ignored;
  for (const deck::DeckCard& card : cards_named(text, "PARAMETER")) {
    for (const grammar::ParameterAssignment& line :
         grammar::parse_parameter_assignments(sources, card.card.data, ignored)) {
      std::set<std::string>& all = made_of[line.name];
      for (const std::string& word : names_in(sources.text(line.value.span))) {
        const auto known = made_of.find(word); // defined before, with all of its own
        if (known != made_of.end() && word != line.name) {
          all.insert(known->second.begin(), known->second.end());
        }
      }
      all.insert(line.name);
    }
  }
  return made_of;
}

std::map<std::string, ParameterUse> find_parameter_uses(const deck::DeckCardList& text,
                                                        const base::SourceTexts& sources) {
  const std::map<std::string, std::set<std::string>> made_of =
      parameter_dependencies(text, sources);
  const std::set<std::string> none;
  std::map<std::string, ParameterUse> uses;
  for (const auto& entry : made_of) {
    uses[entry.first];
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const deck::DeckCard& card = text[i];
    const auto note = [&](const std::string& value, bool counts) {
      for (const std::string& word : names_in(value)) {
        const auto found = made_of.find(word);
        for (const std::string& name : found == made_of.end() ? none : found->second) {
          uses[name].elsewhere = uses[name].elsewhere || !counts;
          if (counts) {
            uses[name].counts.insert(i);
          }
        }
      }
    };
    if (card.name == "PARAMETER") {
      continue;
    }
    for (const auto& [key, value] : card.keys) {
      if (value.find('(') != std::string::npos) { // else a name of something
        note(value, card.name == "MESH" && is_element_sizing_key(key));
      }
    }
    note(card.data, false);
  }
  return uses;
}

} // namespace spricka::program
