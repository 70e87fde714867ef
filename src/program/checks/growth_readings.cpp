// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_measure.hpp"
#include "geometry/cubic_spline.hpp"
#include "life/inversion.hpp"
#include "life/life_curve.hpp"
#include "model/model.hpp"
#include "program/checks/check_line.hpp"
#include "program/checks/check_quantities.hpp"
#include "results/half_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

// The test's own rates, or the law of $GROW.
life::GrowthRateLaw reference_of(const model::Model& model, const model::GrowthTestReadings& test) {
  return test.reference.delta_k.empty()
             ? analysis::growth_law(*model.growth)
             : life::GrowthRateLaw(model::CrackGrowthLaw::table, test.reference);
}

/// K that was computed at a length.
struct AtLength {
  std::string tip;
  double a = 0.0, K1 = 0.0;
  double other = 0.0; ///< in space the other half axis, 0 where the front has none
};

// Of the end of the axis that is read, the first of two; a length of an axis with two ends is half
// of what they span.
std::optional<AtLength> on_axis(const results::LoadStepResult& at, const model::Model& model,
                                const model::GrowthTestReadings& test) {
  const model::CrackDefinition& crack = model.cracks[test.crack.index()];
  for (const results::FrontResult& front : at.fronts) {
    if (results::find_crack_by_front(model, front.name) != &crack ||
        !front.invalid_reason.empty()) {
      continue;
    }
    std::vector<base::Vec3> points;
    for (const results::FrontPointResult& place : front.points) {
      points.push_back(place.x);
    }
    const std::vector<results::FrontAxisEnd> ends =
        results::find_front_axis_ends(crack, points, front.is_loop);
    const auto end = std::ranges::find(ends, !test.on_c, &results::FrontAxisEnd::on_a);
    if (end != ends.end()) {
      const auto [a, c] = results::half_axes(ends);
      return AtLength{.tip = end->tip,
                      .a = test.on_c ? c : a,
                      .K1 = end->interpolate(front.points[end->from].smooth[0],
                                             front.points[end->to].smooth[0]),
                      .other = test.on_c ? a : c};
    }
  }
  return std::nullopt;
}

// Of a tip, the first of two; in space of a place of the front. Empty where its K is none.
std::optional<AtLength> found_at(const results::CrackLengthResult& increment, base::StepId step,
                                 const model::Model& model, const model::GrowthTestReadings& test) {
  const results::LoadStepResult* at = results::find_step(increment, model.steps[step.index()].name);
  if (at == nullptr) {
    return std::nullopt;
  }
  const std::string& crack = model.cracks[test.crack.index()].name;
  const results::FrontResult* tip = results::find_front(*at, crack);
  tip = tip != nullptr ? tip : results::find_front(*at, crack + ".1");
  if (tip == nullptr || !tip->is_tip()) {
    return on_axis(*at, model, test);
  }
  return tip->invalid_reason.empty()
             ? std::optional(AtLength{.tip = tip->name, .a = tip->a, .K1 = tip->single_point().K1})
             : std::nullopt;
}

/// K and R of the increments between their lengths.
class ComputedK {
public:
  ComputedK(const model::Model& model, const results::RunResult& run,
            const model::GrowthTestReadings& test) {
    const model::CrackGrowthSettings& growth = *model.growth;
    std::vector<std::array<double, 4>> found; // log a, log K, R, other half axis
    for (const results::CrackLengthResult& increment : run.increments) {
      const std::optional<AtLength> high = found_at(increment, growth.kmax, model, test);
      if (!high || !(high->K1 > 0.0)) {
        continue;
      }
      tip_ = high->tip;
      double R = test.ratio.value_or(k_nan);
      if (!test.ratio) {
        const std::optional<AtLength> low = found_at(increment, growth.kmin, model, test);
        R = low ? low->K1 / high->K1 : k_nan;
      }
      if (!std::isnan(R)) {
        found.push_back({std::log(high->a), std::log(high->K1), R, high->other});
      }
    }
    std::ranges::sort(found);
    for (const auto& [a, K, R, other] : found) {
      // Splines want lengths that rise: of equal ones the first counts.
      if (log_a_.empty() || a > log_a_.back()) {
        log_a_.push_back(a);
        log_K_.push_back(K);
        R_.push_back(R);
        other_.push_back(other);
      }
    }
    constant_ = test.ratio;
  }

