// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/known_names.hpp"

#include "base/diagnostics.hpp"
#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::program {

namespace {

template <class Entities>
void add_names(const Entities& entities, std::vector<std::string>& names) {
  for (const auto& entity : entities) {
    if (!entity.name.empty()) {
      names.push_back(entity.name);
    }
  }
}

void add_pairs(const model::Model& model, std::vector<std::string>& names) {
  add_names(model.contacts, names);
  for (const model::CrackDefinition& crack : model.cracks) {
    if (crack.faces_in_contact) {
      names.push_back(crack.name + ".FACES");
    }
  }
}

} // namespace

std::vector<std::string> candidate_argument_names(char letter, const model::Model& model) {
  std::vector<std::string> names;
  switch (letter) {
  case 'c':
    add_names(model.cracks, names);
    break;
  case 'p':
    add_pairs(model, names);
    break;
  case 's':
    names.emplace_back("NOW");
    add_names(model.steps, names);
    break;
  case 'o':
    add_names(model.cases, names);
    break;
  case 'm':
    add_names(model.materials, names);
    break;
  case 'l':
    add_names(model.load_paths, names);
    break;
  case 'n':
    add_names(model.mesh.node_sets, names);
    add_names(model.mesh.face_sets, names);
    add_names(model.mesh.element_sets, names);
    break;
  case 'd':
    names = {"X", "Y", "Z"};
    break;
  case 'e':
    add_names(model.nets, names);
    names.emplace_back("*");
    break;
  case 'v':
    for (const auto& [name, value] : model.parameters) {
      names.push_back(name);
    }
    break;
  default:
    break;
  }
  return names;
}

bool is_tip_of_crack(const std::string& tip, const std::string& crack) {
  return crack.empty() || tip == crack || tip.starts_with(crack + ".");
}

base::OptionalFailure find_name_index(const std::vector<std::string>& names, const char* what,
                                      const std::string& name, std::size_t& index) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    return invalid_input(names.empty() ? fmt::format("the deck has no {}", what)
                                       : fmt::format("there is no {} '{}'", what, name),
                         base::make_spelling_hint(name, names));
  }
  index = static_cast<std::size_t>(found - names.begin());
  return {};
}

bool same_word(std::string_view a, std::string_view b) {
  return grammar::to_upper(a) == grammar::to_upper(b);
}

} // namespace spricka::program
