// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/card_table.hpp"

#include <array>

namespace spricka::grammar {

namespace {

using namespace table;
using enum EntityKind;
using enum QuantityKind;

constexpr std::array load_keys{
    required(defining_key("CASE", load_case, "the case this adds to")),
    required(word_key(
        "TYPE", "FORCE|RESULTANT|TRACTION|PRESSURE|BODY|BEARING|DISP|TEMPERATURE|FACES|RESIDUAL",
        "what the values are and what they act on")),
    with_default(word_key("SHAPE", "UNIFORM|COSINE", "how the pressure of a BEARING is spread"),
                 "COSINE"),
};

constexpr std::array load_when{
    KeyPresenceRule{"TYPE",
                    "FORCE|RESULTANT|TRACTION|PRESSURE|BODY|DISP|TEMPERATURE|FACES|RESIDUAL", "",
                    "SHAPE"},
};

constexpr std::array contact_keys{
    required(defining_key("NAME", contact, "called by this in steps and results")),
    required(reference_key("SLAVE", set, "one surface; forces are those on it")),
    required(reference_key("MASTER", surface, "the other surface, or a rigid target")),
    with_default(word_key("TYPE", "UNILATERAL|BONDED", "BONDED: no opening, no slip"),
                 "UNILATERAL"),
    real_key("INTERFERENCE", length, at_least(0),
             "overlap along the normal (on the radius), used exactly"),
    real_key("DIAMETRAL", length, anything,
             "overlap on the diameter: twice INTERFERENCE; negative: clearance"),
    real_key("GAP", length, anything,
             "normal gap, used exactly; 0: a neat fit (zero clearance); negative: overlap"),
    with_default(real_key("MU", number, at_least(0), "coefficient of Coulomb friction"), "0"),
    with_default(
        word_key("PAIRING", "NODE|SEGMENT", "SEGMENT: any two meshes; NODE: matching nodes"),
        "SEGMENT"),
    with_default(
        word_key("MULTIPLIER", "NODE|CORNER",
                 "between solids: a pressure at each node, or at the corners of elements only "
                 "(fewer unknowns, smoother, less sharp at the ends of contact)"),
        "NODE"),
    with_default(word_key("RECOVERY", "LUMPED|CONSISTENT", "how pressure follows from NODE forces"),
                 "LUMPED"),
};

constexpr std::array contact_when{
    KeyPresenceRule{"TYPE", "BONDED", "", "MU"}, // no slip, so nothing to rub
    KeyPresenceRule{"PAIRING", "NODE", "", "MULTIPLIER"},
};

constexpr std::array rigid_keys{
    required(defining_key("NAME", rigid, "called by this on $CONTACT")),
    required(word_key("SHAPE", "LINE|ARC|PLANE|CYLINDER|CONE|SPHERE",
                      "LINE and ARC in 2D, the others in 3D")),
    real_key(
        "X0", length, anything,
        "first point of a LINE, centre of an ARC or a SPHERE, point of a PLANE or an axis; about "
        "an axis (STATE=AXI) the radius"),
    real_key("Y0", length, anything, "see X0"),
    real_key("Z0", length, anything, "see X0"),
    real_key(
        "X1", length, anything,
        "second point of a LINE, the body is on the left, or of the axis of a CYLINDER or CONE; "
        "the normal of a PLANE runs from the first point to it, towards the body"),
    real_key("Y1", length, anything, "see X1"),
    real_key("Z1", length, anything, "see X1"),
    real_key(
        "R", length, anything,
        "radius of an ARC, CYLINDER or SPHERE, of a CONE at the first point; negative for a bore"),
    real_key("R1", length, anything, "radius of a CONE at the second point, with the sign of R"),
};

constexpr std::array rigid_when{
    KeyPresenceRule{"SHAPE", "LINE", "X0 Y0 X1 Y1", "R R1 Z0 Z1"},
    KeyPresenceRule{"SHAPE", "ARC", "X0 Y0 R", "X1 Y1 Z0 Z1 R1"},
    KeyPresenceRule{"SHAPE", "PLANE", "X0 Y0 Z0 X1 Y1 Z1", "R R1"},
    KeyPresenceRule{"SHAPE", "CYLINDER", "X0 Y0 Z0 X1 Y1 Z1 R", "R1"},
    KeyPresenceRule{"SHAPE", "CONE", "X0 Y0 Z0 X1 Y1 Z1 R R1", ""},
    KeyPresenceRule{"SHAPE", "SPHERE", "X0 Y0 Z0 R", "X1 Y1 Z1 R1"},
};

constexpr std::array crack_keys{
    required(defining_key("NAME", crack, "called by this on other cards and in results")),
    reference_key("PATH", set, "ordered nodes from the mouth on, along element edges"),
    reference_key("NET", net, "the net a free crack cuts"),
    real_key("A0", length, above(0), "first length, from the mouth or from the middle"),
    real_key(
        "ANGLE", angle, closed_interval(-6.2832, 6.2832),
        "direction of a free crack of one point, from +x; of a flaw by words the place round a "
        "round face or edge; in radians, or 45[deg]"),
    with_default(
        word_key("LINE", "STRAIGHT|SMOOTH",
                 "how a free crack runs from point to point: straight, or on a smooth curve"),
        "STRAIGHT"),
    key_of_type(
        KeyType::references, "AT", face_set,
        "a flaw by words: the face of a surface flaw, or two faces that meet in the edge of a "
        "corner flaw; names of NET"),
    real_key("DEPTH", length, above(0),
             "of a flaw by words, into the body; of a corner flaw along the first face of AT"),
    real_key("LENGTH", length, above(0),
             "of its mouth on the face (of a corner flaw on the second face of AT); default: twice "
             "the DEPTH, of a corner flaw the DEPTH"),
    word_key("ALONG", "X|Y|Z",
             "direction of the mouth of a surface flaw; default on a round face: along its axis"),
    reference_key("FRONT", set,
                  "nodes of the front of a crack that the mesh has already, in the plane its tip"),
    real_key("A", length, above(0), "semi-axis of an ellipse in space, at right angles to C"),
    real_key("C", length, above(0), "its other semi-axis; left out: a circle"),
    real_key(
        "X0", length, anything,
        "centre of an ellipse, in the body, on its surface or beside it; of a front drawn by its "
        "points a point within the crack; with AT any of X0 Y0 Z0 say where on the face or edge"),
    real_key("Y0", length, anything, "see X0"),
    real_key("Z0", length, anything, "see X0"),
    word_key("NORMAL", "X|Y|Z",
             "normal of an ellipse's plane; then C lies along Y, Z or X, the next axis"),
    real_key(
        "X1", length, anything,
        "for any plane: its normal runs from the centre to this point, where the upper face is"),
    real_key("Y1", length, anything, "see X1"),
    real_key("Z1", length, anything, "see X1"),
    real_key("X2", length, anything, "the semi-axis C runs from the centre towards this point"),
    real_key("Y2", length, anything, "see X2"),
    real_key("Z2", length, anything, "see X2"),
    with_default(word_key("CLOSED", "YES|NO", "whether the last point of a front joins the first"),
                 "NO"),
    with_default(word_key("STATE", "STRESS|STRAIN|AUTO",
                          "plane state that turns G into K; AUTO: the property's"),
                 "AUTO"),
    with_default(word_key("FACES", "CONTACT|FREE", "whether the faces may touch"), "CONTACT"),
    with_default(real_key("MU", number, at_least(0), "friction of the faces"), "0"),
};

constexpr std::array crack_when{
    KeyPresenceRule{"PATH", "", "A0", "ANGLE FRONT NORMAL A X0"},
    KeyPresenceRule{"FRONT", "", "", "PATH ANGLE A0 A X0"},
    KeyPresenceRule{"ANGLE", "", "", "PATH FRONT A"},
    KeyPresenceRule{"AT", "", "DEPTH", "PATH FRONT A A0 X1 X2 CLOSED"},
    KeyPresenceRule{"DEPTH", "", "AT", ""},
    KeyPresenceRule{"LENGTH", "", "AT", ""},
    KeyPresenceRule{"ALONG", "", "AT", ""},
    KeyPresenceRule{"NET", "", "", "PATH FRONT"},
    KeyPresenceRule{"LINE", "SMOOTH", "", "PATH FRONT ANGLE A"},
    KeyPresenceRule{"A", "", "X0 Y0 Z0", "PATH FRONT ANGLE A0 CLOSED"},
    KeyPresenceRule{"C", "", "A", ""},
    KeyPresenceRule{"NORMAL", "", "A", "X1"},
    KeyPresenceRule{"X1", "", "Y1 Z1", ""},
    KeyPresenceRule{"Y1", "", "X1", ""},
    KeyPresenceRule{"Z1", "", "X1", ""},
    KeyPresenceRule{"X2", "", "Y2 Z2", ""},
    KeyPresenceRule{"Y2", "", "X2", ""},
    KeyPresenceRule{"Z2", "", "X2", ""},
    KeyPresenceRule{"CLOSED", "YES", "", "X0"},
    KeyPresenceRule{"FACES", "FREE", "", "MU"},
};

constexpr std::array tipnet_keys{
    required(reference_key("CRACK", crack, "whose tips")),
    real_key("RADIUS", length, above(0), "radius of the rings round the tip"),
    real_key("SIZE", length, above(0), "size of the elements at the tip"),
    with_default(integer_key("RINGS", closed_interval(2, 200),
                             "number of element rings round the tip; in space 3 if left out"),
                 "5"),
    with_default(integer_key("SECTORS", closed_interval(6, 1000),
                             "elements round a full circle; in space 8 if left out"),
                 "24"),
    with_default(
        real_key(
            "FINER", number, closed_interval(0.2, 20.0),
            "makes elements this many times smaller than the other keys say; in the plane also "
            "more rings and sectors, and of FINER and a fine net the finer counts"),
        "1"),
    with_default(word_key("QUARTER", "YES|NO", "quarter-point tip elements"), "YES"),
    with_default(
        word_key("JOIN", "CONFORMING|TRANSITION",
                 "how the patch joins the mesh of the part: edge to edge, or finer and tied to its "
                 "edges"),
        "CONFORMING"),
    with_default(word_key("PATCH", "YES|NO", "NO: the deck's own elements stay"), "YES"),
    with_default(
        word_key(
            "TUBE", "YES|NO",
            "YES: in space a tube of quarter-point elements along the front; NO: tetrahedra up "
            "to the front, even ones within RADIUS, as where no tube fits"),
        "YES"),
    real_key("TOL", number, open_interval(0, 1),
             "a part of K: refine until the error bars of K1 and K2 are below TOL*K, of fronts TOL "
             "times the "
             "largest K"),
};

constexpr std::array tipnet_when{
    KeyPresenceRule{"PATCH", "NO", "", "RADIUS SIZE SECTORS FINER JOIN TUBE"},
    KeyPresenceRule{"TUBE", "NO", "", "SECTORS JOIN"},
};

constexpr std::array vce_keys{
    required(reference_key("CRACK", crack, "whose K")),
    real_key("SHIFT", number, closed_interval(1e-12, 1e-1), "finite shift in tip element sizes"),
    key_of_type(KeyType::integers, "DOMAINS", none, "how many rings move rigidly, a K for each"),
    with_default(
        word_key("CHECK", "NONE|OPENING", "K from the opening of the faces, printed beside K"),
        "NONE"),
};

constexpr std::array cards{
    CardSpec{.name = "LOAD",
             .group = "loads",
             .keys = load_keys,
             .data = DataLineForm::rows,
             .data_required = true,
             .data_form = "SET v1 [v2 [v3]]; values may be (expr in x y z)",
             .when = load_when,
             .doc = "Adds to a load case: forces, pressures, displacements."},
    CardSpec{.name = "CONTACT",
             .group = "contact",
             .keys = contact_keys,
             .exclusive = "INTERFERENCE DIAMETRAL GAP",
             .when = contact_when,
             .doc = "A contact pair and its fit; without one the gap is that of the geometry."},
    CardSpec{.name = "RIGID",
             .group = "contact",
             .keys = rigid_keys,
             .when = rigid_when,
             .doc = "A rigid target, usable as MASTER: a line or circle in 2D or about an axis, a "
                    "plane, cylinder, cone or sphere in 3D."},
    CardSpec{
        .name = "CRACK",
        .group = "crack",
        .keys = crack_keys,
        .data = DataLineForm::rows,
        .data_form = "in the plane: x y, from the mouth (or first tip) on; in space: x y z of "
                     "the front",
        .when = crack_when,
        .doc =
            "A crack: in the plane along PATH or through points, in space an ellipse or a front."},
    CardSpec{.name = "TIPNET",
             .group = "crack",
             .keys = tipnet_keys,
             .when = tipnet_when,
             .doc = "The mesh at a tip or front; the program chooses and prints what is left out."},
    CardSpec{
        .name = "VCE",
        .group = "crack",
        .keys = vce_keys,
        .doc = "Virtual crack extension, the way to K: analytic, or with SHIFT by a finite shift."},
};

} // namespace

std::span<const CardSpec> joint_cards() {
  return cards;
}

} // namespace spricka::grammar
