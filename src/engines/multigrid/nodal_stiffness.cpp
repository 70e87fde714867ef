// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/multigrid/nodal_stiffness.hpp"
#include "base/index.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace spricka::engines {

using base::at;
using base::index;

namespace {

constexpr std::int64_t axes = 3;
constexpr std::int64_t block_size = axes * axes;
constexpr Eigen::Index rigid_count = 6;

} // namespace

NodalStiffness::NodalStiffness(const base::SymmetricCsc& K, std::int64_t locals,
                               const solve::UnknownPlaces& places) {
  number_nodes(locals, places);
  find_blocks(K);
  fill_blocks(K);
  hold_missing_unknowns();
}

void NodalStiffness::number_nodes(std::int64_t locals, const solve::UnknownPlaces& places) {
  std::vector<std::int32_t> given; // [own number]
  place_.reserve(at(locals));
  for (std::int64_t i = 0; i < locals; ++i) {
    const std::int32_t node = places.node[at(i)];
    if (given.empty() || given.back() != node) {
      given.push_back(node);
      unknown_.resize(unknown_.size() + axes, -1);
    }
    const std::int64_t entry =
        axes * (static_cast<std::int64_t>(given.size()) - 1) + places.axis[at(i)];
    unknown_[at(entry)] = i;
    place_.push_back(entry);
  }
  position_.resize(axes, index(given.size()));
  for (std::size_t a = 0; a < given.size(); ++a) {
    position_.col(index(a)) = places.position.col(given[a]);
  }
  row_start_.assign(given.size() + 1, 0);
}

void NodalStiffness::find_blocks(const base::SymmetricCsc& K) {
  const auto locals = static_cast<std::int64_t>(place_.size());
  std::vector<std::int32_t> row;
  for (std::int64_t a = 0; a < nodes(); ++a) {
    row.assign(1, static_cast<std::int32_t>(a));
    for (std::int64_t entry = axes * a; entry < axes * (a + 1); ++entry) {
      const std::int64_t j = unknown_[at(entry)];
      for (std::int64_t p = j < 0 ? 0 : K.start[at(j)]; p < (j < 0 ? 0 : K.start[at(j) + 1]); ++p) {
        const std::int64_t i = K.row[at(p)];
        if (i >= locals) {
          break; // rows ascend
        }
        const auto b = static_cast<std::int32_t>(place_[at(i)] / axes);
        assert(b >= a);
        if (row.back() != b) {
          row.push_back(b);
        }
      }
    }
    std::ranges::sort(row);
    column_.insert(column_.end(), row.begin(), std::unique(row.begin(), row.end()));
    row_start_[at(a) + 1] = static_cast<std::int64_t>(column_.size());
  }
}

void NodalStiffness::fill_blocks(const base::SymmetricCsc& K) {
  const auto locals = static_cast<std::int64_t>(place_.size());
  value_.assign(at(block_size) * column_.size(), 0.0);
  for (std::int64_t j = 0; j < locals; ++j) {
    const std::int64_t a = place_[at(j)] / axes;
    const std::int64_t row_axis = place_[at(j)] % axes;
    std::int64_t k = row_start_[at(a)];
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      const std::int64_t i = K.row[at(p)];
      if (i >= locals) {
        break;
      }
      const std::int64_t b = place_[at(i)] / axes;
      const std::int64_t column_axis = place_[at(i)] % axes;
      while (column_[at(k)] < b) {
        ++k;
      }
      double* const block = &value_[at(block_size * k)];
      block[axes * row_axis + column_axis] = K.value[at(p)];
      if (a == b) {
        block[axes * column_axis + row_axis] = K.value[at(p)];
      }
    }
  }
}

// As stiff as the node is elsewhere, so that it makes the preconditioner no worse.
void NodalStiffness::hold_missing_unknowns() {
  for (std::int64_t a = 0; a < nodes(); ++a) {
    double* const block = &value_[at(block_size * row_start_[at(a)])];
    const double stiffest = std::max({block[0], block[4], block[8]});
    for (std::int64_t c = 0; c < axes; ++c) {
      if (!is_unknown(axes * a + c)) {
        block[(axes + 1) * c] = stiffest;
      }
    }
  }
}

// All the time of a solution is spent here: a row's part of y stays in registers, and the numbers
// of a block are read once for both triangles.
void NodalStiffness::multiply(const double* __restrict x, double* __restrict y) const {
  std::fill_n(y, axes * nodes(), 0.0);
  const double* __restrict A = value_.data();
  for (std::int64_t a = 0; a < nodes(); ++a) {
    double* const ya = y + axes * a;
    const double x0 = x[axes * a];
    const double x1 = x[axes * a + 1];
    const double x2 = x[axes * a + 2];
    // The diagonal block is whole and counts once.
    double y0 = A[0] * x0 + A[1] * x1 + A[2] * x2;
    double y1 = A[3] * x0 + A[4] * x1 + A[5] * x2;
    double y2 = A[6] * x0 + A[7] * x1 + A[8] * x2;
    A += block_size;
    for (std::int64_t k = row_start_[at(a)] + 1; k < row_start_[at(a) + 1]; ++k) {
      const double* const xb = x + axes * column_[at(k)];
      double* const yb = y + axes * column_[at(k)];
      y0 += A[0] * xb[0] + A[1] * xb[1] + A[2] * xb[2];
      y1 += A[3] * xb[0] + A[4] * xb[1] + A[5] * xb[2];
      y2 += A[6] * xb[0] + A[7] * xb[1] + A[8] * xb[2];
      yb[0] += A[0] * x0 + A[3] * x1 + A[6] * x2;
      yb[1] += A[1] * x0 + A[4] * x1 + A[7] * x2;
      yb[2] += A[2] * x0 + A[5] * x1 + A[8] * x2;
      A += block_size;
    }
    ya[0] += y0;
    ya[1] += y1;
    ya[2] += y2;
  }
}

