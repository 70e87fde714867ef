// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstdint>
#include <vector>

namespace spricka::base {

enum class OpCode : std::uint8_t {
  number, ///< push Instruction::value
  x,
  y,
  z,
  rho,
  theta, ///< push a field variable; rho, theta: cylindrical about z
  add,
  subtract,
  multiply,
  divide,
  power,
  negate,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  logical_and,
  logical_or,
  sqrt,
  abs,
  sin,
  cos,
  tan,
  atan2,
  exp,
  log,
  min,
  max
};

struct ExpressionInstruction {
  OpCode op = OpCode::number;
  double value = 0.0;
};

/// A compiled expression in reverse Polish order, parameters already folded to numbers. Built by
/// the grammar, evaluated anywhere. Logical results are 1 and 0.
struct CompiledExpression {
  std::vector<ExpressionInstruction> code;

  /// An expression that has this value everywhere.
  static CompiledExpression make_constant(double value) { return {{{OpCode::number, value}}}; }
  [[nodiscard]] bool is_constant() const;
  /// Value at a point. Domain errors give NaN, as the C library does.
  [[nodiscard]] double operator()(const Vec3& at) const;
};

} // namespace spricka::base
