// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/checks/front_quantities.hpp"

#include "mesh/polyline.hpp"
#include "program/checks/path_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// "K1" and "AT" of "K1.AT".
struct FrontWord {
  const results::FrontQuantity* quantity = nullptr;
  std::string_view where;
  std::optional<results::SensitivityParameter> by; ///< a derivative: "DK1.LOAD.AT"
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

// "DK1.LOAD" of "DK1.LOAD.AT".
FrontWord derivative_word(std::string_view of, std::string_view where) {
  const std::size_t point = of.find('.');
  if (point != 3 || (where != "AT" && where != "PHI")) {
    return {};
  }
  const std::optional<results::SensitivityParameter> by = cause_named(of.substr(point + 1));
  return by ? FrontWord{results::find_front_quantity(of.substr(1, 2)), where, by} : FrontWord{};
}

// On load paths there are K1, K2 and K3.
constexpr std::string_view of_path = "PATH.";

FrontWord front_word(std::string_view text) {
  const bool on_path = text.starts_with(of_path);
  const std::string_view word = on_path ? text.substr(of_path.size()) : text;
  const std::size_t point = word.rfind('.');
  if (point == std::string_view::npos) {
    return {};
  }
  const std::string_view where = word.substr(point + 1);
  if (!on_path && word.starts_with("DK")) {
    return derivative_word(word.substr(0, point), where);
  }
  const results::FrontQuantity* quantity = results::find_front_quantity(word.substr(0, point));
  const bool known = where == "AT" || where == "PHI" || where == "MIN" || where == "MAX";
  const bool follows = quantity != nullptr && (!on_path || quantity->name[0] == 'K');
  return follows && quantity->checked && known ? FrontWord{quantity, where, {}} : FrontWord{};
}

using Fronts = std::vector<const results::FrontResult*>;

// Fronts of a crack: one, or NAME.1, NAME.2 and so on.
Fronts fronts_of(const std::vector<results::FrontResult>& all, const std::string& crack) {
  Fronts fronts;
  for (const results::FrontResult& front : all) {
    if (front.name == crack || front.name.starts_with(crack + ".")) {
      fronts.push_back(&front);
    }
  }
  if (fronts.empty()) {
    throw MissingQuantity(fmt::format("no front of {}", crack));
  }
  for (const results::FrontResult* front : fronts) {
    if (!front->invalid_reason.empty()) {
      throw MissingQuantity(front->invalid_reason);
    }
  }
  return fronts;
}

void refuse_without(const Fronts& fronts, const results::FrontQuantity& quantity) {
  for (const results::FrontResult* front : fronts) {
    if (quantity.given == nullptr || quantity.given(*front)) {
      continue;
    }
    throw MissingQuantity(
        quantity.inside ? fmt::format("K of {} has no error bar: {}", front->name, front->no_bar)
                        : fmt::format("{} has no {}", front->name, quantity.name));
  }
}

double extreme(const Fronts& fronts, const FrontWord& word) {
  const double sign = word.where == "MAX" ? 1.0 : -1.0;
  std::optional<double> best;
  for (const results::FrontResult* front : fronts) {
    for (const results::FrontPointResult& place : front->points) {
      const double value = sign * word.quantity->extract_value(place);
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

double length_of(const std::vector<base::Vec3>& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    length += (line[i + 1] - line[i]).norm();
  }
  return length;
}

NearestFrontPlace nearest_of(const Fronts& fronts, const base::Vec3& x) {
  NearestFrontPlace nearest;
  for (const results::FrontResult* front : fronts) {
    std::vector<base::Vec3> line;
    for (const results::FrontPointResult& place : front->points) {
      line.push_back(place.x);
    }
    if (front->closed) {
      line.push_back(line.front());
    }
    const mesh::PolylinePosition on = mesh::nearest_on(line, x);
    if (on.distance < nearest.away) {
      nearest = {front, on.interpolate(line), on.distance, length_of(line)};
    }
  }
  return nearest;
}

double at_place(const Fronts& fronts, const FrontWord& word, const base::Vec3& x) {
  return results::front_value_near(*nearest_of(fronts, x).front, *word.quantity, x);
}

double at_angle(const Fronts& fronts, const FrontWord& word, double phi) {
  for (const results::FrontResult* front : fronts) {
    if (!front->angles) {
      throw MissingQuantity(fmt::format("{} is no ellipse: its points have no angle", front->name));
    }
    if (const auto value = results::front_value_at_angle(*front, *word.quantity, phi)) {
      return *value;
    }
  }
  throw MissingQuantity(
      fmt::format("the front has no point at {:.6g} degrees", phi * 180.0 / std::numbers::pi));
}

} // namespace

bool is_front_quantity(std::string_view word) {
  return front_word(word).quantity != nullptr;
}

namespace {

// K1 < 0 is no answer, as at the end of a step; the place of t on the path.
std::vector<results::FrontResult> fronts_at(const results::LoadPathResult& path, double t) {
  std::vector<results::FrontResult> fronts;
  for (const results::LoadPathFront& front : path.fronts) {
    fronts.push_back(front.at(t));
    for (const results::FrontPointResult& place : fronts.back().points) {
      const double other = std::max(std::abs(place.K2), std::abs(place.K3));
      if (!place.at_surface && place.K1 < 0.0 && std::abs(place.K1) > 1e-2 * other) {
        fronts.back().invalid_reason =
            "K1 is negative at some points there: the crack faces overlap";
      }
    }
  }
  return fronts;
}

} // namespace

namespace {

// Value times derivative in the place of K. At a change of contact there are two of them and no
// answer.
results::FrontResult derivative_of(const results::FrontResult& front,
                                   results::SensitivityParameter cause, const std::string& name) {
  const auto& all = front.sensitivities.of;
  // Every front has the derivatives by the axes of all ellipses: its own crack's are asked for.
  const auto named = [&](const results::FrontSensitivity& s) {
    return is_of_crack(cause) ? front.name == s.name || front.name.starts_with(s.name + ".")
                              : s.name == name;
  };
  const auto it = std::ranges::find_if(
      all, [&](const results::FrontSensitivity& s) { return s.cause == cause && named(s); });
  if (it == all.end()) {
    throw MissingQuantity(front.sensitivities.notes.empty()
                              ? fmt::format("{} has no value in that step",
                                            is_of_crack(cause) ? "the size of " + front.name : name)
                              : front.sensitivities.notes.front());
  }
  if (!it->is_smooth()) {
    throw MissingQuantity("the contact changes at this very state: there are two derivatives");
  }
  results::FrontResult out = front;
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    results::FrontPointResult& place = out.points[i];
    place.K1 = it->value * it->above[i][0];
    place.K2 = it->value * it->above[i][1];
    place.K3 = it->value * it->above[i][2];
    place.smooth = {place.K1, place.K2, place.K3};
  }
  return out;
}

// What a line asks of fronts.
struct Asked {
  FrontWord word;
  base::Vec3 x = base::Vec3::Zero();
  double phi = 0.0;
  std::vector<results::FrontResult> own; ///< made for this line: of a load path, derivatives
  Fronts fronts;
};

Asked asked_of(const std::string& text, CheckArguments& args, const results::RunResult& run) {
  const bool on_path = text.starts_with(of_path);
  Asked asked;
  asked.word = front_word(text);
  const FrontWord& word = asked.word;
  const std::string crack = args.next_name("a crack");
  if (word.where == "AT") {
    asked.x = {args.required_number("x"), args.required_number("y"), args.required_number("z")};
  }
  const std::string name = args.next_name(on_path ? "a load path" : "a step");
  const double t = on_path ? args.required_number("a place t") : 0.0;
  const bool named = word.by && !is_of_crack(*word.by);
  const std::string by = named ? args.next_name("a name") : std::string();
  asked.phi = word.where == "PHI" ? args.required_number("an angle") : 0.0;
  const std::optional<double> a = args.next_number();
  if (on_path) {
    asked.own = fronts_at(find_load_path(run, name, t, a), t);
  }
  asked.fronts =
      fronts_of(on_path ? asked.own : find_checked_step(run, name, a).step->fronts, crack);
  if (!word.by) {
    refuse_without(asked.fronts, *word.quantity);
    return asked;
  }
  std::vector<results::FrontResult> derivatives; // `fronts` may point into `own`
  for (const results::FrontResult* front : asked.fronts) {
    derivatives.push_back(derivative_of(*front, *word.by, by));
  }
  asked.own = std::move(derivatives);
  asked.fronts = fronts_of(asked.own, crack);
  return asked;
}

// A front is about where a place is asked for within this part of its length: K changes along the
// whole of it.
constexpr double about = 0.05;

} // namespace

double front_quantity(const std::string& text, CheckArguments& args,
                      const results::RunResult& run) {
  const Asked asked = asked_of(text, args, run);
  if (asked.word.where == "AT") {
    return at_place(asked.fronts, asked.word, asked.x);
  }
  return asked.word.where == "PHI" ? at_angle(asked.fronts, asked.word, asked.phi)
                                   : extreme(asked.fronts, asked.word);
}

std::optional<std::string> far_from_front(const model::ResultCheck& check, const std::string& unit,
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
