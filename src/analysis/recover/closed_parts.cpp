// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/closed_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double pi = std::numbers::pi;

/// The nodes of a surface in their order along it; round surfaces go on from the last to the first.
class OrderedContactPoints {
public:
  explicit OrderedContactPoints(const results::ContactResult& contact) : round_(contact.round) {
    for (const results::ContactPoint& p : contact.points) {
      nodes_.push_back(&p);
    }
    std::ranges::stable_sort(nodes_, {}, [&](const auto* p) { return round_ ? p->theta : p->arc; });
  }

  [[nodiscard]] int count() const { return static_cast<int>(nodes_.size()); }
  /// i may lie a turn before or behind the nodes of a round surface.
  [[nodiscard]] const results::ContactPoint& at(int i) const {
    return *nodes_[static_cast<std::size_t>((i % count() + count()) % count())];
  }
  [[nodiscard]] double place(int i) const {
    return round_ ? at(i).theta + 2.0 * pi * std::floor(static_cast<double>(i) / count())
                  : at(i).arc;
  }
  /// Whether the surface goes on from node i to the next; the faces of a mouth are one place.
  [[nodiscard]] bool goes_on(int i) const {
    constexpr double gap = 5.0; // times the distances beside it
    if (!round_ && (i < 0 || i + 1 >= count() ||
                    distance(i) > 1.5 * (place(i + 1) - place(i)) + 1e-9 * std::abs(place(i)))) {
      return false;
    }
    double beside = 0.0;
    for (const int k : {i - 2, i - 1, i + 1, i + 2}) {
      beside = std::max(beside, round_ || (k >= 0 && k + 1 < count()) ? distance(k) : 0.0);
    }
    return distance(i) <= gap * beside || count() < 4;
  }
  [[nodiscard]] bool closed(int i) const { return at(i).closed; }

private:
  [[nodiscard]] double distance(int i) const { return (at(i + 1).x - at(i).x).norm(); }

  std::vector<const results::ContactPoint*> nodes_;
  bool round_;
};

/// Where contact ends beyond its last node, towards the open one next to it: (contact.11) with the
/// force and moment of up to three closed nodes. `step` is 1 or -1.
double end_of(const OrderedContactPoints& row, int last, int first, int step) {
  // The fit needs two nodes; the end of a part of one node is not known better than the node.
  const int nodes = std::min(3, std::abs(last - first) + 1);
  if (nodes < 2) {
    return row.place(last);
  }
  const int from = last - step * (nodes - 1);
  const auto pressure = [&](int i) { return std::max(0.0, row.at(i).p_lumped); };
  double t = 0.0;
  double force = 0.0;
  double moment = 0.0;
  for (int k = 0; k < nodes; ++k) {
    const int i = from + step * k;
    const double h = std::abs(row.place(i + step) - row.place(i));
    const double p = pressure(i);
    // Beyond the last closed node pressure falls to zero on the way to the open one.
    const double q = k + 1 < nodes ? pressure(i + step) : 0.0;
    force += 0.5 * h * (p + q);
    moment += h * (0.5 * t * (p + q) + h * (p + 2.0 * q) / 6.0);
    t += h;
  }
  const double gap = std::abs(row.place(last + step) - row.place(last));
  const double on = force > 0.0 ? 2.5 * moment / force - (t - gap) : 0.5 * gap;
  return row.place(last) + step * std::clamp(on, 0.0, 1.5 * gap);
}

std::array<double, 2> normal(std::array<double, 2> part, bool round) {
  if (round) {
    const double turns = std::floor((part[0] + pi) / (2.0 * pi) + 1e-9);
    part[0] -= 2.0 * pi * turns;
    part[1] -= 2.0 * pi * turns;
  }
  return part;
}

} // namespace

std::vector<std::array<double, 2>> closed_contact_parts(const results::ContactResult& contact) {
  std::vector<std::array<double, 2>> parts;
  if (contact.closed == 0 || contact.points.empty()) {
    return parts;
  }
  const OrderedContactPoints row(contact);
  const double middle = 0.5 * (contact.arc_from + contact.arc_to);
  for (int i = 0; i < row.count(); ++i) {
    if (!row.closed(i) || (row.goes_on(i - 1) && row.closed(i - 1))) {
      continue;
    }
    int last = i;
    while (last - i < row.count() && row.goes_on(last) && row.closed(last + 1)) {
      ++last;
    }
    std::array<double, 2> part{row.goes_on(i - 1) ? end_of(row, i, last, -1) : row.place(i),
                               row.goes_on(last) ? end_of(row, last, i, 1) : row.place(last)};
    part = normal(part, contact.round);
    part[0] = contact.round ? part[0] : std::max(0.0, part[0]); // where the slave starts
    const double turn =
        contact.round ? 2.0 * pi * std::round((middle - part[0]) / (2.0 * pi)) : 0.0;
    const bool longest = (middle - turn >= part[0] && middle - turn <= part[1]) ||
                         (contact.round && middle - turn + 2.0 * pi <= part[1]);
    // The longest part is the contact's arc, whose ends come from the multipliers.
    parts.push_back(longest ? std::array{contact.arc_from, contact.arc_to} : part);
  }
  if (parts.empty()) { // closed all round
    parts.push_back({contact.arc_from, contact.arc_to});
  }
  std::ranges::sort(parts);
  const auto single = [](const std::array<double, 2>& part) { return part[0] == part[1]; };
  if (!std::ranges::all_of(parts, single)) { // nodes beside open ones, at sharp edges
    std::erase_if(parts, single);
  }
  return parts;
}

bool is_between_surface_pieces(const results::ContactResult& contact, double place) {
  const OrderedContactPoints row(contact);
  for (int i = 0; !contact.round && i + 1 < row.count(); ++i) {
    if (row.place(i) < place && place < row.place(i + 1)) {
      return !row.goes_on(i);
    }
  }
  return false;
}

std::string describe_closed_parts(const results::ContactResult& contact) {
  constexpr std::size_t most = 6;
  const std::vector<std::array<double, 2>> parts = closed_contact_parts(contact);
  if (parts.size() < 2) {
    return {};
  }
  const double unit = contact.round ? 180.0 / pi : 1.0;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < parts.size() && i < most; ++i) {
    names.push_back(fmt::format("{:.5g} .. {:.5g}{}", unit * parts[i][0], unit * parts[i][1],
                                contact.round ? " deg" : ""));
  }
  if (parts.size() > most) {
    names.push_back(fmt::format("{} more", parts.size() - most));
  }
  return fmt::format("{} is closed in {} parts ({}): its arc is the longest", contact.name,
                     parts.size(), fmt::join(names, ", "));
}

} // namespace spricka::analysis