  [[nodiscard]] const std::string& tip() const { return tip_; }
  /// Lengths, ascending, and K.
  [[nodiscard]] std::vector<std::array<double, 2>> points() const {
    std::vector<std::array<double, 2>> all;
    all.reserve(log_a_.size());
    for (std::size_t i = 0; i < log_a_.size(); ++i) {
      all.push_back({std::exp(log_a_[i]), std::exp(log_K_[i])});
    }
    return all;
  }
  /// The other half axis at a length.
  [[nodiscard]] double other(double a) const { return at(a) ? value(other_, a) : k_nan; }
  /// The life by these K; empty where some of them do not grow, or have no end.
  [[nodiscard]] std::optional<life::LifeCurve> curve(const life::GrowthRateLaw& law) const {
    std::vector<double> lengths, rates;
    for (std::size_t i = 0; i < log_a_.size(); ++i) {
      const double K = std::exp(log_K_[i]);
      lengths.push_back(std::exp(log_a_[i]));
      // The law takes K at the largest and the smallest load.
      rates.push_back(law.growth_rate(K, R_[i] * K, {lengths.back()}));
    }
    const bool grows =
        std::ranges::all_of(rates, [](double rate) { return rate > 0.0 && std::isfinite(rate); });
    return grows && rates.size() > 1 ? std::optional(life::LifeCurve(lengths, rates))
                                     : std::nullopt;
  }
  [[nodiscard]] double K(double a) const { return at(a) ? std::exp(value(log_K_, a)) : k_nan; }
  [[nodiscard]] double R(double a) const {
    return constant_ ? *constant_ : at(a) ? value(R_, a) : k_nan;
  }

private:
  [[nodiscard]] bool at(double a) const {
    constexpr double room = 1e-9; // lengths of deck and mesh are rounded
    return !log_a_.empty() && std::log(a) >= log_a_.front() - room &&
           std::log(a) <= log_a_.back() + room;
  }
  [[nodiscard]] double value(const std::vector<double>& values, double a) const {
    // Over log a: K goes much like a power of the length.
    return log_a_.size() == 1 ? values.front()
                              : geometry::CubicSpline<double>(log_a_, values).value(std::log(a));
  }

  std::string tip_;
  std::vector<double> log_a_, log_K_, R_, other_;
  std::optional<double> constant_;
};

std::string word_of(const model::GrowthTestReadings& test) {
  switch (test.method) {
  case model::TestRateMethod::secant:
    return "SECANT";
  case model::TestRateMethod::e647:
    return fmt::format("E647, {} readings", test.window);
  case model::TestRateMethod::spline:
    return "SPLINE";
  case model::TestRateMethod::polynomial:
    break;
  }
  return fmt::format("POLYNOMIAL, {} readings", test.window);
}

std::string reference_words(const model::Model& model, const model::GrowthTestReadings& test) {
  constexpr std::array names{
      "", "Paris", "Walker", "Forman", "NASGRO", "table", "Hartman and Schijve"};
  return test.reference.delta_k.empty()
             ? fmt::format("{} law of $GROW", names[static_cast<std::size_t>(model.growth->law)])
             : fmt::format("{} rates of a reference specimen", test.reference.delta_k.size());
}

// Cycles over the lengths that test and computation share.
void compare_lives(const ComputedK& computed, const life::GrowthRateLaw& law,
                   results::GrowthTestResult& test) {
  std::vector<const results::GrowthTestPoint*> shared;
  for (const results::GrowthTestPoint& p : test.points) {
    if (!std::isnan(p.computed) && (shared.empty() || p.a > shared.back()->a)) {
      shared.push_back(&p);
    }
  }
  const std::optional<life::LifeCurve> curve = computed.curve(law);
  test.cycles = test.computed_cycles = test.cycles_error = k_nan;
  if (shared.size() < 2 || !curve) {
    return;
  }
  // Lengths of the test may lie beyond the curve by the round-off that K(a) lets pass.
  const auto within = [&](double a) {
    return std::clamp(a, curve->first_length(), curve->last_length());
  };
  const double from = within(shared.front()->a);
  const double to = within(shared.back()->a);
  test.cycles = shared.back()->cycles - shared.front()->cycles;
  test.computed_cycles = curve->cycles(from, to);
  test.cycles_error = curve->cycles_error(from, to);
}

// What is missing in the points, counted.
void add_notes(results::GrowthTestResult& test) {
  const auto count = [&](auto&& condition) {
    return std::ranges::count_if(test.points, condition);
  };
  const auto outside = count([](const auto& p) { return std::isnan(p.computed); });
  const auto none = count([](const auto& p) { return std::isnan(p.K) && !std::isnan(p.R); });
  const auto beyond = count([](const auto& p) { return !std::isnan(p.K) && !p.covered; });
  if (outside > 0) {
    test.notes.push_back(results::make_note(fmt::format(
        "{} of {} points lie outside the computed crack lengths: there is nothing to compare with",
        outside, test.points.size())));
  }
  if (none > 0) {
    test.notes.push_back(results::questionable_input_note(
        fmt::format("{} of {} points have a rate that no K of the reference gives (scatter made it "
                    "negative, or it is below the threshold); they are left out",
                    none, test.points.size())));
  }
  if (beyond > 0) {
    test.notes.push_back(results::questionable_input_note(
        fmt::format("{} of {} points have a rate beyond the rows of the "
                    "reference, which was drawn straight on",
                    beyond, test.points.size())));
  }
}

