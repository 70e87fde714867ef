// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/catalogue.hpp"

#include "grammar/card_table.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

using enum QuantityKind;

// Arguments by letter; what stands behind ? may be left out: a last number is the crack length.
constexpr std::array quantities{
    ResultQuantity{"K", "cs?aa", stress_intensity, "same as K1"},
    ResultQuantity{"K1", "cs?aa", stress_intensity, "stress intensity of mode I"},
    ResultQuantity{"K2", "cs?aa", stress_intensity, "stress intensity of mode II"},
    ResultQuantity{"K1.BAR", "cs?aa", stress_intensity, "error bar of K1, half its width"},
    ResultQuantity{"K2.BAR", "cs?aa", stress_intensity, "error bar of K2"},
    ResultQuantity{"K1.RAW", "cs?aa", stress_intensity, "K1 as the mesh has it"},
    ResultQuantity{"K2.RAW", "cs?aa", stress_intensity, "K2 as the mesh has it"},
    ResultQuantity{"G", "cs?aa", energy_release, "energy release rate"},
    ResultQuantity{"T", "cs?aa", stress, "stress along the crack at the tip"},
    ResultQuantity{"DK1.LOAD", "cso?a", stress_intensity,
                   "factor of a load case times dK1/d(factor), contact kept"},
    ResultQuantity{"DK1.FIT", "csp?a", stress_intensity,
                   "interference of a contact times dK1/d(interference)"},
    ResultQuantity{"DK1.E", "csm?a", stress_intensity,
                   "Young's modulus of a material times dK1/dE"},
    ResultQuantity{"DK1.A", "cs?a", stress_intensity, "crack length times dK1/da"},
    ResultQuantity{"DK2.LOAD", "cso?a", stress_intensity,
                   "factor of a load case times dK2/d(factor), contact kept"},
    ResultQuantity{"DK2.FIT", "csp?a", stress_intensity,
                   "interference of a contact times dK2/d(interference)"},
    ResultQuantity{"DK2.E", "csm?a", stress_intensity,
                   "Young's modulus of a material times dK2/dE"},
    ResultQuantity{"DK2.A", "cs?a", stress_intensity, "crack length times dK2/da"},
    ResultQuantity{"CPRESS.MIN", "ps?a", stress, "smallest contact pressure"},
    ResultQuantity{"CPRESS.MAX", "ps?a", stress, "largest contact pressure"},
    ResultQuantity{"CPRESS.MEAN", "ps?a", stress, "mean pressure over the part in contact"},
    ResultQuantity{"CPRESS.AT", "psa?a", stress,
                   "contact pressure at the angle theta of a circle, or a length along the slave"},
    ResultQuantity{"CPRESS.NEAR", "paazs?a", stress,
                   "contact pressure where the surface is nearest to x, y; of solids at the node "
                   "nearest to x, y, z"},
    ResultQuantity{"CONTACT.AREA", "ps?a", area, "area of the part in contact, between solids"},
    ResultQuantity{"ARC.FROM", "ps?a", angle,
                   "first angle of the longest part in contact; on a slave that is no circle the "
                   "length along it"},
    ResultQuantity{"ARC.TO", "ps?a", angle, "last angle of the longest part, or length"},
    ResultQuantity{"ARC.PARTS", "ps?a", number, "parts of the surface in contact"},
    ResultQuantity{"ARC.PART.FROM", "psa?a", angle,
                   "first angle, or length, of the n-th part in contact along the surface"},
    ResultQuantity{"ARC.PART.TO", "psa?a", angle, "last angle, or length, of the n-th part"},
    ResultQuantity{"SHEAR.MIN", "ps?a", stress, "smallest shear traction on the slave"},
    ResultQuantity{"SHEAR.MAX", "ps?a", stress, "largest shear traction on the slave"},
    ResultQuantity{
        "SHEAR.AT", "psa?a", stress,
        "shear traction on the slave at the angle theta of a circle, or a length along it"},
    ResultQuantity{"STICK.FROM", "ps?a", angle, "first angle of the part that sticks, or length"},
    ResultQuantity{"STICK.TO", "ps?a", angle, "last angle of the part that sticks, or length"},
    ResultQuantity{"STICK.AREA", "ps?a", area, "area of the part that sticks, between solids"},
    ResultQuantity{"SLIP.MAX", "ps?a", length, "longest way a point has slipped, to and fro"},
    ResultQuantity{"FRICTION.WORK", "ps?a", energy, "work that friction has taken"},
    ResultQuantity{"SUM", "psd?a", force,
                   "force on the slave; about an axis X sums radial forces round it"},
    ResultQuantity{"MOMENT", "psd?a", energy,
                   "moment on the slave about the origin, between solids: force times length"},
    ResultQuantity{"U.X.MIN", "ns?a", length, "smallest displacement along x"},
    ResultQuantity{"U.Y.MIN", "ns?a", length, "smallest displacement along y"},
    ResultQuantity{"U.Z.MIN", "ns?a", length, "smallest displacement along z"},
    ResultQuantity{"U.X.MAX", "ns?a", length, "largest displacement along x"},
    ResultQuantity{"U.Y.MAX", "ns?a", length, "largest displacement along y"},
    ResultQuantity{"U.Z.MAX", "ns?a", length, "largest displacement along z"},
    ResultQuantity{"U.X.AT", "aazs?a", length, "displacement along x at a point"},
    ResultQuantity{"U.Y.AT", "aazs?a", length, "displacement along y at a point"},
    ResultQuantity{"U.Z.AT", "aazs?a", length, "displacement along z at a point"},
    ResultQuantity{"S.XX.MIN", "ns?a", stress, "smallest stress xx"},
    ResultQuantity{"S.YY.MIN", "ns?a", stress, "smallest stress yy"},
    ResultQuantity{"S.ZZ.MIN", "ns?a", stress, "smallest stress zz"},
    ResultQuantity{"S.XY.MIN", "ns?a", stress, "smallest stress xy"},
    ResultQuantity{"S.YZ.MIN", "ns?a", stress, "smallest stress yz"},
    ResultQuantity{"S.XZ.MIN", "ns?a", stress, "smallest stress xz"},
    ResultQuantity{"S.XX.MAX", "ns?a", stress, "largest stress xx"},
    ResultQuantity{"S.YY.MAX", "ns?a", stress, "largest stress yy"},
    ResultQuantity{"S.ZZ.MAX", "ns?a", stress, "largest stress zz"},
    ResultQuantity{"S.XY.MAX", "ns?a", stress, "largest stress xy"},
    ResultQuantity{"S.YZ.MAX", "ns?a", stress, "largest stress yz"},
    ResultQuantity{"S.XZ.MAX", "ns?a", stress, "largest stress xz"},
    ResultQuantity{"S.XX.AT", "aazs?a", stress, "stress xx at a point"},
    ResultQuantity{"S.YY.AT", "aazs?a", stress, "stress yy at a point"},
    ResultQuantity{"S.ZZ.AT", "aazs?a", stress, "stress zz at a point"},
    ResultQuantity{"S.XY.AT", "aazs?a", stress, "stress xy at a point"},
    ResultQuantity{"S.YZ.AT", "aazs?a", stress, "stress yz at a point"},
    ResultQuantity{"S.XZ.AT", "aazs?a", stress, "stress xz at a point"},
    ResultQuantity{"S.MISES.MIN", "ns?a", stress, "smallest von Mises stress"},
    ResultQuantity{"S.MISES.MAX", "ns?a", stress, "largest von Mises stress"},
    ResultQuantity{"S.MISES.AT", "aazs?a", stress, "von Mises stress at a point"},
    ResultQuantity{"S.P1.MIN", "ns?a", stress, "smallest first principal stress"},
    ResultQuantity{"S.P2.MIN", "ns?a", stress, "smallest second principal stress"},
    ResultQuantity{"S.P3.MIN", "ns?a", stress, "smallest third principal stress"},
    ResultQuantity{"S.P1.MAX", "ns?a", stress, "largest first principal stress"},
    ResultQuantity{"S.P2.MAX", "ns?a", stress, "largest second principal stress"},
    ResultQuantity{"S.P3.MAX", "ns?a", stress, "largest third principal stress"},
    ResultQuantity{"S.P1.AT", "aazs?a", stress, "first principal stress at a point"},
    ResultQuantity{"S.P2.AT", "aazs?a", stress, "second principal stress at a point"},
    ResultQuantity{"S.P3.AT", "aazs?a", stress, "third principal stress at a point"},
    ResultQuantity{"REACTION", "nsd?a", force, "force of the supports on a set"},
    ResultQuantity{"ENERGY", "es?a", energy, "strain energy of a net, of all with *"},
    ResultQuantity{"ERROR", "es?a", number, "estimated error of a net in the energy norm, 0 to 1"},
    ResultQuantity{"PATH.K1", "cla?a", stress_intensity, "K1 at a place t of a load path"},
    ResultQuantity{"PATH.K2", "cla?a", stress_intensity, "K2 at a place t of a load path"},
    ResultQuantity{"PATH.SLOPE", "cla?a", stress_intensity,
                   "slope dK1/dt at a place t of a load path; at a breakpoint the slope behind it"},
    ResultQuantity{"PATH.K1.SUM", "claa?a", stress_intensity,
                   "K1 under x times FROM plus y times TO of a load path"},
    ResultQuantity{"PATH.OPENING", "pl?a", number,
                   "t at which the first contact pair opens on a load path"},
    ResultQuantity{"PATH.KNOTS", "l?a", number, "number of breakpoints of a load path"},
    ResultQuantity{"N", "a", life, "cycles (or passes of the spectrum) until a crack length"},
    ResultQuantity{"LIFE", "", life, "cycles (or passes of the spectrum) to the end"},
    ResultQuantity{"TEST.K", "ta", stress_intensity, "K that a test had at a crack length"},
    ResultQuantity{"TEST.RATIO", "t?aa", number,
                   "mean of measured over computed K of a test, from length to length"},
    ResultQuantity{"TEST.RMS", "t?aa", number, "rms of measured over computed K less 1"},
    ResultQuantity{"TEST.INSIDE", "t?aa", number,
                   "share of points whose scatter band holds the computed K"},
    ResultQuantity{"TEST.LIFE", "t", number, "cycles by the computed K over those of a test"},
    ResultQuantity{"TEST.SCATTER", "t", length, "standard deviation of the readings of a test"},
};

