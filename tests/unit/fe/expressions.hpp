// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"

/// Expressions of the place, written as such.
namespace spricka::test::field {

struct Field {
  base::CompiledExpression e;
  Field(double value) : e(base::CompiledExpression::constant(value)) {} // NOLINT: reads as a number
  explicit Field(base::OpCode field) : e{{{field, 0.0}}} {}
  Field(const Field& a, const Field& b, base::OpCode op) : e(a.e) {
    e.code.insert(e.code.end(), b.e.code.begin(), b.e.code.end());
    e.code.push_back({op, 0.0});
  }
  Field(const Field& a, base::OpCode op) : e(a.e) { e.code.push_back({op, 0.0}); }
};

inline Field operator+(const Field& a, const Field& b) {
  return {a, b, base::OpCode::add};
}
inline Field operator-(const Field& a, const Field& b) {
  return {a, b, base::OpCode::subtract};
}
inline Field operator*(const Field& a, const Field& b) {
  return {a, b, base::OpCode::multiply};
}
inline Field operator/(const Field& a, const Field& b) {
  return {a, b, base::OpCode::divide};
}
inline Field operator^(const Field& a, const Field& b) {
  return {a, b, base::OpCode::power};
}
inline Field operator>(const Field& a, const Field& b) {
  return {a, b, base::OpCode::greater};
}
inline Field operator-(const Field& a) {
  return {a, base::OpCode::negate};
}
inline Field exp(const Field& a) {
  return {a, base::OpCode::exp};
}
inline Field log(const Field& a) {
  return {a, base::OpCode::log};
}
inline Field sqrt(const Field& a) {
  return {a, base::OpCode::sqrt};
}
inline Field abs(const Field& a) {
  return {a, base::OpCode::abs};
}
inline Field sin(const Field& a) {
  return {a, base::OpCode::sin};
}
inline Field cos(const Field& a) {
  return {a, base::OpCode::cos};
}
inline Field tan(const Field& a) {
  return {a, base::OpCode::tan};
}
inline Field atan2(const Field& a, const Field& b) {
  return {a, b, base::OpCode::atan2};
}
inline Field min(const Field& a, const Field& b) {
  return {a, b, base::OpCode::min};
}
inline Field max(const Field& a, const Field& b) {
  return {a, b, base::OpCode::max};
}

inline const Field X(base::OpCode::x);
inline const Field Y(base::OpCode::y);
inline const Field Z(base::OpCode::z);
inline const Field RHO(base::OpCode::rho);
inline const Field THETA(base::OpCode::theta);

} // namespace spricka::test::field
