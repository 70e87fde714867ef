// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"

/// Expressions of the place, written as such.
namespace spricka::fe::test {

struct Term {
  base::Expression e;
  Term(double value) : e(base::Expression::constant(value)) {} // NOLINT: reads as a number
  explicit Term(base::Op field) : e{{{field, 0.0}}} {}
  Term(const Term& a, const Term& b, base::Op op) : e(a.e) {
    e.code.insert(e.code.end(), b.e.code.begin(), b.e.code.end());
    e.code.push_back({op, 0.0});
  }
  Term(const Term& a, base::Op op) : e(a.e) { e.code.push_back({op, 0.0}); }
};

inline Term operator+(const Term& a, const Term& b) {
  return {a, b, base::Op::add};
}
inline Term operator-(const Term& a, const Term& b) {
  return {a, b, base::Op::subtract};
}
inline Term operator*(const Term& a, const Term& b) {
  return {a, b, base::Op::multiply};
}
inline Term operator/(const Term& a, const Term& b) {
  return {a, b, base::Op::divide};
}
inline Term operator^(const Term& a, const Term& b) {
  return {a, b, base::Op::power};
}
inline Term operator>(const Term& a, const Term& b) {
  return {a, b, base::Op::greater};
}
inline Term operator-(const Term& a) {
  return {a, base::Op::negate};
}
inline Term exp(const Term& a) {
  return {a, base::Op::exp};
}
inline Term log(const Term& a) {
  return {a, base::Op::log};
}
inline Term sqrt(const Term& a) {
  return {a, base::Op::sqrt};
}
inline Term abs(const Term& a) {
  return {a, base::Op::abs};
}
inline Term sin(const Term& a) {
  return {a, base::Op::sin};
}
inline Term cos(const Term& a) {
  return {a, base::Op::cos};
}
inline Term tan(const Term& a) {
  return {a, base::Op::tan};
}
inline Term atan2(const Term& a, const Term& b) {
  return {a, b, base::Op::atan2};
}
inline Term min(const Term& a, const Term& b) {
  return {a, b, base::Op::min};
}
inline Term max(const Term& a, const Term& b) {
  return {a, b, base::Op::max};
}

inline const Term X(base::Op::x);
inline const Term Y(base::Op::y);
inline const Term Z(base::Op::z);
inline const Term RHO(base::Op::rho);
inline const Term THETA(base::Op::theta);

} // namespace spricka::fe::test
