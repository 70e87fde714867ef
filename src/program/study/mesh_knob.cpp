// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/mesh_knob.hpp"

#include "base/input_file.hpp"
#include "grammar/compile.hpp"
#include "grammar/lexeme.hpp"
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

/// How much a mesh has of everything: to see whether only its sizes have changed.
struct Extent {
  std::size_t elements = 0;
  std::vector<std::pair<std::string, std::pair<base::Vec3, base::Vec3>>> sets; ///< low, high
};

void widen(std::pair<base::Vec3, base::Vec3>& box, const base::Vec3& x) {
  box.first = box.first.cwiseMin(x);
  box.second = box.second.cwiseMax(x);
}

Extent extent_of(const model::Mesh& mesh) {
  Extent extent;
  extent.elements = mesh.element_count();
  const base::Vec3 far = base::Vec3::Constant(1e300);
  for (const model::ElementSet& set : mesh.element_sets) {
    std::pair<base::Vec3, base::Vec3> box{far, -far};
    for (const base::ElementId e : set.elements) {
      for (const base::NodeId n : mesh.nodes_of(e)) {
        widen(box, mesh.x[n.index()]);
      }
    }
    extent.sets.emplace_back(set.name, box);
  }
  for (const model::FaceSet& set : mesh.face_sets) {
    std::pair<base::Vec3, base::Vec3> box{far, -far};
    for (const model::Face& face : set.faces) {
      for (const base::NodeId n : mesh.nodes_of(face.element)) {
        widen(box, mesh.x[n.index()]);
      }
    }
    extent.sets.emplace_back(set.name, box);
  }
  return extent;
}

// Of faces whole elements are measured, whose depth changes with their size.
bool is_same_shape(const Extent& a, const Extent& b) {
  constexpr double moved = 0.15; // of the set's size
  if (a.sets.size() != b.sets.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.sets.size(); ++i) {
    const auto& [low, high] = a.sets[i].second;
    const double size = (high - low).norm();
    const double change = std::max((low - b.sets[i].second.first).cwiseAbs().maxCoeff(),
                                   (high - b.sets[i].second.second).cwiseAbs().maxCoeff());
    if (a.sets[i].first != b.sets[i].first || change > moved * size) {
      return false;
    }
  }
  return true;
}

std::set<std::string> names_of_scripts(const ReadyDeck& ready, bool from_deck) {
  std::set<std::string> names;
  for (const deck::ScriptTable& script : ready.scripts) {
    for (const mesh::ScriptConstant& constant : script.constants) {
      if (constant.from_deck || !from_deck) {
        names.insert(grammar::to_upper(constant.name));
      }
    }
  }
  return names;
}

std::optional<MeshParameter> probe(const StudiedDeck& deck, const std::string& name, double value) {
  constexpr double more = 1.15; // elements, or as many fewer
  deck::ReadOptions options{.defines = deck.defines};
  std::erase_if(options.defines,
                [&](const auto& define) { return grammar::to_upper(define.first) == name; });
  options.defines.emplace_back(name, fmt::format("{:.9g}", 2.0 * value));
  const ReadyDeck twice = read_silently(deck.file, options);
  if (!twice.model || value <= 0.0) {
    return std::nullopt;
  }
  const Extent before = extent_of(deck.ready->model->mesh);
  const Extent after = extent_of(twice.model->mesh);
  const double ratio = static_cast<double>(after.elements) /
                       static_cast<double>(std::max<std::size_t>(before.elements, 1));
  const bool changed = ratio > more || ratio < 1.0 / more;
  if (!changed || !is_same_shape(before, after)) {
    return std::nullopt;
  }
  return MeshParameter{name, value, ratio > 1.0};
}

// Cards whose elements one of the parameters decides.
std::set<std::size_t> reached_cards(const std::vector<MeshParameter>& parameters,
                                    const std::map<std::string, NameUse>& uses) {
  std::set<std::size_t> reached;
  for (const MeshParameter& parameter : parameters) {
    const NameUse& use = uses.at(grammar::to_upper(parameter.name));
    reached.insert(use.counts.begin(), use.counts.end());
  }
  return reached;
}

