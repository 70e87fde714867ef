// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polyline.hpp"
#include "program/checks/check_line.hpp"
#include "program/checks/check_quantities.hpp"
#include "results/k_quantities.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// "K1" and "AT" of "K1.AT".
struct FrontWord {
  const results::KQuantity* quantity = nullptr;
  std::string_view where; ///< of a front in space; empty: the word is of a tip in the plane
  std::optional<results::SensitivityParameter> by; ///< a derivative: "DK1.LOAD"
  bool on_path = false;                            ///< at a place t of a load path: "PATH.K1"
};

// Of the crack itself: no name tells which.
bool is_of_crack(results::SensitivityParameter cause) {
  return cause == results::SensitivityParameter::length ||
         cause == results::SensitivityParameter::axis;
}

std::optional<results::SensitivityParameter> cause_named(std::string_view word) {
  for (const results::SensitivityParameter cause :
       {results::SensitivityParameter::load, results::SensitivityParameter::fit,
        results::SensitivityParameter::modulus, results::SensitivityParameter::length,
        results::SensitivityParameter::axis}) {
    if (results::display_word(cause) == word) {
      return cause;
    }
  }
  return std::nullopt;
}

constexpr std::string_view of_path = "PATH.";

FrontWord front_word(std::string_view text) {
  static constexpr std::array<std::string_view, 4> places{"AT", "PHI", "MIN", "MAX"};
  FrontWord word;
  word.on_path = text.starts_with(of_path);
  text.remove_prefix(word.on_path ? of_path.size() : 0);
  const std::size_t point = text.rfind('.');
  const std::string_view last = point == std::string_view::npos ? "" : text.substr(point + 1);
  if (std::ranges::find(places, last) != places.end()) {
    word.where = last;
    text = text.substr(0, point);
  }
  const bool derivative = !word.on_path && text.starts_with("DK");
  if (derivative) { // "DK1.LOAD"
    word.by = text.find('.') == 3 ? cause_named(text.substr(4)) : std::nullopt;
    if (!word.by || word.where == "MIN" || word.where == "MAX") {
      return {};
    }
    text = text.substr(1, 2);
  }
  word.quantity = results::find_k_quantity(text, word.where.empty() ? 2 : 3);
  const bool of_K_alone = word.on_path || derivative;
  return word.quantity != nullptr && (word.quantity->is_k() || !of_K_alone) ? word : FrontWord{};
}

using Fronts = std::vector<results::FrontResult>;

// Why there is none of that name.
std::string missing_front(const Fronts& all, const FrontWord& word, const std::string& crack) {
  if (!word.where.empty()) {
    return fmt::format("no front of {}", crack);
  }
  const bool two =
      !word.by && !word.on_path && std::ranges::any_of(all, [&](const results::FrontResult& front) {
        return front.is_tip() && front.name == crack + ".1";
      });
  return two ? fmt::format("crack {0} has two tips: {0}.1 and {0}.2", crack)
             : fmt::format("no tip {}", crack);
}

// The tip of that name; in space fronts of the crack, one, or NAME.1, NAME.2 and so on.
Fronts fronts_of(const Fronts& all, const FrontWord& word, const std::string& crack) {
  const bool tip = word.where.empty();
  Fronts fronts;
  for (const results::FrontResult& front : all) {
    if (front.is_tip() == tip &&
        (front.name == crack || (!tip && front.name.starts_with(crack + ".")))) {
      fronts.push_back(front);
    }
  }
  if (fronts.empty()) {
    throw MissingQuantity(missing_front(all, word, crack));
  }
  for (const results::FrontResult& front : fronts) {
    const bool has_it =
        front.two_materials && word.quantity->given == results::KQuantityCondition::always;
    if (!front.invalid_reason.empty() && !has_it) {
      throw MissingQuantity(front.invalid_reason);
    }
  }
  return fronts;
}

void refuse_without_bar(const Fronts& fronts, const results::KQuantity& quantity) {
  for (const results::FrontResult& front : fronts) {
    if (quantity.given == results::KQuantityCondition::with_bar && !front.has_error_bar()) {
      throw MissingQuantity(front.is_tip() ? "no error bar: " + front.missing_bar_reason
                                           : fmt::format("K of {} has no error bar: {}", front.name,
                                                         front.missing_bar_reason));
    }
  }
}

