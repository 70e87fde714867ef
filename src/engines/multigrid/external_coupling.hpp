// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"

#include <cstdint>
#include <vector>

namespace spricka::engines {

/// The rows of K that are external: K_el and K_ee.
class ExternalCoupling {
public:
  ExternalCoupling() = default;
  ExternalCoupling(const base::SymmetricCsc& K, std::int64_t locals);

  [[nodiscard]] std::int64_t externals() const { return K_ee_.rows(); }
  [[nodiscard]] const base::Matrix& external_stiffness() const { return K_ee_; }
  /// K_el u [externals] of locals u.
  [[nodiscard]] base::Vector forces_on_externals(const base::Vector& u) const;
  /// K_le u [locals] of external displacements u.
  [[nodiscard]] base::Vector forces_on_locals(const base::Vector& u) const;
  /// The external rows of the column of a local unknown are appended, ascending.
  void append_column(std::int64_t local, std::vector<std::int64_t>& rows,
                     std::vector<double>& values) const;

private:
  std::vector<std::int64_t> start_{0}; ///< [locals + 1]
  std::vector<std::int64_t> external_;
  std::vector<double> value_;
  base::Matrix K_ee_;
};

} // namespace spricka::engines
