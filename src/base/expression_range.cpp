// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/expression_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace spricka::base {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using Interval = ValueRange;

Interval tidy(Interval i) { // what is not a number can be anything
  return {std::isnan(i.low) ? -infinite : i.low, std::isnan(i.high) ? infinite : i.high};
}

Interval product(const Interval& a, const Interval& b) {
  const std::array<double, 4> v{a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  return std::ranges::any_of(v, [](double x) { return std::isnan(x); })
             ? Interval{-infinite, infinite}
             : Interval{*std::ranges::min_element(v), *std::ranges::max_element(v)};
}

/// mid + slope t +- rest, and inside `hull` as well.
struct Form {
  double mid = 0.0;
  Vec3 slope = Vec3::Zero();
  double rest = 0.0;
  Interval hull;

  [[nodiscard]] double reach() const { return slope.lpNorm<1>() + rest; }
  [[nodiscard]] bool centred() const {
    return std::isfinite(mid) && std::isfinite(reach()) && hull.low <= mid && mid <= hull.high;
  }
};

Form closed(Form f) {
  const double reach = f.reach();
  if (std::isfinite(f.mid) && std::isfinite(reach)) {
    f.hull.low = std::max(f.hull.low, f.mid - reach);
    f.hull.high = std::min(f.hull.high, f.mid + reach);
  }
  f.hull = tidy(f.hull);
  return f;
}

Form of_hull(Interval hull) {
  hull = tidy(hull);
  Form f;
  f.mid = 0.5 * (hull.low + hull.high);
  f.rest = 0.5 * (hull.high - hull.low);
  f.hull = hull;
  return f;
}

Form constant(double v) {
  return {v, Vec3::Zero(), 0.0, tidy({v, v})};
}

Form scaled(const Form& a, double by) {
  const Interval hull = by < 0.0 ? Interval{by * a.hull.high, by * a.hull.low}
                                 : Interval{by * a.hull.low, by * a.hull.high};
  return closed({by * a.mid, by * a.slope, std::abs(by) * a.rest, hull});
}

Form sum(const Form& a, const Form& b) {
  return closed({a.mid + b.mid,
                 a.slope + b.slope,
                 a.rest + b.rest,
                 {a.hull.low + b.hull.low, a.hull.high + b.hull.high}});
}

Form times(const Form& a, const Form& b) {
  const Interval hull = product(a.hull, b.hull);
  if (!a.centred() || !b.centred()) {
    return of_hull(hull);
  }
  const double rest = std::abs(a.mid) * b.rest + std::abs(b.mid) * a.rest + a.reach() * b.reach();
  return closed({a.mid * b.mid, a.mid * b.slope + b.mid * a.slope, rest, hull});
}

// The mean value form: f(mid) + f'(somewhere) (u - mid).
Form smooth(const Form& u, double at_mid, Interval slopes, const Interval& hull) {
  slopes = tidy(slopes);
  const double m = 0.5 * (slopes.low + slopes.high);
  const double w = 0.5 * (slopes.high - slopes.low);
  if (!u.centred() || !std::isfinite(at_mid) || !std::isfinite(w)) {
    return of_hull(hull);
  }
  return closed({at_mid, m * u.slope, std::abs(m) * u.rest + w * u.reach(), tidy(hull)});
}

bool meets_multiple(const Interval& i, double first, double period) {
  return std::ceil((i.low - first) / period) * period + first <= i.high;
}

Interval cosine_range(const Interval& i) {
  const double pi = std::numbers::pi;
  if (!(i.high - i.low < 2.0 * pi)) {
    return {-1.0, 1.0};
  }
  const auto [low, high] = std::minmax({std::cos(i.low), std::cos(i.high)});
  return {meets_multiple(i, pi, 2.0 * pi) ? -1.0 : low,
          meets_multiple(i, 0.0, 2.0 * pi) ? 1.0 : high};
}

Interval sine_range(const Interval& i) {
  const double quarter = 0.5 * std::numbers::pi;
  return cosine_range({i.low - quarter, i.high - quarter});
}

Form absolute(const Form& u) {
  const Interval& h = u.hull;
  const double most = std::max(std::abs(h.low), std::abs(h.high));
  const double least = h.low > 0.0 ? h.low : (h.high < 0.0 ? -h.high : 0.0);
  return smooth(u, std::abs(u.mid), {h.low >= 0.0 ? 1.0 : -1.0, h.high <= 0.0 ? -1.0 : 1.0},
                {least, most});
}

Form tangent(const Form& u) {
  const double pi = std::numbers::pi;
  if (!(u.hull.high - u.hull.low < pi) || meets_multiple(u.hull, 0.5 * pi, pi)) {
    return of_hull({-infinite, infinite});
  }
  const Interval hull{std::tan(u.hull.low), std::tan(u.hull.high)};
  const double most = std::max(std::abs(hull.low), std::abs(hull.high));
  return smooth(u, std::tan(u.mid), {1.0, 1.0 + most * most}, hull);
}

Form root(const Form& u) {
  const Interval hull{std::sqrt(std::max(u.hull.low, 0.0)), std::sqrt(u.hull.high)};
  return u.hull.low > 0.0 ? smooth(u, std::sqrt(u.mid), {0.5 / hull.high, 0.5 / hull.low}, hull)
                          : of_hull(hull);
}

Form exponential(const Form& u) {
  const Interval hull{std::exp(u.hull.low), std::exp(u.hull.high)};
  return smooth(u, std::exp(u.mid), hull, hull);
}

Form logarithm(const Form& u) {
  if (u.hull.low <= 0.0) {
    return of_hull({-infinite, std::log(std::max(u.hull.high, 0.0))});
  }
  return smooth(u, std::log(u.mid), {1.0 / u.hull.high, 1.0 / u.hull.low},
                {std::log(u.hull.low), std::log(u.hull.high)});
}

Form reciprocal(const Form& u) {
  const Interval& h = u.hull;
  if (h.low < 0.0 && h.high > 0.0) {
    return of_hull({-infinite, infinite});
  }
  if (h.low == 0.0 || h.high == 0.0) {
    return of_hull(h.high > 0.0 ? Interval{1.0 / h.high, infinite}
                                : Interval{-infinite, h.low < 0.0 ? 1.0 / h.low : infinite});
  }
  const Interval hull{1.0 / h.high, 1.0 / h.low};
  const auto [low, high] = std::minmax({-hull.low * hull.low, -hull.high * hull.high});
  return smooth(u, 1.0 / u.mid, {low, high}, hull);
}

Interval whole_power(const Interval& h, double n) { // n a whole number > 0
  const auto [low, high] = std::minmax({std::pow(h.low, n), std::pow(h.high, n)});
  const bool even = std::fmod(n, 2.0) == 0.0;
  return {even && h.low < 0.0 && h.high > 0.0 ? 0.0 : low, high};
}

Form power(const Form& u, const Form& exponent) {
  const double n = exponent.mid;
  if (exponent.reach() == 0.0 && n == std::floor(n) && std::abs(n) < 100.0) {
    if (n < 0.0) {
      return reciprocal(power(u, constant(-n)));
    }
    if (n == 0.0) {
      return constant(1.0);
    }
    const Interval less = n > 1.0 ? whole_power(u.hull, n - 1.0) : Interval{1.0, 1.0};
    return smooth(u, std::pow(u.mid, n), {n * less.low, n * less.high}, whole_power(u.hull, n));
  }
  if (u.hull.low > 0.0) {
    return exponential(times(exponent, logarithm(u)));
  }
  if (u.hull.low == 0.0 && exponent.hull.low > 0.0) {
    const double top = u.hull.high;
    return of_hull(
        {0.0, std::max(std::pow(top, exponent.hull.low), std::pow(top, exponent.hull.high))});
  }
  return of_hull({-infinite, infinite});
}

Form angle(const Form& y, const Form& x) {
  const Interval& a = y.hull;
  const Interval& b = x.hull;
  if (b.low <= 0.0 && a.low <= 0.0 && a.high >= 0.0) { // the cut, or the origin
    return of_hull({-std::numbers::pi, std::numbers::pi});
  }
  const std::array<double, 4> v{std::atan2(a.low, b.low), std::atan2(a.low, b.high),
                                std::atan2(a.high, b.low), std::atan2(a.high, b.high)};
  return of_hull({*std::ranges::min_element(v), *std::ranges::max_element(v)});
}

Form truth(bool surely, bool never) {
  return of_hull({surely ? 1.0 : 0.0, never ? 0.0 : 1.0});
}

Form comparison(Op op, const Form& a, const Form& b) {
  const Interval d = sum(a, scaled(b, -1.0)).hull;
  switch (op) {
  case Op::less:
    return truth(d.high < 0.0, d.low >= 0.0);
  case Op::less_equal:
    return truth(d.high <= 0.0, d.low > 0.0);
  case Op::greater:
    return truth(d.low > 0.0, d.high <= 0.0);
  case Op::greater_equal:
    return truth(d.low >= 0.0, d.high < 0.0);
  default: // equal, and of fields almost never
    return truth(d.low == 0.0 && d.high == 0.0, d.low > 0.0 || d.high < 0.0);
  }
}

Form logical(Op op, const Form& a, const Form& b) {
  const auto surely = [](const Form& f) { return f.hull.low > 0.0 || f.hull.high < 0.0; };
  const auto never = [](const Form& f) { return f.hull.low == 0.0 && f.hull.high == 0.0; };
  return op == Op::logical_and ? truth(surely(a) && surely(b), never(a) || never(b))
                               : truth(surely(a) || surely(b), never(a) && never(b));
}

Form unary(Op op, const Form& u) {
  switch (op) {
  case Op::negate:
    return scaled(u, -1.0);
  case Op::sqrt:
    return root(u);
  case Op::abs:
    return absolute(u);
  case Op::sin:
    return smooth(u, std::sin(u.mid), cosine_range(u.hull), sine_range(u.hull));
  case Op::cos: {
    const Interval sine = sine_range(u.hull);
    return smooth(u, std::cos(u.mid), {-sine.high, -sine.low}, cosine_range(u.hull));
  }
  case Op::tan:
    return tangent(u);
  case Op::exp:
    return exponential(u);
  default:
    return logarithm(u);
  }
}

Form extreme(const Form& a, const Form& b, double sign) { // +1: the larger
  Form f = scaled(sum(sum(a, b), scaled(absolute(sum(a, scaled(b, -1.0))), sign)), 0.5);
  const auto& [p, q] = std::pair(a.hull, b.hull);
  const Interval hull = sign > 0.0 ? Interval{std::max(p.low, q.low), std::max(p.high, q.high)}
                                   : Interval{std::min(p.low, q.low), std::min(p.high, q.high)};
  f.hull = {std::max(f.hull.low, hull.low), std::min(f.hull.high, hull.high)};
  return f;
}

Form binary(Op op, const Form& a, const Form& b) {
  switch (op) {
  case Op::add:
    return sum(a, b);
  case Op::subtract:
    return sum(a, scaled(b, -1.0));
  case Op::multiply:
    return times(a, b);
  case Op::divide:
    return times(a, reciprocal(b));
  case Op::power:
    return power(a, b);
  case Op::atan2:
    return angle(a, b);
  case Op::min:
    return extreme(a, b, -1.0);
  case Op::max:
    return extreme(a, b, 1.0);
  case Op::logical_and:
  case Op::logical_or:
    return logical(op, a, b);
  default:
    return comparison(op, a, b);
  }
}

Form coordinate(const PlaceCell& cell, Eigen::Index k) {
  return closed({cell.centre[k], cell.axes.row(k), cell.bulge[k], {cell.least[k], cell.most[k]}});
}

Form field(Op op, const PlaceCell& cell) {
  Form x = coordinate(cell, 0);
  Form y = coordinate(cell, 1);
  switch (op) {
  case Op::x:
    return x;
  case Op::y:
    return y;
  case Op::z:
    return coordinate(cell, 2);
  case Op::rho:
    return root(sum(power(x, constant(2.0)), power(y, constant(2.0))));
  default:
    return angle(y, x);
  }
}

} // namespace

ValueRange range_over(const Expression& expression, const PlaceCell& cell) {
  std::vector<Form> stack;
  for (const Instruction& i : expression.code) {
    switch (i.op) {
    case Op::number:
      stack.push_back(constant(i.value));
      break;
    case Op::x:
    case Op::y:
    case Op::z:
    case Op::rho:
    case Op::theta:
      stack.push_back(field(i.op, cell));
      break;
    case Op::negate:
    case Op::sqrt:
    case Op::abs:
    case Op::sin:
    case Op::cos:
    case Op::tan:
    case Op::exp:
    case Op::log:
      stack.back() = unary(i.op, stack.back());
      break;
    default: {
      const Form b = stack.back();
      stack.pop_back();
      stack.back() = binary(i.op, stack.back(), b);
    }
    }
  }
  return stack.empty() ? ValueRange{} : stack.back().hull;
}

} // namespace spricka::base