constexpr std::array<ResultArgument, 10> result_arguments{{
    {'c', EntityKind::crack, "crack[.tip]"},
    {'p', EntityKind::contact, "contact"},
    {'s', EntityKind::step, "step"},
    {'o', EntityKind::load_case, "case"},
    {'m', EntityKind::material, "material"},
    {'l', EntityKind::path, "path"},
    {'t', EntityKind::test, "test"},
    {'n', EntityKind::any_set, "set"},
    {'e', EntityKind::net, "net|*"},
    {'d', EntityKind::none, "X|Y|Z"},
}};

/// One quantity along fronts; `name` stands in front of the place.
struct AlongFronts {
  std::string name;
  std::string_view arguments; ///< behind crack and place: a step, or a path and t
  QuantityKind quantity;
  std::string doc;
  bool ends = true; ///< has MIN and MAX
};

std::vector<AlongFronts> along_fronts() {
  std::vector<AlongFronts> all;
  for (const char* K : {"K1", "K2", "K3"}) {
    all.push_back({K, "s", stress_intensity, K});
  }
  all.push_back({"G", "s", energy_release, "energy release rate"});
  all.push_back({"T", "s", stress, "T"});
  for (const char* K : {"K1", "K2", "K3"}) {
    const std::string name = K;
    all.push_back({name + ".BAR", "s", stress_intensity, "error bar of " + name});
    all.push_back({name + ".RAW", "s", stress_intensity, name + " as the mesh has it"});
  }
  for (const char* K : {"K1", "K2", "K3"}) {
    all.push_back({fmt::format("PATH.{}", K), "la", stress_intensity,
                   fmt::format("{} at a place t of a load path", K)});
  }
  for (const char* K : {"K1", "K2", "K3"}) {
    all.push_back({fmt::format("D{}.LOAD", K), "so", stress_intensity,
                   fmt::format("factor of a load case times d{}/d(factor)", K), false});
    all.push_back({fmt::format("D{}.FIT", K), "sp", stress_intensity,
                   fmt::format("interference of a contact times d{}/d(interference)", K), false});
    all.push_back({fmt::format("D{}.E", K), "sm", stress_intensity,
                   fmt::format("Young's modulus of a material times d{}/dE", K), false});
    for (const char* axis : {"A", "C"}) {
      all.push_back({fmt::format("D{}.{}", K, axis), "s", stress_intensity,
                     fmt::format("semi-axis {0} of an ellipse times d{1}/d{0}", axis, K), false});
    }
  }
  return all;
}

