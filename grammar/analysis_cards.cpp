// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/card_table.hpp"
#include "grammar/catalogue.hpp"

#include <algorithm>
#include <array>

namespace spricka::grammar {

namespace {

using namespace table;
using enum EntityKind;
using enum QuantityKind;

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

constexpr std::string_view twist_level_words = "I|II|III|IV|V|VI|VII|VIII|IX|X";

constexpr std::array spectrum_keys{
    required(defining_key("NAME", spectrum, "called by this in $GROW")),
    required(reference_key("PATH", path, "the load path that the loads lie on")),
    required(word_key("TYPE", "BLOCKS|SEQUENCE|TWIST",
                      "cycles with their counts; turning points; or made from TWIST's table")),
    with_default(word_key("COUNT", "RAINFLOW|PAIRS",
                          "cycles of a sequence: closed ranges, or each valley with the next peak"),
                 "RAINFLOW"),
    text_key("FILE", "lines from this file, in place of data lines"),
    words_key("ORDER",
              "MIN|MAX|MEAN|AMPLITUDE|RANGE|RATIO|COUNT|VALUE|SKIP|LOW|HIGH|VALLEY|PEAK|CYCLES",
              "what the columns are; LOW, HIGH, COUNT of BLOCKS when left out"),
    integer_key("SKIP", at_least(0), "header lines of the file that are left out"),
    text_key("COMMENT", "what follows it in a line of the file is left out; ! and # otherwise"),
    text_key("MARK", "lines of the file that begin with this word begin a flight"),
    with_default(real_key("FACTOR", number, above(0), "multiplies every load"), "1"),
    with_default(real_key("OFFSET", number, anything, "is added to every load behind FACTOR"), "0"),
    any_number_key("AT0", anything, "load that the step FROM of the path stands for (t = 0)"),
    any_number_key("AT1", anything, "load that the step TO of the path stands for (t = 1)"),
    text_key("VALUES", "unit of the loads, of AT0, AT1, CLIP, OMIT and MEAN: 'ksi', 'g'"),
    any_number_key("CLIP", anything, "higher loads are brought down to this one"),
    any_number_key("OMIT", above(0), "cycles with a smaller range are left out"),
    word_key("UNIT", "PASSES|FLIGHTS|HOURS|CYCLES", "what lives are told in besides passes"),
    real_key("FLIGHTS", number, above(0), "flights in a pass"),
    real_key("HOURS", number, above(0), "hours in a pass"),
    any_number_key("MEAN", above(0), "TWIST: mean load in flight"),
    word_key("HIGHEST", twist_level_words,
             "TWIST: higher gusts become this level; I when left out"),
    word_key("LOWEST", twist_level_words, "TWIST: lower gusts are left out; X when left out"),
    integer_key("SEED", at_least(0), "TWIST: another order of flights and gusts; 1 when left out"),
};

constexpr std::array spectrum_when{
    KeyPresenceRule{"TYPE", "BLOCKS", "", "COUNT MEAN HIGHEST LOWEST SEED"},
    KeyPresenceRule{"TYPE", "SEQUENCE", "", "MEAN HIGHEST LOWEST SEED"},
    KeyPresenceRule{"TYPE", "TWIST", "MEAN", "FILE ORDER SKIP COMMENT MARK FACTOR OFFSET FLIGHTS"},
    KeyPresenceRule{"AT0", "", "AT1", ""},
    KeyPresenceRule{"AT1", "", "AT0", ""},
    KeyPresenceRule{"VALUES", "", "AT0 AT1", ""},
    KeyPresenceRule{"SKIP", "", "FILE", ""},
    KeyPresenceRule{"COMMENT", "", "FILE", ""},
    KeyPresenceRule{"MARK", "", "FILE", "FLIGHTS"},
    KeyPresenceRule{"UNIT", "HOURS", "HOURS", ""},
};

// What the rate of a law is made of: $GROW has these keys, and $LAW.
constexpr std::array law_constant_keys{
    real_key("C", number, above(0), "factor of the law, in KUNIT and AUNIT"),
    real_key("M", number, above(0), "exponent of the law"),
    with_default(real_key("P", number, anything, "exponent of WALKER (gamma) or of NASGRO"), "0"),
    with_default(real_key("Q", number, anything, "exponent of NASGRO"), "0"),
    word_key("NEGATIVE", "POSITIVE_PART|WHOLE|KMAX",
             "WALKER at R < 0: POSITIVE_PART (when left out): as R = 0; WHOLE: K_max - K_min with "
             "PM; KMAX: C (K_max/(1-R)^(1-P))^M"),
    real_key("PM", number, anything, "exponent of WALKER in place of P at R < 0"),
    real_key("KC", stress_intensity, above(0),
             "fracture toughness, in KUNIT if it has no unit; stops the growth; FORMAN, NASGRO and "
             "HARTMAN need it or K1C"),
    real_key("K1C", stress_intensity, above(0),
             "toughness in plane strain, in KUNIT if it has no unit: KC of THICK follows from it"),
    real_key("AK", number, at_least(0), "constant of KC over the thickness"),
    real_key("BK", number, at_least(0), "constant of KC over the thickness"),
    real_key("THICK", length, above(0), "thickness that KC is for"),
    real_key("KIE", stress_intensity, above(0),
             "NASGRO: toughness of surface and corner cracks, in place of KC"),
    real_key("YIELD", stress, above(0), "yield stress of KC over the thickness"),
    with_default(real_key("DKTH", stress_intensity, at_least(0),
                          "threshold, one for all R, in KUNIT if it has no unit"),
                 "0"),
    real_key("DK0", stress_intensity, above(0),
             "threshold over R: that at R = 0, in KUNIT if it has no unit"),
    real_key("DK1", stress_intensity, above(0),
             "threshold over R: that for R to 1, in KUNIT if it has no unit"),
    real_key("CTHP", number, anything, "slope of the threshold over R, for R >= 0"),
    real_key("CTHM", number, anything, "slope of the threshold over R, for R < 0"),
    real_key("AINTRINSIC", length, at_least(0),
             "cracks as short as this have a lower threshold, 0: none; 0.0381 mm when left out"),
    with_default(real_key("RCL", number, closed_interval(0, 0.99),
                          "R from which on the threshold stays what it is there"),
                 "0.7"),
    with_default(real_key("ALPHA", number, closed_interval(1, 3),
                          "constraint factor of Newman's crack opening"),
                 "2"),
    with_default(real_key("SMAX", number, closed_interval(0, 1),
                          "stress over flow stress of Newman's crack opening"),
                 "0.3"),
    unit_key("KUNIT", stress_intensity,
             "unit of K in the law (C, KC, K1C, DKTH, DK0, DK1, table): 'MPa*m^0.5'"),
    unit_key("AUNIT", length, "unit of a in the law (C, table): 'm' or 'mm/cycle'"),
};

constexpr std::array own_grow_keys{
    word_key(
        "LAW", "INCREMENT|PARIS|WALKER|FORMAN|NASGRO|TABLE|HARTMAN",
        "INCREMENT: the crack lengths are given; PARIS: C dK^M; WALKER: C "
        "(dK/(1-R)^(1-P))^M; FORMAN: C dK^M/((1-R) KC - dK); NASGRO: Forman and Mettu's "
        "with Newman's crack opening; TABLE: lines delta_K da/dN; HARTMAN: Hartman and Schijve's, "
        "C ((dK - DKTH)/sqrt(1 - Kmax/KC))^M"),
    reference_key("MATERIAL", law,
                  "the law of this $LAW, in place of LAW and its constants: of the deck, of "
                  "materials.deck beside it, or of those that ship"),
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
    key_of_type(KeyType::references, "INTERACTION", interaction,
                "how the cycles of SPECTRUM act on each other, NONE among them; the first counts, "
                "the others stand beside it"),
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
    real_key("SFLOW", stress, above(0),
             "flow stress: the plastic limit of ligament or section stops the growth"),
    word_key(
        "CORRECT", "YES|NO",
        "NO: K as the mesh has it; else its estimated error is taken out where it has an error "
        "bar, and YES warns where it has none"),
};

constexpr auto grow_keys = join(own_grow_keys, law_constant_keys);

// Which constants a law takes, whose name is the value of `key`.
constexpr std::array<KeyPresenceRule, 10> constants_of_laws(std::string_view key) {
  return {{
      {key, "PARIS", "C M KUNIT AUNIT", "P Q KIE NEGATIVE PM"},
      {key, "WALKER", "C M P KUNIT AUNIT", "Q KIE"},
      {key, "FORMAN", "C M KUNIT AUNIT", "P Q KIE NEGATIVE PM"},
      {key, "NASGRO", "C M KUNIT AUNIT", "NEGATIVE PM"},
      {key, "TABLE", "KUNIT AUNIT", "C M P Q KIE NEGATIVE PM"},
      {key, "HARTMAN", "C M KUNIT AUNIT", "P Q KIE NEGATIVE PM DK0 DK1"},
      {"NEGATIVE", "WHOLE", "PM", ""},
      {"NEGATIVE", "POSITIVE_PART|KMAX", "", "PM"},
      {"DK0", "", "CTHP CTHM", "DKTH"},
      {"DK1", "", "CTHP CTHM", "DKTH DK0"},
  }};
}

// Every law but INCREMENT works on a range of K: from KMIN to KMAX, or those of a spectrum.
constexpr std::array own_grow_when{
    KeyPresenceRule{
        "LAW", "INCREMENT", "KMAX",
        "DA CYCLES C M P Q DKTH ALPHA SMAX KUNIT AUNIT SPECTRUM TOL SFLOW CORRECT AMAX KC "
        "HISTORY INTERACTION DK0 DK1 CTHP CTHM AINTRINSIC RCL K1C AK BK THICK YIELD KIE "
        "NEGATIVE PM MATERIAL"},
    KeyPresenceRule{"K1C", "", "AK BK THICK YIELD", "KC"},
    KeyPresenceRule{"SPECTRUM", "", "", "KMAX KMIN"},
    KeyPresenceRule{"INTERACTION", "", "SPECTRUM", ""},
    KeyPresenceRule{"HISTORY", "CONTINUE", "", "MOUNTED"},
};
constexpr auto grow_when = join(own_grow_when, constants_of_laws("LAW"));

constexpr std::array own_law_keys{
    required(defining_key("NAME", law, "called by this in $GROW")),
    required(word_key("TYPE", "PARIS|WALKER|FORMAN|NASGRO|TABLE|HARTMAN",
                      "the law, as LAW of $GROW has them")),
    text_key("SOURCE", "where the constants are from"),
    text_key("FORM", "of the material that was tested: 'sheet'"),
    text_key("ORIENTATION", "load and growth against the rolling direction: 'L-T'"),
    text_key("ENVIRONMENT", "that the tests were made in: 'lab air'"),
    real_key("DKMIN", stress_intensity, at_least(0),
             "least delta K of the tests, in KUNIT if it has no unit"),
    real_key("DKMAX", stress_intensity, above(0),
             "largest delta K of the tests, in KUNIT if it has no unit"),
    real_key("RMIN", number, closed_interval(-100, 0.99), "least R of the tests"),
    real_key("RMAX", number, closed_interval(-100, 0.99), "largest R of the tests"),
    real_key("SCATTER", number, at_least(0), "standard deviation of ln C; printed"),
};
constexpr auto law_keys = join(own_law_keys, law_constant_keys);

constexpr std::array own_law_when{
    KeyPresenceRule{"K1C", "", "AK BK YIELD", "KC"},
};
constexpr auto law_when = join(own_law_when, constants_of_laws("TYPE"));

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
    KeyPresenceRule{"METHOD", "SECANT|SPLINE", "", "POINTS"},
    KeyPresenceRule{"REFERENCE", "", "KUNIT AUNIT", ""},
};

constexpr std::array interaction_keys{
    required(defining_key("NAME", interaction, "called by this in $GROW")),
    required(word_key(
        "TYPE", "WHEELER|WILLENBORG_1971|WILLENBORG|MODIFIED|CHANG|CLOSURE",
        "WHEELER: rates times (zone over what is left of the overload's)^W; WILLENBORG: K less by "
        "PHI (K required - Kmax), generalised; WILLENBORG_1971: all of it; MODIFIED: with "
        "underloads; CHANG: with Walker's law and compression; CLOSURE: one opening level")),
    word_key("ZONE", "IRWIN2|IRWIN6|IRWIN_FULL|DUGDALE|NASGRO_STRESS|NASGRO_STRAIN",
             "plastic zone over (Kmax/YIELD)^2: 1/(2 pi), 1/(6 pi), 1/pi, pi/8, pi/8/1.15^2, "
             "pi/8/2.55^2"),
    real_key("KAPPA", number, above(0), "the same as a number, in place of ZONE"),
    real_key("YIELD", stress, above(0), "yield stress of the plastic zone"),
    real_key("W", number, at_least(0), "exponent of WHEELER"),
    real_key("SOLR", number, above(1), "ratio of an overload that stops the growth"),
    word_key("MINIMUM", "KEEP|ZERO",
             "WILLENBORG, of an effective K_min below 0: the law sees it, or it is 0"),
    real_key(
        "KTH", stress_intensity, at_least(0),
        "K_max below which a cycle of R = 0 does not grow; left out: the threshold of the law"),
    real_key("PHI0", number, closed_interval(0, 1), "MODIFIED: PHI behind no underload"),
    real_key("Q", number, at_least(0), "CHANG: exponent of rates at R < 0"),
    with_default(real_key("A", number, closed_interval(0, 1), "CHANG: threshold KTH (1 - A R)"),
                 "1"),
    with_default(real_key("RHIGH", number, closed_interval(0, 0.99),
                          "CHANG: the largest R that "
                          "counts"),
                 "0.75"),
    with_default(real_key("RLOW", number, closed_interval(-10, 0),
                          "CHANG: the smallest R that "
                          "counts"),
                 "-0.99"),
    with_default(real_key("ALPHA", number, closed_interval(1, 3),
                          "CLOSURE: constraint factor of Newman's crack opening"),
                 "2"),
    with_default(real_key("SMAX", number, closed_interval(0, 1),
                          "CLOSURE: stress over flow stress of Newman's crack opening"),
                 "0.3"),
};

constexpr std::array interaction_when{
    KeyPresenceRule{"KAPPA", "", "", "ZONE"},
    KeyPresenceRule{"TYPE", "WHEELER", "YIELD W",
                    "SOLR MINIMUM KTH PHI0 Q A RHIGH RLOW ALPHA SMAX"},
    KeyPresenceRule{"TYPE", "WILLENBORG_1971", "YIELD",
                    "W SOLR MINIMUM KTH PHI0 Q A RHIGH RLOW ALPHA SMAX"},
    KeyPresenceRule{"TYPE", "WILLENBORG", "YIELD SOLR MINIMUM", "W PHI0 Q A RHIGH RLOW ALPHA SMAX"},
    KeyPresenceRule{"TYPE", "MODIFIED", "YIELD PHI0",
                    "W SOLR MINIMUM KTH Q A RHIGH RLOW ALPHA SMAX"},
    KeyPresenceRule{"TYPE", "CHANG", "YIELD SOLR KTH Q", "W MINIMUM PHI0 ALPHA SMAX"},
    KeyPresenceRule{"TYPE", "CLOSURE", "",
                    "YIELD ZONE KAPPA W SOLR MINIMUM KTH PHI0 Q A RHIGH RLOW"},
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
    with_default(word_key("ENGINE", "AUTO|CHOLESKY|MUMPS|MULTIGRID", "what solves the equations"),
                 "AUTO"),
    reference_key(
        "SHOW", step,
        "the step that report, pictures and ladder show first; left out: KMAX of a growth, "
        "else the one with the largest K, else with the largest contact pressure"),
};

constexpr std::array restart_keys{
    text_key("READ", "go on from the state in this file"),
    integer_key("AT", at_least(0), "last increment to take over; left out: all of the file"),
    text_key("WRITE", "keep the state in this file, in a sweep one for each point"),
    with_default(integer_key("EVERY", at_least(1), "increments between states"), "1"),
};

constexpr std::array restart_when{
    KeyPresenceRule{"AT", "", "READ", ""},
    KeyPresenceRule{"EVERY", "", "WRITE", ""},
};

constexpr std::array output_keys{
    required(text_key("FILE", "name of the file, in the run folder")),
    required(word_key("FORMAT", "VTU|CSV|JSON", "pictures for ParaView, a table, or JSON")),
    with_default(word_key("EVERY", "STEP|INCREMENT|END", "when it is written"), "STEP"),
};

constexpr std::array cards{
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
             .data_form = "BLOCKS: low high count, or as ORDER says; SEQUENCE: turning points",
             .when = spectrum_when,
             .doc = "A load history on a load path: the cycles that a crack grows by."},
    CardSpec{.name = "INTERACTION",
             .group = "loads",
             .keys = interaction_keys,
             .when = interaction_when,
             .doc = "How a cycle of a spectrum acts on those behind it: retardation by overloads."},
    CardSpec{.name = "GROW",
             .group = "crack",
             .keys = grow_keys,
             .data = DataLineForm::rows,
             .once = true,
             .data_form = "INCREMENT: crack lengths; TABLE: delta_K da/dN, or as $LAW has it",
             .when = grow_when,
             .doc = "Crack growth: runs the steps for every crack length."},
    CardSpec{.name = "LAW",
             .group = "crack",
             .keys = law_keys,
             .data = DataLineForm::rows,
             .data_form = "TABLE: delta_K da/dN; or RATIO R R .., then da/dN delta_K delta_K ..",
             .when = law_when,
             .doc = "A crack growth law by name, with what is known of the tests behind it."},
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
             .doc = "Numerics: contact iterations, threads, engine; and the step that is shown."},
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

bool is_law_constant(std::string_view key) {
  return std::ranges::find(law_constant_keys, key, &KeySpec::name) != law_constant_keys.end();
}

} // namespace spricka::grammar
