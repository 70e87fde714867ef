// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "deck/deck_text.hpp"
#include "model/forward.hpp"

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// Changes of a deck at card level, of which its variants are made.
namespace spricka::program {

/// The fields of one data line, as the deck writes them.
using DataFields = std::vector<std::string>;

/// The fields of all data lines of a card; comments are left out. [line][field]
std::vector<DataFields> split_data_line_fields(const deck::DeckCard& card);

/// Lets `change` rewrite each data line of a card, with its continuations and ended by a newline,
/// given its fields; an empty line goes. Comment and blank lines stay.
void rewrite_data_lines(deck::DeckCard& card,
                        const std::function<void(const DataFields&, std::string& line)>& change);

/// Data lines for which `keep` holds, given their fields; comment and blank lines stay.
void filter_data_lines(deck::DeckCard& card, const std::function<bool(const DataFields&)>& keep);

/// Lines of all $STEP for which `keep` holds, given in upper case what they do and to which name;
/// the name is empty where there is none.
void filter_step_actions(deck::DeckCardList& text,
                         const std::function<bool(const std::string&, const std::string&)>& keep);

/// A text with its names as `change` makes them, but for those in comments, quotes and units.
std::string transform_names_in_text(std::string_view text,
                                    const std::function<std::string(std::string_view)>& change);

/// Contacts stand from the beginning: MOUNT and DISMOUNT go.
void remove_mount_actions(deck::DeckCardList& text);

/// Removes nets and all that is about them alone: their meshes, sets, properties, supports, loads
/// and contacts. Names in upper case; returns the names of contacts that went with them.
std::set<std::string> remove_nets_with_dependents(deck::DeckCardList& text,
                                                  const std::set<std::string>& nets);

/// Steps no longer apply load cases that no card makes.
void drop_undefined_loads(deck::DeckCardList& text);

/// Checks, requests, tests and states of runs go: a variant is asked anew.
void remove_checks_and_requests(deck::DeckCardList& text);

/// Puts ten steps in the place of each load path, from its first loads to its last, and leaves out
/// the checks of the path. False, and nothing changed, where there is no path or a spectrum needs
/// it. The steps stand behind those of the deck, which end with other loads.
bool replace_load_paths_by_steps(deck::DeckCardList& text, const model::Model& model);

/// FORMAT of an $IMPORT, without it the ending of its file, in upper case; empty for other cards.
std::string import_format(const deck::DeckCard& card);

/// A number as cards of variants have it.
std::string format_twelve_digits(double value);

/// "LUG" of "LUG.BORE", upper case; empty without a point.
std::string net_prefix(std::string_view name);

/// A $RIGID card of the plane: a line with the body on its left.
deck::DeckCard make_rigid_line_card(const std::string& name, const base::Vec3& first,
                                    const base::Vec3& second);
/// The same of a circle, with the body outside, for a negative radius inside.
deck::DeckCard make_rigid_circle_card(const std::string& name, const base::Vec3& centre,
                                      double radius);

} // namespace spricka::program
