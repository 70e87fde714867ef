// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "solve/unknown_places.hpp"

#include <cstdint>
#include <vector>

namespace spricka::engines {

/// Rows of a whole matrix, both triangles, as libraries with 32-bit numbers want them.
struct FullRows {
  std::vector<std::int32_t> start, column;
  std::vector<double> value;
};

/// The stiffness of the locals of a body in space, as 3 x 3 blocks of nodes: of the upper triangle,
/// since a product with half of the numbers takes half of the time. A node whose freedoms are
/// partly suppressed or external has a stiff spring of its own in their place, to which nothing is
/// coupled; vectors [3 nodes] are zero there.
class NodalStiffness {
public:
  /// Of the first `locals` rows of K; unknowns of a node follow one another.
  NodalStiffness(const base::SymmetricCsc& K, std::int64_t locals,
                 const solve::UnknownPlaces& places);

  [[nodiscard]] std::int64_t nodes() const {
    return static_cast<std::int64_t>(row_start_.size()) - 1;
  }
  [[nodiscard]] std::int64_t blocks() const { return static_cast<std::int64_t>(column_.size()); }
  /// Entry of nodal vectors that an unknown has.
  [[nodiscard]] std::int64_t place(std::int64_t unknown) const {
    return place_[static_cast<std::size_t>(unknown)];
  }
  [[nodiscard]] const base::Matrix& position() const { return position_; } ///< [3, nodes]

  /// y <- K x; both [3 nodes].
  void multiply(const double* x, double* y) const;
  void copy_diagonal(double* y) const;
  [[nodiscard]] FullRows full_rows() const;
  /// Rigid motions [3 nodes, 6], orthonormal, zero where there is no unknown.
  [[nodiscard]] base::Matrix rigid_motions() const;
  [[nodiscard]] bool is_unknown(std::int64_t entry) const {
    return unknown_[static_cast<std::size_t>(entry)] >= 0;
  }
  /// Column of the lower triangle of the locals: rows and values are appended, rows ascending.
  void append_column(std::int64_t unknown, std::vector<std::int64_t>& rows,
                     std::vector<double>& values) const;

  /// Nodal vector of the locals of a column [n], and back.
  [[nodiscard]] base::Vector by_node(const base::Vector& locals) const;
  [[nodiscard]] base::Vector by_unknown(const base::Vector& nodal) const;

private:
  void number_nodes(std::int64_t locals, const solve::UnknownPlaces& places);
  void find_blocks(const base::SymmetricCsc& K);
  void fill_blocks(const base::SymmetricCsc& K);
  void hold_missing_unknowns();

  std::vector<std::int64_t> place_;     ///< [unknown]
  std::vector<std::int64_t> unknown_;   ///< [3 node + axis] or -1
  std::vector<std::int64_t> row_start_; ///< [nodes + 1] into blocks, the diagonal one first
  std::vector<std::int32_t> column_;    ///< [block] node
  std::vector<double> value_;           ///< [9 block + 3 axis of the row + axis of the column]
  base::Matrix position_;
};

} // namespace spricka::engines
