// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/expression.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::base {

namespace {

bool is_field(OpCode op) {
  return op == OpCode::x || op == OpCode::y || op == OpCode::z || op == OpCode::rho ||
         op == OpCode::theta;
}

double field(OpCode op, const Vec3& p) {
  switch (op) {
  case OpCode::x:
    return p.x();
  case OpCode::y:
    return p.y();
  case OpCode::z:
    return p.z();
  case OpCode::rho:
    return std::hypot(p.x(), p.y());
  default:
    return std::atan2(p.y(), p.x());
  }
}

double unary(OpCode op, double a) {
  switch (op) {
  case OpCode::negate:
    return -a;
  case OpCode::sqrt:
    return std::sqrt(a);
  case OpCode::abs:
    return std::abs(a);
  case OpCode::sin:
    return std::sin(a);
  case OpCode::cos:
    return std::cos(a);
  case OpCode::tan:
    return std::tan(a);
  case OpCode::exp:
    return std::exp(a);
  default:
    return std::log(a);
  }
}

bool is_unary(OpCode op) {
  return op == OpCode::negate || op == OpCode::sqrt || op == OpCode::abs || op == OpCode::sin ||
         op == OpCode::cos || op == OpCode::tan || op == OpCode::exp || op == OpCode::log;
}

double truth(bool b) {
  return b ? 1.0 : 0.0;
}

double binary(OpCode op, double a, double b) {
  switch (op) {
  case OpCode::add:
    return a + b;
  case OpCode::subtract:
    return a - b;
  case OpCode::multiply:
    return a * b;
  case OpCode::divide:
    return a / b;
  case OpCode::power:
    return std::pow(a, b);
  case OpCode::less:
    return truth(a < b);
  case OpCode::less_equal:
    return truth(a <= b);
  case OpCode::greater:
    return truth(a > b);
  case OpCode::greater_equal:
    return truth(a >= b);
  case OpCode::equal:
    return truth(a == b);
  case OpCode::logical_and:
    return truth(a != 0.0 && b != 0.0);
  case OpCode::logical_or:
    return truth(a != 0.0 || b != 0.0);
  case OpCode::atan2:
    return std::atan2(a, b);
  case OpCode::min:
    return std::min(a, b);
  default:
    return std::max(a, b);
  }
}

} // namespace

bool CompiledExpression::is_constant() const {
  return std::none_of(code.begin(), code.end(),
                      [](const ExpressionInstruction& i) { return is_field(i.op); });
}

double CompiledExpression::operator()(const Vec3& at) const {
  std::vector<double> stack;
  stack.reserve(code.size());
  for (const ExpressionInstruction& i : code) {
    if (i.op == OpCode::number) {
      stack.push_back(i.value);
    } else if (is_field(i.op)) {
      stack.push_back(field(i.op, at));
    } else if (is_unary(i.op)) {
      stack.back() = unary(i.op, stack.back());
    } else {
      const double b = stack.back();
      stack.pop_back();
      stack.back() = binary(i.op, stack.back(), b);
    }
  }
  return stack.empty() ? 0.0 : stack.back();
}

} // namespace spricka::base
