// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "deck/deck_text.hpp"
#include "program/job/ready_deck.hpp"
#include "program/study/deck_variant.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// What of a deck makes the meshes of its bodies finer, found from the deck itself, and where its
/// parameters are used.
namespace spricka::program {

/// A parameter that sets sizes or numbers of elements, and nothing else.
struct MeshParameter {
  std::string name; ///< as the deck writes it
  double value = 1.0;
  bool larger_is_finer = true;
};

/// How the meshes of bodies are made finer; there may be nothing.
struct MeshRefinementControls {
  std::vector<MeshParameter> parameters;
  std::vector<MeshParameter> constants; ///< of geometry scripts that no such parameter reaches
  /// Numbers of elements of $MESH cards that no such parameter reaches, FINER of STEP files.
  bool counts = false;
  std::set<std::string> scaled;   ///< scripts without either, by file: all sizes by a factor
  std::vector<std::string> fixed; ///< meshes that stay as they are

  [[nodiscard]] bool empty() const {
    return parameters.empty() && constants.empty() && !counts && scaled.empty();
  }
};

/// Parameters are those that the numbers of elements of $MESH are made of, or that a geometry
/// script takes, and that nothing else uses. What a script makes of one is found by reading the
/// deck with twice its value: there must be more or fewer elements in the same sets of the same
/// extent. Constants of scripts (DefineConstant) that the deck leaves alone are tried in the same
/// way, then the factor of all sizes. Decks to try are written into `folder`.
MeshRefinementControls find_mesh_parameters(const StudiedDeck& deck,
                                            const std::filesystem::path& folder);

/// Changes cards of `text` and collects values of parameters (defines, and words: "fine=0.5",
/// "elements*0.5") for elements of 1/fineness of their size. A fineness of 1 leaves the counts of
/// $MESH cards and the scripts alone. Scripts are copied into `folder`.
DeckVariant refine_deck_mesh(const StudiedDeck& deck, const MeshRefinementControls& mesh_parameter,
                             double fineness, const deck::DeckCardList& text,
                             const std::filesystem::path& folder);

/// Values of parameters with some more; those of `more` count where both have one.
ParameterDefinitions merge_defines(ParameterDefinitions defines, const ParameterDefinitions& more);

/// Reads a changed text of a deck, written into `folder` and removed again.
CheckedDeck read_trial_deck(const deck::DeckCardList& text, const ParameterDefinitions& defines,
                            const std::filesystem::path& folder);

/// Whether a card imports what a geometry script makes.
bool imports_geometry_script(const deck::DeckCard& card);

/// Whether a card imports solids of a STEP file.
bool imports_step_file(const deck::DeckCard& card);

/// Makes the card import a copy of its script in `folder`, NAME_SUFFIX.geo, with one more line.
void import_script_with_added_line(deck::DeckCard& card, const std::string& suffix,
                                   const std::string& line, const std::filesystem::path& folder);

struct ParameterUse {
  std::set<std::size_t> counts; ///< $MESH cards whose numbers of elements it goes into [card]
  bool elsewhere = false;       ///< any other use
};

/// By name in upper case; a parameter has the uses of those that are made of it.
std::map<std::string, ParameterUse> find_parameter_uses(const deck::DeckCardList& text,
                                                        const base::SourceTexts& sources);

/// Parameters that go into the value of one, by its name, directly or through others, and itself.
std::map<std::string, std::set<std::string>>
parameter_dependencies(const deck::DeckCardList& text, const base::SourceTexts& sources);

/// Whether a key of $MESH is a number of elements, or how their sizes are spread.
bool is_element_sizing_key(std::string_view key);

} // namespace spricka::program
