// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/adaptive_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

/// Lines through an element, for piecewise_rule.hpp.
namespace spricka::fe {

inline constexpr int line_degree = 7; ///< of a panel of a line: 4 points
inline constexpr std::size_t line_points = 4;

/// The ends of a panel are looked at this part of it inside: what stands at an end to round-off
/// belongs to the neighbour.
inline constexpr double inside_of_panel = 1e-6;

// Lagrange's functions of the points of a panel just inside its low end; in reverse order at its
// high end.
inline std::array<double, line_points> lagrange_at_low_end() {
  constexpr double end = 2.0 * inside_of_panel - 1.0;
  std::array<double, line_points> values{};
  const auto rule = shape::line_rule(line_degree);
  for (std::size_t i = 0; i < line_points; ++i) {
    values[i] = 1.0;
    for (std::size_t j = 0; j < line_points; ++j) {
      if (j != i) {
        values[i] *= (end - rule[j].r[0]) / (rule[i].r[0] - rule[j].r[0]);
      }
    }
  }
  return values;
}

template <int dim> using Moments = Eigen::Matrix<double, 3, dim + 1>;

// The field times 1 and the reference coordinates.
template <int dim>
Moments<dim> point_moment_contribution(const shape::QuadraturePoint<dim>& p, const base::Vec3& v) {
  Moments<dim> m;
  m.col(0) = p.weight * v;
  for (int k = 0; k < dim; ++k) {
    m.col(k + 1) = p.r[k] * m.col(0);
  }
  return m;
}

/// Values of a field at some points.
struct ValueRange {
  base::Vec3 low = base::Vec3::Constant(std::numeric_limits<double>::max());
  base::Vec3 high = -low;
  double largest = 0.0;

  /// Widens the range by the components and the magnitude of one value.
  void add_value(const base::Vec3& v) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
    largest = std::max(largest, v.norm());
  }
  /// By how much a value leaves them; what lies beyond the last points may by a part of their
  /// change.
  [[nodiscard]] double excess(const base::Vec3& v, double scale) const {
    constexpr double beyond = 0.1;
    constexpr double little = 0.002;
    const double over = std::max((v - high).maxCoeff(), (low - v).maxCoeff());
    return over > little * scale + beyond * (high - low).maxCoeff() ? over : 0.0;
  }
};

/// Of a field at many places: where it is most unlike the others.
struct FieldOutlier {
  double excess = 0.0; ///< by how much it leaves the values at the points of usual rules
  UnitPoint place{};
};

/// What a rule by pieces adds up.
template <int dim> struct LineIntegrals {
  Moments<dim> moments = Moments<dim>::Zero();
  double amount = 0.0; ///< integral of the magnitude
  double missed = 0.0; ///< estimate of the error along the lines
  std::vector<shape::QuadraturePoint<dim>> points;
};

