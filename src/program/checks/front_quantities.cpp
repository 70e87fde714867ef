// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/checks/front_quantities.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// "K1" and "AT" of "K1.AT".
struct FrontWord {
  const results::FrontQuantity* quantity = nullptr;
  std::string_view where;
};

FrontWord front_word(std::string_view word) {
  const std::size_t point = word.find('.');
  if (point == std::string_view::npos) {
    return {};
  }
  const results::FrontQuantity* quantity = results::find_front_quantity(word.substr(0, point));
  const std::string_view where = word.substr(point + 1);
  const bool known = where == "AT" || where == "PHI" || where == "MIN" || where == "MAX";
  return quantity != nullptr && quantity->checked && known ? FrontWord{quantity, where}
                                                           : FrontWord{};
}

// Fronts of a crack: one, or NAME.1, NAME.2 and so on.
std::vector<const results::FrontResult*> fronts_of(const results::StepResult& step,
                                                   const std::string& crack) {
  std::vector<const results::FrontResult*> fronts;
  for (const results::FrontResult& front : step.fronts) {
    if (front.name == crack || front.name.starts_with(crack + ".")) {
      fronts.push_back(&front);
    }
  }
  if (fronts.empty()) {
    throw Missing(fmt::format("no front of {}", crack));
  }
  for (const results::FrontResult* front : fronts) {
    if (!front->doubt.empty()) {
      throw Missing(front->doubt);
    }
  }
  return fronts;
}

double extreme(const std::vector<const results::FrontResult*>& fronts, const FrontWord& word) {
  const double sign = word.where == "MAX" ? 1.0 : -1.0;
  std::optional<double> best;
  for (const results::FrontResult* front : fronts) {
    for (const results::FrontPlace& place : front->points) {
      const double value = sign * word.quantity->of(place);
      if (!place.at_surface && (!best || value > *best)) {
        best = value;
      }
    }
  }
  if (!best) {
    throw Missing("the front has no point within the body");
  }
  return sign * *best;
}

double at_place(const std::vector<const results::FrontResult*>& fronts, const FrontWord& word,
                const base::Vec3& x) {
  const auto away = [&](const results::FrontResult* front) {
    const auto nearest = std::ranges::min_element(
        front->points, {}, [&](const results::FrontPlace& p) { return (p.x - x).norm(); });
    return (nearest->x - x).norm();
  };
  return results::front_value_near(**std::ranges::min_element(fronts, {}, away), *word.quantity, x);
}

double at_angle(const std::vector<const results::FrontResult*>& fronts, const FrontWord& word,
                double phi) {
  for (const results::FrontResult* front : fronts) {
    if (!front->angles) {
      throw Missing(fmt::format("{} is no ellipse: its points have no angle", front->name));
    }
    if (const auto value = results::front_value_at_angle(*front, *word.quantity, phi)) {
      return *value;
    }
  }
  throw Missing(
      fmt::format("the front has no point at {:.6g} degrees", phi * 180.0 / std::numbers::pi));
}

} // namespace

bool is_front_quantity(std::string_view word) {
  return front_word(word).quantity != nullptr;
}

double front_quantity(const std::string& text, Arguments& args, const results::Run& run) {
  const FrontWord word = front_word(text);
  const std::string crack = args.name("a crack");
  base::Vec3 x = base::Vec3::Zero();
  if (word.where == "AT") {
    x = {args.needed("x"), args.needed("y"), args.needed("z")};
  }
  const std::string step = args.name("a step");
  const double phi = word.where == "PHI" ? args.needed("an angle") : 0.0;
  const auto fronts = fronts_of(*find_place(run, step, args.number()).step, crack);
  if (word.where == "AT") {
    return at_place(fronts, word, x);
  }
  return word.where == "PHI" ? at_angle(fronts, word, phi) : extreme(fronts, word);
}

} // namespace spricka::program