// Where both half axes were read, K is of the shape that was computed.
void compare_shapes(const ComputedK& computed, const model::GrowthTestReadings& card,
                    results::GrowthTestResult& test) {
  constexpr double alike = 0.05;
  double most = 0.0;
  double where = 0.0;
  for (std::size_t i = 0; i < card.other.size(); ++i) {
    const double a = card.readings[i][1];
    const double off = card.other[i] / computed.other(a) - 1.0;
    if (std::isfinite(off) && std::abs(off) > std::abs(most)) {
      most = off;
      where = a;
    }
  }
  if (std::abs(most) > alike) {
    test.notes.push_back(results::questionable_input_note(fmt::format(
        "the crack that was read has another shape than the one that was computed: at {} = {:.4g} "
        "its {} is {:+.0f} % off. K is of the computed shape",
        card.on_c ? "c" : "a", where, card.on_c ? "a" : "c", 100.0 * most)));
  }
}

results::GrowthTestResult invert(const model::Model& model, const results::RunResult& run,
                                 const model::GrowthTestReadings& card) {
  const ComputedK computed(model, run, card);
  results::GrowthTestResult test;
  test.name = card.name;
  test.tip = computed.tip();
  test.method = word_of(card);
  test.reference = reference_words(model, card);
  test.readings = card.readings;
  test.computed = computed.points();
  std::vector<life::CrackReading> readings;
  for (const auto& [cycles, a] : card.readings) {
    readings.push_back({cycles, a});
  }
  const life::MeasuredGrowthRates rates =
      life::compute_growth_rates(readings, card.method, card.window);
  test.scatter = rates.scatter;
  test.freedoms = rates.freedoms;
  const life::GrowthRateLaw reference = reference_of(model, card);
  for (const life::InferredK& k :
       life::infer_K_from_growth(rates, reference, [&](double a) { return computed.R(a); })) {
    test.points.push_back({.cycles = k.cycles,
                           .a = k.a,
                           .rate = k.rate,
                           .rate_low = k.rate_low,
                           .rate_high = k.rate_high,
                           .R = k.R,
                           .K = k.K_max,
                           .low = k.low,
                           .high = k.high,
                           .computed = computed.K(k.a),
                           .covered = k.covered});
  }
  compare_lives(computed, reference, test);
  add_notes(test);
  compare_shapes(computed, card, test);
  return test;
}

const results::GrowthTestResult& test_of(const results::RunResult& run, const std::string& name) {
  const auto found = std::ranges::find(run.tests, name, &results::GrowthTestResult::name);
  if (found == run.tests.end()) {
    throw MissingQuantity(fmt::format("no test {}", name));
  }
  return *found;
}

} // namespace

std::vector<results::GrowthTestResult> find_K_from_growth_tests(const model::Model& model,
                                                                const results::RunResult& run) {
  std::vector<results::GrowthTestResult> tests;
  for (const model::GrowthTestReadings& card : model.tests) {
    tests.push_back(invert(model, run, card));
  }
  return tests;
}

double evaluate_growth_test_quantity(CheckLine& line) {
  auto& [model, run, quantity, args] = line;
  const results::GrowthTestResult& test = test_of(run, args.required_name("a test"));
  if (quantity == "TEST.SCATTER") {
    return test.scatter;
  }
  if (quantity == "TEST.K") {
    const double a = args.required_number("a crack length");
    const double K = results::measured_k_at(test, a);
    if (std::isnan(K)) {
      throw MissingQuantity(fmt::format("test {} has no K at a = {:.6g}", test.name, a));
    }
    return K;
  }
  if (quantity == "TEST.LIFE") {
    if (std::isnan(test.life_ratio())) {
      throw MissingQuantity(
          fmt::format("test {} shares no lengths with the computed K", test.name));
    }
    return test.life_ratio();
  }
  const double from = args.optional_number().value_or(0.0);
  const double to = args.optional_number().value_or(std::numeric_limits<double>::infinity());
  const results::GrowthTestComparison found = results::compare_test_k(test, from, to);
  if (found.points == 0) {
    throw MissingQuantity(
        fmt::format("test {} has no point there with a measured and a computed K", test.name));
  }
  return quantity == "TEST.RMS"      ? found.rms
         : quantity == "TEST.INSIDE" ? found.inside
                                     : found.ratio;
}

} // namespace spricka::program