void NodalStiffness::copy_diagonal(double* y) const {
  for (std::int64_t a = 0; a < nodes(); ++a) {
    const double* const block = &value_[at(block_size * row_start_[at(a)])];
    for (std::int64_t c = 0; c < axes; ++c) {
      y[axes * a + c] = block[(axes + 1) * c];
    }
  }
}

FullRows NodalStiffness::full_rows() const {
  // Blocks of each row: those below the diagonal are met first, from rows above.
  std::vector<std::int32_t> width(at(nodes()), 0);
  for (std::int64_t a = 0; a < nodes(); ++a) {
    for (std::int64_t k = row_start_[at(a)]; k < row_start_[at(a) + 1]; ++k) {
      ++width[at(a)];
      width[at(column_[at(k)])] += column_[at(k)] == a ? 0 : 1;
    }
  }
  FullRows rows;
  rows.start.reserve(at(axes * nodes() + 1));
  rows.start.push_back(0);
  for (const std::int32_t blocks : width) {
    for (std::int64_t c = 0; c < axes; ++c) {
      rows.start.push_back(rows.start.back() + static_cast<std::int32_t>(axes) * blocks);
    }
  }
  rows.column.resize(at(rows.start.back()));
  rows.value.resize(at(rows.start.back()));
  std::vector<std::int32_t> next(rows.start.begin(), rows.start.end() - 1);
  const auto put = [&](std::int64_t row, std::int64_t column, double value) {
    std::int32_t& p = next[at(row)];
    rows.column[at(p)] = static_cast<std::int32_t>(column);
    rows.value[at(p)] = value;
    ++p;
  };
  for (std::int64_t a = 0; a < nodes(); ++a) {
    for (std::int64_t k = row_start_[at(a)]; k < row_start_[at(a) + 1]; ++k) {
      const std::int64_t b = column_[at(k)];
      for (std::int64_t c = 0; c < axes; ++c) {
        for (std::int64_t d = 0; d < axes; ++d) {
          const double* const block = &value_[at(block_size * k)];
          put(axes * a + c, axes * b + d, block[axes * c + d]);
          if (a != b) {
            put(axes * b + c, axes * a + d, block[axes * d + c]);
          }
        }
      }
    }
  }
  return rows;
}

base::Matrix NodalStiffness::rigid_motions() const {
  base::Matrix motions = base::Matrix::Zero(index(axes * nodes()), rigid_count);
  const base::Vec3 centre = position_.rowwise().mean();
  for (std::int64_t a = 0; a < nodes(); ++a) {
    const base::Vec3 arm = position_.col(a) - centre;
    for (Eigen::Index c = 0; c < axes; ++c) {
      const base::Vec3 axis = base::Vec3::Unit(c);
      const base::Vec3 turned = axis.cross(arm);
      for (Eigen::Index d = 0; d < axes; ++d) {
        if (is_unknown(axes * a + d)) {
          motions(axes * a + d, c) = axis[d];
          motions(axes * a + d, axes + c) = turned[d];
        }
      }
    }
  }
  // Twice: what is left of a motion that the others nearly make is as good as orthogonal.
  for (int pass = 0; pass < 2; ++pass) {
    for (Eigen::Index k = 0; k < rigid_count; ++k) {
      for (Eigen::Index other = 0; other < k; ++other) {
        motions.col(k) -= motions.col(other).dot(motions.col(k)) * motions.col(other);
      }
      const double length = motions.col(k).norm();
      motions.col(k) *= length > 0.0 ? 1.0 / length : 0.0;
    }
  }
  return motions;
}

void NodalStiffness::append_column(std::int64_t unknown, std::vector<std::int64_t>& rows,
                                   std::vector<double>& values) const {
  const std::int64_t a = place_[at(unknown)] / axes;
  const std::int64_t row_axis = place_[at(unknown)] % axes;
  for (std::int64_t k = row_start_[at(a)]; k < row_start_[at(a) + 1]; ++k) {
    for (std::int64_t c = 0; c < axes; ++c) {
      const std::int64_t row = unknown_[at(axes * column_[at(k)] + c)];
      if (row >= unknown) {
        rows.push_back(row);
        values.push_back(value_[at(block_size * k + axes * row_axis + c)]);
      }
    }
  }
}

base::Vector NodalStiffness::by_node(const base::Vector& locals) const {
  base::Vector nodal = base::Vector::Zero(index(axes * nodes()));
  for (std::size_t i = 0; i < place_.size(); ++i) {
    nodal[place_[i]] = locals[index(i)];
  }
  return nodal;
}

base::Vector NodalStiffness::by_unknown(const base::Vector& nodal) const {
  base::Vector locals(index(place_.size()));
  for (std::size_t i = 0; i < place_.size(); ++i) {
    locals[index(i)] = nodal[place_[i]];
  }
  return locals;
}

} // namespace spricka::engines
