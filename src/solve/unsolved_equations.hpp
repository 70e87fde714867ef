// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/condensed_equations.hpp"

#include <cassert>
#include <utility>

namespace spricka::solve {

/// In the place of equations that no engine could solve: its report says why.
class UnsolvedEquations final : public CondensedEquations {
public:
  explicit UnsolvedEquations(FactorReport report) : report_(std::move(report)) {
    assert(report_.status != FactorStatus::ok);
  }
  [[nodiscard]] const FactorReport& report() const override { return report_; }
  [[nodiscard]] base::Matrix take_schur() override { return {}; }
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& /*f*/) const override {
    assert(false && "asked of equations that were not solved");
    return {};
  }
  [[nodiscard]] base::Matrix
  solve(const base::Matrix& f, const ExternalDisplacementSolver& /*displacement*/) const override {
    return condense_load(f);
  }
  [[nodiscard]] RowCompliance
  compliance_with_externals_held(SparseRightHandSides /*F*/) const override {
    assert(false && "asked of equations that were not solved");
    return {};
  }

private:
  FactorReport report_;
};

} // namespace spricka::solve
