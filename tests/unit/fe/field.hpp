// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"

/// Expressions of x, y, rho and theta written as formulas, for tests that load a model with a
/// field.
namespace spricka::test {

struct Field {
  base::Expression code;

  Field(double value) : code(base::Expression::constant(value)) {} // NOLINT: numbers are fields
  explicit Field(base::Op variable) : code{{{variable, 0.0}}} {}

  Field& append(const Field& b, base::Op op) {
    code.code.insert(code.code.end(), b.code.code.begin(), b.code.code.end());
    code.code.push_back({op, 0.0});
    return *this;
  }
  [[nodiscard]] Field apply(base::Op op) const {
    Field f = *this;
    f.code.code.push_back({op, 0.0});
    return f;
  }
};

inline Field operator+(Field a, const Field& b) {
  return a.append(b, base::Op::add);
}
inline Field operator-(Field a, const Field& b) {
  return a.append(b, base::Op::subtract);
}
inline Field operator*(Field a, const Field& b) {
  return a.append(b, base::Op::multiply);
}
inline Field operator/(Field a, const Field& b) {
  return a.append(b, base::Op::divide);
}
inline Field sin(const Field& a) {
  return a.apply(base::Op::sin);
}
inline Field cos(const Field& a) {
  return a.apply(base::Op::cos);
}

inline const Field x_field{base::Op::x};
inline const Field y_field{base::Op::y};
inline const Field rho_field{base::Op::rho};
inline const Field theta_field{base::Op::theta};

} // namespace spricka::test
