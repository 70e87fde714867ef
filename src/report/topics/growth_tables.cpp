// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/growth_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/topics/front_places.hpp"
#include "report/topics/growth_law_summary.hpp"
#include "report/topics/result_tables.hpp"
#include "report/topics/spectrum_tables.hpp"
#include "results/result_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::report {

namespace {

// Smallest and largest K_min / K_max of what the law was given; empty where nothing is open.
std::optional<std::pair<double, double>> range_of_R(const results::GrowthResult& growth) {
  std::optional<std::pair<double, double>> R;
  for (const results::GrowthStation& station : growth.stations) {
    for (const results::GrownPointResult& tip : station.points) {
      if (tip.K_max > 0.0) {
        const double here = tip.K_min / tip.K_max;
        R = R ? std::pair(std::min(R->first, here), std::max(R->second, here))
              : std::pair(here, here);
      }
    }
  }
  return R;
}

// Where faces close K_min below 0 is not that of the crack as it is
// (analysis/scene/free_faces.hpp).
bool continued_below_closing(const model::Model& model, const results::GrowthResult& growth) {
  const bool touching =
      std::ranges::any_of(model.cracks, &model::CrackDefinition::faces_in_contact);
  const auto R = range_of_R(growth);
  return model.growth->knows_negative_ratio() && touching && R && R->first < 0.0;
}

// Whether the faces of a crack touch at its tip at the smallest load, somewhere in the growth.
bool closes_at_smallest(const model::Model& model, const results::RunResult& run) {
  if (model.growth->spectrum || !model.growth->kmin.valid()) {
    return false;
  }
  return std::ranges::any_of(run.increments, [&](const results::CrackLengthResult& increment) {
    const std::size_t smallest = model.growth->kmin.index();
    return smallest < increment.steps.size() &&
           std::ranges::any_of(increment.steps[smallest].fronts,
                               [](const results::FrontResult& front) {
                                 return front.is_tip() && front.single_point().closed;
                               });
  });
}

std::string ratio_words(const model::Model& model, const results::RunResult& run) {
  const results::GrowthResult& growth = *run.growth;
  const auto R = range_of_R(growth);
  if (!R) {
    return {};
  }
  std::string out =
      fmt::format("K_min / K_max that the law used: {:.4g} to {:.4g}.\n", R->first, R->second);
  if (continued_below_closing(model, growth)) {
    out += "K_min below 0 is computed with crack faces that may overlap and all other contacts as "
           "they are, as laws with R < 0 assume.\n";
  }
  const model::NegativeRatioRule at_negative = model.growth->constants.at_negative_ratio;
  const bool below = R->first < 0.0 || closes_at_smallest(model, run);
  if (below && model.growth->law == model::CrackGrowthLaw::nasgro) {
    out += "At R < 0 the law uses Newman's opening function for this R, down to R = -2.\n";
  } else if (below && at_negative != model::NegativeRatioRule::positive_part) {
    out += at_negative == model::NegativeRatioRule::K_max
               ? "At R < 0 the law uses C (K_max / (1-R)^(1-P))^M (NEGATIVE=KMAX).\n"
               : "At R < 0 the law uses K_max - K_min with the exponent PM (NEGATIVE=WHOLE).\n";
  } else if (below && model.growth->law == model::CrackGrowthLaw::table &&
             model.growth->knows_negative_ratio()) {
    out += "At R < 0 the columns of the table have K_max - K_min.\n";
  } else if (below) {
    out +=
        "This law counts R < 0 as R = 0: delta K = K_max, as in ASTM E647. Constants from a test "
        "at R < 0 whose delta K is K_max - K_min do not fit it.\n";
  }
  return out;
}

/// What is found of a point of a front at a station.
struct StationRow {
  const results::GrowthStation& station;
  const results::GrownPointResult& point;
};
using Grown = results::GrownPointResult;

std::vector<StationRow> station_rows(const results::GrowthResult& growth,
                                     const std::vector<std::size_t>& points) {
  std::vector<StationRow> rows;
  for (const results::GrowthStation& station : growth.stations) {
    for (const std::size_t i : points) {
      rows.push_back({station, station.points.at(i)});
    }
  }
  return rows;
}

std::vector<std::size_t> all_growth_points(const results::GrowthResult& growth) {
  std::vector<std::size_t> all(growth.point_names.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// A value of a row's point, times a unit.
auto grown(double Grown::*member, double unit = 1.0) {
  return [=](const StationRow& row) { return row.point.*member * unit; };
}

} // namespace

void write_life_csv(const std::filesystem::path& file, const model::Model& model,
                    const results::RunResult& run) {
  if (!run.growth) {
    return;
  }
  const results::GrowthResult& growth = *run.growth;
  Columns<StationRow> columns;
  const base::OutputUnit life = results::life_unit(model.units, growth);
  const base::OutputUnit length = model.units.output_length();
  const base::OutputUnit K = model.units.output_stress_intensity();
  columns.exact("increment", [](const StationRow& row) { return row.station.increment; })
      .exact("N", life, [](const StationRow& row) { return row.station.cycles; })
      .exact("tip", [](const StationRow& row) { return row.point.name; })
      .exact("a", length, grown(&Grown::a))
      .exact("K_max", K, grown(&Grown::K_max))
      .exact("K_min", K, grown(&Grown::K_min))
      .exact("delta_K", K, [](const StationRow& row) { return row.point.K_max - row.point.K_min; })
      .exact("K2_max", K, grown(&Grown::K2_max))
      .exact("da_dN", length, grown(&Grown::rate))
      .exact("turn", grown(&Grown::turn, degrees_per_radian));
  for (int c = 0; c < model.mesh.dim; ++c) {
    columns.exact(std::string(1, "xyz"[c]), length,
                  [c](const StationRow& row) { return row.point.x[c]; });
  }
  if (growth.followed) {
    columns.exact("K_max_first", K, grown(&Grown::first_max))
        .exact("K_min_first", K, grown(&Grown::first_min))
        .exact("passes", [](const StationRow& row) { return row.station.passes; })
        .exact("change", [](const StationRow& row) { return row.station.change; });
  }
  const std::string units = fmt::format(
      "a x y [{0}], K_max K_min delta_K K2_max [{1}], da_dN [{0}/{2}], turn [deg], N [{5}]; ended: "
      "{3}{4}",
      length.name, K.name, growth.unit, growth.ended,
      continued_below_closing(model, growth) ? "; K_min below 0: of faces that could overlap" : "",
      life.name);
  write_file(file, columns.csv(units, station_rows(growth, all_growth_points(growth))));
}

void write_life_curve_csv(const std::filesystem::path& file, const model::Model& model,
                          const results::RunResult& run) {
  if (!run.growth) {
    return;
  }
  const results::GrowthResult& growth = *run.growth;
  Columns<std::size_t> columns; // of points of the curve
  const base::OutputUnit life = results::life_unit(model.units, growth);
  const base::OutputUnit length = model.units.output_length();
  columns.exact("N", life, [&](std::size_t k) { return growth.curve[k].cycles; });
  for (std::size_t i = 0; i < growth.point_names.size(); ++i) {
    columns.exact("a_" + growth.point_names[i], length,
                  [&growth, i](std::size_t k) { return growth.curve[k].a[i]; });
  }
  for (const results::ComparedLife& other : growth.compared) { // at the same lengths
    const std::vector<results::LifeCurvePoint>& curve = other.curve;
    columns.fill_only_if([&curve](std::size_t k) { return k < curve.size(); });
    columns.exact("N_" + other.name, life, [&curve](std::size_t k) { return curve[k].cycles; });
  }
  const std::string units = fmt::format("N [{}], a of each tip [{}]", life.name, length.name);
  std::vector<std::size_t> points(growth.curve.size());
  std::iota(points.begin(), points.end(), std::size_t{0});
  write_file(file, columns.csv(units, points));
}

namespace {

ReportTable station_table(const model::Model& model, const results::GrowthResult& growth,
                          const std::vector<std::size_t>& points) {
  const base::OutputUnit length = model.units.output_length();
  const base::OutputUnit K = model.units.output_stress_intensity();
  const base::OutputUnit rate = length / base::OutputUnit{growth.unit};
  Columns<StationRow> columns;
  columns.number("increment", "", [](const StationRow& row) { return row.station.increment; })
      .number("N", results::life_unit(model.units, growth),
              [](const StationRow& row) { return row.station.cycles; })
      .words("tip", [](const StationRow& row) { return row.point.name; })
      .number("a", length, grown(&Grown::a))
      .number("K max", K, grown(&Grown::K_max))
      .number("K min", K, grown(&Grown::K_min))
      .number("K2", K, grown(&Grown::K2_max))
      .number("da/dN", rate, grown(&Grown::rate), "{:.4g}")
      .number("turn", "deg", grown(&Grown::turn, degrees_per_radian), "{:.3f}");
  if (growth.followed) {
    columns.number("K max first", K, grown(&Grown::first_max))
        .number("K min first", K, grown(&Grown::first_min))
        .number("passes", "", [](const StationRow& row) { return row.station.passes; });
  }
  return columns.table("Growth", station_rows(growth, points));
}

} // namespace

ReportTable growth_station_table(const model::Model& model, const results::RunResult& run) {
  const results::GrowthResult growth = run.growth.value_or(results::GrowthResult());
  return station_table(model, growth, all_growth_points(growth));
}

ReportTable reported_growth_station_table(const model::Model& model,
                                          const results::RunResult& run) {
  const results::GrowthResult growth = run.growth.value_or(results::GrowthResult());
  return station_table(model, growth, reported_growth_points(growth));
}

std::string first_interaction_name(const model::Model& model) {
  const std::optional<std::size_t> first = model.growth->interactions.front();
  return first ? model.interactions[*first].name : "NONE";
}

ReportTable compared_lives_table(const model::Model& model, const results::RunResult& run) {
  struct Life {
    std::string name;
    double ratio;
  };
  std::vector<Life> lives;
  double own = 0.0;
  base::OutputUnit unit;
  if (run.growth && !run.growth->interaction.empty()) {
    own = run.growth->final_cycles();
    unit = results::life_unit(model.units, *run.growth);
    lives.push_back({"interaction " + first_interaction_name(model), 1.0});
    for (const results::ComparedLife& other : run.growth->compared) {
      lives.push_back({other.what, other.ratio});
    }
  }
  Columns<Life> columns;
  columns.words("life by", [](const Life& life) { return life.name; })
      .number("N", unit, [own](const Life& life) { return life.ratio * own; })
      .number(
          "over the first", "", [](const Life& life) { return life.ratio; }, "{:.4g}");
  return columns.table("Lives side by side", lives);
}

namespace {

// Whether K of the first cycle is that of all others, and how sure it is that they are alike.
std::string history_summary(const model::Model& model, const results::GrowthResult& growth) {
  constexpr double same = 1e-4; // of the largest K
  double largest = 0.0;
  double apart = 0.0;
  double change = 0.0;
  int passes = 0;
  for (const results::GrowthStation& station : growth.stations) {
    passes = std::max(passes, station.passes);
    change = std::max(change, station.change);
    for (const results::GrownPointResult& tip : station.points) {
      largest = std::max(largest, tip.K_max);
      apart = std::max(
          {apart, std::abs(tip.K_max - tip.first_max), std::abs(tip.K_min - tip.first_min)});
    }
  }
  if (passes == 0) {
    return "With friction K depends on the load history, but the loads were not repeated: see the "
           "warnings.\n";
  }
  // with slip carried over a length begins with what was before, not with the steps
  const bool carried = model.growth->history == model::SlipHistoryOverGrowth::carry_on;
  const std::string first = growth.unit == "pass" ? "first pass at a length"
                            : carried             ? "cycle of the steps run once at a length"
                                                  : "first cycle";
  std::string out =
      fmt::format("With friction K depends on the load history: the loads were followed one after "
                  "another until K repeated itself, at most {} times; from one time to the next it "
                  "changes by {:.1e} of the largest K.\n",
                  passes, change);
  out += apart > same * largest
             ? fmt::format("The {} differs from those that follow: its K is off by up to {:.2g} % "
                           "of the largest. The life is that of those that follow.\n",
                           first, 100.0 * apart / largest)
             : fmt::format("The {} is like those that follow.\n", first);
  return out;
}

// What the error bars of K at the first station mean for the cycles of cracks in space.
std::string mesh_words(const model::Model& model, const results::RunResult& run) {
  const double exponent = model.growth->constants.m;
  if (model.growth->spectrum || !(exponent > 0.0) || run.increments.empty() ||
      model.growth->kmax.index() >= run.increments[0].steps.size()) {
    return {};
  }
  double sum = 0.0;
  std::size_t count = 0;
  for (const results::FrontResult& front :
       run.increments[0].steps[model.growth->kmax.index()].fronts) {
    for (const results::FrontPointResult& place : front.points) {
      if (!front.is_tip() && front.has_error_bar() && !place.at_surface && place.K1 > 0.0) {
        sum += place.bar[0].size() / place.K1;
        ++count;
      }
    }
  }
  if (count == 0) {
    return {};
  }
  const double known = sum / static_cast<double>(count);
  return fmt::format("The error bars of K at the first station are {:.2g} % on average, which is "
                     "{:.2g} % of the cycles.\n",
                     100.0 * known, 100.0 * exponent * known);
}

// Which K the law was given, and at how many stations.
std::string law_K_words(const model::Model& model, const results::RunResult& run) {
  const std::string largest = leading_step_name(model);
  std::size_t corrected = 0;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      corrected += step.step == largest &&
                           std::ranges::any_of(step.fronts, &results::FrontResult::is_corrected)
                       ? 1
                       : 0;
    }
  }
  const std::size_t all = run.increments.size();
  const std::string raw = "The law used K as the mesh has it";
  if (!run.growth->corrected) {
    return raw + (run.growth->followed ? ", as friction leaves no estimate of its error.\n"
                                       : " (CORRECT=NO).\n");
  }
  if (corrected == 0) {
    return raw + ", as it has no error bar.\n";
  }
  return corrected == all
             ? "The law used K with its estimated error taken out.\n"
             : fmt::format("The law used K with its estimated error taken out at {} of {} "
                           "stations, K as the mesh has it at the others.\n",
                           corrected, all);
}

} // namespace

