// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/heat_points.hpp"

#include "fe/corner_rule.hpp"
#include "fe/hidden_search.hpp"
#include "fe/load_rule.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace spricka::fe {

namespace {

class HeatSampler {
public:
  HeatSampler(const AnyElement<2>& element, const AnyNodeVectors<2>& X, const HeatField& field,
              base::ElementId e, const FieldScale& scale)
      : element_(element), X_(in_space<2>(X)), field_(field), e_(e), scale_(scale) {}

  SampledHeat points(int tip) {
    run(tip, scale_.largest);
    // of a thin layer the element holds little, of which the error shall be a small part
    const double mean = 3.0 * amount_ / area_;
    if (rough_ && mean > 0.0 && mean < 0.5 * scale_.largest) {
      run(tip, mean);
    }
    return {std::move(points_), rough_, amount_, missed_};
  }

private:
  // Rules agree when their moments of a temperature differ by less of `of_`. A part so small, in
  // halvings, that stays apart by less than `left` is left: a jump is then known to 1e-4 of an
  // element.
  static constexpr double agree = 1e-7;
  static constexpr double left = 1e-5;
  static constexpr int least_depth = 12;
  static constexpr int most_depth = 60;
  static constexpr std::size_t most_points = 60000;
  // More than so much is left by a jump, but not by a kink.
  static constexpr double jump = 1e-6;

  using Moments = Eigen::Matrix<double, 6, 1>;
  struct Cell {
    std::array<double, 2> low{}, size{};
    std::vector<HeatPoint> points;
    Moments moments = Moments::Zero(); ///< with quadratic functions of the reference coordinates
    double most = std::numeric_limits<double>::lowest();
    double least = std::numeric_limits<double>::max();
    double area = 0.0, amount = 0.0;
  };

  void run(int tip, double of) {
    of_ = of;
    rough_ = false;
    points_.clear();
    amount_ = missed_ = area_ = 0.0;
    for (const Chart& chart : charts(element_, tip)) {
      chart_ = chart;
      split(take({0.0, 0.0}, {1.0, 1.0}), 0);
    }
  }

  [[nodiscard]] base::Vec2 place(const shape::Point<2>& r) const {
    return X_.topRows<2>() * element_.N(r);
  }

  [[nodiscard]] Cell take(const std::array<double, 2>& low,
                          const std::array<double, 2>& size) const {
    constexpr int degree = 7; // 4 x 4 points
    Cell cell;
    cell.low = low;
    cell.size = size;
    for (const auto& p : shape::line_rule(degree)) {
      const double a = low[0] + 0.5 * size[0] * (1.0 + p.r[0]);
      for (const auto& q : shape::line_rule(degree)) {
        const shape::Point<2> r = chart_.r(a, low[1] + 0.5 * size[1] * (1.0 + q.r[0]));
        const double w = 0.25 * size[0] * size[1] * p.weight * q.weight * chart_.area(a);
        const double det =
            Eigen::Matrix2d(X_.topRows<2>().lazyProduct(element_.dN(r))).determinant();
        const double T = field_(e_, place(r));
        cell.points.push_back({e_, r, w * det, T});
        cell.moments += (w * T) * Moments{{1.0, r[0], r[1], r[0] * r[0], r[0] * r[1], r[1] * r[1]}};
        cell.most = std::max(cell.most, T);
        cell.least = std::min(cell.least, T);
        cell.area += w * det;
        cell.amount += w * det * std::abs(T);
      }
    }
    return cell;
  }

  void split(const Cell& cell, int depth) {
    std::array<std::array<Cell, 2>, 2> half;
    std::array<double, 2> off{};
    for (std::size_t k = 0; k < 2; ++k) {
      std::array<double, 2> size = cell.size;
      size[k] *= 0.5;
      std::array<double, 2> low = cell.low;
      half[k][0] = take(low, size);
      low[k] += size[k];
      half[k][1] = take(low, size);
      // Halved either way: the one that changes the moments more is the way across the jump.
      off[k] = (cell.moments - half[k][0].moments - half[k][1].moments).cwiseAbs().maxCoeff();
    }
    const double most = std::max(off[0], off[1]);
    std::size_t way = off[1] > off[0] ? 1 : 0;
    const bool out = depth >= most_depth || points_.size() > most_points;
    if (most <= agree * of_ || !std::isfinite(most)) {
      // The rules agree: it remains whether something stands between their points.
      double open = 0.0;
      if (!hides(cell, half, way, open) || out) {
        missed_ += open * cell.area / (cell.size[0] * cell.size[1]);
        keep(cell);
        return;
      }
    } else if (out || (depth + 1 >= least_depth && most <= left * of_)) {
      rough_ = rough_ || most > jump * scale_.largest;
      missed_ += most > left * of_ ? most * cell.area / (cell.size[0] * cell.size[1]) : 0.0;
      // Points of the halves stand nearer to the jump than those of the whole.
      keep(half[way][0]);
      keep(half[way][1]);
      return;
    }
    split(half[way][0], depth + 1);
    split(half[way][1], depth + 1);
  }

