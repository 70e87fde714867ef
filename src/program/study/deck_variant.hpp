// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"
#include "sense/section.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Decks that the program makes of one that it is given.
namespace spricka::program {

struct CheckedDeck;
using ParameterDefinitions = std::vector<std::pair<std::string, std::string>>;

/// A deck as its cards, what it was read with, and the model that it makes.
struct StudiedDeck {
  std::filesystem::path file;
  ParameterDefinitions defines; ///< of the command line
  deck::DeckCardList text;
  const CheckedDeck* ready = nullptr;
};

/// What a study varies; settings of one family with several sizes are a series.
enum class SettingFamily {
  given,      ///< the deck as it is
  whole,      ///< meshes of bodies and nets of tips, all sizes alike; a deck without cracks: bodies
  host,       ///< meshes of bodies alone
  tip,        ///< nets of tips alone
  quarter,    ///< all sizes, with QUARTER=NO
  linear,     ///< all sizes, with linear elements
  transition, ///< JOIN=TRANSITION
  tube,       ///< TUBE=NO
  part,       ///< one side of the planes of symmetry
  tolerance,  ///< TOL, from the coarsest mesh
  path,       ///< steps in place of load paths
  asked,      ///< --vary
  peer        ///< CalculiX on the meshes of others
};

/// For legends: "all sizes", "without quarter points".
const char* display_name(SettingFamily family);

/// How answers of the solid are asked of its section.
struct SectionMapping {
  sense::SectionPlane plane;
  /// [crack, upper case] K2 of the section has the sign of K2 in space, or the other one.
  std::map<std::string, double> sign_of_K2;
};

/// A deck made of the one given, and what is needed to ask it for the answers of that one.
struct DeckVariant {
  std::optional<deck::DeckCardList> text = {}; ///< empty: the scene has no place for it
  std::string reason = {};                     ///< why there is none
  std::string name = {};                       ///< "fine=0.5 FINER=0.5", "without friction"
  std::string words = {};                      ///< what is simplified, a sentence
  std::filesystem::path deck = {};             ///< its file, in the scratch folder
  ParameterDefinitions defines = {};           ///< that it is read with
  std::string mirrored = {};                   ///< across which axes its model is a part, "XY"
  std::optional<SectionMapping> section = {};  ///< it is a plane model of a solid
  bool simpler = true; ///< false: another model, no simpler one; never the one that is enough
  SettingFamily family = SettingFamily::given;
  double fineness = 1.0; ///< elements have 1/fineness of the deck's sizes, where those vary
};

/// No deck, and why.
inline DeckVariant make_refused_variant(std::string reason) {
  return {.reason = std::move(reason)};
}

/// The part of a deck whose model is one of two, four or eight mirror images: with a $SYMMETRY card
/// for each plane that all of the model respects. Refused is a model without such a plane.
DeckVariant reduce_by_symmetry(const model::Model& model, const deck::DeckCardList& text);

/// The section of bodies along an axis in plane stress or strain ("STRESS", "STRAIN"), or of round
/// ones ("AXI"): their meshes and sets written out, other cards as of `text`, the deck of the
/// model. Refused is what differs along the axis, or round it.
DeckVariant make_section_deck(const model::Model& model, const deck::DeckCardList& text,
                              const std::string& state);

/// Simpler models of a deck's joint, made by rewriting its cards. The richest (the deck itself,
/// without its checks and requests) first: a half by symmetry, without friction, all mounted at
/// once, fits but bonded, without interference, bonded, stiff or rigid pressing bodies, pressures
/// in their place, the other plane state; of solids their sections. Their decks are written into
/// `folder`.
std::vector<DeckVariant> make_simpler_models(const StudiedDeck& deck,
                                             const std::filesystem::path& folder);

} // namespace spricka::program