/// Results along fronts of cracks in space: each quantity at a place, at an angle and at its ends.
const std::vector<ResultQuantity>& front_results() {
  static std::deque<std::string> texts; // what the words below look at
  static const std::vector<ResultQuantity> all = [] {
    const auto keep = [](std::string text) -> std::string_view {
      return texts.emplace_back(std::move(text));
    };
    std::vector<ResultQuantity> found;
    for (const AlongFronts& q : along_fronts()) {
      found.push_back(
          {keep(q.name + ".AT"), keep(fmt::format("caaa{}?a", q.arguments)), q.quantity,
           keep(fmt::format("in space: {} where the front is nearest to x, y, z", q.doc))});
      found.push_back(
          {keep(q.name + ".PHI"), keep(fmt::format("c{}a?a", q.arguments)), q.quantity,
           keep(fmt::format("in space: {} at the angle phi of an ellipse, as 45[deg]", q.doc))});
      for (const auto& [end, word] : {std::pair("MIN", "smallest"), std::pair("MAX", "largest")}) {
        if (q.ends) {
          found.push_back({keep(fmt::format("{}.{}", q.name, end)),
                           keep(fmt::format("c{}?a", q.arguments)), q.quantity,
                           keep(fmt::format("in space: {} {} along the front, but for its ends on "
                                            "a surface",
                                            word, q.doc))});
        }
      }
    }
    return found;
  }();
  return all;
}

} // namespace

