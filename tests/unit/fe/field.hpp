// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"

/// Expressions of x, y, rho and theta written as formulas, for tests that load a model with a
/// field.
namespace spricka::test {

struct Field {
  base::CompiledExpression code;

  Field(double value)
      : code(base::CompiledExpression::constant(value)) {} // NOLINT: numbers are fields
  explicit Field(base::OpCode variable) : code{{{variable, 0.0}}} {}

  Field& append(const Field& b, base::OpCode op) {
    code.code.insert(code.code.end(), b.code.code.begin(), b.code.code.end());
    code.code.push_back({op, 0.0});
    return *this;
  }
  [[nodiscard]] Field apply(base::OpCode op) const {
    Field f = *this;
    f.code.code.push_back({op, 0.0});
    return f;
  }
};

inline Field operator+(Field a, const Field& b) {
  return a.append(b, base::OpCode::add);
}
inline Field operator-(Field a, const Field& b) {
  return a.append(b, base::OpCode::subtract);
}
inline Field operator*(Field a, const Field& b) {
  return a.append(b, base::OpCode::multiply);
}
inline Field operator/(Field a, const Field& b) {
  return a.append(b, base::OpCode::divide);
}
inline Field sin(const Field& a) {
  return a.apply(base::OpCode::sin);
}
inline Field cos(const Field& a) {
  return a.apply(base::OpCode::cos);
}

inline const Field x_field{base::OpCode::x};
inline const Field y_field{base::OpCode::y};
inline const Field rho_field{base::OpCode::rho};
inline const Field theta_field{base::OpCode::theta};

} // namespace spricka::test
