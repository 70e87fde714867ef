// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/quadrature.hpp"

#include "shape/gauss_jacobi.hpp"

#include <cmath>
#include <vector>

namespace spricka::shape {

namespace {

using Rule1 = std::vector<QuadraturePoint<1>>;
using Rule2 = std::vector<QuadraturePoint<2>>;

constexpr int max_points = max_degree / 2 + 1;

void add_centre(Rule2& rule, double weight) {
  rule.push_back({{1.0 / 3.0, 1.0 / 3.0}, 0.5 * weight});
}

// The three (b == c) or six images of a point under the symmetries of the triangle; `weight` is
// that of one image, as a share of the area.
void add_orbit(Rule2& rule, double weight, double b, double c) {
  const double a = 1.0 - b - c;
  const double w = 0.5 * weight;
  rule.push_back({{b, c}, w});
  rule.push_back({{c, a}, w});
  rule.push_back({{a, b}, w});
  if (b != c) {
    rule.push_back({{c, b}, w});
    rule.push_back({{b, a}, w});
    rule.push_back({{a, c}, w});
  }
}

// Source: Strang, Fix 1973 (also Dunavant 1985, degree 4), in closed form.
Rule2 triangle_6() {
  const double root = std::sqrt(38.0 - 44.0 * std::sqrt(0.4));
  const double share = std::sqrt(213125.0 - 53320.0 * std::sqrt(10.0));
  Rule2 rule;
  for (const double sign : {1.0, -1.0}) {
    const double b = (8.0 - std::sqrt(10.0) + sign * root) / 18.0;
    add_orbit(rule, (620.0 + sign * share) / 3720.0, b, b);
  }
  return rule;
}

// Source: Radon 1948, degree 5.
Rule2 triangle_7() {
  const double root = std::sqrt(15.0);
  Rule2 rule;
  add_centre(rule, 9.0 / 40.0);
  for (const double sign : {1.0, -1.0}) {
    const double b = (6.0 + sign * root) / 21.0;
    add_orbit(rule, (155.0 + sign * root) / 1200.0, b, b);
  }
  return rule;
}

// Source: Dunavant 1985, degree 6.
Rule2 triangle_12() {
  Rule2 rule;
  add_orbit(rule, 0.116786275726379366030206473065, 0.249286745170910421291638553107,
            0.249286745170910421291638553107);
  add_orbit(rule, 0.050844906370206816920936809106, 0.063089014491502227340331602870,
            0.063089014491502227340331602870);
  add_orbit(rule, 0.082851075618373575193553456420, 0.053145049844816947353249671631,
            0.310352451033784405416607733956);
  return rule;
}

// Source: Dunavant 1985, degree 8.
Rule2 triangle_16() {
  Rule2 rule;
  add_centre(rule, 0.144315607677787168251091110489);
  add_orbit(rule, 0.103217370534718250281791550292, 0.170569307751760206622293501491,
            0.170569307751760206622293501491);
  add_orbit(rule, 0.032458497623198080310925928341, 0.050547228317030975458423550596,
            0.050547228317030975458423550596);
  add_orbit(rule, 0.095091634267284624793896104388, 0.459292588292723156028815514494,
            0.459292588292723156028815514494);
  add_orbit(rule, 0.027230314174434994264844690073, 0.263112829634638113421785786284,
            0.008394777409957605337213834539);
  return rule;
}

// x = (1 + s)(1 - t)/4, y = (1 + t)/2 on [-1,1]^2, dx dy = (1 - t)/8 ds dt: the factor 1 - t is the
// Jacobi weight.
Rule2 collapsed(int degree) {
  const int n = degree / 2 + 1;
  Rule2 rule;
  for (const QuadraturePoint<1>& t : gauss_jacobi_rule(n, 1.0)) {
    for (const QuadraturePoint<1>& s : gauss_jacobi_rule(n, 0.0)) {
      rule.push_back({{0.25 * (1.0 + s.r[0]) * (1.0 - t.r[0]), 0.5 * (1.0 + t.r[0])},
                      0.125 * s.weight * t.weight});
    }
  }
  return rule;
}

Rule2 make_triangle_rule(int degree) {
  Rule2 rule;
  if (degree <= 1) {
    add_centre(rule, 1.0);
  } else if (degree == 2) {
    add_orbit(rule, 1.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0);
  } else if (degree <= 4) {
    rule = triangle_6();
  } else if (degree == 5) {
    rule = triangle_7();
  } else if (degree == 6) {
    rule = triangle_12();
  } else if (degree <= 8) {
    rule = triangle_16();
  } else {
    rule = collapsed(degree);
  }
  return rule;
}

Rule2 make_quadrilateral_rule(int points) {
  const Rule1 line = gauss_jacobi_rule(points, 0.0);
  Rule2 rule;
  for (const QuadraturePoint<1>& y : line) {
    for (const QuadraturePoint<1>& x : line) {
      rule.push_back({{x.r[0], y.r[0]}, x.weight * y.weight});
    }
  }
  return rule;
}

// All rules are made at the first call; initialisation of a local static is safe between threads.
struct PlaneRules {
  std::vector<Rule1> line;          // [points - 1]
  std::vector<Rule2> quadrilateral; // [points - 1]
  std::vector<Rule2> triangle;      // [degree]

  PlaneRules() {
    for (int n = 1; n <= max_points; ++n) {
      line.push_back(gauss_jacobi_rule(n, 0.0));
      quadrilateral.push_back(make_quadrilateral_rule(n));
    }
    for (int degree = 0; degree <= max_degree; ++degree) {
      triangle.push_back(make_triangle_rule(degree));
    }
  }
};

const PlaneRules& rules() {
  static const PlaneRules all;
  return all;
}

std::size_t points_for(int degree) {
  assert(degree >= 0 && degree <= max_degree);
  return static_cast<std::size_t>(degree / 2);
}

} // namespace

std::span<const QuadraturePoint<1>> line_rule(int degree) {
  return rules().line[points_for(degree)];
}

std::span<const QuadraturePoint<2>> quadrilateral_rule(int degree) {
  return rules().quadrilateral[points_for(degree)];
}

std::span<const QuadraturePoint<2>> triangle_rule(int degree) {
  assert(degree >= 0 && degree <= max_degree);
  return rules().triangle[static_cast<std::size_t>(degree)];
}

} // namespace spricka::shape
