// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/quadrature.hpp"

#include "shape/gauss_jacobi.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spricka::shape {

namespace {

using Rule3 = std::vector<QuadraturePoint<3>>;

// All images of a point under the symmetries of the tetrahedron, by its barycentric coordinates;
// `weight` is that of one image, as a share of the volume.
void add_orbit(Rule3& rule, double weight, std::array<double, 4> l) {
  std::ranges::sort(l);
  do {
    rule.push_back({{l[1], l[2], l[3]}, weight / 6.0});
  } while (std::next_permutation(l.begin(), l.end()));
}

// Three equal coordinates.
void add_vertex_orbit(Rule3& rule, double weight, double a) {
  add_orbit(rule, weight, {a, a, a, 1.0 - 3.0 * a});
}

// Source: Hammer, Stroud 1956, degree 2.
Rule3 tetrahedron_4() {
  Rule3 rule;
  add_vertex_orbit(rule, 0.25, (5.0 - std::sqrt(5.0)) / 20.0);
  return rule;
}

// Source: Walkington 2000, degree 5; digits from the moment equations.
Rule3 tetrahedron_14() {
  Rule3 rule;
  const double edge = 0.04550370412564964949188052627934;
  add_vertex_orbit(rule, 0.11268792571801585079918565233329, 0.31088591926330060979734573376346);
  add_vertex_orbit(rule, 0.07349304311636194954371020548633, 0.09273525031089122640232391373703);
  add_orbit(rule, 0.04254602077708146643806942812026, {edge, edge, 0.5 - edge, 0.5 - edge});
  return rule;
}

// Source: Keast 1986, degree 6; digits from the moment equations.
Rule3 tetrahedron_24() {
  Rule3 rule;
  const double a = 0.06366100187501752529923552760573;
  const double b = 0.26967233145831580803409780572761;
  add_vertex_orbit(rule, 0.03992275025816749209969062755748, 0.21460287125915202928883921938628);
  add_vertex_orbit(rule, 0.01007721105532064294801323744594, 0.04067395853461135311557944895641);
  add_vertex_orbit(rule, 0.05535718154365472209515327785373, 0.32233789014227551034399447076249);
  add_orbit(rule, 27.0 / 560.0, {a, a, b, 1.0 - 2.0 * a - b});
  return rule;
}

// z = (1 + u)/2, y = (1 + v)(1 - z)/2, x = (1 + s)(1 - y - z)/2 on [-1,1]^3: dx dy dz =
// (1 - v)(1 - u)^2 / 64 ds dv du, whose factors are the Jacobi weights.
Rule3 collapsed(int degree) {
  const int n = degree / 2 + 1;
  const auto line = gauss_jacobi_rule(n, 0.0);
  const auto triangle = gauss_jacobi_rule(n, 1.0);
  Rule3 rule;
  for (const QuadraturePoint<1>& u : gauss_jacobi_rule(n, 2.0)) {
    const double z = 0.5 * (1.0 + u.r[0]);
    for (const QuadraturePoint<1>& v : triangle) {
      const double y = 0.5 * (1.0 + v.r[0]) * (1.0 - z);
      for (const QuadraturePoint<1>& s : line) {
        rule.push_back(
            {{0.5 * (1.0 + s.r[0]) * (1.0 - y - z), y, z}, u.weight * v.weight * s.weight / 64.0});
      }
    }
  }
  return rule;
}

Rule3 make_tetrahedron_rule(int degree) {
  if (degree <= 1) {
    return {{Point<3>::Constant(0.25), 1.0 / 6.0}};
  }
  if (degree == 2) {
    return tetrahedron_4();
  }
  if (degree <= 5) {
    return tetrahedron_14();
  }
  return degree == 6 ? tetrahedron_24() : collapsed(degree);
}

// The plane rule at each point of the line.
Rule3 product(std::span<const QuadraturePoint<2>> plane, std::span<const QuadraturePoint<1>> line) {
  Rule3 rule;
  for (const QuadraturePoint<1>& z : line) {
    for (const QuadraturePoint<2>& p : plane) {
      rule.push_back({{p.r[0], p.r[1], z.r[0]}, p.weight * z.weight});
    }
  }
  return rule;
}

// All rules are made at the first call; initialisation of a local static is safe between threads.
struct SolidRules {
  std::vector<Rule3> tetrahedron; // [degree]
  std::vector<Rule3> prism;       // [degree]
  std::vector<Rule3> hexahedron;  // [degree]

  SolidRules() {
    for (int degree = 0; degree <= max_solid_degree; ++degree) {
      tetrahedron.push_back(make_tetrahedron_rule(degree));
      prism.push_back(product(triangle_rule(degree), line_rule(degree)));
      hexahedron.push_back(product(quadrilateral_rule(degree), line_rule(degree)));
    }
  }
};

const SolidRules& rules() {
  static const SolidRules all;
  return all;
}

std::size_t place(int degree) {
  assert(degree >= 0 && degree <= max_solid_degree);
  return static_cast<std::size_t>(degree);
}

} // namespace

std::span<const QuadraturePoint<3>> tetrahedron_rule(int degree) {
  return rules().tetrahedron[place(degree)];
}

std::span<const QuadraturePoint<3>> prism_rule(int degree) {
  return rules().prism[place(degree)];
}

std::span<const QuadraturePoint<3>> hexahedron_rule(int degree) {
  return rules().hexahedron[place(degree)];
}

} // namespace spricka::shape
