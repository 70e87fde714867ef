// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/march.hpp"

#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

/// Logarithm of the ratio by which an arm grows at most.
constexpr double first_step = 0.1;
/// Advance as a part of the way to an edge, and to another crack, which may come the other way.
constexpr double of_way_to_edge = 0.6;
constexpr double of_way_to_crack = 0.35;
/// A ligament of this part of the arm counts as cut through: K grows without bound in it.
constexpr double through = 0.02;
/// Turns [rad] of a piece of a curved advance, and of an advance.
constexpr double turn_of_piece = 0.05;
constexpr double turn_of_advance = 0.3;

double angle_of(const base::Vec3& d) {
  return std::atan2(d.y(), d.x());
}

base::Vec3 unit(double angle) {
  return {std::cos(angle), std::sin(angle), 0.0};
}

double length_of(const std::vector<base::Vec3>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

// Of the crack's last part at a tip, away from the crack.
base::Vec3 last_part(const mesh::CrackLine& line, bool at_first) {
  const std::vector<base::Vec3>& p = line.points;
  return (at_first ? p[0] - p[1] : p.back() - p[p.size() - 2]).normalized();
}

const base::Vec3& tip_point(const mesh::CrackLine& line, bool at_first) {
  return at_first ? line.points.front() : line.points.back();
}

} // namespace

std::vector<GrowingTip> growing_tips(const model::Model& model,
                                     const std::vector<mesh::CrackLine>& lines) {
  std::vector<GrowingTip> tips;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!crack_grows(model, lines[i].crack.index())) {
      continue;
    }
    if (lines[i].embedded) {
      tips.push_back({lines[i].name + ".1", i, true});
      tips.push_back({lines[i].name + ".2", i, false});
    } else {
      tips.push_back({lines[i].name, i, false});
    }
  }
  return tips;
}

March::March(const model::Model& model, Law law, std::vector<mesh::CrackLine> lines, State state)
    : model_(model), law_(std::move(law)), lines_(std::move(lines)),
      tips_(growing_tips(model, lines_)), around_(model.mesh), state_(std::move(state)) {
  // A run that goes on stands where its last station was; whether that was the end follows anew.
  for (std::size_t i = 0; i < state_.lines.size(); ++i) {
    lines_[i].points = state_.lines[i];
  }
  if (state_.stations.empty()) {
    state_.step = first_step;
  } else {
    look_for_end();
  }
}

const model::Growth& March::rules() const {
  return *model_.growth;
}

bool March::turns() const {
  return rules().direction != model::GrowthDirection::path;
}

Heading March::heading_of(std::size_t tip) const {
  const GrowingTip& t = tips_[tip];
  const mesh::CrackLine& line = lines_[t.line];
  // Where cracks turn, the way on is that found at the last station; else the crack's own.
  const double angle = state_.stations.empty() || !turns()
                           ? angle_of(last_part(line, t.at_first))
                           : state_.stations.back().tips[tip].heading;
  return {tip_point(line, t.at_first), unit(angle)};
}

// Parts of the next advance by tip: rates extrapolated to its middle (Adams and Bashforth), once
// there are two stations.
std::vector<double> March::shares() const {
  const std::vector<Station>& all = state_.stations;
  std::vector<double> share;
  const auto of = [](const Station& station, std::size_t tip) {
    return station.tips[tip].rate / station.rate();
  };
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    double p = of(all.back(), tip);
    if (all.size() > 1 && p > 0.0) {
      const Station& before = all[all.size() - 2];
      const double h = all.back().s - before.s;
      // A guess of the advance of s: obstacles and lengths that cut it are looked at afterwards.
      const double next = all.back().s * (std::exp(state_.step) - 1.0);
      // (growth.2). Cut, so that a line through two stations makes no share negative or far too
      // large.
      p = std::clamp(p + 0.5 * next / h * (p - of(before, tip)), 0.5 * p, 2.0 * p);
    }
    share.push_back(p);
  }
  double sum = 0.0;
  for (const double p : share) {
    sum += p;
  }
  for (double& p : share) {
    p /= sum;
  }
  return share;
}

