// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"

/// Expressions of the place, written as such.
namespace spricka::test::field {

struct Field {
  base::Expression e;
  Field(double value) : e(base::Expression::constant(value)) {} // NOLINT: reads as a number
  explicit Field(base::Op field) : e{{{field, 0.0}}} {}
  Field(const Field& a, const Field& b, base::Op op) : e(a.e) {
    e.code.insert(e.code.end(), b.e.code.begin(), b.e.code.end());
    e.code.push_back({op, 0.0});
  }
  Field(const Field& a, base::Op op) : e(a.e) { e.code.push_back({op, 0.0}); }
};

inline Field operator+(const Field& a, const Field& b) {
  return {a, b, base::Op::add};
}
inline Field operator-(const Field& a, const Field& b) {
  return {a, b, base::Op::subtract};
}
inline Field operator*(const Field& a, const Field& b) {
  return {a, b, base::Op::multiply};
}
inline Field operator/(const Field& a, const Field& b) {
  return {a, b, base::Op::divide};
}
inline Field operator^(const Field& a, const Field& b) {
  return {a, b, base::Op::power};
}
inline Field operator>(const Field& a, const Field& b) {
  return {a, b, base::Op::greater};
}
inline Field operator-(const Field& a) {
  return {a, base::Op::negate};
}
inline Field exp(const Field& a) {
  return {a, base::Op::exp};
}
inline Field log(const Field& a) {
  return {a, base::Op::log};
}
inline Field sqrt(const Field& a) {
  return {a, base::Op::sqrt};
}
inline Field abs(const Field& a) {
  return {a, base::Op::abs};
}
inline Field sin(const Field& a) {
  return {a, base::Op::sin};
}
inline Field cos(const Field& a) {
  return {a, base::Op::cos};
}
inline Field tan(const Field& a) {
  return {a, base::Op::tan};
}
inline Field atan2(const Field& a, const Field& b) {
  return {a, b, base::Op::atan2};
}
inline Field min(const Field& a, const Field& b) {
  return {a, b, base::Op::min};
}
inline Field max(const Field& a, const Field& b) {
  return {a, b, base::Op::max};
}

inline const Field X(base::Op::x);
inline const Field Y(base::Op::y);
inline const Field Z(base::Op::z);
inline const Field RHO(base::Op::rho);
inline const Field THETA(base::Op::theta);

} // namespace spricka::test::field
