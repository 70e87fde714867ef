// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/card_table.hpp"

#include <array>

namespace spricka::grammar {

namespace {

using namespace table;
using enum EntityKind;
using enum QuantityKind;

constexpr std::array deck_keys{
    required(integer_key("VERSION", closed_interval(1, 1), "version of the language; this is 1")),
    required(word_key("LENGTH", "M|MM|IN", "unit of every length of the deck")),
    required(word_key("FORCE", "N|KN|LBF", "unit of every force; stresses are FORCE/LENGTH^2")),
    text_key("TITLE", "heads the listing"),
    unit_key("OUTK", stress_intensity,
             "what K is written in, 'MPa*sqrt(m)'; left out: as the deck's units have it"),
    unit_key("OUTLENGTH", length, "what lengths are written in, 'in'; areas and rates follow"),
    unit_key("OUTFORCE", force,
             "what forces are written in, 'kip'; moments, energies and G follow with OUTLENGTH"),
    unit_key("OUTSTRESS", stress, "what stresses and pressures are written in, 'ksi'"),
    word_key(
        "OUTLIFE", "CYCLES|KCYCLES|PASSES",
        "what lives are written in; KCYCLES: thousands; left out: cycles, of a spectrum passes"),
};

constexpr std::array include_keys{
    required(text_key("FILE", "a file of whole cards; its path counts from the including file")),
};

constexpr std::array net_keys{
    required(defining_key("NAME", net, "sets of the net are seen outside as NAME.SET")),
};

constexpr std::array import_keys{
    required(text_key("FILE", "path from this deck")),
    word_key("FORMAT", "GEO|MSH|INP|NASTRAN|STEP",
             "gmsh script, gmsh mesh, input of Abaqus or CalculiX, Nastran bulk data, or solids of "
             "a STEP file; left out: by what FILE holds or its ending"),
    with_default(real_key("SCALE", number, above(0), "factor on every coordinate"), "1"),
    real_key("SIZE", length, above(0),
             "STEP: size of the elements; left out: a fifteenth of the part"),
    with_default(real_key("FINER", number, closed_interval(0.2, 20),
                          "STEP: makes all elements this many times smaller"),
                 "1"),
    key_of_type(KeyType::references, "SOLID", solid,
                "STEP: which solids of the file; left out: all"),
    with_default(word_key("TYPE", "ASIS|QUADRATIC", "QUADRATIC raises linear elements"), "ASIS"),
    with_default(word_key("SKIP", "NOTHING|LOADS|ALL",
                          "INP, NASTRAN: LOADS passes over supports, loads and steps, ALL over all "
                          "but mesh, sets, surfaces, sections and what is elastic"),
                 "NOTHING"),
    text_key("ESET", "INP: only the elements of this set of the file, and what names them: one "
                     "body of several"),
};

constexpr std::array mesh_keys{
    required(word_key("SHAPE", "BLOCK|RING|LUG|PLATE", "what is meshed; a PLATE has a round hole")),
    required(word_key("TYPE",
                      "TRIM3|TRIMC6|QUAM4|QUAMC8|QUAMC9|TET10|PENTA6|PENTAC15|HEXE8|HEXEC20|"
                      "HEXEC27",
                      "element type; a C stands for curved, quadratic edges")),
    with_default(real_key("X0", length, anything,
                          "corner of a BLOCK or PLATE, centre of a RING or of a LUG's bore"),
                 "0"),
    with_default(real_key("Y0", length, anything, "see X0"), "0"),
    with_default(real_key("Z0", length, anything, "lower face, in space"), "0"),
    real_key("LX", length, above(0), "side of a BLOCK or PLATE along x"),
    real_key("LY", length, above(0), "side of a BLOCK or PLATE along y"),
    real_key("LZ", length, above(0), "thickness along z, in space"),
    real_key("RI", length, at_least(0),
             "inner radius of a RING (0: a disc), radius of the bore of a LUG or PLATE"),
    real_key("RO", length, above(0),
             "outer radius of a RING; radius of the head of a LUG, default W/2"),
    real_key("W", length, above(0),
             "width of a LUG at END, which is at -x; sides run from there to the round head at +x"),
    real_key("L", length, above(0), "length of a LUG, from the centre of the bore to END"),
    with_default(
        real_key("EX", length, anything, "centre of the head of a LUG, as seen from the bore's"),
        "0"),
    with_default(real_key("EY", length, anything, "see EX"), "0"),
    real_key("XH", length, anything, "centre of the hole of a PLATE; default: the middle"),
    real_key("YH", length, anything, "see XH"),
    with_default(real_key("T0", angle, anything, "first angle of a RING"), "0"),
    with_default(real_key("T1", angle, anything, "last angle of a RING"), "2*pi"),
    with_default(integer_key("NX", at_least(1), "elements along x"), "1"),
    with_default(integer_key("NY", at_least(1), "elements along y"), "1"),
    with_default(integer_key("NZ", at_least(1), "elements along z"), "1"),
    with_default(integer_key("NR", at_least(1),
                             "elements from RI outwards, of a PLATE in a box about the hole"),
                 "1"),
    with_default(integer_key("NT", at_least(3), "elements round"), "16"),
    with_default(real_key("BIAS", number, above(0),
                          "last over first element size along x, or from RI to RO"),
                 "1"),
};

constexpr std::array mesh_when{
    KeyPresenceRule{"SHAPE", "BLOCK", "LX LY", "RI RO W L EX EY XH YH T0 T1 NR NT"},
    KeyPresenceRule{"SHAPE", "RING", "RI RO", "LX LY W L EX EY XH YH NX NY"},
    KeyPresenceRule{"SHAPE", "LUG", "RI W L", "LX LY XH YH T0 T1 NX NY BIAS"},
    KeyPresenceRule{"SHAPE", "PLATE", "RI LX LY", "RO W L EX EY T0 T1 NX NY BIAS"},
    KeyPresenceRule{"TYPE", "TRIM3|TRIMC6|QUAM4|QUAMC8|QUAMC9", "", "Z0 LZ NZ"},
};

constexpr std::array coor_keys{
    defining_key("NSET", node_set, "a node set of these nodes"),
    with_default(word_key("SYSTEM", "CART|CYL", "CYL: the columns are r, theta, z"), "CART"),
    with_default(integer_key("DIM", closed_interval(2, 3), "2: no z column"), "3"),
};

constexpr std::array element_keys{
    required(word_key("TYPE",
                      "TRIM3|TRIMC6|QUAM4|QUAMC8|QUAMC9|"
                      "TET4|TET10|PENTA6|PENTAC15|HEXE8|HEXEC20|HEXEC27",
                      "element type, which says how many nodes a line has")),
    defining_key("ESET", element_set, "an element set of these elements"),
};

constexpr std::array nset_keys{
    required(defining_key("NAME", node_set, "called by this, outside its net by NET.NAME")),
    reference_key("FROM", set, "start from the nodes of this set"),
    expression_key("WHERE", "keep the nodes where this holds"),
    expression_key("ORDER", "sort by this, ascending: crack paths and fronts"),
};

constexpr std::array eset_keys{
    required(defining_key("NAME", element_set, "called by this, outside its net by NET.NAME")),
    reference_key("FROM", element_set, "start from the elements of this set"),
    expression_key("WHERE", "keep the elements at whose centroid this holds"),
};

constexpr std::array fset_keys{
    required(defining_key("NAME", face_set, "called by this, outside its net by NET.NAME")),
    reference_key("FROM", set, "start from the boundary faces of this set"),
    expression_key("WHERE", "keep the faces all of whose nodes fulfil this"),
};

constexpr std::array material_keys{
    required(defining_key("NAME", material, "called by this on $PROPERTY")),
    required(real_key("E", stress, above(0), "Young's modulus")),
    required(real_key("NU", number, ValueLimits{-1.0, 0.5, true, true}, "Poisson's ratio")),
    with_default(real_key("RHO", number, at_least(0), "density"), "0"),
    with_default(real_key("ALPHA", number, anything,
                          "thermal expansion per degree, for $LOAD TYPE=TEMPERATURE"),
                 "0"),
};

constexpr std::array property_keys{
    required(reference_key("ESET", element_set, "the elements")),
    required(reference_key("MATERIAL", material, "what they are made of")),
    required(word_key("STATE", "STRESS|STRAIN|AXI|SOLID",
                      "plane stress, plane strain, axisymmetric about x = 0, 3D")),
    with_default(real_key("THICK", length, above(0), "thickness of a plane body"), "1"),
};

constexpr std::array property_when{
    KeyPresenceRule{"STATE", "AXI|SOLID", "", "THICK"},
};

constexpr std::array freedom_keys{
    required(
        word_key("CLASS", "SUPPRESSED|PRESCRIBED|EXTERNAL",
                 "SUPPRESSED: held at zero; PRESCRIBED: moved by $LOAD TYPE=DISP; EXTERNAL: kept "
                 "in condensation")),
    required(word_key("DOF", "X|Y|Z|XY|XZ|YZ|XYZ", "directions that the class is for")),
};

constexpr std::array mpc_keys{
    required(word_key("TYPE", "EQUATION|TRANSITION|RIGID", "kind of tie")),
    reference_key("SLAVE", set, "the tied nodes"),
    reference_key("MASTER", set, "the faces they are tied to"),
    with_default(real_key("RHS", number, anything, "right-hand side of the equation"), "0"),
};

constexpr std::array mpc_when{
    KeyPresenceRule{"TYPE", "TRANSITION", "SLAVE MASTER", "RHS"},
    KeyPresenceRule{"TYPE", "RIGID", "SLAVE", "MASTER RHS"},
    KeyPresenceRule{"TYPE", "EQUATION", "", "SLAVE MASTER"},
};

constexpr std::array symmetry_keys{
    required(
        word_key("NORMAL", "X|Y|Z", "normal of the plane, which lies in the middle of all bodies")),
    with_default(word_key("KEEP", "ABOVE|BELOW",
                          "the side that is modelled: of the larger coordinates, or "
                          "of the smaller ones"),
                 "ABOVE"),
};

constexpr std::string_view items = "id, first : last [: step], SET, -SET";

constexpr std::array cards{
    CardSpec{.name = "DECK",
             .group = "deck",
             .keys = deck_keys,
             .once = true,
             .doc = "First card: version of the language, units, title."},
    CardSpec{
        .name = "PARAMETER",
        .group = "deck",
        .data = DataLineForm::assignments,
        .data_required = true,
        .data_form = "NAME = expression",
        .doc = "Constants for the expressions below; -D NAME=expr on the command line overrides."},
    CardSpec{.name = "REQUIRE",
             .group = "deck",
             .data = DataLineForm::rows,
             .data_required = true,
             .data_form = "(condition) 'what is wrong where it does not hold'",
             .doc = "Conditions on the parameters; where one fails, its text is the error."},
    CardSpec{.name = "INCLUDE",
             .group = "deck",
             .keys = include_keys,
             .doc = "Reads the cards of another file in place of this one."},
    CardSpec{
        .name = "NET",
        .group = "subnets",
        .keys = net_keys,
        .doc =
            "Opens a net: the mesh of one part, with its own node and element numbers and sets."},
    CardSpec{.name = "ENDNET", .group = "subnets", .doc = "Closes the net; nets do not nest."},
    CardSpec{.name = "IMPORT",
             .group = "topology",
             .keys = import_keys,
             .data = DataLineForm::rows,
             .data_form = "physical-or-set-name = new-name; STEP: faces = NAME [size]",
             .doc = "A mesh and its sets from a file into the open net."},
    CardSpec{.name = "MESH",
             .group = "topology",
             .keys = mesh_keys,
             .when = mesh_when,
             .doc = "Meshes a block, ring, lug or plate with a hole and names its sides."},
    CardSpec{.name = "COOR",
             .group = "topology",
             .keys = coor_keys,
             .data = DataLineForm::table,
             .data_required = true,
             .data_form = "id x y [z]",
             .doc = "Node coordinates."},
    CardSpec{.name = "ELEMENT",
             .group = "topology",
             .keys = element_keys,
             .data = DataLineForm::table,
             .data_required = true,
             .data_form = "id n1 n2 ..",
             .doc = "Elements with their nodes: corners first, then mid-edge nodes."},
    CardSpec{.name = "NSET",
             .group = "topology",
             .keys = nset_keys,
             .data = DataLineForm::rows,
             .data_form = items,
             .doc = "A node set from items, from another set or by place."},
    CardSpec{.name = "ESET",
             .group = "topology",
             .keys = eset_keys,
             .data = DataLineForm::rows,
             .data_form = items,
             .doc = "An element set from items, from another set or by place."},
    CardSpec{.name = "FSET",
             .group = "topology",
             .keys = fset_keys,
             .data = DataLineForm::rows,
             .data_form = "SET, -SET; a node set gives the faces all of whose nodes lie in it",
             .doc = "A set of boundary faces (edges in 2D); stands wherever a node set is wanted."},
    CardSpec{.name = "MATERIAL",
             .group = "material and geometry",
             .keys = material_keys,
             .doc = "Isotropic, linear elastic material."},
    CardSpec{.name = "PROPERTY",
             .group = "material and geometry",
             .keys = property_keys,
             .when = property_when,
             .doc =
                 "Plane stress, plane strain or solid, thickness and material of an element set."},
    CardSpec{.name = "FREEDOM",
             .group = "freedoms",
             .keys = freedom_keys,
             .data = DataLineForm::rows,
             .data_required = true,
             .data_form = items,
             .doc = "Supports and prescribed displacements, by the class of degrees of freedom."},
    CardSpec{.name = "MPC",
             .group = "freedoms",
             .keys = mpc_keys,
             .data = DataLineForm::rows,
             .data_form =
                 "EQUATION: coefficient node dof, again and again; NET.12 for a node of a net",
             .when = mpc_when,
             .doc = "Ties between nodes: multi-point constraints."},
    CardSpec{.name = "SYMMETRY",
             .group = "freedoms",
             .keys = symmetry_keys,
             .doc = "Models one half of a symmetric deck: one side of a plane of symmetry."},
};

} // namespace

std::span<const CardSpec> model_cards() {
  return cards;
}

} // namespace spricka::grammar
