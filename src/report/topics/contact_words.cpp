// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/contact_words.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/round_off.hpp"
#include "report/topics/figures.hpp"
#include "results/shown_step.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace spricka::report {
namespace {

using results::ContactPoint;
using results::ContactResult;

constexpr int sectors_of_turn = 36;

double degrees(double angle) {
  return angle * degrees_per_radian;
}

/// Area of the surface between solids [length^2].
double surface_area(const ContactResult& contact) {
  double area = 0.0;
  const auto corner = [&](std::size_t k) -> const base::Vec3& {
    return contact.points[static_cast<std::size_t>(contact.corners[k])].x;
  };
  for (std::size_t k = 0; k + 2 < contact.corners.size(); k += 3) {
    area += 0.5 * (corner(k + 1) - corner(k)).cross(corner(k + 2) - corner(k)).norm();
  }
  return area;
}

/// The longest stretch of angles at which no point of a surface round an axis is closed [rad];
/// empty: there is none.
std::optional<std::array<double, 2>> open_arc(const ContactResult& contact) {
  constexpr double sector = 360.0 / sectors_of_turn;
  std::array<bool, sectors_of_turn> known{};
  std::array<bool, sectors_of_turn> closed{};
  for (const ContactPoint& point : contact.points) {
    const double from_low = degrees(point.theta) + 180.0;
    const auto s = static_cast<std::size_t>(
        std::clamp(static_cast<int>(from_low / sector), 0, sectors_of_turn - 1));
    known[s] = true;
    closed[s] = closed[s] || point.closed;
  }
  std::size_t longest = 0;
  std::size_t begin = 0;
  for (std::size_t first = 0; first < sectors_of_turn; ++first) {
    std::size_t count = 0;
    while (count < sectors_of_turn && known[(first + count) % sectors_of_turn] &&
           !closed[(first + count) % sectors_of_turn]) {
      ++count;
    }
    if (count > longest) {
      longest = count;
      begin = first;
    }
  }
  if (longest == 0) {
    return std::nullopt;
  }
  const double from = -180.0 + sector * static_cast<double>(begin);
  return std::array{from, from + sector * static_cast<double>(longest)};
}

/// Between solids: how much of the surface touches, and round an axis where none of it does.
std::string area_words(const model::Model& model, const ContactResult& contact) {
  const double whole = surface_area(contact);
  const base::OutputUnit unit = base::output_unit(model.units, base::QuantityKind::area);
  std::string text = fmt::format("touches over {}", unit.text(contact.area, 4));
  if (whole > 0.0) {
    text += fmt::format(" ({:.0f} % of its surface)", 100.0 * contact.area / whole);
  }
  if (contact.radius > 0.0) {
    if (const auto open = open_arc(contact)) {
      text += fmt::format(", nowhere from {:.0f} to {:.0f} deg", (*open)[0], (*open)[1]);
    }
  }
  return text;
}

/// In the plane: the longest part that touches.
std::string arc_words(const model::Model& model, const ContactResult& contact) {
  if (contact.closed == contact.rows) {
    return contact.round ? "touches all along its arc" : "touches all along";
  }
  if (contact.round) {
    return fmt::format("touches from {:.1f} to {:.1f} deg ({:.0f} deg in all), is open beside",
                       degrees(contact.arc_from), degrees(contact.arc_to),
                       degrees(contact.arc_to - contact.arc_from));
  }
  const base::OutputUnit unit = model.units.output_length();
  return fmt::format("touches from {:.4g} to {} along it, is open beside",
                     unit.from_deck(contact.arc_from), unit.text(contact.arc_to, 4));
}

/// Whether all of it is pressed alike but for the mesh.
bool is_uniform(const model::Contact& card, const ContactResult& contact,
                const ContactPoint& peak) {
  constexpr double alike = 0.99;
  return std::ranges::all_of(contact.points, [&](const ContactPoint& point) {
    return recovered_pressure(card, point) >= alike * recovered_pressure(card, peak);
  });
}

std::string peak_words(const model::Model& model, const model::Contact& card,
                       const ContactResult& contact) {
  const ContactPoint* const peak = find_peak_pressure(card, contact);
  if (peak == nullptr) {
    return {};
  }
  const base::OutputUnit unit = model.units.output_length();
  const std::string pressure = model.units.output_stress().text(recovered_pressure(card, *peak), 4);
  if (is_uniform(card, contact, *peak)) {
    return fmt::format("; pressure {} everywhere", pressure);
  }
  std::string where;
  if (contact.radius > 0.0) {
    where =
        fmt::format("{:.0f} deg, {} along the axis", degrees(peak->theta), unit.text(peak->arc, 4));
  } else if (contact.round) {
    where = fmt::format("{:.1f} deg", degrees(peak->theta));
  } else {
    where = fmt::format("{:.4g}, {:.4g}", unit.from_deck(peak->x[0]), unit.from_deck(peak->x[1]));
    where += contact.space ? ", " + unit.text(peak->x[2], 4) : " " + unit.name;
  }
  return fmt::format("; largest pressure {} at {}", pressure, where);
}

bool is_pressed_at_all(const ContactResult& contact, double least_pressure) {
  return contact.mounted && contact.closed > 0 && contact.max_pressure > least_pressure;
}

/// In which other step more of it touches: "; in step PRESS all along its arc".
std::string open_since_words(const results::CrackLengthResult& increment, const ContactResult& now,
                             double least_pressure) {
  const results::LoadStepResult* fullest = nullptr;
  int most = now.mounted ? now.closed : 0;
  int rows = now.rows;
  for (const results::LoadStepResult& step : increment.steps) {
    const ContactResult* const there = results::find_contact(step, now.name);
    if (there != nullptr && is_pressed_at_all(*there, least_pressure) && there->closed > most) {
      fullest = &step;
      most = there->closed;
      rows = there->rows;
    }
  }
  if (fullest == nullptr) {
    return {};
  }
  return most == rows ? fmt::format("; in step {} all of it touches", fullest->step)
                      : fmt::format("; in step {} {:.0f} % of it touches", fullest->step,
                                    100.0 * most / std::max(rows, 1));
}

} // namespace

std::string contact_words(const model::Model& model, const results::RunResult& run,
                          const model::Contact& contact) {
  const results::CrackLengthResult& increment = run.increments.back();
  const results::LoadStepResult* const step =
      results::shown_step_result(model, run.increments, increment);
  const ContactResult* const found =
      step == nullptr ? nullptr : results::find_contact(*step, contact.name);
  if (found == nullptr) {
    return {};
  }
  const double least = least_contact_pressure(model, run);
  const std::string before = open_since_words(increment, *found, least);
  if (!found->mounted) {
    return "is not mounted" + before;
  }
  if (!is_pressed_at_all(*found, least)) {
    return "carries nothing" + before;
  }
  return (found->space ? area_words(model, *found) : arc_words(model, *found)) +
         peak_words(model, contact, *found) + before;
}

} // namespace spricka::report
