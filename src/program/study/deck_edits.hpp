// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Changes of a deck at card level that several variants of the ladder make.
namespace spricka::program {

/// Fields of one data line, as the deck writes them, comments left out.
std::vector<std::string> data_fields(std::string_view line);

/// Data lines for which `keep` holds; comment and blank lines stay. `keep` gets the fields.
void filter_lines(deck::DeckCard& card,
                  const std::function<bool(const std::vector<std::string>&)>& keep);

/// Contacts stand from the beginning: MOUNT and DISMOUNT go.
void drop_mounts(deck::DeckText& text);

/// Steps no longer switch the fit of these contacts (upper case).
void drop_fits(deck::DeckText& text, const std::set<std::string>& contacts);

/// Removes nets and all that is about them alone: their meshes, sets, properties, supports, loads
/// and contacts. Names in upper case; returns the names of contacts that went with them.
std::set<std::string> remove_nets(deck::DeckText& text, const std::set<std::string>& nets);

/// Steps no longer apply load cases that no card makes.
void drop_undefined_loads(deck::DeckText& text);

/// Parameters get the values that the command line gives them (-D).
void apply_defines(deck::DeckText& text,
                   const std::vector<std::pair<std::string, std::string>>& defines);

/// Checks, requests, tests and states of runs go: a variant is asked anew.
void drop_requests(deck::DeckText& text);

/// "LUG" of "LUG.BORE", upper case; empty without a point.
std::string net_prefix(std::string_view name);

} // namespace spricka::program
