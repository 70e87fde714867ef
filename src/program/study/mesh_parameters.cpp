// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/mesh_parameters.hpp"

#include "base/input_file.hpp"
#include "grammar/compile.hpp"
#include "grammar/lexeme.hpp"
#include "program/study/mesh_probe.hpp"
#include "program/study/name_uses.hpp"
#include "report/drawing/file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

std::set<std::string> names_of_scripts(const ReadyDeck& ready, bool from_deck) {
  std::set<std::string> names;
  for (const deck::ImportedScript& script : ready.scripts) {
    for (const mesh::GeometryScriptConstant& constant : script.constants) {
      if (constant.from_deck || !from_deck) {
        names.insert(grammar::to_upper(constant.name));
      }
    }
  }
  return names;
}

MeshParameter parameter_of(const std::string& name, double value, double ratio) {
  return {name, value, ratio > 1.0};
}

std::optional<MeshParameter> probe(const StudiedDeck& deck, const std::string& name, double value) {
  deck::DeckReadOptions options{.defines = deck.defines};
  std::erase_if(options.defines,
                [&](const auto& define) { return grammar::to_upper(define.first) == name; });
  options.defines.emplace_back(name, fmt::format("{:.9g}", 2.0 * value));
  const ReadyDeck twice = read_silently(deck.file, options);
  if (!twice.model || value <= 0.0) {
    return std::nullopt;
  }
  const auto ratio = element_count_ratio(deck.ready->model->mesh, twice.model->mesh);
  return ratio ? std::optional(parameter_of(name, value, *ratio)) : std::nullopt;
}

// What the elements become by a change of the deck's text; empty as element_count_ratio().
std::optional<double> probe_text(const StudiedDeck& deck, const deck::DeckText& text,
                                 const fs::path& folder) {
  const fs::path file = folder / "probe.deck";
  report::write_file(file, write_deck(text, folder));
  const ReadyDeck changed = read_silently(file, {.defines = deck.defines});
  fs::remove(file);
  return changed.model ? element_count_ratio(deck.ready->model->mesh, changed.model->mesh)
                       : std::nullopt;
}

