// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/card_table.hpp"

#include <algorithm>
#include <array>

namespace spricka::grammar {

namespace {

// Examples as a deck would hold them; every one is read and bound by a test.
constexpr std::array texts{
    CardHelpText{
        "DECK",
        "It must stand first. All bare numbers of the deck are in its units: lengths in LENGTH, "
        "forces in FORCE, stresses in FORCE/LENGTH^2 (N and mm give MPa), angles in radians. A "
        "number may carry its own unit, 0.084[mm] or 70[GPa], and is converted. OUTK, OUTLENGTH, "
        "OUTFORCE, OUTSTRESS and OUTLIFE choose what results are written in: listing, report, CSV "
        "files, terminal, shell and the bare numbers of $CHECK. They change nothing of what the "
        "deck says, nor results.h5, which stays in units of the deck.",
        "$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='Lug with one crack'\n"
        "  & OUTK='ksi*sqrt(in)' OUTLENGTH='in' OUTFORCE='kip' OUTSTRESS='ksi' OUTLIFE=KCYCLES\n"},
    CardHelpText{
        "PARAMETER",
        "A parameter stands for its value in every expression below it, and an expression "
        "stands in parentheses: RI=(R). Parameters may use those above them. A name is defined "
        "once; the command line replaces its value with -D R=40 or -D 'F=80[kN]'. A GEO script "
        "of $IMPORT gets the parameters by their names.",
        "$PARAMETER\n"
        "  R     = 36                        ! mm\n"
        "  F     = 97.1[kN]\n"
        "  sigma = F/(101*14)\n"},
    CardHelpText{
        "REQUIRE",
        "For decks whose parameters others change, by hand, with -D or in a sweep. The message "
        "is the text and the values of the parameters in the condition. Nothing else of the deck "
        "is looked at then.",
        "$PARAMETER\n"
        "  bore = 40\n"
        "  pin  = 39.95\n"
        "$REQUIRE\n"
        "  (pin < bore)  'the pin is not thinner than the bore'\n"},
    CardHelpText{
        "INCLUDE",
        "The file holds whole cards and neither $DECK nor $END. Includes may include others, 16 "
        "deep at most.",
        "$INCLUDE FILE='lug_model.inc'\n"},
    CardHelpText{
        "NET",
        "Everything up to $ENDNET belongs to the net. Parts that touch each other should be nets "
        "of their own. Of a net LUG the set BORE is called BORE inside the net and LUG.BORE "
        "outside. The program condenses a net once, and again only when the net itself changes.",
        "$NET NAME=LUG\n"
        "  $MESH SHAPE=LUG TYPE=QUAMC8 RI=36 W=173 L=232.5 NR=8 NT=48\n"
        "$ENDNET\n"},
    CardHelpText{"ENDNET", "",
                 "$NET NAME=PIN\n  $MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=30\n$ENDNET\n"},
    CardHelpText{
        "IMPORT",
        "GEO is a geometry script of gmsh; the library meshes it, and values of its "
        "DefineConstant are replaced by the deck's parameters of the same name, in whatever case. "
        "MSH is a mesh "
        "that gmsh wrote. Physical groups become sets: in 2D surfaces element sets, curves face "
        "sets, points node sets. NASTRAN is bulk data: property 5 is the element set P5. A data "
        "line gives a group or set another name. STEP has solids, which "
        "OpenCASCADE converts to millimetres and the program to the LENGTH of $DECK. One solid "
        "becomes the element set BODY, its faces F1, F2 .., of second-order tetrahedra; several "
        "become NAME with NAME_F1 .. each, bodies of their own even where they touch. SOLID takes "
        "some of them, so that each part can be a net. A data line names faces: by number; by "
        "kind, as CYLINDER 15 (the radius), PLANE -Z (the way it faces), CONE, SPHERE, TORUS, "
        "CURVED; by a condition in x y z rho theta that all points of a face fulfil; or by kind "
        "and condition. A size behind the name holds on these faces, and elements grow away from "
        "them. spricka check prints tables of solids and faces, also of a deck that is refused.",
        "$IMPORT FILE='lug.geo' FORMAT=GEO\n"
        "  inner_edge = BORE\n"
        "$IMPORT FILE='joint.step' SOLID=LUG SIZE=6\n"
        "  CYLINDER 15 = BORE 1.5\n"
        "  PLANE Z (z > 11) = ZMAX\n"
        "  F1 = END\n"},
    CardHelpText{
        "MESH",
        "Every shape makes the element set BODY and sets of its sides: BLOCK makes XMIN XMAX "
        "YMIN YMAX, RING makes INNER and OUTER, LUG makes BORE, HEAD, SIDES and END, PLATE makes "
        "BORE XMIN XMAX YMIN YMAX. With a solid TYPE the shape is swept through the thickness LZ "
        "in NZ layers and has ZMIN and ZMAX as well. A RING with RI=0 is a disc. A LUG whose W is "
        "more than 2 RO is tapered; a straight lug with a square end is a PLATE with its hole "
        "near XMAX. Elements of a PLATE grow from the hole outwards.",
        "$MESH SHAPE=LUG TYPE=HEXEC20 RI=20 RO=45 W=120 L=130 LZ=15 NR=5 NT=40 NZ=3\n"},
    CardHelpText{
        "COOR",
        "One node a line. Node numbers are free and need no order; they count in the net that "
        "the card stands in. With SYSTEM=CYL the columns are r, theta (radians) and z.",
        "$COOR DIM=2 NSET=CORNERS\n"
        "  1   0   0\n"
        "  2  10   0\n"
        "  3  10   5\n"
        "  4   0   5\n"},
    CardHelpText{
        "ELEMENT",
        "One element a line, a leading & continues a long one. Nodes go round against the "
        "clock: corners first, then mid-edge nodes from the edge between the first two corners "
        "on, then the middle (QUAMC9).",
        "$ELEMENT TYPE=QUAM4 ESET=PLATE\n"
        "  1  1 2 3 4\n"},
    CardHelpText{
        "NSET",
        "Items are numbers, ranges first : last : step, and names of sets; -NAME takes a set "
        "away again. WHERE keeps the nodes where its expression in x y z rho theta holds "
        "(comparisons, and, or). Without FROM and items WHERE sees all nodes of the net. ORDER "
        "sorts: a crack path starts at the mouth.",
        "$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)\n"
        "$NSET NAME=RIM\n"
        "  1 : 40 : 2  -LINE\n"},
    CardHelpText{"ESET", "Items as on $NSET; WHERE is asked at the centroid of each element.",
                 "$ESET NAME=HOT FROM=BODY WHERE=(rho < 40)\n"},
    CardHelpText{
        "FSET",
        "Faces are what loads and contacts work on. Where a card wants faces, a node set "
        "stands for the faces whose nodes all lie in the set; so this card is seldom needed.",
        "$FSET NAME=UPPER_BORE FROM=LUG.BORE WHERE=(y > -1e-9)\n"},
    CardHelpText{
        "MATERIAL",
        "ALPHA is what a $LOAD of TYPE=TEMPERATURE expands. No analysis uses RHO, which is only "
        "written out with the mesh; a load of TYPE=BODY gives its force per volume.",
        "$MATERIAL NAME=AL7475 E=69.8[GPa] NU=0.33\n"},
    CardHelpText{
        "PROPERTY",
        "Every element needs exactly one property. STRESS is plane stress, STRAIN plane strain; "
        "forces and energies count for the whole THICK. Without THICK it is 1; that is an error "
        "where another plane property has a THICK, and a warning where loads are total forces. A "
        "warning names bodies that meet in a contact, a tie or an edge and differ in THICK or "
        "STATE.",
        "$PROPERTY ESET=LUG.BODY MATERIAL=AL7475 STATE=STRESS THICK=14\n"},
    CardHelpText{
        "FREEDOM",
        "A freedom is a displacement component of a node. SUPPRESSED freedoms are zero: "
        "supports and symmetry lines. PRESCRIBED freedoms move as $LOAD TYPE=DISP says. "
        "EXTERNAL freedoms are kept when a net is condensed; no result depends on that. All "
        "other freedoms are free. A body that contact holds needs no support.",
        "$FREEDOM CLASS=SUPPRESSED DOF=XY\n"
        "  LUG.END\n"},
    CardHelpText{
        "MPC",
        "TRANSITION ties the SLAVE nodes to the MASTER faces by their shape functions; RIGID "
        "makes the SLAVE nodes one rigid body; EQUATION is a linear equation between "
        "displacement components; the first one follows the others. TRANSITION is exact where "
        "every side of the SLAVE mesh "
        "lies on one MASTER face.",
        "$MPC TYPE=TRANSITION SLAVE=FINE.RIM MASTER=COARSE.RIM\n"},
    CardHelpText{
        "SYMMETRY",
        "The deck has the whole bodies, supports, loads, contacts and cracks. The program "
        "models one side of the plane in their middle and holds the nodes in the plane across "
        "it. Everything in the deck has to be symmetric about the plane (spricka check lists "
        "such planes), and no element may lie across it. Give total loads of the whole model; "
        "forces, energies and areas in the results are those of the modelled side. In a plane "
        "model a crack that is drawn across the plane begins in the plane, and a crack that "
        "is drawn in the plane opens by half. Two cards make a quarter, three an eighth.",
        "$SYMMETRY NORMAL=Y KEEP=ABOVE\n"},
    CardHelpText{
        "LOAD",
        "Several cards with one CASE add up; $STEP applies a case with a factor. FORCE: on each "
        "node of the set. RESULTANT: a total, spread over faces or elements. TRACTION: force "
        "per area, x y z. PRESSURE: normal, positive pushes. FACES: a pressure that opens a crack, "
        "named in the place of a set; C1.LEFT and C1.RIGHT are its two faces, seen from the mouth, "
        "for PRESSURE and TRACTION (at every crack length anew). RESIDUAL: the stress across the "
        "place "
        "of a crack before it was there, tension positive, which opens it as FACES does; over the "
        "section of the body it has neither force nor moment. BODY: force per volume. BEARING: "
        "the pressure of a pin that is not modelled, given by its resultant. DISP: values of "
        "PRESCRIBED freedoms. TEMPERATURE: degrees above the state without stress, of elements "
        "whose "
        "material has ALPHA. In 2D areas count THICK, with STATE=AXI the whole circumference, for "
        "FORCE and RESULTANT as well. Values may be expressions in x y z, with steps and peaks at "
        "any place: they are integrated piece by piece. Lines of DISP for one set add up; sets "
        "that "
        "share a node must agree there, or give it zero.",
        "$LOAD CASE=TENSION TYPE=TRACTION\n"
        "  PLATE.YMAX  0  (100[MPa]*(1 - x/40))\n"
        "$LOAD CASE=PIN TYPE=BEARING SHAPE=COSINE\n"
        "  LUG.BORE  97.1[kN]  0\n"
        "$LOAD CASE=LEAK TYPE=FACES\n"
        "  TOP  5[MPa]\n"},
    CardHelpText{
        "CONTACT",
        "The surfaces cannot overlap and can always separate. There is no penalty and no "
        "contact stiffness to choose. INTERFERENCE counts on the radius, DIAMETRAL on the "
        "diameter (twice as much): a drawing that says 72.084 in 72 means DIAMETRAL=0.084. "
        "The conditions are the same whichever surface is SLAVE; SEGMENT pairs need no "
        "matching nodes. Fits are switched on by FIT and MOUNT of $STEP; a fit that no step "
        "names is always on. With STATE=AXI forces, areas and mean pressures are those of the "
        "whole circumference. Where the contact is pressed up to an edge of one surface, the "
        "pressure has no bound; the listing says so. Between solids NODE is not for "
        "faces of 8 nodes.",
        "$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE DIAMETRAL=0.084\n"
        "$CONTACT NAME=PIN SLAVE=SHAFT.OUTER MASTER=SLEEVE.INNER GAP=0\n"},
    CardHelpText{
        "RIGID",
        "A rigid target has no mesh and does not move: the other body is moved or loaded. Seen "
        "from "
        "the first point of a LINE to the second, the body is on the left; what lies beyond the "
        "ends faces nothing, so that a LINE shorter than the surface is a flat punch with sharp "
        "edges. An ARC is a whole circle: a shaft that bodies lie round, or with negative R a bore "
        "that they lie in. Distances and normals are exact; GAP, INTERFERENCE and DIAMETRAL of "
        "$CONTACT replace the distances. The SLAVE carries the multipliers, PAIRING=NODE takes its "
        "nodes one by one. With STATE=AXI a LINE is a cylinder, a cone or a plane, an ARC a sphere "
        "or a torus. In 3D a PLANE, CYLINDER, CONE or SPHERE has no ends; with negative R (of a "
        "CONE "
        "both) it is a bore or a socket. The listing's force balance shows the reaction that holds "
        "the target.",
        "$RIGID NAME=FLOOR SHAPE=LINE X0=-50 Y0=0 X1=50 Y1=0\n"
        "$RIGID NAME=PIN SHAPE=ARC X0=0 Y0=0 R=20\n"
        "$CONTACT NAME=FOOT SLAVE=PLATE.YMIN MASTER=FLOOR\n"
        "$RIGID NAME=TABLE SHAPE=PLANE X0=0 Y0=0 Z0=-5 X1=0 Y1=0 Z1=-4\n"
        "$RIGID NAME=BOLT SHAPE=CYLINDER X0=0 Y0=0 Z0=0 X1=0 Y1=0 Z1=1 R=8\n"},
    CardHelpText{
        "CRACK",
        "A free crack is a point on the boundary of NET, its direction ANGLE and its length A0, "
        "or a line through several points; the program cuts it into the mesh. If the first point "
        "lies inside the body both ends are tips, NAME.1 at the first point and NAME.2 at the "
        "last, and the crack's length a is half of the line's. LINE=SMOOTH draws a spline through "
        "the points (straight lines between points of an arc would disturb K at each kink). "
        "A crack with PATH follows element edges; on a symmetry line the nodes behind the tip "
        "are released and K counts both halves. Two sides of a bore are two cards. With "
        "FACES=CONTACT the faces of a crack touch where they would overlap, slip with MU against "
        "friction and part again; K1 is 0 at a tip where they touch. Faces that touch are a "
        "contact NAME.FACES in the listing, in CPRESS and in $CHECK; places on it are lengths "
        "along the crack from its mouth or first point. FACES=FREE lets them overlap and says so. "
        "In space a flaw can be told by words: AT names two faces of NET for a corner flaw in the "
        "edge where they meet, or one face for a surface flaw, with DEPTH and LENGTH; ANGLE about "
        "the axis of a round face or edge, or any of X0 Y0 Z0, say where. It is normal to the edge "
        "or face; ALONG turns the mouth of a surface flaw. "
        "A crack is plane: an ellipse, given by its centre and its semi-axes A and C "
        "(without C a circle), or the area inside a front, given by points that a smooth curve "
        "joins. Only what lies inside the body is cut: with the centre inside the body the crack "
        "is embedded, on a face it is a surface crack, on an edge a corner crack. An open front "
        "starts and ends on the "
        "surface or outside, X0 Y0 Z0 is a point within the crack. K belongs to the points along "
        "the front; its angle phi counts from the axis C towards A, which is normal x C. The face "
        "that the normal points away from is NAME.RIGHT, the other one NAME.LEFT. With STATE=AXI a "
        "crack is a ring, a cone or, from a point on the axis, a penny; K is that of a unit of its "
        "front.",
        "$CRACK NAME=TOP NET=LUG A0=1.8 ANGLE=90[deg]\n"
        "  0  36\n"
        "$CRACK NAME=CORNER NET=LUG A=3.6 X0=20 Y0=0 Z0=0 NORMAL=Y\n"
        "$CRACK NAME=FLAW NET=LUG AT=BORE,ZMAX DEPTH=1.27 ANGLE=90[deg]\n"},
    CardHelpText{
        "TIPNET",
        "The patch is the new mesh round a tip: rings of quarter-point elements (the "
        "rosette), and a graded mesh that joins them to the net. It moves with the tip. "
        "Without this card the sizes follow from the crack's length and from what is near "
        "(boundaries, contact surfaces, other cracks); the listing names them. In the plane the "
        "tip mesh follows a net that is finer than it, as if FINER were so large; not where "
        "SIZE, RINGS, SECTORS or TOL is given. Smaller SIZE: finer. JOIN=TRANSITION divides the "
        "patch's rim into finer edges "
        "that follow those of the net: for nets that are coarse round the crack.",
        "$TIPNET CRACK=TOP RADIUS=0.5 SIZE=0.02 RINGS=6\n"},
    CardHelpText{
        "VCE",
        "K comes from the derivative of the energy for a virtual motion of the tip. Each number "
        "of DOMAINS is a count of rings that move rigidly; the spread of K between them checks "
        "the method (not the mesh). CHECK=OPENING prints K1 and K2 of the opening behind the tip "
        "beside them, a coarser value by another way; nothing uses it.",
        "$VCE CRACK=TOP DOMAINS=2,3,4\n"},
    CardHelpText{
        "STEP",
        "LOAD case factor sets a case's factor, FIT contact factor that of a fit. MOUNT puts a "
        "contact in: until then it is absent, and its gap or interference counts from the "
        "deformed bodies as they are at that moment (mounting without force); DISMOUNT takes it "
        "out "
        "again. Steps run in deck order, as in the workshop: press, mount, load, unload.",
        "$STEP NAME=PRESS\n"
        "  FIT BUSH 1\n"
        "$STEP NAME=ASSEMBLE\n"
        "  MOUNT PIN\n"
        "$STEP NAME=LOAD\n"
        "  LOAD SHAFTLOAD 1\n"
        "$STEP NAME=UNLOAD\n"
        "  LOAD SHAFTLOAD 0\n"},
    CardHelpText{
        "LOADPATH",
        "Loads and fits run from those of step FROM to those of step TO and on in a straight "
        "line, (1-t) FROM + t TO. Without friction K is piecewise linear in t: every "
        "breakpoint, where a pair opens or closes, is found. With friction the card only defines "
        "what the t of a spectrum mean. Nothing may be mounted or dismounted between the "
        "two steps.",
        "$LOADPATH NAME=UP FROM=PRESS TO=LOAD BEYOND=1.5\n"},
    CardHelpText{
        "SPECTRUM",
        "Loads lie on a load path: as places t (0 at its step FROM, 1 at TO), or as loads of which "
        "AT0 and AT1 say what these steps stand for. BLOCKS: each line is a number of cycles "
        "between two loads, or has the columns that ORDER names; SEQUENCE: turning points in their "
        "order, counted as COUNT says (RAINFLOW: ASTM E1049). TWIST: the published table of a "
        "transport wing's flights and gusts, in an order of this program's own. One pass through "
        "all of them is the unit of life; UNIT tells lives in flights, hours or cycles, too. "
        "Beyond both ends of the load path there is no K: its BEYOND must reach the largest "
        "load. With friction turning points are solved in their order, at most 2000.",
        "$SPECTRUM NAME=FLIGHT PATH=UP TYPE=BLOCKS ORDER=MAX,MIN,COUNT AT0=0 AT1=120[MPa] "
        "FLIGHTS=100\n"
        "  120  12   20\n"
        "  84  36  5000\n"},
    CardHelpText{
        "INTERACTION",
        "Behind a cycle with a large plastic zone the next ones grow less, until they leave that "
        "zone. The zone alone decides how long that lasts: its factor (ZONE or KAPPA) and YIELD "
        "have no defaults, and are printed with the life. The cycles are followed one by one in "
        "the order of the spectrum, over K of every load at every length. Several models beside "
        "one another cost no solution more: $GROW INTERACTION=W1,NONE. Those that act by R alone "
        "(WILLENBORG, MODIFIED) need a law that knows R; CHANG takes WALKER without a threshold, "
        "CLOSURE takes PARIS, whose C and M are those of the effective range.",
        "$INTERACTION NAME=W1 TYPE=WHEELER W=1.43 ZONE=IRWIN2 YIELD=365\n"
        "$INTERACTION NAME=GW TYPE=WILLENBORG SOLR=3 MINIMUM=KEEP ZONE=IRWIN2 YIELD=365\n"},
    CardHelpText{
        "GROW",
        "All steps are run for every crack length. With LAW=INCREMENT the data lines are the "
        "lengths; in space semi-axes A of ellipses, C in its ratio to A. KMAX and KMIN name the "
        "steps whose K is the largest and the smallest of a "
        "load cycle. By a law the program chooses the lengths itself, so that the cycles are "
        "right to TOL, and ends at AMAX, CYCLES, KC, the ligament's plastic limit (SFLOW), an "
        "edge, another crack, or where nothing grows any more. With friction the loads are "
        "followed one after another until K repeats itself, each length from the beginning "
        "(HISTORY=RESTART) or from what slipped at the one before (CONTINUE). Constants of a law "
        "are "
        "in KUNIT and AUNIT, which every law needs; KC, K1C, KIE, DKTH, DK0 and DK1 may have a "
        "unit "
        "of their own, and AINTRINSIC, THICK and YIELD are in units of the deck. DK0 or DK1 with "
        "CTHP and CTHM make a threshold over R, DKTH is one for all R. MATERIAL takes law and "
        "constants of a $LAW, with THICK the toughness of that thickness; spricka help materials "
        "lists those that ship.",
        "$GROW LAW=PARIS KMAX=LOAD KMIN=UNLOAD C=1e-11 M=3 KUNIT='MPa*m^0.5' AUNIT='m' AMAX=30\n"},
    CardHelpText{
        "LAW",
        "$GROW MATERIAL=NAME uses it. It has the constants of $GROW and what is known of the tests "
        "that they were fitted to; what is left out is not stated. K1C with AK, BK and YIELD gives "
        "the toughness of the THICK of $GROW, else of its own. With TYPE=TABLE a line RATIO names "
        "the R of the columns, then lines have da/dN and the delta K of each column (K_max - K_min "
        "for R < 0). Between columns delta K follows Walker's exponent of the two columns around R "
        "at the same rate, beyond them that of the nearest two. Laws of a file materials.deck "
        "beside the deck, which has $DECK and $END, need not be included.",
        "$LAW NAME=AL2024 TYPE=TABLE KUNIT='MPa*m^0.5' AUNIT='mm' SOURCE='our tests' FORM='sheet' "
        "RMAX=0.5\n"
        "  RATIO  0   0.5\n"
        "  1e-7   3.3  2.1\n"
        "  1e-5   8.1  5.6\n"
        "  1e-3   29   18.2\n"},
    CardHelpText{
        "TEST",
        "Data lines N a are readings of a crack growth test: cycles and length, as $CRACK counts "
        "it; in space N a c, both semi-axes, or the one of AXIS alone; AXIS says which one is "
        "compared. At the same range of K the part and a reference grow at the same rate da/dN, so "
        "that the measured rate gives K of the part. The reference is the law of $GROW, or rates "
        "of a specimen: lines RATE delta_K "
        "da/dN, straight in the logarithms in between. K_min/K_max of each length comes from the "
        "steps KMIN and KMAX of $GROW. Results are in test.csv with the scatter band; manual, "
        "inversion.md.",
        "$TEST NAME=LUG1 CRACK=C1 METHOD=POLYNOMIAL KUNIT='MPa*mm^0.5' AUNIT='mm'\n"
        "  0      3.21\n"
        "  500    3.35\n"
        "  1000   3.52\n"
        "  1500   3.71\n"
        "  2000   3.88\n"
        "  2500   4.11\n"
        "  3000   4.30\n"
        "  RATE  100  4.7e-6\n"
        "  RATE  900  3.4e-3\n"},
    CardHelpText{"SWEEP", "",
                 "$PARAMETER\n"
                 "  fit = 0.084\n"
                 "$SWEEP PARAMETER=fit\n"
                 "  0  0.042  0.084\n"},
    CardHelpText{
        "CONTROL",
        "Seldom needed. THREADS never changes a result; the command line's --threads goes first. "
        "ENGINE changes the last digits at most; --engine goes first, and the page of the manual "
        "on engines says what each is for. "
        "SHOW changes no result: it names the step whose state the report opens with and "
        "whose stresses are kept where no $OUTPUT asks for more.",
        "$CONTROL SHOW=UNLOAD\n"},
    CardHelpText{
        "RESTART",
        "The state is kept after every crack length. spricka run DECK --restart continues a "
        "stopped run and gives the same results to the last bit. Files lie relative to the deck. A "
        "state fits a deck whose cards are the same but for $OUTPUT, $CHECK, $CONTROL, $TASK, "
        "lengths of $GROW and steps taken away at the end.",
        "$RESTART WRITE='lug.rst'\n"},
    CardHelpText{
        "TASK",
        "Its names and their order are checked; in this version the chain always follows from "
        "the cards.",
        "$TASK\n"
        "  TOPOLOGY STIFFNESS CONDENSE CONTACT VCE RECOVER OUTPUT\n"},
    CardHelpText{
        "OUTPUT",
        "Each line asks for one result: U displacements, S stresses, REACTION forces of the "
        "supports, each of a set; CPRESS of a contact, K of a crack. k.csv, pressure.csv, "
        "listing and report are written without asking.",
        "$OUTPUT FILE='head.csv' FORMAT=CSV EVERY=STEP\n"
        "  U LUG.HEAD\n"
        "  K TOP\n"},
    CardHelpText{
        "CHECK",
        "REL counts the tolerance from the value, ABS is in the value's own unit. A bare number is "
        "in the unit of output, if $DECK chooses one (OUTK and its like), an expression in the "
        "deck's units. SOURCE says "
        "where the value comes from; 'RECORDED' is for numbers that only the program itself "
        "gave. A run with a failed check ends with exit code 1. `spricka help quantities` "
        "lists what can be asked for.",
        "$CHECK\n"
        "  K(TOP,LOAD,10.8) = 707.5  REL 0.001  SOURCE 'two independent solvers'\n"
        "  SUM(BUSH,LOAD,X) = 97.1[kN]  REL 1e-6  SOURCE 'equilibrium'\n"},
    CardHelpText{"END", "Nothing but blank lines and comments may follow.", "$END\n"},
};

} // namespace

const CardHelpText* find_card_help(std::string_view card) {
  const auto* const it = std::find_if(texts.begin(), texts.end(),
                                      [&](const CardHelpText& t) { return t.card == card; });
  return it == texts.end() ? nullptr : it;
}

} // namespace spricka::grammar