std::span<const CardSpec> card_catalogue() {
  static const std::vector<CardSpec> all = [] {
    std::vector<CardSpec> cards(model_cards().begin(), model_cards().end());
    for (const std::span<const CardSpec> more : {joint_cards(), analysis_cards()}) {
      cards.insert(cards.end(), more.begin(), more.end());
    }
    for (CardSpec& card : cards) {
      if (const CardHelpText* text = find_card_help(card.name)) {
        card.notes = text->notes;
        card.example = text->example;
      }
    }
    return cards;
  }();
  return all;
}

const CardSpec* find_card(std::string_view name) {
  const auto all = card_catalogue();
  const auto it = std::ranges::find(all, name, &CardSpec::name);
  return it == all.end() ? nullptr : &*it;
}

const ResultArgument* find_argument_by_letter(char letter) {
  const auto* const it = std::ranges::find(result_arguments, letter, &ResultArgument::letter);
  return it == result_arguments.end() ? nullptr : it;
}

std::span<const ResultQuantity> result_quantities() {
  static const std::vector<ResultQuantity> all = [] {
    std::vector<ResultQuantity> both(quantities.begin(), quantities.end());
    // Those of fronts behind the last one of tips.
    const auto behind = std::ranges::find(both, "T", &ResultQuantity::name) + 1;
    both.insert(behind, front_results().begin(), front_results().end());
    return both;
  }();
  return all;
}

const ResultQuantity* find_result_quantity(std::string_view name) {
  const auto all = result_quantities();
  const auto it = std::ranges::find(all, name, &ResultQuantity::name);
  return it == all.end() ? nullptr : &*it;
}

} // namespace spricka::grammar
