// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "deck/deck_text.hpp"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Changes of a deck at card level that several variants of the ladder make.
namespace spricka::program {

/// Fields of one data line, as the deck writes them, comments left out.
std::vector<std::string> data_fields(std::string_view line);

/// A deck that was rewritten, or why there is none.
struct RewrittenDeck {
  std::optional<deck::DeckText> text;
  std::string reason;
};

/// Data lines for which `keep` holds; comment and blank lines stay. `keep` gets the fields.
void filter_lines(deck::DeckCard& card,
                  const std::function<bool(const std::vector<std::string>&)>& keep);

/// Lines of a $STEP for which `keep` holds, given in upper case what they do and to which name;
/// the name is empty where there is none.
void filter_actions(deck::DeckCard& step,
                    const std::function<bool(const std::string&, const std::string&)>& keep);

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

/// A number as cards of variants have it.
std::string twelve_digits(double value);

/// "LUG" of "LUG.BORE", upper case; empty without a point.
std::string net_prefix(std::string_view name);

/// A $RIGID card of the plane: a line with the body on its left.
deck::DeckCard rigid_line(const std::string& name, const base::Vec3& first,
                          const base::Vec3& second);
/// The same of a circle, with the body outside, for a negative radius inside.
deck::DeckCard rigid_circle(const std::string& name, const base::Vec3& centre, double radius);

} // namespace spricka::program