/// Lines through the unit cube in the direction in which the field changes most, each cut at the
/// jumps of the field and halved where it bends, until two Gauss rules agree.
template <int dim> class LineQuadrature {
public:
  /// `room`: error of a panel; `smooth`: nothing can jump or kink.
  LineQuadrature(const AdaptiveDomain<dim>& domain, const ReferenceField<dim>& value, double room,
                 bool smooth, const FieldOutlier& outlier)
      : domain_(domain), value_(value), room_(room) {
    along_ = dim == 1 ? 0 : steepest(outlier.place);
    seen_ = ValueRange(); // what the points of no line have seen is not integrated
    // A line sees nothing of a layer that lies between its points.
    const bool hidden = outlier.excess > 0.0;
    constexpr int usual = adaptive_rule_limits<dim>.panels;
    const int panels = hidden ? 2 * usual : smooth ? usual / 4 : usual;
    for (int i = 0; i <= panels; ++i) {
      ends_.push_back(static_cast<double>(i) / panels);
    }
    const double cut = outlier.place[along_];
    if (hidden && std::ranges::find(ends_, cut) == ends_.end()) {
      ends_.insert(std::ranges::upper_bound(ends_, cut), cut);
    }
  }

  [[nodiscard]] std::size_t line_direction() const { return along_; }
  [[nodiscard]] const ValueRange& value_range() const { return seen_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  [[nodiscard]] bool has_jumps() const { return jumps_; }

  /// Adds the integrals along the line through `line`, all its panels refined, times `weight` to
  /// the sums.
  void integrate_line(const UnitPoint& line, double weight, LineIntegrals<dim>& sums) {
    for (std::size_t i = 1; i < ends_.size(); ++i) {
      add_panel(line, weight, panel(line, ends_[i - 1], ends_[i]), 0, sums);
    }
  }

private:
  static constexpr int most_evaluations = 2 * adaptive_rule_limits<dim>.evaluations;
  static constexpr int deepest = 48; ///< halvings of a panel

  struct LineSample {
    double t = 0.0;
    base::Vec3 v = base::Vec3::Zero();
    shape::QuadraturePoint<dim> p;
  };
  struct LinePanel {
    double low = 0.0, high = 0.0;
    std::array<LineSample, line_points> samples;
    LineSample first, last; ///< at its ends
    Moments<dim> moments = Moments<dim>::Zero();
    /// By how much the field at an end leaves what the points tell, times the part of the panel
    /// between them.
    double off_low = 0.0, off_high = 0.0;
  };
  LineSample sample(UnitPoint line, double t) {
    line[along_] = t;
    LineSample s{t, {}, domain_.map(line)};
    s.v = value_(s.p.r);
    seen_.add_value(s.v);
    ++evaluations_;
    return s;
  }

  // The direction in which the field changes most, on lines through a place and on a few others.
  std::size_t steepest(const UnitPoint& place) {
    constexpr int grid = adaptive_rule_limits<dim>.grid;
    constexpr int points = 64; // of the lines through the place
    std::array<double, 3> change{};
    for (along_ = 0; along_ < dim; ++along_) {
      change[along_] = change_along(place, points);
      for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
          for (int k = 0; k < adaptive_rule_limits<dim>.layers; ++k) {
            // Each line once: the places of a diagonal plane.
            if ((i + j + k) % grid == 0) {
              change[along_] +=
                  change_along({(i + 0.5) / grid, (j + 0.5) / grid, (k + 0.5) / grid}, grid);
            }
          }
        }
      }
    }
    return static_cast<std::size_t>(std::ranges::max_element(change) - change.begin());
  }
  double change_along(const UnitPoint& place, int points) {
    double change = 0.0;
    base::Vec3 before = sample(place, 0.5 / points).v;
    for (int i = 1; i < points; ++i) {
      const base::Vec3 v = sample(place, (i + 0.5) / points).v;
      change += (v - before).norm();
      before = v;
    }
    return change;
  }

  LinePanel panel(const UnitPoint& line, double low, double high) {
    static const std::array<double, line_points> at_end = lagrange_at_low_end();
    constexpr double beyond = 0.07; // so much of a panel lies between an end and the next point
    const double length = high - low;
    LinePanel result;
    result.low = low;
    result.high = high;
    result.first = sample(line, low + inside_of_panel * length);
    result.last = sample(line, high - inside_of_panel * length);
    base::Vec3 from_low = -result.first.p.weight * result.first.v;
    base::Vec3 from_high = -result.last.p.weight * result.last.v;
    std::size_t i = 0;
    for (const auto& [r, weight] : shape::line_rule(line_degree)) {
      LineSample& s = result.samples[i];
      s = sample(line, low + 0.5 * length * (1.0 + r[0]));
      from_low += at_end[i] * s.p.weight * s.v;
      from_high += at_end[line_points - 1 - i] * s.p.weight * s.v;
      s.p.weight *= 0.5 * length * weight;
      result.moments += point_moment_contribution<dim>(s.p, s.v);
      ++i;
    }
    result.off_low = beyond * length * from_low.norm();
    result.off_high = beyond * length * from_high.norm();
    return result;
  }

  void keep(const LinePanel& panel, double weight, LineIntegrals<dim>& sums) {
    sums.moments += weight * panel.moments;
    for (const LineSample& s : panel.samples) {
      sums.points.push_back(s.p);
      sums.points.back().weight *= weight;
      sums.amount += sums.points.back().weight * s.v.norm();
    }
  }

  // A place between samples at which the field jumps; `otherwise` where it does not.
  double jump_in(const UnitPoint& line, const LinePanel& whole,
                 const std::array<LinePanel, 2>& halves, double otherwise) {
    constexpr int first_steps = 6; // of a field that does not jump little is left after these
    constexpr double stays = 0.3;
    std::vector<LineSample> samples{whole.first, whole.last};
    for (const LinePanel* panel : {&whole, halves.data(), &halves[1]}) {
      samples.insert(samples.end(), panel->samples.begin(), panel->samples.end());
    }
    std::ranges::sort(samples, {}, &LineSample::t);
    std::size_t at = 0;
    double most_change = 0.0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const double change = (samples[i + 1].v - samples[i].v).norm();
      if (change > most_change) {
        at = i;
        most_change = change;
      }
    }
    LineSample low = samples[at];
    LineSample high = samples[at + 1];
    double change = most_change;
    for (int k = 0; k < adaptive_rule_limits<dim>.bisections; ++k) {
      const LineSample middle = sample(line, 0.5 * (low.t + high.t));
      ((middle.v - low.v).norm() > (high.v - middle.v).norm() ? high : low) = middle;
      change = (high.v - low.v).norm();
      if (k >= first_steps && change < stays * most_change) {
        return otherwise;
      }
    }
    constexpr double jump = 1e-6;
    jumps_ = jumps_ || change > jump * seen_.largest;
    return 0.5 * (low.t + high.t);
  }

  // Error by a bend or jump between an end of a panel and the next point: of a smooth field little
  // is left in half the panel.
  static double beside(double whole, double half) {
    constexpr double smooth = 0.1; // half the length, and a sixteenth of what points leave
    return half > smooth * whole ? half : 0.0;
  }

  // Adds a panel, by pieces where its halves differ from it.
  void add_panel(const UnitPoint& line, double weight, const LinePanel& whole, int depth,
                 LineIntegrals<dim>& sums) {
    double cut = 0.5 * (whole.low + whole.high);
    std::array<LinePanel, 2> halves{panel(line, whole.low, cut), panel(line, cut, whole.high)};
    const double off = std::max(whole.off_low, whole.off_high);
    const double error = std::max(
        {(whole.moments - halves[0].moments - halves[1].moments).cwiseAbs().maxCoeff(),
         beside(off, halves[0].off_high), beside(off, halves[1].off_low),
         beside(whole.off_low, halves[0].off_low), beside(whole.off_high, halves[1].off_high)});
    if (!(error > room_) || !std::isfinite(error)) {
      keep(whole, weight, sums);
      return;
    }
    if (depth >= deepest || evaluations_ > most_evaluations) {
      keep(halves[0], weight, sums);
      keep(halves[1], weight, sums);
      sums.missed += weight * error;
      return;
    }
    const double jump = jump_in(line, whole, halves, cut);
    if (jump != cut) {
      halves = {panel(line, whole.low, jump), panel(line, jump, whole.high)};
    }
    add_panel(line, weight, halves[0], depth + 1, sums);
    add_panel(line, weight, halves[1], depth + 1, sums);
  }

  const AdaptiveDomain<dim>& domain_;
  const ReferenceField<dim>& value_;
  double room_;
  std::vector<double> ends_; ///< of the panels of a line to begin with
  std::size_t along_ = 0;
  ValueRange seen_;
  int evaluations_ = 0;
  bool jumps_ = false;
};

} // namespace spricka::fe
