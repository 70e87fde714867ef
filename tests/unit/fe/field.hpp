// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"

/// Expressions of x, y, rho and theta written as formulas, for tests that load a model with a
/// field.
namespace spricka::test {

struct CardField {
  base::CompiledExpression code;

  CardField(double value)
      : code(base::CompiledExpression::make_constant(value)) {} // NOLINT: numbers are fields
  explicit CardField(base::OpCode variable) : code{{{variable, 0.0}}} {}

  CardField& append(const CardField& b, base::OpCode op) {
    code.code.insert(code.code.end(), b.code.code.begin(), b.code.code.end());
    code.code.push_back({op, 0.0});
    return *this;
  }
  [[nodiscard]] CardField apply(base::OpCode op) const {
    CardField f = *this;
    f.code.code.push_back({op, 0.0});
    return f;
  }
};

inline CardField operator+(CardField a, const CardField& b) {
  return a.append(b, base::OpCode::add);
}
inline CardField operator-(CardField a, const CardField& b) {
  return a.append(b, base::OpCode::subtract);
}
inline CardField operator*(CardField a, const CardField& b) {
  return a.append(b, base::OpCode::multiply);
}
inline CardField operator/(CardField a, const CardField& b) {
  return a.append(b, base::OpCode::divide);
}
inline CardField sin(const CardField& a) {
  return a.apply(base::OpCode::sin);
}
inline CardField cos(const CardField& a) {
  return a.apply(base::OpCode::cos);
}

inline const CardField x_field{base::OpCode::x};
inline const CardField y_field{base::OpCode::y};
inline const CardField rho_field{base::OpCode::rho};
inline const CardField theta_field{base::OpCode::theta};

} // namespace spricka::test
