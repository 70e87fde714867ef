// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"

/// Expressions of the place, written as such.
namespace spricka::test::field {

struct CardField {
  base::CompiledExpression e;
  CardField(double value)
      : e(base::CompiledExpression::make_constant(value)) {} // NOLINT: reads as a number
  explicit CardField(base::OpCode field) : e{{{field, 0.0}}} {}
  CardField(const CardField& a, const CardField& b, base::OpCode op) : e(a.e) {
    e.code.insert(e.code.end(), b.e.code.begin(), b.e.code.end());
    e.code.push_back({op, 0.0});
  }
  CardField(const CardField& a, base::OpCode op) : e(a.e) { e.code.push_back({op, 0.0}); }
};

inline CardField operator+(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::add};
}
inline CardField operator-(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::subtract};
}
inline CardField operator*(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::multiply};
}
inline CardField operator/(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::divide};
}
inline CardField operator^(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::power};
}
inline CardField operator>(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::greater};
}
inline CardField operator-(const CardField& a) {
  return {a, base::OpCode::negate};
}
inline CardField exp(const CardField& a) {
  return {a, base::OpCode::exp};
}
inline CardField log(const CardField& a) {
  return {a, base::OpCode::log};
}
inline CardField sqrt(const CardField& a) {
  return {a, base::OpCode::sqrt};
}
inline CardField abs(const CardField& a) {
  return {a, base::OpCode::abs};
}
inline CardField sin(const CardField& a) {
  return {a, base::OpCode::sin};
}
inline CardField cos(const CardField& a) {
  return {a, base::OpCode::cos};
}
inline CardField tan(const CardField& a) {
  return {a, base::OpCode::tan};
}
inline CardField atan2(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::atan2};
}
inline CardField min(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::min};
}
inline CardField max(const CardField& a, const CardField& b) {
  return {a, b, base::OpCode::max};
}

inline const CardField X(base::OpCode::x);
inline const CardField Y(base::OpCode::y);
inline const CardField Z(base::OpCode::z);
inline const CardField RHO(base::OpCode::rho);
inline const CardField THETA(base::OpCode::theta);

} // namespace spricka::test::field