// A script takes its constants from parameters of the deck.
void set_constant(deck::DeckText& text, const std::string& name, double value) {
  deck::DeckCard card;
  card.name = "PARAMETER";
  card.data = fmt::format("  {} = {:.9g}\n", name, value);
  append_card(text, std::move(card));
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
std::set<std::string> reached_scripts(const MeshParameterSet& mesh_parameter,
                                      const ReadyDeck& ready) {
  std::set<std::string> reached;
  for (const deck::ImportedScript& script : ready.scripts) {
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

bool is_script(const deck::DeckCard& card) {
  return card.name == "IMPORT" && card.word_value("FORMAT") == "GEO";
}

std::vector<MeshParameter> find_parameters(const StudiedDeck& deck,
                                           const std::map<std::string, ParameterUse>& uses) {
  const std::set<std::string> taken = names_of_scripts(*deck.ready, true);
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
    const std::set<std::string>& parts = made_of.at(name);
    const bool follows =
        std::ranges::any_of(parts, [&](const std::string& part) { return names.contains(part); });
    if (follows) {
      continue; // it changes with the other
    }
    if (std::optional<MeshParameter> parameter = probe(deck, name, value)) {
      parameter->name = written;
      names.insert(name);
      found.push_back(*parameter);
    }
  }
  return found;
}

// Of scripts that no parameter of the deck reaches.
std::vector<MeshParameter> find_constants(const StudiedDeck& deck,
                                          const MeshParameterSet& mesh_parameter,
                                          const fs::path& folder) {
  const std::set<std::string> reached = reached_scripts(mesh_parameter, *deck.ready);
  std::vector<MeshParameter> found;
  for (const deck::ImportedScript& script : deck.ready->scripts) {
    for (const mesh::GeometryScriptConstant& constant : script.constants) {
      const bool free =
          constant.defined && !constant.from_deck && constant.value.value_or(0.0) > 0.0;
      if (!free || reached.contains(name_of_file(script.file)) || is_among(found, constant.name)) {
        continue;
      }
      deck::DeckText text = deck.text;
      set_constant(text, constant.name, 2.0 * *constant.value);
      if (const auto ratio = probe_text(deck, text, folder)) {
        found.push_back(parameter_of(constant.name, *constant.value, *ratio));
      }
    }
  }
  return found;
}

/// Evaluates what stands in a card, with the deck's parameters.
class CardValues {
public:
  explicit CardValues(const StudiedDeck& deck) {
    scope_.sources = &deck.ready->sources;
    scope_.units = deck.ready->model->units;
    for (const auto& [name, value] : deck.ready->model->parameters) {
      scope_.values[grammar::to_upper(name)] = value;
    }
  }

  [[nodiscard]] std::optional<double> of(const deck::DeckCard& card, std::string_view key) const {
    for (const grammar::HeaderParameter& parameter : card.card.parameters) {
      if (parameter.key == key) {
        base::Diagnostics ignored;
        return grammar::evaluate(parameter.values.front().expression, scope_, ignored);
      }
    }
    return std::nullopt;
  }

private:
  grammar::ExpressionScope scope_;
};

void multiply_counts(const CardValues& values, double fineness, deck::DeckCard& card) {
  for (auto& [key, text] : card.keys) {
    if (!is_count_key(key) || key == "BIAS") {
      continue;
    }
    const double least = key == "NT" ? 3.0 : 1.0;
    if (const std::optional<double> count = values.of(card, key)) {
      text = fmt::format("{}", std::lround(std::max(least, std::round(*count * fineness))));
    }
  }
}

// gmsh multiplies all sizes by it; numbers of Transfinite lines stay. Scripts in which that changes
// nothing are found by it, too.
void copy_finer(deck::DeckCard& card, double fineness, const fs::path& folder) {
  const fs::path file = file_of(card);
  const fs::path copy = folder / fmt::format("{}_{:g}.geo", file.stem().string(), fineness);
  report::write_file(copy, base::read_file(file, base::largest_mesh_file) +
                               fmt::format("\nMesh.MeshSizeFactor = {:.9g};\n", 1.0 / fineness));
  card.set("FILE", "'" + fs::absolute(copy).lexically_normal().string() + "'");
}

bool follows_factor(const StudiedDeck& deck, std::size_t card, const fs::path& folder) {
  constexpr double finer = 2.0;
  deck::DeckText text = deck.text;
  copy_finer(text[card], finer, folder);
  return probe_text(deck, text, folder).value_or(0.0) > 1.0;
}

} // namespace

MeshParameterSet find_mesh_parameters(const StudiedDeck& deck, const fs::path& folder) {
  MeshParameterSet mesh_parameter;
  const std::map<std::string, ParameterUse> uses = parameter_uses(deck.text, deck.ready->sources);
  mesh_parameter.parameters = find_parameters(deck, uses);
  mesh_parameter.constants = find_constants(deck, mesh_parameter, folder);
  const std::set<std::size_t> reached = reached_cards(mesh_parameter.parameters, uses);
  const std::set<std::string> scripts = reached_scripts(mesh_parameter, *deck.ready);
  for (std::size_t i = 0; i < deck.text.size(); ++i) {
    const deck::DeckCard& card = deck.text[i];
    const std::string file = name_of_file(file_of(card));
    if (card.name == "MESH" && !reached.contains(i)) {
      mesh_parameter.counts = true;
    } else if (is_script(card) && scripts.contains(file)) {
      continue;
    } else if (is_script(card) && follows_factor(deck, i, folder)) {
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

FinerMesh finer_mesh(const StudiedDeck& deck, const MeshParameterSet& mesh_parameter,
                     double fineness, deck::DeckText& text, const fs::path& folder) {
  FinerMesh finer;
  const std::map<std::string, ParameterUse> uses = parameter_uses(text, deck.ready->sources);
  const std::set<std::size_t> reached = reached_cards(mesh_parameter.parameters, uses);
  const CardValues values(deck);
  for (std::size_t i = 0; i < text.size() && fineness != 1.0; ++i) {
    if (text[i].name == "MESH" && !reached.contains(i)) {
      multiply_counts(values, fineness, text[i]);
    } else if (is_script(text[i]) &&
               mesh_parameter.scaled.contains(name_of_file(file_of(text[i])))) {
      copy_finer(text[i], fineness, folder);
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
    set_constant(text, constant.name, add_words(constant));
  }
  if (finer.words.empty()) {
    finer.words = fmt::format("elements*{:.6g}", fineness);
  }
  return finer;
}

} // namespace spricka::program
