// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/adaptive_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::fe {

namespace {

// Lagrange's function of one point of a rule at another place.
double lagrange(std::span<const shape::QuadraturePoint<1>> rule, double point, double place) {
  double value = 1.0;
  for (const auto& other : rule) {
    if (other.r[0] != point) {
      value *= (place - other.r[0]) / (point - other.r[0]);
    }
  }
  return value;
}

// Nested adaptive Gauss rules, one for each direction of the unit cube: an interval is halved
// until one rule over it and two over its halves agree as to the integrals of the field and of its
// first moments, and until its bounds tell that nothing hides between the points. A jump across a
// surface costs a path of intervals instead of a layer of cells.
template <int dim> class NestedRule {
public:
  using Places = std::array<double, 3>;

  NestedRule(shape::Domain domain, const ReferenceField<dim>& value, const HiddenBound& hidden,
             const AdaptiveSettings& settings)
      : domain_(domain), value_(value), hidden_(hidden), set_(settings),
        largest_(settings.scale.largest) {}

  /// A rough pass tells how much there is (a peak's height says nothing of that), a second one what
  /// is little of it.
  AdaptedRule<dim> run() {
    const Places low{};
    const Places high{1.0, 1.0, 1.0};
    amount_ = line(0, low, high).amount;
    amount_ = std::max(amount_, set_.scale.mean);
    rough_ = false;
    count_ = 0;
    Sum all = line(0, low, high);
    return {std::move(all.points), all.missed > room(0) ? all.missed : 0.0, seen_, all.amount};
  }

private:
  static constexpr int degree = 9;
  static constexpr double roughly = 1e-4;
  /// Of one element. A jump takes some 300 along a line, 50 000 over a plane; across a solid, where
  /// a million would be wanted, the rule stops earlier and says so.
  static constexpr int most_points = dim == 1 ? 50000 : (dim == 2 ? 600000 : 200000);
  /// The last direction goes on when the others have to stop: it costs little, and what is found
  /// there no coarser line would find.
  static constexpr int points_for(int k) { return k + 1 < dim ? most_points / 2 : most_points; }
  static constexpr std::size_t moments = 3 * (dim + 1);
  static constexpr int deepest = 48; // a jump is then at its place to round-off
  /// Halvings of a line where only the bounds ask for them: a jump beside the end of an interval,
  /// which no point of the rules sees, wants a path of them. Bounds may as well never come down.
  static constexpr int deepest_doubt = 30;
  static constexpr int most_doubts(int k) { return k + 1 == dim ? 200 : 40; }

  struct Sum {
    std::array<double, moments> integral{};
    double amount = 0.0;                             ///< integral of the magnitude
    double missed = 0.0;                             ///< estimate of the integral's error
    std::array<double, moments> at_low{}, at_high{}; ///< of one panel: its ends, extrapolated
    base::Vec3 low = base::Vec3::Constant(std::numeric_limits<double>::max());
    base::Vec3 high = -low;
    std::vector<shape::QuadraturePoint<dim>> points;

    void add(Sum&& other, double weight) {
      for (std::size_t m = 0; m < moments; ++m) {
        integral[m] += weight * other.integral[m];
      }
      amount += weight * other.amount;
      missed += weight * other.missed;
      low = low.cwiseMin(other.low);
      high = high.cwiseMax(other.high);
      for (auto& p : other.points) {
        p.weight *= weight;
        points.push_back(p);
      }
    }
  };

  // Less for inner directions: the outer ones compare what they add up to.
  [[nodiscard]] double room(int k) const {
    constexpr std::array<double, 3> part{1.0, 0.1, 0.01};
    const double all = rough_ ? roughly * std::max(largest_, seen_) : set_.tolerance * amount_;
    return part[static_cast<std::size_t>(k)] * all;
  }

  // The field at one point.
  Sum sample(const Places& t) {
    Sum s;
    const auto p = unit_cube_point<dim>(domain_, t);
    const base::Vec3 v = value_(p.r);
    for (std::size_t c = 0; c < 3; ++c) {
      const double f = p.weight * v[static_cast<Eigen::Index>(c)];
      s.integral[c] = f;
      for (std::size_t k = 0; k < dim; ++k) {
        s.integral[3 * (k + 1) + c] = f * p.r[static_cast<Eigen::Index>(k)];
      }
    }
    s.amount = p.weight * v.norm();
    s.low = s.high = v;
    seen_ = std::max(seen_, v.norm());
    s.points.push_back(p);
    ++count_;
    return s;
  }

  // One rule along direction k over [low_k, high_k], the directions after it by their own.
  Sum panel(int k, const Places& low, const Places& high) {
    const auto d = static_cast<std::size_t>(k);
    const double half = 0.5 * (high[d] - low[d]);
    Sum s;
    for (const auto& [r, weight] : shape::line_rule(degree)) {
      Sum here = at(k, low, high, low[d] + half * (1.0 + r[0]));
      for (std::size_t m = 0; m < moments; ++m) {
        s.at_low[m] += lagrange(shape::line_rule(degree), r[0], -1.0) * here.integral[m];
        s.at_high[m] += lagrange(shape::line_rule(degree), r[0], 1.0) * here.integral[m];
      }
      s.add(std::move(here), half * weight);
    }
    return s;
  }

  // What stands behind the place t of direction k.
  Sum at(int k, Places low, Places high, double t) {
    low[static_cast<std::size_t>(k)] = high[static_cast<std::size_t>(k)] = t;
    return k + 1 < dim ? line(k + 1, low, high) : sample(low);
  }

  // A bend beside the end of an interval, in what inner directions add up to, is seen by no point
  // of the rules: the ends themselves tell it. That much of an interval lies beyond the last point.
  // A jump on the border of the element, to round-off, belongs to its neighbour.
  double end_error(int k, const Places& low, const Places& high, const Sum& first,
                   const Sum& second) {
    constexpr double beyond = 0.0235;
    const auto d = static_cast<std::size_t>(k);
    constexpr double inside = 1e-9;
    const Sum start = at(k, low, high, std::max(low[d], inside));
    const Sum end = at(k, low, high, std::min(high[d], 1.0 - inside));
    double worst = 0.0;
    for (std::size_t m = 0; m < moments; ++m) {
      worst = std::max({worst, std::abs(start.integral[m] - first.at_low[m]),
                        std::abs(end.integral[m] - second.at_high[m])});
    }
    return beyond * (high[d] - low[d]) * worst;
  }

  Sum line(int k, const Places& low, const Places& high) {
    int doubts = most_doubts(k);
    return refined(k, {low, high, 0, &doubts}, panel(k, low, high));
  }

  /// A part of a line.
  struct Part {
    Places low, high;
    int depth;
    int* doubts; ///< left on the line
  };

  Sum refined(int k, const Part& part, Sum coarse) {
    const auto& [low, high, depth, doubts] = part;
    const auto d = static_cast<std::size_t>(k);
    Places end = high;
    Places start = low;
    end[d] = start[d] = 0.5 * (low[d] + high[d]);
    Sum first = panel(k, low, end);
    Sum second = panel(k, start, high);
    double error = 0.0;
    for (std::size_t m = 0; m < moments; ++m) {
      error =
          std::max(error, std::abs(coarse.integral[m] - first.integral[m] - second.integral[m]));
    }
    if ((k + 1 < dim || dim == 1) && error <= room(k)) {
      error = std::max(error, end_error(k, low, high, first, second));
    }
    const bool agreed = error <= room(k) || !std::isfinite(error);
    const bool out = depth >= deepest || count_ > points_for(k);
    const bool tired = *doubts <= 0 || depth >= deepest_doubt;
    double open = 0.0;
    const bool doubt = agreed && hides(k, low, high, first, second, open);
    *doubts -= doubt ? 1 : 0;
    if (out || (agreed && (!doubt || tired))) {
      first.add(std::move(second), 1.0);
      first.missed += (agreed ? 0.0 : error) + (k == 0 ? open : 0.0);
      return first;
    }
    coarse.points.clear();
    Sum sum = refined(k, {low, end, depth + 1, doubts}, std::move(first));
    sum.add(refined(k, {start, high, depth + 1, doubts}, std::move(second)), 1.0);
    return sum;
  }

  // Whether a value was found between the points, which the rules must get nearer to. What may
  // hide of the integral over the reference element, found or not, goes to `open`.
  [[nodiscard]] bool hides(int k, const Places& low, const Places& high, const Sum& a, const Sum& b,
                           double& open) const {
    const SearchSettings search{(k == 0 ? little_peak : little_tail) * std::max(largest_, seen_),
                                little_open * amount_, dim == 1 ? 300 : 100};
    const SeenValues seen{a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
    const SearchResult result = search_hidden(
        dim, hidden_,
        [this](const Places& t) { return value_(unit_cube_point<dim>(domain_, t).r); }, {low, high},
        seen, search);
    open = reference_size(domain_) * (result.found ? found_part(result) : result.open);
    return result.found;
  }
  // At least what lies in the box of the find.
  [[nodiscard]] double found_part(const SearchResult& result) const {
    double part = std::max(largest_, seen_);
    for (std::size_t k = 0; k < dim; ++k) {
      part *= result.place.high[k] - result.place.low[k];
    }
    return part;
  }
  shape::Domain domain_;
  const ReferenceField<dim>& value_;
  const HiddenBound& hidden_;
  AdaptiveSettings set_;
  double largest_ = 0.0;
  double seen_ = 0.0;
  double amount_ = 0.0;
  bool rough_ = true;
  int count_ = 0;
};

} // namespace

template <int dim>
AdaptedRule<dim> adapted_rule(shape::Domain domain, int usual_degree,
                              const ReferenceField<dim>& value, const HiddenBound& hidden,
                              const AdaptiveSettings& settings) {
  constexpr int second_degree = 15;
  const auto usual = shape::quadrature<dim>(domain, usual_degree);
  using Moments = Eigen::Matrix<double, 3, dim + 1>;
  base::Vec3 low = base::Vec3::Constant(std::numeric_limits<double>::max());
  base::Vec3 high = -low;
  double largest = 0.0;
  double amount = 0.0;
  const auto moments = [&](std::span<const shape::QuadraturePoint<dim>> rule) {
    Moments sum = Moments::Zero();
    amount = 0.0;
    for (const auto& point : rule) {
      const base::Vec3 v = value(point.r);
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
      largest = std::max(largest, v.norm());
      amount += point.weight * v.norm();
      sum.col(0) += point.weight * v;
      for (int k = 0; k < dim; ++k) {
        sum.col(k + 1) += point.weight * point.r[k] * v;
      }
    }
    return sum;
  };
  const Moments difference =
      moments(usual) - moments(shape::quadrature<dim>(domain, second_degree));
  const double scale = std::max(settings.scale.largest, largest);
  const double error = difference.cwiseAbs().maxCoeff();
  double beside = 0.0; // of a bend between an end and the points next to it
  if constexpr (dim == 1) {
    constexpr double beyond = 0.02;
    const auto rule = shape::quadrature<dim>(domain, second_degree);
    for (const double end : {-1.0, 1.0}) {
      base::Vec3 v = value(shape::Point<1>::Constant(end));
      for (const auto& point : rule) {
        v -= lagrange(rule, point.r[0], end) * value(point.r);
      }
      beside = std::max(beside, beyond * v.norm());
    }
  }
  // of plane and solid loads that are smooth the usual rule is far better than the elements
  const double usual_tolerance = dim > 1 && settings.smooth ? 1e-5 : 0.0;
  const double room =
      std::max(settings.tolerance, usual_tolerance) * std::max(settings.scale.mean, amount);
  const bool agreed = std::max(error, beside) <= room || !std::isfinite(error);
  if (agreed) {
    const double mean = std::max(settings.scale.mean, amount / reference_size(domain));
    const auto at = [&](const std::array<double, 3>& t) {
      return base::Vec3(value(unit_cube_point<dim>(domain, t).r));
    };
    const SearchResult found = search_hidden(dim, hidden, at, {{}, {1.0, 1.0, 1.0}}, {low, high},
                                             {little_peak * scale, little_open * mean});
    if (!found.found) {
      const double open = found.open > little_open * mean ? found.open : 0.0;
      return {{usual.begin(), usual.end()}, reference_size(domain) * open, largest, amount};
    }
  }
  return NestedRule<dim>(domain, value, hidden, settings).run();
}

#define ADAPTED_RULE(dim)                                                                          \
  template AdaptedRule<dim> adapted_rule<dim>(shape::Domain, int, const ReferenceField<dim>&,      \
                                              const HiddenBound&, const AdaptiveSettings&);
ADAPTED_RULE(1)
ADAPTED_RULE(2)
ADAPTED_RULE(3)

} // namespace spricka::fe
