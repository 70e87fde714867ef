// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/code_texts.hpp"

#include <algorithm>

namespace spricka::program {

namespace {

// Same form as the codes, with the remedy in place of the meaning.
constexpr std::array advice{
    CodeMeaning{"E101",
                "Look at the token under the carets and at what stands before it: a missing "
                "value, bracket or quotation mark. A header goes on in the next line only if "
                "that starts with &."},
    CodeMeaning{"E102",
                "A comment starts with !. Data lines stand below the header of their card."},
    CodeMeaning{"E103",
                "Numbers have a point, not a comma, and e for the exponent (1e-3, not 1d-3). "
                "A range is first : last : step."},
    CodeMeaning{"E104", "Cards are never abbreviated. spricka help lists them."},
    CodeMeaning{"E105", "spricka help CARD lists the keys of a card."},
    CodeMeaning{"E106", "spricka help CARD says which keys are required, and which only together."},
    CodeMeaning{"E107", "Take one of them away; the order of keys is free."},
    CodeMeaning{"E108", "Words are those of spricka help CARD. The value of a parameter is written "
                        "in brackets, THICK=(h); a text in quotes, FILE='lug.geo'."},
    CodeMeaning{"E109", "spricka help CARD gives the range. Is the unit the one you mean?"},
    CodeMeaning{"E110", "spricka help CARD says which keys go together. INTERFERENCE counts on the "
                        "radius, DIAMETRAL on the diameter: give one."},
    CodeMeaning{"E111", "Start the deck with $DECK VERSION=1 LENGTH=MM FORCE=N; only comments may "
                        "stand before it. A file for $INCLUDE is not run by itself."},
    CodeMeaning{"E112", "Write $END as the last line of the deck's own file. It shows that nothing "
                        "was lost."},
    CodeMeaning{"E113",
                "Paths count from the file that holds the $INCLUDE. Only plain files are read, "
                "no pipes or devices: 1000 at most, 16 deep, 1 GiB together."},
    CodeMeaning{"E114", "Each $NET is closed by $ENDNET before the next one opens."},
    CodeMeaning{"E115", "spricka help CARD shows the form of a data line and an example."},
    CodeMeaning{"E117", "Names have letters A to Z, digits and _, and start with a letter."},
    CodeMeaning{"E118", "Move $END to the end, or take away what is behind it."},
    CodeMeaning{"E120", "Elements take as many nodes as their type has; continue a line with a "
                        "leading &."},
    CodeMeaning{"E121", "One node or element a line. $COOR with DIM=2 has no z."},
    CodeMeaning{"E122", "Save the file as plain text in UTF-8."},
    CodeMeaning{"E123", "The deck's author asks for this. Change the parameters that the message "
                        "names; nothing else of the deck was looked at."},
    CodeMeaning{"E201", "Parameters are defined above their use, or by -D NAME=value."},
    CodeMeaning{"E202", "spricka help functions lists them."},
    CodeMeaning{"E203", "spricka help functions shows how each is written."},
    CodeMeaning{"E204", "spricka help units lists them. Case counts: MPa, mm, kN."},
    CodeMeaning{"E205", "spricka help CARD names the dimension of each key."},
    CodeMeaning{"E206", "A division by zero, a root of a negative number or an overflow."},
    CodeMeaning{"E207",
                "One deck defines a parameter once; to try another value use -D NAME=value."},
    CodeMeaning{"E208", "Functions, pi, x, y, z, rho, theta, and, or are taken."},
    CodeMeaning{"E209", "The place has a value only in WHERE, ORDER and the values of $LOAD."},
    CodeMeaning{"E210", "Write -D NAME=expression, in quotes if it holds brackets: -D 'F=80[kN]'."},
    CodeMeaning{"E301",
                "Mend the name, or define it by its card: $NSET, $FSET, $MATERIAL, $CONTACT .. "
                "Outside its net a set is called NET.SET. spricka check lists the sets."},
    CodeMeaning{"E308",
                "Paths count from the file that holds the card. Only plain files are read, no "
                "pipes or devices: 256 MiB at most of numbers, 4 GiB of a mesh."},
    CodeMeaning{"E302", "Names of one kind differ; sets of different nets may be alike."},
    CodeMeaning{"E305", "Give every element set a $PROPERTY."},
    CodeMeaning{"E307", "Number the nodes against the clock, corners first, then mid-edge nodes."},
    CodeMeaning{"E309", "Does WHERE compare with = where rounding needs abs(x-1) < 1e-9? Are the "
                        "lengths in the deck's units?"},
    CodeMeaning{"E311",
                "A face is taken when all of its nodes are in the set, mid-edge nodes too."},
    CodeMeaning{"E314", "spricka help quantities lists them."},
    CodeMeaning{"E315", "spricka help quantities shows the arguments of each."},
    CodeMeaning{"E317", "PATH is a node set with ORDER, from the mouth on."},
    CodeMeaning{"E319", "$FREEDOM CLASS=PRESCRIBED names the freedoms that $LOAD TYPE=DISP moves."},
    CodeMeaning{"E320",
                "A step says how it ends: one LOAD for a case, one FIT or MOUNT for a contact."},
    CodeMeaning{"E321",
                "Look at the numbers of elements, NX NY NZ or NR NT, for a digit too many."},
    CodeMeaning{"E322",
                "Choose another FILE: k_set.csv, not k.csv. It counts without its folders, as "
                "all files lie in the run folder, and each $OUTPUT has its own."},
    CodeMeaning{"E323",
                "Take two different steps with no MOUNT or DISMOUNT between them: it changes "
                "where gaps count from. Paths before and behind it are two cards."},
    CodeMeaning{"E324",
                "With friction K depends on the order of loads: run steps with SUBSTEPS. Only "
                "the path of the spectrum of $GROW may be there: its loads are followed."},
    CodeMeaning{"E327",
                "With friction each turning point is a solution: take TYPE=BLOCKS, or leave "
                "out ranges below the threshold."},
    CodeMeaning{"E326",
                "A test needs readings N a, a reference of rates (the law of $GROW, or lines "
                "RATE), and $GROW with the crack lengths and steps to compare with."},
    CodeMeaning{"E328",
                "spricka check prints what the body has of a flaw. AT=BORE,ZMAX is the edge "
                "where two faces of NET meet, AT=BORE one face; ANGLE counts about its axis."},
    CodeMeaning{"E341",
                "manual/interaction.md has what each TYPE of $INTERACTION needs of the law."},
    CodeMeaning{"E331", "The words are gmsh's. Try the file in gmsh itself."},
    CodeMeaning{"E332",
                "Give curves and surfaces their names with Physical in the .geo file; of a STEP "
                "file spricka check prints tables of solids and faces."},
    CodeMeaning{"E336",
                "Supports, loads, steps and contact belong into the deck: take them out of the "
                "file, or pass over them with $IMPORT SKIP=LOADS or SKIP=ALL."},
    CodeMeaning{"E325",
                "All t of a spectrum lie between 0 and BEYOND of its load path: let the path "
                "begin at the smallest load and go on to the largest."},
    CodeMeaning{"E390", "Leave -D out, or the $SWEEP card."},
    CodeMeaning{"E401",
                "A free crack needs two points, or one with ANGLE and A0; a path two nodes."},
    CodeMeaning{"E402", "Give A0, points or the lengths of $GROW."},
    CodeMeaning{"E405", "A $STEP applies loads and fits: $STEP NAME=LOAD, below it LOAD case 1."},
    CodeMeaning{"E411", "Are the sets those of the right bodies and sides? SLAVE and MASTER look "
                        "along their outward normals."},
    CodeMeaning{"E412", "Give a smaller RADIUS on $TIPNET, or other DOMAINS on $VCE."},
    CodeMeaning{"E413", "A bearing load needs faces of a bore on the side it pushes to."},
    CodeMeaning{"E414", "Keep the crack's patch away from the node: a smaller RADIUS on $TIPNET."},
    CodeMeaning{"E415", "SLAVE is the finer side; MASTER the faces of the coarser one that it lies "
                        "on, within a tenth of a face."},
    CodeMeaning{"E416", "Ties say more than once, and differently, where a freedom goes: leave one "
                        "out, or let a support or prescribed value follow the tie."},
    CodeMeaning{"E418",
                "Each node of the set carries the force of its line. Tie a loose node by $MPC; "
                "near a crack use TRACTION or RESULTANT on a face set."},
    CodeMeaning{"E421", "The first point of a free crack lies on the boundary of its net; the "
                        "message names the nearest one."},
    CodeMeaning{"E423",
                "RADIUS of $TIPNET must be smaller than the room named, SIZE smaller than "
                "RADIUS. Where the net section is lost, take a shorter A0; a body cut through is "
                "two nets. Along a line of symmetry a crack is a PATH whose nodes are all "
                "suppressed across it. In space a front keeps off the surface, its edges and other "
                "cracks, or ends on the surface at 25 degrees or more: the message names where it "
                "does not; a smaller RADIUS makes the tube round it narrower."},
    CodeMeaning{"E424", "Give a smaller RADIUS on $TIPNET, or move the crack. In space the whole "
                        "front lies in elements of one $PROPERTY."},
    CodeMeaning{
        "E425",
        "Move the crack or change its size: the message names where it leaves the "
        "body, touches the surface along it, or has a hole of the body within. Where its front "
        "lies in two bodies of one net give each body a net of its own."},
    CodeMeaning{"E426", "Use TRIMC6, QUAMC8 or QUAMC9, or TYPE=QUADRATIC on $IMPORT."},
    CodeMeaning{"E428", "Refine the net there, or give a smaller RADIUS on $TIPNET."},
    CodeMeaning{"E429",
                "Refine the net near the crack or give RADIUS and SIZE on $TIPNET. In space "
                "the message names the place: an edge of the body nearer than the tube is "
                "wide wants a smaller RADIUS, folded elements on a curved surface want a "
                "finer net there."},
    CodeMeaning{"E430",
                "End a crack before it meets another, and bend it by less than 165 degrees."},
    CodeMeaning{"E431", "Give an AMAX that is longer than the crack is at first; leave PATCH=NO to "
                        "LAW=INCREMENT with lengths that end at nodes."},
    CodeMeaning{"E432",
                "THICK is 1 where it is left out: give it to all plane properties, or to none "
                "where forces are meant per unit of thickness."},
    CodeMeaning{"E433",
                "Lines of TYPE=DISP for one set add up. Different sets that share a node, a "
                "corner, must give it the same value, or one of them zero."},
    CodeMeaning{"E434", "Look at the expression where the body is: a division by zero, a root of a "
                        "negative number, a value beyond 1e308."},
    CodeMeaning{"E435",
                "Keep the crack's patch away from the rim of the load's set: a smaller RADIUS "
                "on $TIPNET, or a set whose rim is straight."},
    CodeMeaning{"W423",
                "K1 along such a front scatters by 2 to 4 % from point to point, its smooth "
                "curve ($CHECK at an angle or a place) by 1.3 to 2.6 %; fronts with tubes "
                "are within 0.5 %. A front that leaves the body at 25 degrees or more and "
                "keeps off its edges has a tube."},
    CodeMeaning{"W426", "Make the mesh of quadratic elements: K is much better for the same time."},
    CodeMeaning{"W425",
                "Let borders of what is held, loaded or in contact keep off the ends of the "
                "crack's front, or give a smaller RADIUS on $TIPNET. Sets "
                "that nothing uses are not told of."},
    CodeMeaning{"W432", "Give THICK, or THICK=1 where forces are meant per unit of thickness."},
    CodeMeaning{"W433", "A plane model spreads contact forces and stresses evenly through each "
                        "thickness: meant only where the bodies share their middle plane."},
    CodeMeaning{"W434", "Give bodies that meet one STATE, unless a thick one holds a thin one."},
    CodeMeaning{"W435", "Refine the net where the load changes, or write it with fewer poles and "
                        "waves: what may be missed is said in parts of its total. Told from 0.05 % "
                        "on; spots of a twentieth of an element may not be seen."},
    CodeMeaning{"W436",
                "Refine the net along the set, with nodes at kinks and steps: the bars of K "
                "do not hold what is lost between them."},
    CodeMeaning{"E437",
                "A crack gives the node at its mouth two, one for each face. Hold, tie or load "
                "an edge that ends there, or move the crack or the node a little."},
    CodeMeaning{"E438", "Of a half model the body has one face of the crack: load that one."},
    CodeMeaning{"E439",
                "FRONT names nodes of a crack that the mesh has already: its faces are sides of "
                "elements that lie on one another, each with nodes of its own at the same places; "
                "nodes of the front are common to both. To have a crack cut into the mesh draw it: "
                "A, X0, Y0, Z0 or its points."},
    CodeMeaning{"E464",
                "Name another folder with --out, or take away what is in the way yourself: only "
                "folders with the mark .spricka are replaced, and of them only the files that "
                "the mark names. Exit code 7."},
    CodeMeaning{"E465",
                "Wait for that run, or give --out. The message names process and host. Exit "
                "code 7."},
    CodeMeaning{"E466", "Fewer or coarser elements, fewer --threads, a higher ulimit -v or another "
                        "machine. spricka check foretells what a deck needs. Exit code 4."},
    CodeMeaning{"E467", "The folder is as it was: its listing says when and of which deck it is."},
    CodeMeaning{"E468", "Is the disk full, or the reader of a pipe gone? The run folder itself is "
                        "whole: exit code 7."},
    CodeMeaning{"E469", "Let $RESTART WRITE name a file beside the run folder. Exit code 7."},
    CodeMeaning{"W464",
                "A bare number counts in the units of $DECK: write 80[kN], not 80, where the "
                "deck writes a unit."},
    CodeMeaning{"W465",
                "LENGTH=IN goes with FORCE=LBF (psi), LENGTH=MM with FORCE=N (MPa), LENGTH=M "
                "with FORCE=N (Pa)."},
    CodeMeaning{
        "W466",
        "gmsh writes curves as bars, surfaces of solids as plane elements: nothing is lost. Give "
        "them no section; bars and skins that carry load cannot be imported. A thin shell on a "
        "solid has next to no stiffness; a thick one is better meshed as solids."},
    CodeMeaning{"W467", "Say in the deck how the model is held and loaded."},
    CodeMeaning{"W468", "Say in the deck how bodies touch and hang together: $CONTACT, with "
                        "TYPE=BONDED for a tie. spricka convert FILE.inp NEW.deck begins such a "
                        "deck."},
    CodeMeaning{"W469", "Mend the file if it is meant otherwise, or give $MATERIAL and $PROPERTY."},
    CodeMeaning{"E452", "Add $CRACK, or take $GROW away."},
    CodeMeaning{"E453", "KMAX names the step with the largest K of a cycle, KMIN that with the "
                        "smallest: exchange them, or look at the sign of the load."},
    CodeMeaning{"E454",
                "Toughness and threshold without a unit are in KUNIT: give both their units, "
                "35[MPa*m^0.5], or look at KUNIT."},
    CodeMeaning{"W452", "Apply it in a step, LOAD case 1, or take the $LOAD away."},
    CodeMeaning{"W453",
                "A step keeps what it does not name. Give it what it should do; a FIT scales "
                "what the contact declares, so that with GAP=0 it has nothing to scale."},
    CodeMeaning{"W454", "Lengths of $GROW take the place of A0."},
    CodeMeaning{"W455", "manual/theory/life.md has the laws with their exponents; other books name "
                        "them otherwise."},
    CodeMeaning{"W456",
                "The message says what: K that the law was not made for, a life of next to no "
                "cycles, an end that is none. KUNIT and AUNIT are the first things to look "
                "at."},
    CodeMeaning{"E480",
                "A deck may come from anyone, so its scripts draw and mesh, no more. Write what "
                "is included into the script itself; or mesh it by hand and import the .msh."},
    CodeMeaning{"E481", "Is a size or a number of the script far off? Else --mesh-time allows more "
                        "seconds of processor time."},
    CodeMeaning{"E482",
                "Is a size or a number of the script far off? Else --mesh-memory allows more."},
    CodeMeaning{"E483",
                "The message has gmsh's last words. Is the geometry sound for all values of "
                "its constants: no circle without radius, no division into nothing?"},
    CodeMeaning{"E484", "seccomp filters are a part of the Linux kernel that a container may have "
                        "switched off. Decks without scripts, .msh and STEP files need none."},
    CodeMeaning{"E485",
                "Write the parameter as the constant that is meant, with the same letters."},
    CodeMeaning{"E486",
                "Names match whatever the case of letters; the listing and spricka check show "
                "what each constant got."},
    CodeMeaning{"W482", "Nothing is lost: the mesh goes from gmsh straight into the model."},
    CodeMeaning{"W483", "Parts that are missing in the table of solids stand in those files."},
    CodeMeaning{"W484",
                "Solids that are not to be one body are nets of their own, each by an $IMPORT with "
                "its SOLID, and meet in a $CONTACT."},
    CodeMeaning{"W480", "Take it away, or is it a misspelt constant of a script?"},
    CodeMeaning{"W481",
                "In a script DefineConstant[ R = 36 ]; takes the deck's R, R = 36; does not."},
    CodeMeaning{"E500", "The deck is right, but there is no analysis for this yet: exit code 4."},
    CodeMeaning{"E510",
                "The message names the body and the direction that nothing holds, or the "
                "crack that cannot be placed. Add a support or a contact; a body that slides needs "
                "more friction, more pressure or less load: exit code 4."},
    CodeMeaning{"E520",
                "With friction: more SUBSTEPS, or a smaller MU, as with much of it there may be no "
                "solution. Without: please report it, with the deck. Exit code 5."},
    CodeMeaning{"E530",
                "Is the path right, may you read and write there, is the disk full? A folder "
                "that is no run folder is never overwritten. spricka-mesher is installed "
                "with spricka and needs a process and some files (ulimit -u, -n): exit "
                "code 7."},
    CodeMeaning{"E540", "Write .msh or .vtu for the mesh alone: exit code 4."},
    CodeMeaning{"W307", "The element's stiffness is sound, as the Jacobian is positive where it is "
                        "integrated; but some places in that corner belong to it twice."},
    CodeMeaning{"W336",
                "Refine where bending or near incompressibility made you choose the special "
                "form."},
    CodeMeaning{"W341",
                "Bodies that share no node are separate: merge the nodes where the mesh is made, "
                "or tie or pair the sides."},
    CodeMeaning{"W342", "Angles without a unit are radians; write 45[deg]."},
    CodeMeaning{"W344", "STATE of $CRACK only says how K follows from G; without it that is the "
                        "elements' own."},
    CodeMeaning{"W345",
                "Two tips so near the surface hardly are what was drawn. Put the first point "
                "on the surface or outside by less than a thousandth of an element side."},
    CodeMeaning{"E351",
                "Contacts that are mounted one after the other may share faces: DISMOUNT one "
                "in the step that says MOUNT for the other."},
    CodeMeaning{"E352", "Tied surfaces cannot part: take the $CONTACT away, or the $MPC."},
    CodeMeaning{"E354",
                "Supports, loads, contacts and cracks have to be mirrored by the plane, and the "
                "mesh a line in it: divide bodies there. Else leave $SYMMETRY out and model the "
                "whole."},
    CodeMeaning{"E353",
                "Each $SWEEP multiplies the points of the others; WITH varies two parameters "
                "together."},
    CodeMeaning{"W351", "Load the pin where there is one; BEARING, PRESSURE and TRACTION stand for "
                        "bodies that are not modelled."},
    CodeMeaning{"W352",
                "A line `SET 0 0` below $LOAD TYPE=DISP says that 0 is meant; a support has "
                "CLASS=SUPPRESSED."},
    CodeMeaning{"W353", "REL is a part of the value: 30 per cent is REL 0.3."},
    CodeMeaning{"W354", "Take one of the two $CONTACT away: only their sum means anything."},
    CodeMeaning{"W355", "Angles are radians: cos(30[deg]), theta > 30[deg]."},
    CodeMeaning{"W357", "Name it where it is meant, or take it away."},
    CodeMeaning{"W358", "Lines of one case add up."},
    CodeMeaning{"W361", "Name the parameter in an expression."},
    CodeMeaning{"W366",
                "Results are those of the side that $SYMMETRY keeps: name the mirror image of what "
                "is asked for, or keep the other side."},
    CodeMeaning{"W371", "KC without a unit counts in KUNIT."},
    CodeMeaning{"W368", "The numbers of a block are its low, its high and its count."},
    CodeMeaning{"W369", "Leave out the column of times: only the places t count."},
    CodeMeaning{"W370", "Linear and quadratic elements fit together only by a tie."},
    CodeMeaning{"W372",
                "Faces that WHERE holds on in part are left out. Divide the mesh at the border, "
                "or load the whole side by an expression with the condition as a factor."},
    CodeMeaning{"W373",
                "A residual stress has no force and no moment over a section of the whole body, "
                "beyond the crack as well: K of one that has is too large or too small. Take its "
                "mean and its slope out of it."},
    CodeMeaning{"W364", "FIT takes a part of the fit that $CONTACT declares: 1 is all of it."},
    CodeMeaning{"W337", "The moduli must be in deck units already."},
    CodeMeaning{"E550",
                "sweep.csv has the error of each point; started again, the sweep tries them "
                "again."},
    CodeMeaning{"E551", "Start it again with the same folder: finished points are taken over."},
    CodeMeaning{"E552", "spricka sweep is for decks with $SWEEP; for one set of values use spricka "
                        "run. Exit code 2."},
    CodeMeaning{"E553",
                "Run the tasks that have these runs again, with the same K/N or in a new array: "
                "they do what is missing and nothing else. Then collect again. Exit code 6."},
    CodeMeaning{"E554", "Run the task again when no other process has its runs: exit code 6."},
    CodeMeaning{"E555",
                "Make the deck run by itself first; it needs a crack, a contact, a $CHECK or "
                "a body that is loaded."},
    CodeMeaning{"E560",
                "Is the path right? AT= up to an increment that is whole may help; else start "
                "from the beginning: exit code 7."},
    CodeMeaning{"E561", "Take the deck that wrote the state, or start from the beginning. $OUTPUT, "
                        "$CHECK, $CONTROL, $TASK and lengths of $GROW may change; so may its law "
                        "and the spectrum, without friction, SFLOW and $TIPNET TOL."},
    CodeMeaning{"E562", "Give an AT that the file holds, or none: exit code 3."},
    CodeMeaning{"E563",
                "Is the disk full, may you write there, does another run write it? What was "
                "kept before is still good: exit code 7."},
    CodeMeaning{"E564",
                "Give another name; a file that is not ours is never overwritten: exit code 7."},
    CodeMeaning{"E565",
                "Go on with the version that wrote it, or start from the beginning: only the "
                "same program gives the same bits. Exit code 7."},
    CodeMeaning{"E566", "Run it again with --restart."},
    CodeMeaning{"E567", "Put $RESTART WRITE='file.rst' into the deck: exit code 2."},
    CodeMeaning{"W560", "Nothing but the last increments is lost: they are solved again."},
    CodeMeaning{"W561", "The message says which, and why."},
    CodeMeaning{"W503", "Pair the sides by a $CONTACT TYPE=BONDED, which is exact. Ties at points "
                        "pass constant stress exactly only where every side of the fine "
                        "mesh lies on one face of the coarse one."},
    CodeMeaning{
        "W506",
        "The table of rounds in the listing says what was tried and how far K came. A looser "
        "TOL, or a deck whose own mesh can be made finer where the errors are: exit code 5."},
    CodeMeaning{"W509",
                "Memory was short, or --engine asked for it. More memory, a coarser mesh or "
                "--engine cholesky or mumps give an answer within round-off; the error of K is "
                "about that of the displacements."},
    CodeMeaning{"W510",
                "The answer is as good as any. --engine with the name of the engine that has "
                "solved it spares the time of the attempt."},
    CodeMeaning{"W575",
                "A crack that is pressed in every step has K2 and K3 at most, and grows by no "
                "law here. Look at NET of $CRACK and at the direction of the loads."},
    CodeMeaning{
        "W570",
        "G and (K1^2 + K2^2)/E', domains of different size and the opening of the faces agree "
        "to some 1e-4 of K on sound meshes, along fronts in space to some 1e-2. Something near the "
        "tip is not as smooth as the "
        "mesh takes it: a narrow load or temperature, a front of pressure, another tip or "
        "corner within a few elements. Refine there (a smaller SIZE or RADIUS, a finer host); "
        "if the two do not come together, do not trust either: the difference is the error."},
    CodeMeaning{"W451",
                "Tie the sides with $MPC, pair them with $CONTACT, or mesh the bodies as one. "
                "Sides that lie on each other join nothing by themselves."},
    CodeMeaning{"W457", "The support takes the force at once. Is the set the one that is meant, or "
                        "the support?"},
    CodeMeaning{"W458",
                "Where every node of a surface is held nothing reaches the body behind it."},
    CodeMeaning{"W460",
                "The line of the crack in the listing tells what the body has of it: kind, "
                "length along each face, area. A centre on an edge gives a corner crack, on "
                "a face a surface crack, inside an embedded one; else A and C are not the "
                "flaw's size."},
    CodeMeaning{"W461", "Of the two parts of a section the crack is the one with X0 Y0 Z0 in it."},
    CodeMeaning{"W462", "A crack at a face that is held across it counts with its mirror image."},
    CodeMeaning{"W463", "The front is a smooth curve through all points in their order."},
    CodeMeaning{"W459", "PATH is ordered from the mouth, where the boundary turns, to the tip, and "
                        "lengths count from its first node."},
    CodeMeaning{"E457", "Leave SIZE out, or give it together with RINGS or RADIUS: fields at a tip "
                        "change with the distance from it, which rings must follow."},
    CodeMeaning{"E458", "Begin PATH on the boundary; a crack inside a body is drawn by points."},
    CodeMeaning{"W571",
                "A DIAMETRAL or INTERFERENCE presses, a GAP keeps apart; a fit acts when a "
                "step has FIT. A stop that no load reaches deserves no more than this word."},
    CodeMeaning{"W572", "Pa for MPa in a law is a factor of 1e6 to the power of its exponent. The "
                        "threshold of a law ends growth, DKTH, DK0 or DK1."},
    CodeMeaning{"W576",
                "The part of the growth says whether it matters. Take a law whose data reach "
                "as far, or give it rows or columns there; DKMIN, DKMAX, RMIN and RMAX of "
                "$LAW are what is known of its data."},
    CodeMeaning{"W573", "Readings are lengths in the unit of the deck, from the mouth on."},
    CodeMeaning{"W574",
                "What is compared is K at the place named in the message. Ask where the front "
                "is: k.csv has its points."},
    CodeMeaning{"W504",
                "Refine near the elements named, or use quadratic elements: linear ones and few "
                "distorted ones are stiff in bending. Sharp inner corners and edges of contact "
                "have errors that refinement moves but does not end; if stresses "
                "there are not wanted, the estimate can be left at that."},
    CodeMeaning{"W442",
                "Leave GAP, INTERFERENCE or DIAMETRAL out to have the drawn gap measured, or "
                "draw the surfaces in contact: the declared gap is taken as it is."},
    CodeMeaning{"W443", "Put the faces that the message tells the place of into the set, or give "
                        "them a $CONTACT of their own."},
    CodeMeaning{"W444",
                "Look at the unit of the fit, and at the radii of the drawing. Strains above "
                "1 % are beyond small displacements and elastic materials."},
    CodeMeaning{"W445", "MU=0.15, not MU=15."},
    CodeMeaning{"W446",
                "Give them a $CONTACT, or draw them apart. Bodies that lie upon each other "
                "with more than a twentieth of their extent are meant to, and not warned of."},
    CodeMeaning{
        "W502",
        "The numbers are those of the deck as it stands. Are KMIN and KMAX exchanged, are the "
        "readings of a test those of this crack, is there too much friction for one "
        "solution? The message says which."},
    CodeMeaning{
        "W507",
        "The message says what is off, and by how much where that is known. Crack faces that "
        "touch or open over less than the mesh resolves want a smaller SIZE on $TIPNET; "
        "faces that overlap FACES=CONTACT; a SHIFT of $VCE that is too large, none; friction "
        "more SUBSTEPS, or none; a pressure that goes up and down a declared fit, other "
        "meshes or MULTIPLIER=CORNER; bodies that slide off each other want to be drawn "
        "where they end up."},
    CodeMeaning{
        "W508",
        "Do not use the numbers that the message names. K1 is negative: FACES=CONTACT, or a "
        "smaller SIZE where the faces bear on each other already. Bodies run into each "
        "other: give them a $CONTACT, or hold them. K hangs on a support of a single node, "
        "which gives way the more the finer the mesh is: hold a side. Bodies slide, turn or "
        "are strained beyond small displacements: are loads, moduli and fits in the units "
        "meant?"},
};

} // namespace

std::vector<CodeMeaning> all_message_codes() {
  std::vector<CodeMeaning> all(deck::error_codes.begin(), deck::error_codes.end());
  all.insert(all.end(), later_codes.begin(), later_codes.end());
  std::sort(all.begin(), all.end(),
            [](const CodeMeaning& a, const CodeMeaning& b) { return a.code < b.code; });
  return all;
}

std::string_view message_code_advice(std::string_view code) {
  const auto* const it = std::find_if(advice.begin(), advice.end(),
                                      [&](const CodeMeaning& a) { return a.code == code; });
  return it == advice.end() ? std::string_view() : it->meaning;
}

} // namespace spricka::program
