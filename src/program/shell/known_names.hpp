// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "grammar/catalogue.hpp"
#include "model/forward.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The names that words of the shell can stand for.
namespace spricka::program {

/// Names of the deck's steps, in deck order.
std::vector<std::string> step_names(const model::Model& model);
/// Names of the load cases, in deck order.
std::vector<std::string> load_case_names(const model::Model& model);
/// Names of the contacts that the deck declares.
std::vector<std::string> contact_names(const model::Model& model);
/// Contacts, and the faces of cracks that may touch.
std::vector<std::string> pair_names(const model::Model& model);
/// Names of the cracks, in deck order.
std::vector<std::string> crack_names(const model::Model& model);
/// Names of the load paths, in deck order.
std::vector<std::string> path_names(const model::Model& model);
std::vector<std::string> mesh_set_names(const model::Model& model); ///< of nodes, faces, elements
std::vector<std::string> net_names(const model::Model& model);      ///< of all nets, and *
/// Names of the materials, in deck order.
std::vector<std::string> material_names(const model::Model& model);
std::vector<std::string> parameter_names(const model::Model& model); ///< as the deck writes them
/// Names of all results that the prompt and $CHECK can ask for.
std::vector<std::string> quantity_names();

/// Whether a tip or front belongs to the crack of that name, or is that tip; to any if it is empty.
bool is_of_crack(const std::string& tip, const std::string& crack);

/// The place of a name (upper case) in a list, or what it is not and which was meant.
base::Trouble find_name(const std::vector<std::string>& names, const char* what,
                        const std::string& name, std::size_t& index);

/// The same word but for the case of its letters.
bool same_word(std::string_view a, std::string_view b);

/// The letters of a quantity's arguments (grammar/catalogue.hpp), without ? and in the plane
/// without z.
std::string argument_letters(const grammar::ResultQuantity& quantity, int dim);

} // namespace spricka::program
