// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/expression.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::base {

namespace {

bool is_field(Op op) {
  return op == Op::x || op == Op::y || op == Op::z || op == Op::rho || op == Op::theta;
}

double field(Op op, const Vec3& p) {
  switch (op) {
  case Op::x:
    return p.x();
  case Op::y:
    return p.y();
  case Op::z:
    return p.z();
  case Op::rho:
    return std::hypot(p.x(), p.y());
  default:
    return std::atan2(p.y(), p.x());
  }
}

double unary(Op op, double a) {
  switch (op) {
  case Op::negate:
    return -a;
  case Op::sqrt:
    return std::sqrt(a);
  case Op::abs:
    return std::abs(a);
  case Op::sin:
    return std::sin(a);
  case Op::cos:
    return std::cos(a);
  case Op::tan:
    return std::tan(a);
  case Op::exp:
    return std::exp(a);
  default:
    return std::log(a);
  }
}

bool is_unary(Op op) {
  return op == Op::negate || op == Op::sqrt || op == Op::abs || op == Op::sin || op == Op::cos ||
         op == Op::tan || op == Op::exp || op == Op::log;
}

double truth(bool b) {
  return b ? 1.0 : 0.0;
}

double binary(Op op, double a, double b) {
  switch (op) {
  case Op::add:
    return a + b;
  case Op::subtract:
    return a - b;
  case Op::multiply:
    return a * b;
  case Op::divide:
    return a / b;
  case Op::power:
    return std::pow(a, b);
  case Op::less:
    return truth(a < b);
  case Op::less_equal:
    return truth(a <= b);
  case Op::greater:
    return truth(a > b);
  case Op::greater_equal:
    return truth(a >= b);
  case Op::equal:
    return truth(a == b);
  case Op::logical_and:
    return truth(a != 0.0 && b != 0.0);
  case Op::logical_or:
    return truth(a != 0.0 || b != 0.0);
  case Op::atan2:
    return std::atan2(a, b);
  case Op::min:
    return std::min(a, b);
  default:
    return std::max(a, b);
  }
}

} // namespace

bool Expression::is_constant() const {
  return std::none_of(code.begin(), code.end(),
                      [](const Instruction& i) { return is_field(i.op); });
}

double Expression::operator()(const Vec3& at) const {
  std::vector<double> stack;
  stack.reserve(code.size());
  for (const Instruction& i : code) {
    if (i.op == Op::number) {
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