double extreme(const Fronts& fronts, const FrontWord& word) {
  const double sign = word.where == "MAX" ? 1.0 : -1.0;
  std::optional<double> best;
  for (const results::FrontResult& front : fronts) {
    for (const results::FrontPointResult& place : front.points) {
      const double value = sign * word.quantity->extract_value(front, place);
      if (!place.at_surface && (!best || value > *best)) {
        best = value;
      }
    }
  }
  if (!best) {
    throw MissingQuantity("the front has no point within the body");
  }
  return sign * *best;
}

// Where fronts are nearest to a place.
struct NearestFrontPlace {
  const results::FrontResult* front = nullptr;
  base::Vec3 x;
  double away = std::numeric_limits<double>::max();
  double length = 0.0; ///< of the front
};

NearestFrontPlace nearest_of(const Fronts& fronts, const base::Vec3& x) {
  NearestFrontPlace nearest;
  for (const results::FrontResult& front : fronts) {
    std::vector<base::Vec3> line;
    for (const results::FrontPointResult& place : front.points) {
      line.push_back(place.x);
    }
    if (front.is_loop) {
      line.push_back(line.front());
    }
    const geometry::NearestPolylinePoint on = geometry::nearest_point(x, line);
    if (on.distance < nearest.away) {
      nearest = {&front, on.interpolate(line), on.distance, geometry::polyline_length(line)};
    }
  }
  return nearest;
}

double at_place(const Fronts& fronts, const FrontWord& word, const base::Vec3& x) {
  return results::front_value_near(*nearest_of(fronts, x).front, *word.quantity, x);
}

double at_angle(const Fronts& fronts, const FrontWord& word, double phi) {
  for (const results::FrontResult& front : fronts) {
    if (!front.has_angles) {
      throw MissingQuantity(fmt::format("{} is no ellipse: its points have no angle", front.name));
    }
    if (const auto value = results::front_value_at_angle(front, *word.quantity, phi)) {
      return *value;
    }
  }
  throw MissingQuantity(
      fmt::format("the front has no point at {:.6g} degrees", phi * 180.0 / std::numbers::pi));
}

// The place of t on the path.
Fronts fronts_at(const results::LoadPathResult& path, double t) {
  Fronts fronts;
  for (const results::LoadPathFront& along : path.fronts) {
    results::FrontResult& front = fronts.emplace_back(along.at(t));
    // That a tip is in doubt on the whole path comes first.
    if (front.invalid_reason.empty() || !front.is_tip()) {
      const std::string overlap = invalid_k1_reason(front);
      front.invalid_reason = overlap.empty() ? front.invalid_reason : overlap;
    }
  }
  return fronts;
}

// Why there is no one derivative of K1, K2 or K3.
std::string missing_derivative(const results::FrontResult& front, const results::Sensitivity& by,
                               std::size_t mode) {
  if (!front.is_tip()) {
    return "the contact changes at this very state: there are two derivatives";
  }
  return by.below.empty() || by.above.empty()
             ? "on one side of this state nothing holds a body"
             : fmt::format("the contact changes at this very state: {:.7g} below, {:.7g} above",
                           by.value * by.below.front()[mode], by.value * by.above.front()[mode]);
}

// Value times derivative in the place of K. At a change of contact there are two of them and no
// answer.
results::FrontResult derivative_of(const results::FrontResult& front, const FrontWord& word,
                                   const std::string& name) {
  const auto& all = front.sensitivities.by_parameter;
  // Every front has the derivatives by the axes of all ellipses: its own crack's are asked for.
  const auto named = [&](const results::Sensitivity& s) {
    return is_of_crack(*word.by) ? front.name == s.name || front.name.starts_with(s.name + ".")
                                 : s.name == name;
  };
  const auto by = std::ranges::find_if(
      all, [&](const results::Sensitivity& s) { return s.cause == *word.by && named(s); });
  if (by == all.end()) {
    throw MissingQuantity(
        front.sensitivities.notes.empty()
            ? fmt::format("{} has no value in that step",
                          is_of_crack(*word.by) ? "the size of " + front.name : name)
            : front.sensitivities.notes.front());
  }
  if (!by->is_smooth()) {
    throw MissingQuantity(
        missing_derivative(front, *by, static_cast<std::size_t>(word.quantity->mode)));
  }
  results::FrontResult out = front;
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    results::FrontPointResult& place = out.points[i];
    place.K1 = by->value * by->below[i][0];
    place.K2 = by->value * by->below[i][1];
    place.K3 = by->value * by->below[i][2];
    place.smooth = {place.K1, place.K2, place.K3};
  }
  return out;
}