  void keep(const Cell& cell) {
    points_.insert(points_.end(), cell.points.begin(), cell.points.end());
    amount_ += cell.amount;
    area_ += cell.area;
  }

  // Whether something stands between the points, and which way leads to it; `open` of the square.
  bool hides(const Cell& cell, const std::array<std::array<Cell, 2>, 2>& half, std::size_t& way,
             double& open) const {
    SeenValues seen{base::Vec3(cell.least, 0.0, 0.0), base::Vec3(cell.most, 0.0, 0.0)};
    for (const auto& pair : half) {
      for (const Cell& part : pair) {
        seen.low[0] = std::min(seen.low[0], part.least);
        seen.high[0] = std::max(seen.high[0], part.most);
      }
    }
    const auto bounds = [&](const UnitBox& box, const SeenValues& known) {
      const base::ValueRange range = field_.range(e_, place_of(box));
      return std::max(range.high - known.high[0], known.low[0] - range.low);
    };
    const auto value = [&](const std::array<double, 3>& t) {
      return base::Vec3(field_(e_, place(chart_.r(t[0], t[1]))), 0.0, 0.0);
    };
    const UnitBox box{{cell.low[0], cell.low[1], 0.0},
                      {cell.low[0] + cell.size[0], cell.low[1] + cell.size[1], 0.0}};
    const SearchResult result = search_hidden(
        2, bounds, value, box, seen,
        {little_peak * scale_.largest, little_open * scale_.mean * cell.size[0] * cell.size[1]});
    open = result.open;
    if (result.found) {
      const double a = (result.place.high[0] - result.place.low[0]) / cell.size[0];
      const double b = (result.place.high[1] - result.place.low[1]) / cell.size[1];
      way = b < a || (a == b && cell.size[1] > cell.size[0]) ? 1 : 0;
      open = little_peak * scale_.largest * a * b * cell.size[0] * cell.size[1];
    }
    return result.found;
  }

  // Where a box of the chart lies in space.
  [[nodiscard]] base::PlaceCell place_of(const UnitBox& box) const {
    // A jump on the border of an element is its neighbour's.
    constexpr double border = 1e-9;
    const auto at = [&](double s, double t) {
      const auto between = [&](std::size_t k, double v) {
        const double low = std::max(box.low[k], border);
        const double high = std::min(box.high[k], 1.0 - border);
        return 0.5 * (low + high) + 0.5 * v * (high - low);
      };
      return base::Vec3(X_ * element_.N(chart_.r(between(0, s), between(1, t))));
    };
    base::PlaceCell cell;
    cell.centre = at(0.0, 0.0);
    end_at_sides(X_, cell);
    cell.axes.col(0) = 0.5 * (at(1.0, 0.0) - at(-1.0, 0.0));
    cell.axes.col(1) = 0.5 * (at(0.0, 1.0) - at(0.0, -1.0));
    // What is curved leaves the straight cell most at its corners, sides' middles and centre.
    for (int c = 0; c < 9; ++c) {
      const double s = c % 3 - 1;
      const double t = c / 3 - 1; // NOLINT(bugprone-integer-division)
      const base::Vec3 straight = cell.centre + s * cell.axes.col(0) + t * cell.axes.col(1);
      cell.bulge = cell.bulge.cwiseMax((at(s, t) - straight).cwiseAbs());
    }
    return cell;
  }

  const AnyElement<2>& element_;
  SpaceNodes<2> X_;
  const HeatField& field_;
  base::ElementId e_;
  FieldScale scale_;
  double of_ = 0.0;
  Chart chart_;
  std::vector<HeatPoint> points_;
  bool rough_ = false;
  double amount_ = 0.0, missed_ = 0.0, area_ = 0.0;
};

} // namespace

SampledHeat sample_heat(const AnyElement<2>& element, const AnyNodeVectors<2>& X,
                        const HeatField& field, base::ElementId e, const FieldScale& scale,
                        int tip) {
  return HeatSampler(element, X, field, e, scale).points(tip);
}

} // namespace spricka::fe
