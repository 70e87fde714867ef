// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/error_codes.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace spricka::program {

using deck::ErrorCode;

/// What is found behind the reading of a deck. E33: imports; E4: cracks, patches, contacts and
/// loads on the mesh; E5 and W5: the run. Codes are stable: none is given a second meaning.
inline constexpr std::array later_codes{
    ErrorCode{"E330", "a file to import that is not there"},
    ErrorCode{"E331", "gmsh refuses a geometry or mesh, or the file is damaged"},
    ErrorCode{"E332", "no such physical group or set in an imported file"},
    ErrorCode{"E333", "an imported file without elements"},
    ErrorCode{"E334", "an imported element of a type that is not known"},
    ErrorCode{"E335", "an imported plane mesh that does not lie in z = 0"},
    ErrorCode{"E336", "an Abaqus input file that is damaged or says what cannot be imported"},
    ErrorCode{"E401", "a crack whose line is not given"},
    ErrorCode{"E402", "a crack without a length"},
    ErrorCode{"E403", "a crack longer than its line"},
    ErrorCode{"E405", "a deck without a step"},
    ErrorCode{"E410", "contact surfaces that cannot be paired"},
    ErrorCode{"E411", "contact surfaces that never face each other"},
    ErrorCode{"E412", "no ring domain fits round a crack tip"},
    ErrorCode{"E413", "a resultant that its set cannot carry"},
    ErrorCode{"E414", "an $MPC with a node that a crack has cut out"},
    ErrorCode{"E415", "an $MPC whose slave nodes do not lie on the master faces"},
    ErrorCode{"E416", "$MPC cards that contradict each other or supports"},
    ErrorCode{"E417", "a total load on faces of a crack"},
    ErrorCode{"E418", "a force on a node that no element has, or that a crack cut out or added"},
    ErrorCode{"E419", "a support on a node that a crack has cut out"},
    ErrorCode{"E421", "a crack that does not start on the boundary"},
    ErrorCode{"E422", "a crack on a symmetry line that is no straight part of the boundary"},
    ErrorCode{"E423", "a rosette or tube of tip elements that does not fit"},
    ErrorCode{"E424", "a crack, or its patch, across a material boundary"},
    ErrorCode{"E425", "a crack that leaves its body or runs along the boundary"},
    ErrorCode{"E426", "a crack patch among linear elements"},
    ErrorCode{"E427", "a PATH that cannot be followed"},
    ErrorCode{"E428", "crack patches that meet on a line of symmetry"},
    ErrorCode{"W423", "a crack in space without a tube of tip elements"},
    ErrorCode{"W425", "the border of a set that a crack's elements move"},
    ErrorCode{"E429", "a crack patch that could not be meshed"},
    ErrorCode{"E430", "cracks that meet, cross or turn back"},
    ErrorCode{"E431", "a growth by a law that cannot begin"},
    ErrorCode{"E434", "a load that is not a finite number everywhere"},
    ErrorCode{"E435", "a load whose total the mesh round a crack would change"},
    ErrorCode{"W435", "a load that no integration rule follows within an element"},
    ErrorCode{"W436", "a displacement that the nodes it is given at do not carry"},
    ErrorCode{"E437", "a support, tie or force in the node of a crack's mouth that tells no face"},
    ErrorCode{"E438", "a load on a face of a crack that the body does not have"},
    ErrorCode{"E439", "no crack in the mesh at the nodes that FRONT names"},
    ErrorCode{"W451", "bodies drawn touching with nothing to join them"},
    ErrorCode{"W457", "a load that goes wholly into supports"},
    ErrorCode{"W458", "a contact surface or mouth of a crack that is wholly held"},
    ErrorCode{"W459", "a PATH that begins in the middle of a side"},
    ErrorCode{"E457", "rings of a rosette that grow too fast"},
    ErrorCode{"E458", "a PATH with PATCH=NO that begins inside the body"},
    ErrorCode{"E464", "a folder or file that is not ours where results would go"},
    ErrorCode{"E465", "a run folder that another run is writing"},
    ErrorCode{"E466", "too little memory"},
    ErrorCode{"E467", "a run without results where those of an earlier one stand"},
    ErrorCode{"E468", "a standard output that cannot be written"},
    ErrorCode{"E469", "a restart file inside the run folder"},
    ErrorCode{"W466", "bars of an imported file that are left out"},
    ErrorCode{"W467", "supports, loads and steps of an imported file that are passed over"},
    ErrorCode{"E480", "a geometry script that reaches outside: commands, files, the end of gmsh"},
    ErrorCode{"E481", "reading or meshing an imported file takes too long"},
    ErrorCode{"E482", "meshing an imported file takes too much memory"},
    ErrorCode{"E483", "gmsh crashed on an imported file, ended or was stopped"},
    ErrorCode{"E484", "gmsh cannot be run safely on this system"},
    ErrorCode{"E485", "a parameter that may mean two constants of a geometry script"},
    ErrorCode{"E486", "a parameter that nothing uses, named almost as a constant of a script"},
    ErrorCode{"W480", "a parameter that nothing uses in a deck with a geometry script"},
    ErrorCode{"W481", "a parameter that a geometry script sets to another value"},
    ErrorCode{"E500", "a card, key or word that this version does not run"},
    ErrorCode{"E510", "a model that cannot be solved"},
    ErrorCode{"E520", "a solution that did not converge"},
    ErrorCode{"E530", "trouble with a file, the deck itself or the run folder, or with a process"},
    ErrorCode{"E540", "a deck says what the form to convert it to cannot say"},
    ErrorCode{"W331", "gmsh's own words about an imported file"},
    ErrorCode{"W332", "an imported group with faces that are no side of an element"},
    ErrorCode{"W336", "an imported element whose special form is not kept"},
    ErrorCode{"W337", "SCALE on a file that brings moduli"},
    ErrorCode{"E550", "a point of a sweep without success; the sweep goes on"},
    ErrorCode{"E551", "a sweep stopped by a signal"},
    ErrorCode{"E555", "a study or a ladder of a deck that gives no answer to compare"},
    ErrorCode{"E560", "a restart file, or a part of it, that is missing, cut off or changed"},
    ErrorCode{"E561", "a restart file of another deck: a card differs"},
    ErrorCode{"E562", "a restart from an increment that was not kept"},
    ErrorCode{"E563", "a restart file that cannot be written"},
    ErrorCode{"E564", "a file that is no restart file where one is named"},
    ErrorCode{"E565", "a restart file of another version"},
    ErrorCode{"E566", "a run stopped by a signal or by --time"},
    ErrorCode{"E567", "--restart or --time with a deck that keeps no state"},
    ErrorCode{"W456", "a growth that needs a second look"},
    ErrorCode{"W501", "linear triangles, tetrahedra or wedges of a nearly incompressible material"},
    ErrorCode{"W502", "a result of a step that needs a second look"},
    ErrorCode{"W503", "a TRANSITION between meshes that do not nest"},
    ErrorCode{"W504", "a mesh whose estimated error is large"},
    ErrorCode{"W505", "middle nodes at a tip that are neither quarter points nor middles"},
    ErrorCode{"W506", "K that is not within the tolerance asked for"},
    ErrorCode{"W570", "two ways to the same K part by more than its error bar"},
    ErrorCode{"W571", "a contact that presses in no step"},
    ErrorCode{"W572", "a life beyond all use"},
    ErrorCode{"W573", "a test that shares no length with the computed ones"},
    ErrorCode{"W574", "a check at a place that the front does not pass"},
    ErrorCode{"W560", "the newest state cannot be read; the one before is taken"},
    ErrorCode{"W561", "kept increments that are not taken over, or not whole"},
    ErrorCode{"W540", "a converted deck of which only the first step is written"},
};

/// Every code the program can print, the deck's first.
std::vector<ErrorCode> all_codes();

/// What to do about a code, in sentences; empty where the meaning says it all.
std::string_view advice_on(std::string_view code);

} // namespace spricka::program