// What a line asks of fronts.
struct Asked {
  FrontWord word;
  base::Vec3 x = base::Vec3::Zero();
  double phi = 0.0;
  Fronts fronts; ///< with derivatives in the place of K where these are asked for
};

Asked asked_of(const std::string& text, CheckArguments& args, const results::RunResult& run) {
  Asked asked;
  asked.word = front_word(text);
  const FrontWord& word = asked.word;
  const std::string crack = args.required_name("a crack");
  if (word.where == "AT") {
    asked.x = args.required_point(3);
  }
  const std::string name = args.required_name(word.on_path ? "a load path" : "a step");
  const double t = word.on_path ? args.required_number("a place t") : 0.0;
  const bool named = word.by && !is_of_crack(*word.by);
  // K of a tip has a derivative by the length of each tip; empty: that of the crack.
  const std::string by = named ? args.required_name("a name") : word.where.empty() ? crack : "";
  asked.phi = word.where == "PHI" ? args.required_number("an angle") : 0.0;
  const std::optional<double> a = args.optional_number();
  asked.fronts =
      word.on_path
          ? fronts_of(fronts_at(find_load_path(run, name, t, a), t), word, crack)
          : fronts_of(find_checked_increment_and_step(run, name, a).step->fronts, word, crack);
  refuse_without_bar(asked.fronts, *word.quantity);
  for (results::FrontResult& front : asked.fronts) {
    if (word.by) {
      front = derivative_of(front, word, by);
    }
  }
  return asked;
}

// A front is about where a place is asked for within this part of its length: K changes along the
// whole of it.
constexpr double about = 0.05;

} // namespace

bool is_front_quantity(std::string_view word) {
  return front_word(word).quantity != nullptr;
}

std::string error_bar_part_quantity_word(std::string_view word, std::string_view part) {
  const FrontWord of = front_word(word);
  if (of.quantity == nullptr || !of.quantity->is_k() || of.by || of.on_path) {
    return {};
  }
  return fmt::format("{}.{}{}{}", of.quantity->name, part, of.where.empty() ? "" : ".", of.where);
}

double evaluate_front_quantity(CheckLine& line) {
  const Asked asked = asked_of(line.word, line.args, line.run);
  if (asked.word.where.empty()) {
    return asked.word.quantity->extract_value(asked.fronts.front());
  }
  if (asked.word.where == "AT") {
    return at_place(asked.fronts, asked.word, asked.x);
  }
  return asked.word.where == "PHI" ? at_angle(asked.fronts, asked.word, asked.phi)
                                   : extreme(asked.fronts, asked.word);
}

std::optional<std::string> far_from_front_warning(const model::ResultCheck& check,
                                                  const std::string& unit,
                                                  const results::RunResult& run) {
  if (front_word(check.quantity).where != "AT") {
    return std::nullopt;
  }
  try {
    CheckArguments args(check);
    const Asked asked = asked_of(check.quantity, args, run);
    const NearestFrontPlace nearest = nearest_of(asked.fronts, asked.x);
    if (!(nearest.away > about * nearest.length)) {
      return std::nullopt;
    }
    return fmt::format("the nearest place of front {} is {:.3g} {} from there, at {:.6g} {:.6g} "
                       "{:.6g}: is it the place that is meant?",
                       nearest.front->name, nearest.away, unit, nearest.x.x(), nearest.x.y(),
                       nearest.x.z());
  } catch (const MissingQuantity&) { // said where the value is read
    return std::nullopt;
  }
}

} // namespace spricka::program