// Scripts that take one of the parameters, by file.
std::set<std::string> reached_scripts(const MeshKnob& knob, const ReadyDeck& ready) {
  std::set<std::string> reached;
  for (const deck::ScriptTable& script : ready.scripts) {
    for (const mesh::ScriptConstant& constant : script.constants) {
      const bool ours = std::ranges::any_of(knob.parameters, [&](const MeshParameter& parameter) {
        return grammar::to_upper(constant.name) == grammar::to_upper(parameter.name);
      });
      if (constant.from_deck && ours) {
        reached.insert(fs::path(script.file).filename().string());
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
  return card.name == "IMPORT" && card.word("FORMAT") == "GEO";
}

std::vector<MeshParameter> find_parameters(const StudiedDeck& deck,
                                           const std::map<std::string, NameUse>& uses) {
  const std::set<std::string> taken = names_of_scripts(*deck.ready, true);
  const auto made_of = ingredients_of(deck.text, deck.ready->sources);
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
    for (const grammar::Parameter& parameter : card.card.parameters) {
      if (parameter.key == key) {
        base::Diagnostics ignored;
        return grammar::evaluate(parameter.values.front().expression, scope_, ignored);
      }
    }
    return std::nullopt;
  }

private:
  grammar::Scope scope_;
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

// gmsh multiplies all sizes by it; numbers of Transfinite lines stay.
void copy_finer(deck::DeckCard& card, double fineness, const fs::path& folder) {
  const fs::path file = file_of(card);
  const fs::path copy = folder / fmt::format("{}_{:g}.geo", file.stem().string(), fineness);
  report::write_file(copy, base::read_file(file, base::largest_mesh_file) +
                               fmt::format("\nMesh.MeshSizeFactor = {:.9g};\n", 1.0 / fineness));
  card.set("FILE", "'" + fs::absolute(copy).lexically_normal().string() + "'");
}

} // namespace

MeshKnob find_mesh_knob(const StudiedDeck& deck) {
  MeshKnob knob;
  const std::map<std::string, NameUse> uses = uses_of_parameters(deck.text, deck.ready->sources);
  knob.parameters = find_parameters(deck, uses);
  const std::set<std::size_t> reached = reached_cards(knob.parameters, uses);
  const std::set<std::string> scripts = reached_scripts(knob, *deck.ready);
  for (std::size_t i = 0; i < deck.text.size(); ++i) {
    const deck::DeckCard& card = deck.text[i];
    if (card.name == "MESH" && !reached.contains(i)) {
      knob.counts = true;
    } else if (is_script(card)) {
      const bool follows = scripts.contains(fs::path(file_of(card)).filename().string());
      knob.scripts = knob.scripts || !follows;
    } else if (card.name == "IMPORT") {
      knob.fixed.push_back(fmt::format("the mesh of {} stays as it is",
                                       fs::path(file_of(card)).filename().string()));
    } else if (card.name == "ELEMENT") {
      knob.fixed.push_back(fmt::format("the elements of {} stay as the deck writes them",
                                       card.net.empty() ? "$ELEMENT" : "net " + card.net));
    }
  }
  return knob;
}

FinerMesh finer_mesh(const StudiedDeck& deck, const MeshKnob& knob, double fineness,
                     deck::DeckText& text, const fs::path& folder) {
  FinerMesh finer;
  for (const MeshParameter& parameter : knob.parameters) {
    const double value =
        parameter.larger_is_finer ? parameter.value * fineness : parameter.value / fineness;
    finer.defines.emplace_back(parameter.name, fmt::format("{:.6g}", value));
    finer.words +=
        fmt::format("{}{}={:.6g}", finer.words.empty() ? "" : " ", parameter.name, value);
  }
  if (!knob.counts && !knob.scripts) {
    return finer;
  }
  const std::map<std::string, NameUse> uses = uses_of_parameters(deck.text, deck.ready->sources);
  const std::set<std::size_t> reached = reached_cards(knob.parameters, uses);
  const std::set<std::string> scripts = reached_scripts(knob, *deck.ready);
  const CardValues values(deck);
  for (std::size_t i = 0; i < text.size() && fineness != 1.0; ++i) {
    if (text[i].name == "MESH" && !reached.contains(i)) {
      multiply_counts(values, fineness, text[i]);
    } else if (is_script(text[i]) &&
               !scripts.contains(fs::path(file_of(text[i])).filename().string())) {
      copy_finer(text[i], fineness, folder);
    }
  }
  if (finer.words.empty()) {
    finer.words = fmt::format("elements*{:.6g}", fineness);
  }
  return finer;
}

} // namespace spricka::program
