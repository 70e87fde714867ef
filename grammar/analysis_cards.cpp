// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/card_table.hpp"

#include <array>

namespace spricka::grammar {

namespace {

using namespace table;
using enum Kind;
using enum Quantity;

constexpr std::array load_keys{
    required(defines("CASE", load_case, "the case this adds to")),
    required(word("TYPE", "FORCE|RESULTANT|TRACTION|PRESSURE|BODY|BEARING|DISP|TEMPERATURE|FACES",
                  "what the values are and what they act on")),
    preset(word("SHAPE", "UNIFORM|COSINE", "how the pressure of a BEARING is spread"), "COSINE"),
};

constexpr std::array load_when{
    When{"TYPE", "FORCE", "", "SHAPE"},       When{"TYPE", "RESULTANT", "", "SHAPE"},
    When{"TYPE", "TRACTION", "", "SHAPE"},    When{"TYPE", "PRESSURE", "", "SHAPE"},
    When{"TYPE", "BODY", "", "SHAPE"},        When{"TYPE", "DISP", "", "SHAPE"},
    When{"TYPE", "TEMPERATURE", "", "SHAPE"}, When{"TYPE", "FACES", "", "SHAPE"},
};

constexpr std::array contact_keys{
    required(defines("NAME", contact, "called by this in steps and results")),
    required(refers("SLAVE", set, "one surface; forces are those on it")),
    required(refers("MASTER", surface, "the other surface, or a rigid target")),
    preset(word("TYPE", "UNILATERAL|BONDED", "BONDED: no opening, no slip"), "UNILATERAL"),
    real("INTERFERENCE", length, at_least(0),
         "overlap along the normal (on the radius), used exactly"),
    real("DIAMETRAL", length, anything,
         "overlap on the diameter: twice INTERFERENCE; negative: clearance"),
    real("GAP", length, anything,
         "normal gap, used exactly; 0: a neat fit (zero clearance); negative: overlap"),
    preset(real("MU", number, at_least(0), "coefficient of Coulomb friction"), "0"),
    preset(word("PAIRING", "NODE|SEGMENT", "SEGMENT: any two meshes; NODE: matching nodes"),
           "SEGMENT"),
    preset(word("MULTIPLIER", "NODE|CORNER",
                "between solids: a pressure at each node, or at the corners of elements only "
                "(fewer unknowns, smoother, less sharp at the ends of contact)"),
           "NODE"),
    preset(word("RECOVERY", "LUMPED|CONSISTENT", "how pressure follows from NODE forces"),
           "LUMPED"),
};

constexpr std::array contact_when{
    When{"TYPE", "BONDED", "", "MU"}, // no slip, so nothing to rub
    When{"PAIRING", "NODE", "", "MULTIPLIER"},
};

constexpr std::array rigid_keys{
    required(defines("NAME", rigid, "called by this on $CONTACT")),
    required(word("SHAPE", "LINE|ARC|PLANE|CYLINDER|CONE|SPHERE",
                  "LINE and ARC in 2D, the others in 3D")),
    real("X0", length, anything,
         "first point of a LINE, centre of an ARC or a SPHERE, point of a PLANE or an axis; about "
         "an axis (STATE=AXI) the radius"),
    real("Y0", length, anything, "see X0"),
    real("Z0", length, anything, "see X0"),
    real("X1", length, anything,
         "second point of a LINE, the body is on the left, or of the axis of a CYLINDER or CONE; "
         "the normal of a PLANE runs from the first point to it, towards the body"),
    real("Y1", length, anything, "see X1"),
    real("Z1", length, anything, "see X1"),
    real("R", length, anything,
         "radius of an ARC, CYLINDER or SPHERE, of a CONE at the first point; negative for a bore"),
    real("R1", length, anything, "radius of a CONE at the second point, with the sign of R"),
};

constexpr std::array rigid_when{
    When{"SHAPE", "LINE", "X0 Y0 X1 Y1", "R R1 Z0 Z1"},
    When{"SHAPE", "ARC", "X0 Y0 R", "X1 Y1 Z0 Z1 R1"},
    When{"SHAPE", "PLANE", "X0 Y0 Z0 X1 Y1 Z1", "R R1"},
    When{"SHAPE", "CYLINDER", "X0 Y0 Z0 X1 Y1 Z1 R", "R1"},
    When{"SHAPE", "CONE", "X0 Y0 Z0 X1 Y1 Z1 R R1", ""},
    When{"SHAPE", "SPHERE", "X0 Y0 Z0 R", "X1 Y1 Z1 R1"},
};

constexpr std::array crack_keys{
    required(defines("NAME", crack, "called by this on other cards and in results")),
    refers("PATH", set, "ordered nodes from the mouth on, along element edges"),
    refers("NET", net, "the net a free crack cuts"),
    real("A0", length, above(0), "first length, from the mouth or from the middle"),
    real("ANGLE", angle, between(-6.2832, 6.2832),
         "direction of a free crack of one point, from +x; in radians, or 45[deg]"),
    preset(word("LINE", "STRAIGHT|SMOOTH",
                "how a free crack runs from point to point: straight, or on a smooth curve"),
           "STRAIGHT"),
    refers("FRONT", set, "nodes of the front of a crack in space that the mesh has already"),
    real("A", length, above(0), "semi-axis of an ellipse in space, at right angles to C"),
    real("C", length, above(0), "its other semi-axis; left out: a circle"),
    real("X0", length, anything,
         "centre of an ellipse, in the body, on its surface or beside it; of a front drawn by its "
         "points a point within the crack"),
    real("Y0", length, anything, "see X0"),
    real("Z0", length, anything, "see X0"),
    word("NORMAL", "X|Y|Z",
         "normal of an ellipse's plane; then C lies along Y, Z or X, the next axis"),
    real("X1", length, anything,
         "for any plane: its normal runs from the centre to this point, where the upper face is"),
    real("Y1", length, anything, "see X1"),
    real("Z1", length, anything, "see X1"),
    real("X2", length, anything, "the semi-axis C runs from the centre towards this point"),
    real("Y2", length, anything, "see X2"),
    real("Z2", length, anything, "see X2"),
    preset(word("CLOSED", "YES|NO", "whether the last point of a front joins the first"), "NO"),
    preset(word("STATE", "STRESS|STRAIN|AUTO",
                "plane state that turns G into K; AUTO: the property's"),
           "AUTO"),
    preset(word("FACES", "CONTACT|FREE", "whether the faces may touch"), "CONTACT"),
    preset(real("MU", number, at_least(0), "friction of the faces"), "0"),
};

constexpr std::array crack_when{
    When{"PATH", "", "A0", "ANGLE FRONT NORMAL A X0"},
    When{"FRONT", "", "", "PATH ANGLE A0 A X0"},
    When{"ANGLE", "", "A0", "PATH FRONT A X0"},
    When{"NET", "", "", "PATH FRONT"},
    When{"LINE", "SMOOTH", "", "PATH FRONT ANGLE A"},
    When{"A", "", "X0 Y0 Z0", "PATH FRONT ANGLE A0 CLOSED"},
    When{"C", "", "A", ""},
    When{"NORMAL", "", "A", "X1"},
    When{"X1", "", "Y1 Z1", ""},
    When{"Y1", "", "X1", ""},
    When{"Z1", "", "X1", ""},
    When{"X2", "", "Y2 Z2", ""},
    When{"Y2", "", "X2", ""},
    When{"Z2", "", "X2", ""},
    When{"CLOSED", "YES", "", "X0"},
    When{"FACES", "FREE", "", "MU"},
};

constexpr std::array tipnet_keys{
    required(refers("CRACK", crack, "whose tips")),
    real("RADIUS", length, above(0), "radius of the rings round the tip"),
    real("SIZE", length, above(0), "size of the elements at the tip"),
    preset(integer("RINGS", between(2, 200),
                   "number of element rings round the tip; in space 3 if left out"),
           "5"),
    preset(integer("SECTORS", between(6, 1000),
                   "elements round a full circle; in space 8 if left out"),
           "24"),
    preset(real("FINER", number, between(0.2, 20.0),
                "makes elements this many times smaller than the other keys say; in the plane also "
                "more rings and sectors"),
           "1"),
    preset(word("QUARTER", "YES|NO", "quarter-point tip elements"), "YES"),
    preset(word("JOIN", "CONFORMING|TRANSITION",
                "how the patch joins the mesh of the part: edge to edge, or finer and tied to its "
                "edges"),
           "CONFORMING"),
    preset(word("PATCH", "YES|NO", "NO: the deck's own elements stay"), "YES"),
    preset(word("TUBE", "YES|NO",
                "YES: in space a tube of quarter-point elements along the front; NO: tetrahedra up "
                "to the front, even ones within RADIUS, as where no tube fits"),
           "YES"),
    real("TOL", number, within(0, 1),
         "a part of K: refine until the error bars of K1 and K2 are below TOL*K, of fronts TOL "
         "times the "
         "largest K"),
};

constexpr std::array tipnet_when{
    When{"PATCH", "NO", "", "RADIUS SIZE SECTORS FINER JOIN TUBE"},
    When{"TUBE", "NO", "", "SECTORS JOIN"},
};

constexpr std::array vce_keys{
    required(refers("CRACK", crack, "whose K")),
    real("SHIFT", number, between(1e-12, 1e-1), "finite shift in tip element sizes"),
    of_type(KeyType::integers, "DOMAINS", none, "how many rings move rigidly, a K for each"),
    preset(word("CHECK", "NONE|OPENING", "K from the opening of the faces, printed beside K"),
           "NONE"),
};

constexpr std::array step_keys{
    required(defines("NAME", step, "called by this in results")),
    integer("SUBSTEPS", between(1, 1000000),
            "equal parts a step with friction is run in; left out: as many as its shear needs"),
};

constexpr std::array load_path_keys{
    required(defines("NAME", path, "called by this in results")),
    required(refers("FROM", step, "loads and fits at t = 0: those this step ends with")),
    required(refers("TO", step, "loads and fits at t = 1")),
    preset(real("BEYOND", number, between(1, 1e6), "the last t"), "1"),
};

constexpr std::array spectrum_keys{
    required(defines("NAME", spectrum, "called by this in $GROW")),
    required(refers("PATH", path, "the load path whose t the data lines hold")),
    required(word("TYPE", "BLOCKS|SEQUENCE", "cycles with their counts, or turning points")),
    text("FILE", "turning points or lines from this file, in place of data lines"),
    preset(real("FACTOR", number, above(0), "multiplies every t"), "1"),
};

constexpr std::array grow_keys{
    required(word("LAW", "INCREMENT|PARIS|WALKER|FORMAN|NASGRO|TABLE",
                  "INCREMENT: the crack lengths are given; PARIS: C dK^M; WALKER: C "
                  "(dK/(1-R)^(1-P))^M; FORMAN: C dK^M/((1-R) KC - dK); NASGRO: Forman and Mettu's "
                  "with Newman's crack opening; TABLE: lines delta_K da/dN")),
    preset(word("DIRECTION", "PATH|HOOP|K2ZERO",
                "PATH: along its line or in its plane; HOOP: to the largest hoop stress; K2ZERO: "
                "to where K2 vanishes"),
           "PATH"),
    of_type(KeyType::references, "CRACKS", crack, "the cracks that grow; all when left out"),
    preset(word("SHAPE", "FREE|ELLIPSE",
                "FREE: in space K shapes the front; ELLIPSE: in space the front stays an ellipse"),
           "FREE"),
    refers("KMAX", step, "the step of the largest K"),
    refers("KMIN", step, "the step of the smallest K"),
    refers("SPECTRUM", spectrum, "the load history of one pass, in place of KMAX and KMIN"),
    preset(word("HISTORY", "RESTART|CONTINUE",
                "with friction: CONTINUE carries slip over from length to length"),
           "RESTART"),
    preset(word("MOUNTED", "EACH|FIRST",
                "EACH: every length mounts anew; FIRST: keeps what was mounted at the first"),
           "EACH"),
    real("DA", length, above(0), "largest advance of an increment"),
    real("TOL", number, between(1e-6, 0.1),
         "error of the cycles, as a part of them; 1e-3 when left out, 0.02 in space"),
    real("AMAX", length, above(0), "crack length at which the growth stops"),
    real("CYCLES", number, above(0), "cycles, or passes, at which the growth stops"),
    real("C", number, above(0), "factor of the law, in KUNIT and AUNIT"),
    real("M", number, above(0), "exponent of the law"),
    preset(real("P", number, anything, "exponent of WALKER (gamma) or of NASGRO"), "0"),
    preset(real("Q", number, anything, "exponent of NASGRO"), "0"),
    real("KC", stress_intensity, above(0),
         "fracture toughness, in KUNIT if it has no unit; stops the growth"),
    real("SFLOW", stress, above(0),
         "flow stress: the plastic limit of ligament or section stops the growth"),
    preset(word("CORRECT", "YES|NO", "YES: K with the error bar's bias taken out"), "NO"),
    preset(real("DKTH", stress_intensity, at_least(0), "threshold, in KUNIT if it has no unit"),
           "0"),
    preset(real("ALPHA", number, between(1, 3), "constraint factor of NASGRO"), "2"),
    preset(real("SMAX", number, between(0, 1), "stress over flow stress of NASGRO"), "0.3"),
    unit_name("KUNIT", stress_intensity, "unit of K in the law (C, KC, DKTH, table): 'MPa*m^0.5'"),
    unit_name("AUNIT", length, "unit of a in the law (C, table): 'm' or 'mm/cycle'"),
};

// Every law but INCREMENT works on a range of K: from KMIN to KMAX, or those of a spectrum.
constexpr std::array grow_when{
    When{"LAW", "INCREMENT", "KMAX",
         "DA CYCLES C M P Q DKTH ALPHA SMAX KUNIT AUNIT SPECTRUM TOL SFLOW CORRECT AMAX KC "
         "HISTORY"},
    When{"LAW", "PARIS", "C M KUNIT AUNIT", "P Q ALPHA SMAX"},
    When{"LAW", "WALKER", "C M P KUNIT AUNIT", "Q ALPHA SMAX"},
    When{"LAW", "FORMAN", "C M KC KUNIT AUNIT", "P Q ALPHA SMAX"},
    When{"LAW", "NASGRO", "C M KC KUNIT AUNIT", ""},
    When{"LAW", "TABLE", "KUNIT AUNIT", "C M P Q ALPHA SMAX"},
    When{"SPECTRUM", "", "", "KMAX KMIN"},
    When{"HISTORY", "CONTINUE", "", "MOUNTED"},
};

constexpr std::array test_keys{
    required(defines("NAME", test, "called by this in results")),
    required(refers("CRACK", crack, "that was measured")),
    preset(word("METHOD", "SECANT|POLYNOMIAL|E647|SPLINE", "how rates follow from lengths"),
           "POLYNOMIAL"),
    word("AXIS", "A|C", "semi-axis of a crack in space that was read; else A"),
    preset(integer("POINTS", between(5, 99), "readings in a parabola, an odd number"), "7"),
    text("FILE", "lines N a [c] from this file, in place of data lines"),
    text("REFERENCE", "lines delta_K da/dN from this file, in place of RATE"),
    real("RATIO", number, between(-100, 0.99), "K_min/K_max; else that of KMIN and KMAX of $GROW"),
    unit_name("KUNIT", stress_intensity, "unit of delta_K in RATE and REFERENCE: 'MPa*m^0.5'"),
    unit_name("AUNIT", length, "unit of da in RATE and REFERENCE: 'm' or 'mm/cycle'"),
};

constexpr std::array test_when{
    When{"METHOD", "SECANT", "", "POINTS"},
    When{"METHOD", "SPLINE", "", "POINTS"},
    When{"REFERENCE", "", "KUNIT AUNIT", ""},
};

constexpr std::array sweep_keys{
    required(refers("PARAMETER", parameter, "the parameter that varies")),
    refers("WITH", parameter, "a second parameter that varies with it, in pairs"),
};

constexpr std::array control_keys{
    preset(integer("MAXITER", at_least(1), "most pivots of the contact solution"), "100"),
    preset(later(real("TOL", number, within(0, 1), "relative tolerance of contact"), "*"), "1e-8"),
    preset(integer("THREADS", at_least(0), "0: one for each core"), "0"),
};

constexpr std::array restart_keys{
    text("READ", "go on from the state in this file"),
    integer("AT", at_least(0), "last increment to take over; left out: all of the file"),
    text("WRITE", "keep the state in this file, in a sweep one for each point"),
    preset(integer("EVERY", at_least(1), "increments between states"), "1"),
};

constexpr std::array restart_when{
    When{"AT", "", "READ", ""},
    When{"EVERY", "", "WRITE", ""},
};

constexpr std::array output_keys{
    required(text("FILE", "name of the file, in the run folder")),
    required(word("FORMAT", "VTU|CSV|JSON", "pictures for ParaView, a table, or JSON")),
    preset(word("EVERY", "STEP|INCREMENT|END", "when it is written"), "STEP"),
};

constexpr std::array cards{
    CardSpec{.name = "LOAD",
             .group = "loads",
             .keys = load_keys,
             .data = Data::rows,
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
        .data = Data::rows,
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
             .data = Data::rows,
             .data_form = "LOAD case factor, FIT contact factor, MOUNT contact, DISMOUNT contact",
             .doc = "Sets the factors of loads and fits; a factor not named stays as it was."},
    CardSpec{.name = "LOADPATH",
             .group = "loads",
             .keys = load_path_keys,
             .doc = "K and contact for all loads on the line between two steps, exact."},
    CardSpec{.name = "SPECTRUM",
             .group = "loads",
             .keys = spectrum_keys,
             .data = Data::rows,
             .data_form = "BLOCKS: low high count; SEQUENCE: turning points",
             .doc = "A load history on a load path: the cycles that a crack grows by."},
    CardSpec{.name = "GROW",
             .group = "crack",
             .keys = grow_keys,
             .data = Data::rows,
             .once = true,
             .data_form = "INCREMENT: crack lengths; TABLE: delta_K da/dN",
             .when = grow_when,
             .doc = "Crack growth: runs the steps for every crack length."},
    CardSpec{.name = "TEST",
             .group = "crack",
             .keys = test_keys,
             .data = Data::rows,
             .data_form = "N a [c]; or RATE delta_K da/dN",
             .when = test_when,
             .doc = "A crack growth test: measured lengths turned into K, beside the computed K."},
    CardSpec{.name = "SWEEP",
             .group = "requests",
             .keys = sweep_keys,
             .data = Data::rows,
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
             .data = Data::rows,
             .data_required = true,
             .once = true,
             .data_form = "TOPOLOGY STIFFNESS CONDENSE CONTACT VCE GROW RECOVER OUTPUT",
             .doc =
                 "The stages of the run in order; without this card they follow from the others."},
    CardSpec{.name = "OUTPUT",
             .group = "requests",
             .keys = output_keys,
             .data = Data::rows,
             .data_required = true,
             .data_form = "U set, S set, CPRESS contact, K crack, REACTION set",
             .doc = "Asks for results in a file of the run folder."},
    CardSpec{.name = "CHECK",
             .group = "requests",
             .data = Data::rows,
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