std::optional<std::vector<mesh::CrackLine>> March::next(base::Diagnostics& diagnostics) {
  if (end_) {
    return std::nullopt;
  }
  if (state_.stations.empty()) {
    trial_ = lines_;
    return trial_;
  }
  if (!plan()) {
    return std::nullopt;
  }
  std::optional<std::vector<mesh::CrackLine>> lines = advanced_lines(diagnostics);
  if (lines) {
    trial_ = *lines;
  }
  return lines;
}

bool March::plan() {
  const std::vector<double> share = shares();
  const Station& here = state_.stations.back();
  // No arm may grow by more than the step; what each tip demands only makes it shorter.
  double ds = 1e300;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    if (share[tip] > 0.0) {
      ds = std::min(ds, (std::exp(state_.step) - 1.0) * here.tips[tip].a / share[tip]);
    }
  }
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    if (share[tip] > 0.0 && !limit(tip, share[tip], ds)) {
      return false;
    }
  }
  advance_.clear();
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    const double by = share[tip] * ds;
    const double left = length_left(tip);
    // The last length is met exactly, and no advance is left over that is only round-off.
    const bool to_the_end = by >= left * (1.0 - 1e-9);
    // What earlier advances missed is made up for, within bounds that keep the tip going on.
    const double all = std::clamp(by + here.tips[tip].owed, 0.5 * by, 2.0 * by);
    advance_.push_back(to_the_end ? left : std::min(all, left));
  }
  return true;
}

// To AMAX and to the last node of a path.
double March::length_left(std::size_t tip) const {
  const mesh::CrackLine& line = lines_[tips_[tip].line];
  double longest = rules().last_length.value_or(std::numeric_limits<double>::infinity());
  if (!line.path.empty() && !turns()) {
    std::vector<base::Vec3> path;
    for (const base::NodeId n : line.path) {
      path.push_back(model_.mesh.x[n.index()]);
    }
    longest = std::min(longest, length_of(path));
  }
  return longest - state_.stations.back().tips[tip].a;
}

// What a tip lets the advance of all be; false: the growth ends here.
bool March::limit(std::size_t tip, double share, double& ds) {
  const GrowingTip& t = tips_[tip];
  const TipStation& here = state_.stations.back().tips[tip];
  if (rules().largest_advance) {
    ds = std::min(ds, *rules().largest_advance / share);
  }
  const double left = length_left(tip);
  if (left <= 1e-9 * here.a) { // AMAX has ended it before
    end_at_station("PATH END", fmt::format("the path of {} ends at a = {:.6g}", t.name, here.a));
    return false;
  }
  ds = std::min(ds, left / share);
  if (turns() && state_.stations.size() > 1) {
    const TipStation& before = state_.stations[state_.stations.size() - 2].tips[tip];
    const double turned = std::remainder(here.heading - before.heading, 2.0 * std::numbers::pi);
    const double curvature = std::abs(turned) / std::max(here.a - before.a, 1e-300);
    // The curvature of the last advance is no guess of the way for a larger turn.
    ds = curvature * ds * share > turn_of_advance ? turn_of_advance / (curvature * share) : ds;
  }
  return limit_by_obstacles(tip, share, ds);
}

bool March::limit_by_obstacles(std::size_t tip, double share, double& ds) {
  const GrowingTip& t = tips_[tip];
  const double a = state_.stations.back().tips[tip].a;
  const Heading heading = heading_of(tip);
  if (const auto edge = around_.edge_ahead(lines_[t.line], heading)) {
    if (edge->distance <= through * a) {
      end_at_station("EDGE", fmt::format("{} reaches {}: {:.3g} is left of the ligament, in which "
                                         "K grows without bound",
                                         t.name, edge->what, edge->distance));
      return false;
    }
    ds = std::min(ds, of_way_to_edge * edge->distance / share);
  }
  if (const auto crack = Surroundings::crack_ahead(lines_, t.line, heading)) {
    if (crack->distance <= through * a) {
      end_at_station("LINK-UP", fmt::format("{} meets {}: {:.3g} is left between them", t.name,
                                            crack->what, crack->distance));
      return false;
    }
    ds = std::min(ds, of_way_to_crack * crack->distance / share);
  }
  return true;
}

void March::end_at_station(std::string word, std::string reason) {
  end_ = End{std::move(word), std::move(reason), state_.stations.back().s};
}

