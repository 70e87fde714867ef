// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/checks/place_quantities.hpp"

#include "analysis/recover/closed_parts.hpp"
#include "geometry/polyline.hpp"
#include "program/checks/field_quantities.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace spricka::program {

double contact_value_near(const results::ContactResult& contact,
                          double results::ContactPoint::*value, const base::Vec3& x) {
  if (contact.points.empty()) {
    throw MissingQuantity("the contact has no surface");
  }
  double best = std::numeric_limits<double>::infinity();
  double found = 0.0;
  if (contact.space) {
    for (const results::ContactPoint& p : contact.points) {
      if ((p.x - x).norm() < best) {
        best = (p.x - x).norm();
        found = p.*value;
      }
    }
    return found;
  }
  for (std::size_t i = 0; i < contact.points.size(); ++i) {
    const results::ContactPoint& a = contact.points[i];
    const bool ends = i + 1 == contact.points.size();
    const results::ContactPoint& next = ends ? a : contact.points[i + 1];
    const double run = (next.x - a.x).norm(); // a jump or a mouth is no edge
    const bool last = !(run > 0.0) || run > 1.6 * std::abs(next.arc - a.arc);
    const results::ContactPoint& b = last ? a : next;
    const auto [t, distance] =
        geometry::nearest_point(base::Vec2(x.head<2>()), a.x.head<2>(), b.x.head<2>());
    if (distance < best) {
      best = distance;
      found = (1.0 - t) * a.*value + t * b.*value;
    }
  }
  return found;
}

double contact_arc_end(const results::ContactResult& contact, double number, std::size_t end) {
  const std::vector<std::array<double, 2>> parts = analysis::closed_parts(contact);
  const auto count = static_cast<double>(parts.size());
  if (!(number >= 1.0 && number <= count) || number != std::floor(number)) {
    throw MissingQuantity(
        fmt::format("contact {} is closed in {} parts", contact.name, parts.size()));
  }
  return parts[static_cast<std::size_t>(number) - 1][end];
}

} // namespace spricka::program
