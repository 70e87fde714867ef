// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/field_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace spricka::grammar {

namespace {

constexpr std::array words{
    DamageToleranceTerm{
        .word = "bushing",
        .also = "bush, bushes, sleeve, liner",
        .text = "A bushing is a part: its mesh is a $NET of its own. A $CONTACT between "
                "bushing and bore has the interference, DIAMETRAL (on the diameter) or "
                "INTERFERENCE (on the radius). FIT in a $STEP presses the bushing in.",
        .topics = "NET CONTACT STEP",
        .pages = "howto/interference solid_lug"},
    DamageToleranceTerm{
        .word = "corner crack",
        .also = "surface crack, embedded crack, part-through crack, quarter-elliptical crack, "
                "semi-elliptical crack, penny-shaped crack",
        .text = "A solid needs one $CRACK with the semi-axes A and C of an ellipse (A alone: "
                "a circle). With its centre on an edge of the body it is a corner crack, on "
                "a face a surface crack, inside the body an embedded crack. $GROW SHAPE=FREE "
                "lets K shape the front, SHAPE=ELLIPSE keeps an ellipse.",
        .topics = "CRACK GROW",
        .pages = "solid_crack howto/bore_crack lug_corner_crack"},
    DamageToleranceTerm{
        .word = "crack closure",
        .also = "closure, closed crack, crack opening",
        .text = "With FACES=CONTACT on $CRACK the crack faces touch where they would "
                "overlap, and K1 is 0 at a tip where they touch. Closure by plasticity is "
                "not computed; only LAW=NASGRO has Newman's opening function of R.",
        .topics = "CRACK FACES NASGRO",
        .pages = "growth cracks"},
    DamageToleranceTerm{
        .word = "crack front",
        .also = "front",
        .text = "In a solid a crack has a front: $CRACK gives it by an ellipse or by its "
                "points. A tube of quarter-point elements along the front comes with it; "
                "$TIPNET changes their sizes. k.csv has K1, K2 and K3 of each point.",
        .topics = "CRACK TIPNET K1.MAX",
        .pages = "solid_crack run_folder"},
    DamageToleranceTerm{
        .word = "crack growth",
        .also = "growth, growth rate, growth law, da/dN, propagation, fatigue, fatigue crack "
                "growth, Paris law",
        .text = "$GROW grows the cracks by a law (PARIS, WALKER, FORMAN, NASGRO or a TABLE "
                "of rates). The range of K comes from two steps, KMAX and KMIN, or from a "
                "$SPECTRUM. The results are in life.csv and life_curve.csv.",
        .topics = "GROW SPECTRUM LIFE",
        .pages = "growth theory/life"},
    DamageToleranceTerm{
        .word = "crack tip",
        .also = "tip",
        .text = "In a plane model a crack from the boundary has one tip, with the name of "
                "the crack. A crack inside the body has two, NAME.1 and NAME.2. The program "
                "makes the mesh at the tip; $TIPNET changes it.",
        .topics = "CRACK TIPNET K1",
        .pages = "cracks"},
    DamageToleranceTerm{
        .word = "critical crack size",
        .also = "critical crack length, critical flaw size, critical length, final crack "
                "size, fracture",
        .text =
            "It is the length at which the growth of $GROW ends: where K at the largest load "
            "reaches KC, or where the net section reaches its plastic limit (SFLOW). "
            "life_curve.csv goes up to this length, and the listing says what ended the growth.",
        .topics = "GROW KC SFLOW",
        .pages = "growth"},
    DamageToleranceTerm{
        .word = "damage tolerance",
        .also = "DTA, damage tolerance analysis",
        .text = "$CRACK gives the initial flaw, $STEP the loads, $GROW the law and the end "
                "(KC, SFLOW, AMAX). The run gives the cycles to the end and the crack length "
                "over the cycles. Inspection intervals, scatter factors on lives and load "
                "interaction (retardation) are not computed.",
        .topics = "CRACK STEP GROW SPECTRUM",
        .pages = "growth tutorial glossary"},
    DamageToleranceTerm{
        .word = "error bar",
        .also = "error estimate, accuracy, convergence, mesh error",
        .text = "Each K has an error bar: half the width in which the exact K of the model "
                "is expected (K1.BAR in $CHECK, K1_bar in k.csv). TOL on $TIPNET refines the "
                "mesh until the error bar is small enough.",
        .topics = "K1.BAR TIPNET",
        .pages = "error_bar"},
    DamageToleranceTerm{
        .word = "fit",
        .also = "interference, interference fit, press fit, shrink fit, neat fit, net fit, "
                "clearance, clearance fit",
        .text = "The fit is a number on $CONTACT; the mesh does not change. DIAMETRAL is the "
                "interference on the diameter (negative: clearance), INTERFERENCE the one on "
                "the radius, and GAP=0 is a neat fit (zero clearance). FIT in a $STEP sets "
                "its factor.",
        .topics = "CONTACT STEP",
        .pages = "howto/interference"},
    DamageToleranceTerm{
        .word = "flaw",
        .also = "defect, flaw size, crack size, crack length",
        .text = "A flaw is a crack here: one $CRACK for each. In a plane model its size is "
                "the length A0; in a solid it is the semi-axes A and C of an ellipse. The "
                "mesh of the part need not know of it.",
        .topics = "CRACK",
        .pages = "cracks solid_crack howto/bore_crack"},
    DamageToleranceTerm{
        .word = "fracture toughness",
        .also = "toughness, KIC, K1C",
        .text = "It is KC on $GROW. The growth ends where K at the largest load reaches KC; "
                "FORMAN and NASGRO have it in the law as well. KC is one value: there is no "
                "R-curve.",
        .topics = "KC GROW",
        .pages = "growth"},
    DamageToleranceTerm{
        .word = "geometry factor",
        .also = "beta, beta factor, geometry correction, boundary correction, correction "
                "factor",
        .text = "Every run with cracks writes beta.csv. Its column beta is K1/sqrt(pi a), a "
                "stress; divided by your reference stress it is the geometry factor. In a "
                "joint with contact K is not proportional to the load, and one beta may not "
                "be enough.",
        .topics = "LOADPATH K1",
        .pages = "howto/beta_tables run_folder gallery/one_beta"},
    DamageToleranceTerm{
        .word = "initial flaw size",
        .also = "initial flaw, initial crack, initial crack size, initial crack length",
        .text = "A growth by a law starts at the size on $CRACK: the length A0 in a plane "
                "model, the semi-axes A and C in a solid. $SWEEP runs several sizes.",
        .topics = "CRACK A0 SWEEP",
        .pages = "growth howto/sweep"},
    DamageToleranceTerm{
        .word = "inspection",
        .also = "inspection interval, inspection threshold, detectable crack size, "
                "detectable flaw, NDI, NDT",
        .text = "The program computes no inspection interval. It gives what one is made of: "
                "life_curve.csv has the crack length over the cycles, and $CHECK knows N(a), "
                "the cycles to a length, and LIFE(), the cycles to the end. LIFE() less N(a) "
                "of the detectable length is the time to find the crack, in cycles.",
        .topics = "N LIFE GROW",
        .pages = "growth run_folder"},
    DamageToleranceTerm{
        .word = "life",
        .also = "lives, fatigue life, crack growth life, cycles to failure",
        .text = "The life is the number of cycles, or of passes of a spectrum, from the "
                "first crack length to the end of the growth. $GROW computes it. Crack "
                "initiation is not computed.",
        .topics = "GROW N LIFE",
        .pages = "growth"},
    DamageToleranceTerm{
        .word = "link-up",
        .also = "multiple site damage, MSD, widespread fatigue damage, WFD, coalescence",
        .text = "Several cracks are several $CRACK cards, and each tip grows at its own "
                "rate. In a plane model the growth ends where two cracks meet (LINK-UP in "
                "the listing). In a solid two cracks in one plane can go on as one.",
        .topics = "CRACK GROW",
        .pages = "growth"},
    DamageToleranceTerm{
        .word = "load spectrum",
        .also = "spectra, flight spectrum, load history, rainflow, block loading, exceedance, "
                "flights, clipping, truncation, TWIST",
        .text = "$SPECTRUM has the loads of one pass, as blocks of cycles or as turning "
                "points that rainflow counts. They lie on a $LOADPATH, so that K of each load is "
                "exact with contact; AT0 and AT1 say which loads its steps stand for. spectrum.csv "
                "has levels and exceedances.",
        .topics = "SPECTRUM LOADPATH GROW",
        .pages = "growth load_path"},
    DamageToleranceTerm{
        .word = "load transfer",
        .also = "bearing-bypass, bearing bypass load, bypass, bypass load, bearing load, "
                "fastener load, joint",
        .text = "Model the joint: each part is a $NET, each pin a part with a $CONTACT. "
                "SUM(contact, step, X) is the force that a pin transfers. For one hole with "
                "known loads take two load cases, $LOAD TYPE=BEARING and TYPE=TRACTION (the "
                "bypass), and set their factors in $STEP. There is no fastener element.",
        .topics = "SUM LOAD CONTACT STEP",
        .pages = "tutorial howto/interference"},
    DamageToleranceTerm{
        .word = "lug",
        .also = "clevis, lug bore",
        .text = "$MESH SHAPE=LUG meshes a plane lug; $IMPORT reads any other one. Pin and "
                "bushing are parts with contact. $LOAD TYPE=BEARING stands for a pin that is "
                "not modelled.",
        .topics = "MESH IMPORT CONTACT BEARING",
        .pages = "lug solid_lug lug_corner_crack howto/bore_crack"},
    DamageToleranceTerm{
        .word = "net section",
        .also = "net section yield, plastic collapse, plastic limit, ligament, flow stress",
        .text = "SFLOW on $GROW is the flow stress. The growth ends where the ligament "
                "carries its plastic limit under the largest load (NET SECTION in the "
                "listing). Without SFLOW nothing is checked.",
        .topics = "SFLOW GROW",
        .pages = "growth"},
    DamageToleranceTerm{
        .word = "pin",
        .also = "bolt, fastener, rivet, shaft",
        .text = "A pin is a part: its mesh is a $NET of its own, with a $CONTACT to the "
                "bore. MOUNT in a $STEP puts it in. $RIGID SHAPE=ARC is a pin that does not "
                "deform; $LOAD TYPE=BEARING is the assumed pressure of a pin that is not "
                "modelled.",
        .topics = "CONTACT STEP RIGID BEARING",
        .pages = "howto/interference tutorial"},
    DamageToleranceTerm{
        .word = "plasticity",
        .also = "yielding, yield stress, plastic zone, elastic-plastic",
        .text = "Materials are linear elastic: there is no yielding and no plastic zone. "
                "SFLOW on $GROW ends a growth at the plastic limit of the net section.",
        .topics = "MATERIAL SFLOW",
        .pages = "growth"},
    DamageToleranceTerm{
        .word = "residual strength",
        .also = "residual strength curve, R-curve",
        .text = "There is no card for a residual strength curve, and no R-curve. $GROW ends "
                "where K at the largest load reaches KC, or the net section its plastic limit "
                "(SFLOW). For the load at which K reaches KC at given lengths take a "
                "$LOADPATH with $GROW LAW=INCREMENT: load_path.csv has K for every load.",
        .topics = "KC SFLOW LOADPATH PATH.K1",
        .pages = "growth load_path"},
    DamageToleranceTerm{
        .word = "residual stress",
        .also = "residual stresses, cold working, cold expansion, shot peening",
        .text = "Give the stress across the place of the crack, $LOAD TYPE=RESIDUAL with an "
                "expression in x y z: with FACES=CONTACT on $CRACK the faces touch where it "
                "presses them together. The cold expansion itself is not computed. Stresses by "
                "a fit or by temperature are part of the solution.",
        .topics = "LOAD CRACK CONTACT",
        .pages = "howto/cold_worked_hole howto/interference"},
    DamageToleranceTerm{
        .word = "retardation",
        .also = "load interaction, interaction, overload, acceleration, Wheeler, Willenborg",
        .text = "$INTERACTION says how cycles of a spectrum act on those behind them, and "
                "$GROW INTERACTION=W1,NONE takes such rules side by side. Without, each cycle "
                "counts by its own K.",
        .topics = "INTERACTION SPECTRUM GROW",
        .pages = "interaction theory/interaction"},
    DamageToleranceTerm{
        .word = "SIF",
        .also = "stress intensity, stress intensity factor, K3",
        .text = "Stress intensity factors are K1, K2 and (in solids) K3, in the units of the "
                "deck, stress times the root of a length, or in those of OUTK on $DECK. They "
                "stand in k.csv, in the listing and in $CHECK, with error bars.",
        .topics = "K1 K1.BAR K1.PHI CHECK DECK",
        .pages = "run_folder error_bar"},
    DamageToleranceTerm{
        .word = "stress concentration",
        .also = "stress concentration factor, Kt",
        .text = "Take the largest first principal stress of a set, S.P1.MAX(set, step), and "
                "divide it by your reference stress.",
        .topics = "S.P1.MAX OUTPUT",
        .pages = "cards"},
    DamageToleranceTerm{
        .word = "stress ratio",
        .also = "R ratio, load ratio",
        .text = "R = K_min/K_max follows from the steps KMIN and KMAX of $GROW, or from the "
                "$SPECTRUM. Laws differ in what they do with K_min below 0.",
        .topics = "KMIN KMAX GROW",
        .pages = "growth"},
    DamageToleranceTerm{
        .word = "threshold",
        .also = "fatigue threshold, crack growth threshold",
        .text = "It is DK0 or DK1 on $GROW, with CTHP and CTHM, over R, or DKTH, one for all R: a "
                "crack does not grow where delta K is not above it.",
        .topics = "DK0 DKTH GROW",
        .pages = "growth"},
    DamageToleranceTerm{
        .word = "through crack",
        .also = "through-thickness crack, edge crack, centre crack, center crack",
        .text = "In a plane model every crack goes through the thickness: $CRACK with a "
                "point, ANGLE and A0. In a solid its front runs from face to face.",
        .topics = "CRACK",
        .pages = "cracks howto/bore_crack solid_crack"},
};

// Letters without case, one sign for all that stands between the parts of a word.
char plain(char c) {
  return c == '-' || c == '_' || c == '/'
             ? ' '
             : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

bool is_same(std::string_view one, std::string_view other) {
  return std::ranges::equal(one, other, {}, plain, plain);
}

} // namespace

std::span<const DamageToleranceTerm> damage_tolerance_terms() {
  return words;
}

std::vector<std::string_view> term_synonyms(const DamageToleranceTerm& word) {
  std::vector<std::string_view> names{word.word};
  std::string_view rest = word.also;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(", "), rest.size());
    names.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 2, rest.size()));
  }
  return names;
}

const DamageToleranceTerm* find_damage_tolerance_term(std::string_view name) {
  const bool plural = name.ends_with('s') || name.ends_with('S');
  const std::string_view singular = name.substr(0, name.size() - (plural ? 1 : 0));
  for (const std::string_view wanted : {name, singular}) {
    for (const DamageToleranceTerm& word : words) {
      for (const std::string_view known : term_synonyms(word)) {
        if (is_same(wanted, known)) {
          return &word;
        }
      }
    }
  }
  return nullptr;
}

} // namespace spricka::grammar
