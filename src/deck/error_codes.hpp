// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string_view>

namespace spricka::deck {

struct ErrorCode {
  std::string_view code;
  std::string_view meaning;
};

/// Every mistake a deck can hold, for the manual. E1: syntax and cards; E2: expressions and units;
/// E3: references and the model. Codes are stable: none is given a second meaning.
inline constexpr std::array error_codes{
    ErrorCode{"E101", "something else was expected here, or the line ends early"},
    ErrorCode{"E102", "text that belongs to nothing"},
    ErrorCode{"E103", "not a number, range or label as the language writes them"},
    ErrorCode{"E104", "no such card"},
    ErrorCode{"E105", "the card has no such key"},
    ErrorCode{"E106", "the card needs this key"},
    ErrorCode{"E107", "a key is given twice"},
    ErrorCode{"E108", "a value of the wrong kind or an unknown word"},
    ErrorCode{"E109", "a number out of its range"},
    ErrorCode{"E110", "keys that exclude each other or mean nothing together"},
    ErrorCode{"E111", "$DECK is not the first card"},
    ErrorCode{"E112", "$END is missing"},
    ErrorCode{"E113", "an included file cannot be read, includes itself or is nested too deep"},
    ErrorCode{"E114", "$NET and $ENDNET do not match"},
    ErrorCode{"E115", "data lines are missing, unwanted or not of the card's form"},
    ErrorCode{"E117", "a name with a letter the language does not have"},
    ErrorCode{"E118", "a card behind $END"},
    ErrorCode{"E119", "a card is given twice that a deck has once"},
    ErrorCode{"E120", "a table row ends early or holds no number here"},
    ErrorCode{"E121", "a table row goes on behind its last column"},
    ErrorCode{"E122", "a file that is not a plain text"},
    ErrorCode{"E201", "no such parameter"},
    ErrorCode{"E202", "no such function"},
    ErrorCode{"E203", "a function with the wrong number of arguments"},
    ErrorCode{"E204", "no such unit"},
    ErrorCode{"E205", "a unit that does not fit the quantity"},
    ErrorCode{"E206", "an expression without a finite value"},
    ErrorCode{"E207", "a parameter is defined twice"},
    ErrorCode{"E208", "a parameter named by a word of the language"},
    ErrorCode{"E209", "x y z rho theta where there is no place"},
    ErrorCode{"E210", "a definition on the command line that is none"},
    ErrorCode{"E301", "no such set, material, contact, crack, case, step or parameter"},
    ErrorCode{"E302", "a name is defined twice"},
    ErrorCode{"E303", "no such node or element number"},
    ErrorCode{"E304", "a node or element number is given twice"},
    ErrorCode{"E305", "an element without a property"},
    ErrorCode{"E306", "an element with two properties"},
    ErrorCode{"E307", "an element turned inside out"},
    ErrorCode{"E308", "a file named by a card does not exist"},
    ErrorCode{"E309", "a set is empty"},
    ErrorCode{"E310", "a set is made of itself"},
    ErrorCode{"E311", "a node set that holds no boundary face where faces are wanted"},
    ErrorCode{"E312", "the wrong number of load values"},
    ErrorCode{"E313", "plane and space mixed"},
    ErrorCode{"E314", "no such result"},
    ErrorCode{"E315", "the wrong arguments of a result"},
    ErrorCode{"E316", "contact surfaces with faces in common"},
    ErrorCode{"E317", "a path that is no crack path"},
    ErrorCode{"E318", "a deck without elements"},
    ErrorCode{"E319", "a displacement where no freedom is prescribed"},
    ErrorCode{"E320", "a step that says the same thing twice"},
    ErrorCode{"E321", "a mesh too large to be made"},
    ErrorCode{"W307", "a solid element that folds over slightly in a corner"},
    ErrorCode{"E432", "a plane $PROPERTY without THICK beside others with it"},
    ErrorCode{"E433", "displacements of one case that contradict each other where sets meet"},
    ErrorCode{"W312", "a load with fewer values than directions"},
    ErrorCode{"W313", "a heated material without ALPHA"},
    ErrorCode{"E340", "an element that stands twice"},
    ErrorCode{"W341", "sides of elements that touch, with nothing to join them"},
    ErrorCode{"W342", "an angle in whole radians"},
    ErrorCode{"W343", "a modulus beyond that of any material"},
    ErrorCode{"W344", "a crack in another plane state than its elements"},
    ErrorCode{"W345", "a crack that starts just inside the surface"},
    ErrorCode{"W432", "forces on a plane body whose THICK is not given"},
    ErrorCode{"W433", "plane bodies of different thickness that meet"},
    ErrorCode{"W434", "plane stress that meets plane strain"},
    ErrorCode{"E322", "an output file with the name of one that every run writes"},
    ErrorCode{"E323", "a load path between steps that no straight line joins"},
    ErrorCode{"E324", "a load path with friction"},
    ErrorCode{"E325", "a spectrum that leaves its load path, or has no cycle"},
    ErrorCode{"E326", "a growth test without the readings, reference or lengths it needs"},
    ErrorCode{"E327", "a spectrum with friction that is too long to be followed"},
    ErrorCode{"E390", "a parameter is swept and given with -D"},
    ErrorCode{"E391", "a parameter is swept twice"},
};

} // namespace spricka::deck