std::string compared_life_legend(const results::ComparedLife& other) {
  return other.ratio < 0.5 ? fmt::format("{}: 1/{:.2f} of the life", other.what, 1.0 / other.ratio)
                           : fmt::format("{}: {:.2f} times the life", other.what, other.ratio);
}

std::string life_summary(const model::Model& model, const results::RunResult& run) {
  if (!run.growth) {
    return {};
  }
  const results::GrowthResult& growth = *run.growth;
  std::string out;
  for (const std::string& passage : growth.passages) {
    out += passage + ".\n";
  }
  out += fmt::format("Ended by {}: {}.\n", growth.ended, growth.reason);
  const base::OutputUnit life = results::life_unit(model.units, growth);
  out += fmt::format("N = {:.7g} {}", life.from_deck(growth.final_cycles()),
                     life.name == "pass" ? "passes of the spectrum"
                                         : results::life_unit_words(life.name));
  if (growth.unit == "pass") {
    out += life.name == "pass"
               ? ""
               : fmt::format(", {:.7g} passes of the spectrum", growth.final_cycles());
    out += fmt::format(" of {:.7g} cycles, {:.7g} cycles in all; cycles are counted on {}",
                       growth.cycles_per_pass, growth.final_cycles() * growth.cycles_per_pass,
                       growth.counted);
  }
  out += std::isfinite(growth.error)
             ? fmt::format("; error from the number of stations: about {:.2g} % (TOL {:.2g} %)\n",
                           100.0 * growth.error, 100.0 * model.growth->tolerance)
             : "; too few stations to estimate the error from their number\n";
  out += spectrum_summary(model, run);
  out += mesh_words(model, run);
  if (growth.followed) {
    out += history_summary(model, growth);
  }
  out += ratio_words(model, run);
  for (const std::string& sentence : growth.interaction) {
    out += sentence + ".\n";
  }
  for (const results::ComparedLife& other : growth.compared) {
    if (growth.interaction.empty()) { // else there is a table
      out += fmt::format("For comparison, {}.\n", compared_life_legend(other));
    }
  }
  if (!growth.curve.empty()) {
    for (std::size_t i = 0; i < growth.point_names.size(); ++i) {
      out += fmt::format("{}: a = {} at the end\n", growth.point_names[i],
                         model.units.output_length().text(growth.curve.back().a[i], 7));
    }
  }
  out += growth_law_summary(model, growth);
  out += law_K_words(model, run);
  out += growth.corrected
             ? "Sensitivities are those of the first increment unless the deck asks for "
               "more.\n"
             : "Error bars and sensitivities are those of the first increment unless "
               "the deck asks for more.\n";
  return out;
}

} // namespace spricka::report
