// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/vec.hpp"
#include "model/model.hpp"
#include "program/study/deck_answers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace spricka::program {

namespace {

using CheckArguments = std::vector<std::variant<std::string, double>>;

// "MAX" of "S.XX.MAX"; without a point all of it.
std::string_view last_word(const std::string& quantity) {
  return std::string_view(quantity).substr(quantity.rfind('.') + 1);
}

class InSection {
public:
  explicit InSection(const SectionMapping& view) : view_(view) {}

  [[nodiscard]] VariantCheckAndFactor of(const AnswerRequest& answer) const {
    switch (answer.group) {
    case AnswerGroup::K:
      return of_front(answer.check);
    case AnswerGroup::pressure:
      return of_contact(answer.check);
    case AnswerGroup::displacement:
    case AnswerGroup::stress:
      return of_field(answer.check);
    case AnswerGroup::energy:
      return {answer.check, view_.plane.round ? 2.0 * std::numbers::pi / view_.plane.depth() : 1.0};
    default:
      return {};
    }
  }

private:
  // All places of a front are one tip.
  [[nodiscard]] VariantCheckAndFactor of_front(model::ResultCheck check) const {
    const std::string place(last_word(check.quantity));
    const std::size_t from = check.quantity.starts_with("PATH.") ? 5 : 0;
    const std::string mode = check.quantity.substr(from, check.quantity.find('.', from) - from);
    const bool known = mode == "K1" || mode == "K2" || mode == "G";
    const auto* const crack =
        check.arguments.empty() ? nullptr : std::get_if<std::string>(check.arguments.data());
    const auto sign = crack == nullptr ? view_.sign_of_K2.end() : view_.sign_of_K2.find(*crack);
    if (!known || (place != "AT" && place != "MIN" && place != "MAX") ||
        sign == view_.sign_of_K2.end()) {
      return {};
    }
    if (place == "AT") {
      check.arguments.erase(check.arguments.begin() + 1, check.arguments.begin() + 4);
    }
    check.quantity.erase(check.quantity.rfind('.'));
    return {std::move(check), mode == "K2" ? sign->second : 1.0};
  }

  [[nodiscard]] VariantCheckAndFactor of_contact(model::ResultCheck check) const {
    const std::string place(last_word(check.quantity));
    if (place == "NEAR") {
      put_place(check.arguments, 1);
    } else if (place != "MIN" && place != "MAX" && place != "MEAN") {
      return {};
    }
    return {std::move(check), 1.0};
  }

  // "S.XX.AT", "U.Y.MAX": the word in the middle is of components.
  [[nodiscard]] VariantCheckAndFactor of_field(model::ResultCheck check) const {
    if (std::ranges::count(check.quantity, '.') != 2) {
      return {};
    }
    const bool at = last_word(check.quantity) == "AT";
    const std::size_t end = check.quantity.rfind('.');
    for (std::size_t i = check.quantity.find('.') + 1; i < end; ++i) {
      const std::optional<char> own = component(check.quantity[i], at ? &check.arguments : nullptr);
      if (!own) {
        return {};
      }
      check.quantity[i] = *own;
    }
    if (at) {
      put_place(check.arguments, 0);
    }
    return {std::move(check), 1.0};
  }

  // About an axis, radial ones are those of places in a plane of coordinates.
  [[nodiscard]] std::optional<char> component(char c, const CheckArguments* place) const {
    const sense::SectionPlane& plane = view_.plane;
    if (c != 'X' && c != 'Y' && c != 'Z') {
      return std::nullopt;
    }
    const int axis = c - 'X';
    if (axis == plane.space_direction_index(1)) {
      return 'Y';
    }
    if (!plane.round) {
      return axis == plane.space_direction_index(0) ? std::optional('X') : std::nullopt;
    }
    const base::Vec3 x = place == nullptr ? base::Vec3::Zero() : place_of(*place, 0);
    const double radius = plane.section_coordinates(x).x();
    constexpr double askew = 1e-6;
    const bool radial = axis != plane.axis && radius > 0.0 && x[axis] > (1.0 - askew) * radius;
    return radial ? std::optional('X') : std::nullopt;
  }

  static base::Vec3 place_of(const CheckArguments& arguments, std::size_t first) {
    base::Vec3 x = base::Vec3::Zero();
    for (std::size_t d = 0; d < 3 && first + d < arguments.size(); ++d) {
      const auto* const value = std::get_if<double>(&arguments[first + d]);
      x[static_cast<Eigen::Index>(d)] = value == nullptr ? 0.0 : *value;
    }
    return x;
  }

  // x, y, z from `first` on become the two of the section.
  void put_place(CheckArguments& arguments, std::size_t first) const {
    const base::Vec3 x = view_.plane.section_coordinates(place_of(arguments, first));
    arguments[first] = x.x();
    arguments[first + 1] = x.y();
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(first) + 2);
  }

  const SectionMapping& view_;
};

// The largest "U.Y" of a whole that y mirrors is that of a part, or minus its smallest.
bool is_odd_extreme(const AnswerRequest& answer, const std::string& mirrored) {
  const std::string& word = answer.check.quantity;
  const bool directed =
      answer.group == AnswerGroup::displacement || answer.group == AnswerGroup::stress;
  const std::size_t from = word.find('.');
  const std::size_t to = word.rfind('.');
  if (!directed || from == to || (!word.ends_with(".MIN") && !word.ends_with(".MAX"))) {
    return false;
  }
  const std::string component = word.substr(from, to - from);
  return std::ranges::any_of(
      mirrored, [&](char axis) { return std::ranges::count(component, axis) % 2 == 1; });
}

// Of the whole from a part: its energy is the sum of that of all images; of contact arcs, which may
// lie across, and of extremes that change their sign across a plane, nothing is told.
VariantCheckAndFactor in_part(const AnswerRequest& answer, const std::string& mirrored) {
  if (!mirrored.empty() && (answer.group == AnswerGroup::arc || is_odd_extreme(answer, mirrored))) {
    return {};
  }
  const int images = answer.group == AnswerGroup::energy ? 1 << mirrored.size() : 1;
  return {answer.check, 1.0 / images};
}

} // namespace

std::vector<VariantCheckAndFactor>
checks_asked_of_variant(const DeckVariant& variant, const std::vector<AnswerRequest>& answers) {
  std::vector<VariantCheckAndFactor> found;
  found.reserve(answers.size());
  for (const AnswerRequest& answer : answers) {
    found.push_back(variant.section ? InSection(*variant.section).of(answer)
                                    : in_part(answer, variant.mirrored));
  }
  return found;
}

} // namespace spricka::program
