// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/card_table.hpp"

#include <array>

namespace spricka::grammar {

namespace {

using namespace table;
using enum EntityKind;
using enum Quantity;

constexpr std::array load_keys{
    required(defining_key("CASE", load_case, "the case this adds to")),
    required(word_key("TYPE",
                      "FORCE|RESULTANT|TRACTION|PRESSURE|BODY|BEARING|DISP|TEMPERATURE|FACES",
                      "what the values are and what they act on")),
    with_default(word_key("SHAPE", "UNIFORM|COSINE", "how the pressure of a BEARING is spread"),
                 "COSINE"),
};

constexpr std::array load_when{
    KeyCondition{"TYPE", "FORCE|RESULTANT|TRACTION|PRESSURE|BODY|DISP|TEMPERATURE|FACES", "",
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
    KeyCondition{"TYPE", "BONDED", "", "MU"}, // no slip, so nothing to rub
    KeyCondition{"PAIRING", "NODE", "", "MULTIPLIER"},
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
    KeyCondition{"SHAPE", "LINE", "X0 Y0 X1 Y1", "R R1 Z0 Z1"},
    KeyCondition{"SHAPE", "ARC", "X0 Y0 R", "X1 Y1 Z0 Z1 R1"},
    KeyCondition{"SHAPE", "PLANE", "X0 Y0 Z0 X1 Y1 Z1", "R R1"},
    KeyCondition{"SHAPE", "CYLINDER", "X0 Y0 Z0 X1 Y1 Z1 R", "R1"},
    KeyCondition{"SHAPE", "CONE", "X0 Y0 Z0 X1 Y1 Z1 R R1", ""},
    KeyCondition{"SHAPE", "SPHERE", "X0 Y0 Z0 R", "X1 Y1 Z1 R1"},
};

constexpr std::array crack_keys{
    required(defining_key("NAME", crack, "called by this on other cards and in results")),
    reference_key("PATH", set, "ordered nodes from the mouth on, along element edges"),
    reference_key("NET", net, "the net a free crack cuts"),
    real_key("A0", length, above(0), "first length, from the mouth or from the middle"),
    real_key("ANGLE", angle, closed_interval(-6.2832, 6.2832),
             "direction of a free crack of one point, from +x; in radians, or 45[deg]"),
    with_default(
        word_key("LINE", "STRAIGHT|SMOOTH",
                 "how a free crack runs from point to point: straight, or on a smooth curve"),
        "STRAIGHT"),
    reference_key("FRONT", set, "nodes of the front of a crack in space that the mesh has already"),
    real_key("A", length, above(0), "semi-axis of an ellipse in space, at right angles to C"),
    real_key("C", length, above(0), "its other semi-axis; left out: a circle"),
    real_key(
        "X0", length, anything,
        "centre of an ellipse, in the body, on its surface or beside it; of a front drawn by its "
        "points a point within the crack"),
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
    KeyCondition{"PATH", "", "A0", "ANGLE FRONT NORMAL A X0"},
    KeyCondition{"FRONT", "", "", "PATH ANGLE A0 A X0"},
    KeyCondition{"ANGLE", "", "A0", "PATH FRONT A X0"},
    KeyCondition{"NET", "", "", "PATH FRONT"},
    KeyCondition{"LINE", "SMOOTH", "", "PATH FRONT ANGLE A"},
    KeyCondition{"A", "", "X0 Y0 Z0", "PATH FRONT ANGLE A0 CLOSED"},
    KeyCondition{"C", "", "A", ""},
    KeyCondition{"NORMAL", "", "A", "X1"},
    KeyCondition{"X1", "", "Y1 Z1", ""},
    KeyCondition{"Y1", "", "X1", ""},
    KeyCondition{"Z1", "", "X1", ""},
    KeyCondition{"X2", "", "Y2 Z2", ""},
    KeyCondition{"Y2", "", "X2", ""},
    KeyCondition{"Z2", "", "X2", ""},
    KeyCondition{"CLOSED", "YES", "", "X0"},
    KeyCondition{"FACES", "FREE", "", "MU"},
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
            "more rings and sectors"),
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
    KeyCondition{"PATCH", "NO", "", "RADIUS SIZE SECTORS FINER JOIN TUBE"},
    KeyCondition{"TUBE", "NO", "", "SECTORS JOIN"},
};

constexpr std::array vce_keys{
    required(reference_key("CRACK", crack, "whose K")),
    real_key("SHIFT", number, closed_interval(1e-12, 1e-1), "finite shift in tip element sizes"),
    key_of_type(KeyType::integers, "DOMAINS", none, "how many rings move rigidly, a K for each"),
    with_default(
        word_key("CHECK", "NONE|OPENING", "K from the opening of the faces, printed beside K"),
        "NONE"),
};

constexpr std::array step_keys{
    required(defining_key("NAME", step, "called by this in results")),
    integer_key("SUBSTEPS", closed_interval(1, 1000000),
                "equal parts a step with friction is run in; left out: as many as its shear needs"),
};

constexpr std::array load_path_keys{
    required(defining_key("NAME", path, "called by this in results")),
    required(reference_key("FROM", step, "loads and fits at t = 0: those this step ends with")),
    required(reference_key("TO", step, "loads and fits at t = 1")),
    with_default(real_key("BEYOND", number, closed_interval(1, 1e6), "the last t"), "1"),
};

constexpr std::array spectrum_keys{
    required(defining_key("NAME", spectrum, "called by this in $GROW")),
    required(reference_key("PATH", path, "the load path whose t the data lines hold")),
    required(word_key("TYPE", "BLOCKS|SEQUENCE", "cycles with their counts, or turning points")),
    text_key("FILE", "turning points or lines from this file, in place of data lines"),
    with_default(real_key("FACTOR", number, above(0), "multiplies every t"), "1"),
};

constexpr std::array grow_keys{
    required(
        word_key("LAW", "INCREMENT|PARIS|WALKER|FORMAN|NASGRO|TABLE",
                 "INCREMENT: the crack lengths are given; PARIS: C dK^M; WALKER: C "
                 "(dK/(1-R)^(1-P))^M; FORMAN: C dK^M/((1-R) KC - dK); NASGRO: Forman and Mettu's "
                 "with Newman's crack opening; TABLE: lines delta_K da/dN")),
    with_default(
        word_key("DIRECTION", "PATH|HOOP|K2ZERO",
                 "PATH: along its line or in its plane; HOOP: to the largest hoop stress; K2ZERO: "
                 "to where K2 vanishes"),
        "PATH"),
    key_of_type(KeyType::references, "CRACKS", crack, "the cracks that grow; all when left out"),
    with_default(
        word_key("SHAPE", "FREE|ELLIPSE",
                 "FREE: in space K shapes the front; ELLIPSE: in space the front stays an ellipse"),
        "FREE"),
    reference_key("KMAX", step, "the step of the largest K"),
    reference_key("KMIN", step, "the step of the smallest K"),
    reference_key("SPECTRUM", spectrum, "the load history of one pass, in place of KMAX and KMIN"),
    with_default(word_key("HISTORY", "RESTART|CONTINUE",
                          "with friction: CONTINUE carries slip over from length to length"),
                 "RESTART"),
    with_default(
        word_key("MOUNTED", "EACH|FIRST",
                 "EACH: every length mounts anew; FIRST: keeps what was mounted at the first"),
        "EACH"),
    real_key("DA", length, above(0), "largest advance of an increment"),
    real_key("TOL", number, closed_interval(1e-6, 0.1),
             "error of the cycles, as a part of them; 1e-3 when left out, 0.02 in space"),
    real_key("AMAX", length, above(0), "crack length at which the growth stops"),
    real_key("CYCLES", number, above(0), "cycles, or passes, at which the growth stops"),
    real_key("C", number, above(0), "factor of the law, in KUNIT and AUNIT"),
    real_key("M", number, above(0), "exponent of the law"),
    with_default(real_key("P", number, anything, "exponent of WALKER (gamma) or of NASGRO"), "0"),
    with_default(real_key("Q", number, anything, "exponent of NASGRO"), "0"),
    real_key("KC", stress_intensity, above(0),
             "fracture toughness, in KUNIT if it has no unit; stops the growth"),
    real_key("SFLOW", stress, above(0),
             "flow stress: the plastic limit of ligament or section stops the growth"),
    with_default(word_key("CORRECT", "YES|NO", "YES: K with the error bar's bias taken out"), "NO"),
    with_default(
        real_key("DKTH", stress_intensity, at_least(0), "threshold, in KUNIT if it has no unit"),
        "0"),
    with_default(real_key("ALPHA", number, closed_interval(1, 3), "constraint factor of NASGRO"),
                 "2"),
    with_default(
        real_key("SMAX", number, closed_interval(0, 1), "stress over flow stress of NASGRO"),
        "0.3"),
    unit_key("KUNIT", stress_intensity, "unit of K in the law (C, KC, DKTH, table): 'MPa*m^0.5'"),
    unit_key("AUNIT", length, "unit of a in the law (C, table): 'm' or 'mm/cycle'"),
};

// Every law but INCREMENT works on a range of K: from KMIN to KMAX, or those of a spectrum.
constexpr std::array grow_when{
    KeyCondition{"LAW", "INCREMENT", "KMAX",
                 "DA CYCLES C M P Q DKTH ALPHA SMAX KUNIT AUNIT SPECTRUM TOL SFLOW CORRECT AMAX KC "
                 "HISTORY"},
    KeyCondition{"LAW", "PARIS", "C M KUNIT AUNIT", "P Q ALPHA SMAX"},
    KeyCondition{"LAW", "WALKER", "C M P KUNIT AUNIT", "Q ALPHA SMAX"},
    KeyCondition{"LAW", "FORMAN", "C M KC KUNIT AUNIT", "P Q ALPHA SMAX"},
    KeyCondition{"LAW", "NASGRO", "C M KC KUNIT AUNIT", ""},
    KeyCondition{"LAW", "TABLE", "KUNIT AUNIT", "C M P Q ALPHA SMAX"},
    KeyCondition{"SPECTRUM", "", "", "KMAX KMIN"},
    KeyCondition{"HISTORY", "CONTINUE", "", "MOUNTED"},
};

constexpr std::array test_keys{
    required(defining_key("NAME", test, "called by this in results")),
    required(reference_key("CRACK", crack, "that was measured")),
    with_default(
        word_key("METHOD", "SECANT|POLYNOMIAL|E647|SPLINE", "how rates follow from lengths"),
        "POLYNOMIAL"),
    word_key("AXIS", "A|C", "semi-axis of a crack in space that was read; else A"),
    with_default(
        integer_key("POINTS", closed_interval(5, 99), "readings in a parabola, an odd number"),
        "7"),
    text_key("FILE", "lines N a [c] from this file, in place of data lines"),
    text_key("REFERENCE", "lines delta_K da/dN from this file, in place of RATE"),
    real_key("RATIO", number, closed_interval(-100, 0.99),
             "K_min/K_max; else that of KMIN and KMAX of $GROW"),
    unit_key("KUNIT", stress_intensity, "unit of delta_K in RATE and REFERENCE: 'MPa*m^0.5'"),
    unit_key("AUNIT", length, "unit of da in RATE and REFERENCE: 'm' or 'mm/cycle'"),
};

constexpr std::array test_when{
    KeyCondition{"METHOD", "SECANT|SPLINE", "", "POINTS"},
    KeyCondition{"REFERENCE", "", "KUNIT AUNIT", ""},
};

constexpr std::array sweep_keys{
    required(reference_key("PARAMETER", parameter, "the parameter that varies")),
    reference_key("WITH", parameter, "a second parameter that varies with it, in pairs"),
};

constexpr std::array control_keys{
    with_default(integer_key("MAXITER", at_least(1), "most pivots of the contact solution"), "100"),
    with_default(
        with_unavailable_words(
            real_key("TOL", number, open_interval(0, 1), "relative tolerance of contact"), "*"),
        "1e-8"),
    with_default(integer_key("THREADS", at_least(0), "0: one for each core"), "0"),
};

constexpr std::array restart_keys{
    text_key("READ", "go on from the state in this file"),
    integer_key("AT", at_least(0), "last increment to take over; left out: all of the file"),
    text_key("WRITE", "keep the state in this file, in a sweep one for each point"),
    with_default(integer_key("EVERY", at_least(1), "increments between states"), "1"),
};

constexpr std::array restart_when{
    KeyCondition{"AT", "", "READ", ""},
    KeyCondition{"EVERY", "", "WRITE", ""},
};

constexpr std::array output_keys{
    required(text_key("FILE", "name of the file, in the run folder")),
    required(word_key("FORMAT", "VTU|CSV|JSON", "pictures for ParaView, a table, or JSON")),
    with_default(word_key("EVERY", "STEP|INCREMENT|END", "when it is written"), "STEP"),
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
    CardSpec{.name = "STEP",
             .group = "loads",
             .keys = step_keys,
             .data = DataLineForm::rows,
             .data_form = "LOAD case factor, FIT contact factor, MOUNT contact, DISMOUNT contact",
             .doc = "Sets the factors of loads and fits; a factor not named stays as it was."},
    CardSpec{.name = "LOADPATH",
             .group = "loads",
             .keys = load_path_keys,
             .doc = "K and contact for all loads on the line between two steps, exact."},
    CardSpec{.name = "SPECTRUM",
             .group = "loads",
             .keys = spectrum_keys,
             .data = DataLineForm::rows,
             .data_form = "BLOCKS: low high count; SEQUENCE: turning points",
             .doc = "A load history on a load path: the cycles that a crack grows by."},
    CardSpec{.name = "GROW",
             .group = "crack",
             .keys = grow_keys,
             .data = DataLineForm::rows,
             .once = true,
             .data_form = "INCREMENT: crack lengths; TABLE: delta_K da/dN",
             .when = grow_when,
             .doc = "Crack growth: runs the steps for every crack length."},
    CardSpec{.name = "TEST",
             .group = "crack",
             .keys = test_keys,
             .data = DataLineForm::rows,
             .data_form = "N a [c]; or RATE delta_K da/dN",
             .when = test_when,
             .doc = "A crack growth test: measured lengths turned into K, beside the computed K."},
    CardSpec{.name = "SWEEP",
             .group = "requests",
             .keys = sweep_keys,
             .data = DataLineForm::rows,
             .data_required = true,
             .data_form = "values (pairs when WITH is given)",
             .doc = "Runs the deck again for each value; several cards multiply."},
    CardSpec{.name = "CONTROL",
             .group = "requests",
             .keys = control_keys,
             .once = true,
             .doc = "Numerics: contact iterations, threads."},
    CardSpec{.name = "RESTART",
             .group = "requests",
             .keys = restart_keys,
             .once = true,
             .when = restart_when,
             .doc = "Keeps the state of a run, so that a stopped run can continue."},
    CardSpec{.name = "TASK",
             .group = "requests",
             .data = DataLineForm::rows,
             .data_required = true,
             .once = true,
             .data_form = "TOPOLOGY STIFFNESS CONDENSE CONTACT VCE GROW RECOVER OUTPUT",
             .doc =
                 "The stages of the run in order; without this card they follow from the others."},
    CardSpec{.name = "OUTPUT",
             .group = "requests",
             .keys = output_keys,
             .data = DataLineForm::rows,
             .data_required = true,
             .data_form = "U set, S set, CPRESS contact, K crack, REACTION set",
             .doc = "Asks for results in a file of the run folder."},
    CardSpec{.name = "CHECK",
             .group = "requests",
             .data = DataLineForm::rows,
             .data_required = true,
             .data_form = "QUANTITY(arguments) = value REL|ABS tolerance [SOURCE 'text']",
             .doc = "A value the run is compared with; a failure sets the exit code."},
    CardSpec{.name = "END", .group = "deck", .doc = "Last card; a truncated deck is an error."},
};

} // namespace

std::span<const CardSpec> analysis_cards() {
  return cards;
}

} // namespace spricka::grammar
