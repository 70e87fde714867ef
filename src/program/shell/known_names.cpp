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

template <class Entities> std::vector<std::string> names_of(const Entities& entities) {
  std::vector<std::string> names;
  for (const auto& entity : entities) {
    if (!entity.name.empty()) {
      names.push_back(entity.name);
    }
  }
  return names;
}

} // namespace

std::vector<std::string> step_names(const model::Model& model) {
  return names_of(model.steps);
}
std::vector<std::string> load_case_names(const model::Model& model) {
  return names_of(model.cases);
}
std::vector<std::string> contact_names(const model::Model& model) {
  return names_of(model.contacts);
}
std::vector<std::string> pair_names(const model::Model& model) {
  std::vector<std::string> names = names_of(model.contacts);
  for (const model::CrackDefinition& crack : model.cracks) {
    if (crack.faces_in_contact) {
      names.push_back(crack.name + ".FACES");
    }
  }
  return names;
}
std::vector<std::string> crack_names(const model::Model& model) {
  return names_of(model.cracks);
}
std::vector<std::string> path_names(const model::Model& model) {
  return names_of(model.load_paths);
}
std::vector<std::string> mesh_set_names(const model::Model& model) {
  std::vector<std::string> names = names_of(model.mesh.node_sets);
  for (const std::vector<std::string>& more :
       {names_of(model.mesh.face_sets), names_of(model.mesh.element_sets)}) {
    names.insert(names.end(), more.begin(), more.end());
  }
  return names;
}
std::vector<std::string> net_names(const model::Model& model) {
  std::vector<std::string> names = names_of(model.nets);
  names.emplace_back("*");
  return names;
}
std::vector<std::string> material_names(const model::Model& model) {
  return names_of(model.materials);
}
std::vector<std::string> parameter_names(const model::Model& model) {
  std::vector<std::string> names;
  for (const auto& [name, value] : model.parameters) {
    names.push_back(name);
  }
  return names;
}
std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const grammar::ResultQuantity& quantity : grammar::result_quantities()) {
    names.emplace_back(quantity.name);
  }
  return names;
}

bool is_of_crack(const std::string& tip, const std::string& crack) {
  return crack.empty() || tip == crack || tip.starts_with(crack + ".");
}

base::Trouble find_name(const std::vector<std::string>& names, const char* what,
                        const std::string& name, std::size_t& index) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    return invalid_input(names.empty() ? fmt::format("the deck has no {}", what)
                                       : fmt::format("there is no {} '{}'", what, name),
                         base::suggest_spelling(name, names));
  }
  index = static_cast<std::size_t>(found - names.begin());
  return {};
}

bool same_word(std::string_view a, std::string_view b) {
  return grammar::to_upper(a) == grammar::to_upper(b);
}

std::string argument_letters(const grammar::ResultQuantity& quantity, int dim) {
  std::string letters(quantity.arguments);
  std::erase(letters, '?');
  if (dim == 2) {
    std::erase(letters, 'z');
  }
  return letters;
}

} // namespace spricka::program