std::optional<std::vector<mesh::CrackLine>>
March::advanced_lines(base::Diagnostics& diagnostics) const {
  if (turns()) {
    std::vector<mesh::CrackLine> lines = lines_;
    for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
      extend(tip, advance_[tip], lines[tips_[tip].line]);
    }
    return lines;
  }
  // On ways that the deck draws, lines are cut anew to the arms; zero stands for the first length.
  std::vector<Arms> arms(model_.cracks.size());
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    Arms& of = arms[lines_[tips_[tip].line].crack.index()];
    (tips_[tip].at_first ? of.first : of.last) = state_.stations.back().tips[tip].a + advance_[tip];
  }
  return crack_lines(model_, arms, diagnostics);
}

// An arc that goes on with the curvature of the last advance, as a polyline with small kinks.
void March::extend(std::size_t tip, double by, mesh::CrackLine& line) const {
  const bool at_first = tips_[tip].at_first;
  if (by <= 0.0) {
    return;
  }
  std::vector<base::Vec3>& points = line.points;
  if (at_first) {
    std::reverse(points.begin(), points.end());
  }
  const double before = angle_of((points.back() - points[points.size() - 2]).normalized());
  const TipStation& here = state_.stations.back().tips[tip];
  double curvature = 0.0;
  if (state_.stations.size() > 1) {
    const TipStation& last = state_.stations[state_.stations.size() - 2].tips[tip];
    curvature = here.a > last.a
                    ? std::remainder(here.heading - last.heading, 2.0 * std::numbers::pi) /
                          (here.a - last.a)
                    : 0.0;
  }
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::abs(curvature) * by / turn_of_piece)));
  for (int k = 0; k < pieces; ++k) {
    // The heading in the middle of a piece, so that chords follow the arc (growth.10).
    const double angle = here.heading + curvature * by * (k + 0.5) / pieces;
    const base::Vec3 next = points.back() + by / pieces * unit(angle);
    // A kink too small to mean anything would only be one more point for the mesh to meet.
    if (k == 0 && std::abs(std::remainder(angle - before, 2.0 * std::numbers::pi)) < 1e-7) {
      points.back() = next; // straight on
    } else {
      points.push_back(next);
    }
  }
  if (!line.symmetric_half) {
    line.path.clear(); // it leaves the nodes
  }
  if (at_first) {
    std::reverse(points.begin(), points.end());
  }
}

std::vector<mesh::CrackLine> March::straight_on(double advance) const {
  std::vector<mesh::CrackLine> lines = lines_;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    const Heading heading = heading_of(tip);
    const auto edge = around_.edge_ahead(lines_[tips_[tip].line], heading);
    // A look ahead must not leave the body.
    const double by = edge ? std::min(advance, 0.9 * edge->distance) : advance;
    std::vector<base::Vec3>& points = lines[tips_[tip].line].points;
    const bool at_first = tips_[tip].at_first;
    const base::Vec3 next = tip_point(lines[tips_[tip].line], at_first) + by * heading.direction;
    if (last_part(lines[tips_[tip].line], at_first).dot(heading.direction) > 1.0 - 1e-12) {
      (at_first ? points.front() : points.back()) = next;
    } else {
      points.insert(at_first ? points.begin() : points.end(), next);
    }
  }
  return lines;
}

bool March::take(std::vector<TipStation> found) {
  Station station;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    const GrowingTip& t = tips_[tip];
    const mesh::CrackLine& line = trial_[t.line];
    TipStation& here = found[tip];
    // The arms are the clock of the growth: summed from advances, not measured on polylines.
    here.a = state_.stations.empty() ? (line.embedded ? 0.5 : 1.0) * length_of(line.points)
                                     : state_.stations.back().tips[tip].a + advance_[tip];
    here.heading = angle_of(last_part(line, t.at_first)) + here.turn;
    here.x = tip_point(line, t.at_first).x();
    here.y = tip_point(line, t.at_first).y();
    station.s += here.a;
  }
  station.tips = std::move(found);
  state_.stations.push_back(std::move(station));
  // First, as the judgement counts what the advance is found to have missed.
  settle();
  if (!good_enough()) {
    state_.stations.pop_back();
    ++state_.rejected;
    return false;
  }
  lines_ = trial_;
  state_.lines.clear();
  for (const mesh::CrackLine& line : lines_) {
    state_.lines.push_back(line.points);
  }
  look_for_end();
  return true;
}

} // namespace spricka::growth
