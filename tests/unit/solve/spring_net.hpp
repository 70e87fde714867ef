// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/dense_solve.hpp"
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "solve/row_elimination.hpp"
#include "solve/unknown_places.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

/// Elastic nets of springs, whose condensation dense algebra can check.
namespace spricka::solve::test_nets {

using base::Matrix;
using base::SymmetricCsc;
using base::Vector;

inline std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// A square net of nodes [side, side] joined by springs along edges and both diagonals: elastic,
/// two freedoms a node, free to move as a rigid body unless `ground` holds the left side.
struct SpringNet {
  int side;
  double ground;
  std::vector<int> number; ///< [nodes] place of each node in the numbering

  SpringNet(int s, double g) : side(s), ground(g), number(at(s) * at(s)) {
    std::iota(number.begin(), number.end(), 0);
  }

  [[nodiscard]] std::int64_t rows() const { return 2LL * side * side; }
  [[nodiscard]] std::int64_t row(int x, int y, int c) const {
    return 2LL * number[at(y * side + x)] + c;
  }

  /// Numbers the nodes so that those with `last(x, y)` come last; returns how many rows those have.
  template <class Last> std::int64_t put_last(Last last) {
    int next = 0;
    std::int64_t count = 0;
    for (const bool pass : {false, true}) {
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          if (last(x, y) == pass) {
            number[at(y * side + x)] = next++;
            count += pass ? 2 : 0;
          }
        }
      }
    }
    return count;
  }

  [[nodiscard]] SymmetricCsc matrix() const {
    std::map<std::pair<std::int64_t, std::int64_t>, double> entries; // (column, row)
    const auto add = [&](std::int64_t i, std::int64_t j, double v) {
      if (i >= j) {
        entries[{j, i}] += v;
      }
    };
    const auto spring = [&](int x0, int y0, int x1, int y1, double k) {
      const double length = std::hypot(x1 - x0, y1 - y0);
      const double d[2] = {(x1 - x0) / length, (y1 - y0) / length};
      for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
          const double v = k * d[a] * d[b];
          add(row(x0, y0, a), row(x0, y0, b), v);
          add(row(x1, y1, a), row(x1, y1, b), v);
          add(row(x0, y0, a), row(x1, y1, b), -v);
          add(row(x1, y1, a), row(x0, y0, b), -v);
        }
      }
    };
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const double k = 1.0 + 0.3 * std::sin(x + 2.0 * y);
        if (x + 1 < side) {
          spring(x, y, x + 1, y, k);
        }
        if (y + 1 < side) {
          spring(x, y, x, y + 1, k);
        }
        if (x + 1 < side && y + 1 < side) {
          spring(x, y, x + 1, y + 1, 0.5 * k);
          spring(x + 1, y, x, y + 1, 0.7 * k);
        }
      }
      if (ground > 0.0) {
        add(row(0, y, 0), row(0, y, 0), ground);
        add(row(0, y, 1), row(0, y, 1), ground);
      }
    }
    return compress(entries);
  }

  /// Displacements of the three rigid motions [rows, 3].
  [[nodiscard]] Matrix rigid() const {
    Matrix R = Matrix::Zero(rows(), 3);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        R(row(x, y, 0), 0) = 1.0;
        R(row(x, y, 1), 1) = 1.0;
        R(row(x, y, 0), 2) = -static_cast<double>(y) / side;
        R(row(x, y, 1), 2) = static_cast<double>(x) / side;
      }
    }
    return R;
  }

private:
  [[nodiscard]] SymmetricCsc
  compress(const std::map<std::pair<std::int64_t, std::int64_t>, double>& entries) const {
    SymmetricCsc K;
    K.n = rows();
    K.start.assign(at(K.n) + 1, 0);
    for (const auto& [place, value] : entries) {
      K.row.push_back(place.second);
      K.value.push_back(value);
      ++K.start[at(place.first) + 1];
    }
    std::partial_sum(K.start.begin(), K.start.end(), K.start.begin());
    return K;
  }
};

inline Matrix dense(const SymmetricCsc& K) {
  Matrix A = Matrix::Zero(K.n, K.n);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      A(K.row[at(p)], j) = K.value[at(p)];
      A(j, K.row[at(p)]) = K.value[at(p)];
    }
  }
  return A;
}

inline Matrix random_columns(std::int64_t n, int k) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  return Matrix::NullaryExpr(n, k, [&] { return number(engine); });
}

inline Matrix dense_schur(const Matrix& A, std::int64_t l) {
  const std::int64_t e = A.rows() - l;
  return A.bottomRightCorner(e, e) -
         A.bottomLeftCorner(e, l) * base::solve_square_system(Matrix(A.topLeftCorner(l, l)),
                                                              Matrix(A.topRightCorner(l, e)));
}

inline bool same_bits(const Matrix& a, const Matrix& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

/// Rows of two or three unknowns, of locals and of externals.
inline SparseRightHandSides random_rows(std::int64_t n, int k) {
  std::mt19937 engine(11);
  std::uniform_int_distribution<std::int64_t> place(0, n - 1);
  std::uniform_real_distribution<double> weight(-1.0, 1.0);
  SparseRightHandSides F;
  for (int j = 0; j < k; ++j) {
    for (int i = 0; i < 2 + j % 2; ++i) {
      F.row.push_back(place(engine));
      F.value.push_back(weight(engine));
    }
    F.start.push_back(static_cast<std::int64_t>(F.row.size()));
  }
  return F;
}

/// A block of nodes joined by springs to all 26 neighbours: an elastic body in space whose rigid
/// motions are exact. The first layer stands on springs of its own where `ground` says so; the
/// nodes of the last `external_layers` layers are external.
struct SpringBlock {
  std::array<int, 3> sides;
  double ground = 1.0;
  int external_layers = 0;
  double stretch = 1.0; ///< of all distances along x: flat cells
  bool loose_corner = false;

  [[nodiscard]] std::int64_t nodes() const { return 1LL * sides[0] * sides[1] * sides[2]; }
  [[nodiscard]] std::int64_t rows() const { return 3 * nodes(); }
  [[nodiscard]] std::int64_t externals() const {
    return 3LL * sides[0] * sides[1] * external_layers;
  }
  [[nodiscard]] std::array<int, 3> cell(std::int64_t node) const {
    return {static_cast<int>(node % sides[0]), static_cast<int>(node / sides[0] % sides[1]),
            static_cast<int>(node / sides[0] / sides[1])};
  }
  [[nodiscard]] Eigen::Vector3d place(std::int64_t node) const {
    const std::array<int, 3> c = cell(node);
    return {stretch * c[0], 1.0 * c[1], 1.0 * c[2]};
  }
  [[nodiscard]] UnknownPlaces places() const {
    UnknownPlaces places;
    places.position.resize(3, nodes());
    for (std::int64_t i = 0; i < rows(); ++i) {
      places.node.push_back(static_cast<std::int32_t>(i / 3));
      places.axis.push_back(static_cast<std::int8_t>(i % 3));
      places.position.col(i / 3) = place(i / 3);
    }
    return places;
  }
  [[nodiscard]] SymmetricCsc matrix() const {
    std::map<std::pair<std::int64_t, std::int64_t>, double> entries; // (column, row)
    for (std::int64_t a = 0; a < nodes(); ++a) {
      for (int c = 0; c < 3; ++c) {
        entries[{3 * a + c, 3 * a + c}] += cell(a)[2] == 0 ? ground : 0.0;
      }
      const std::int64_t last =
          std::min<std::int64_t>(nodes(), a + 1LL * sides[0] * sides[1] + sides[0] + 2);
      for (std::int64_t b = a + 1; b < last; ++b) {
        if (are_neighbours(a, b) && !(loose_corner && a == 0)) {
          add_spring(a, b, entries);
        }
      }
    }
    SymmetricCsc K;
    K.n = rows();
    K.start.assign(at(K.n) + 1, 0);
    for (const auto& [where, value] : entries) {
      K.row.push_back(where.second);
      K.value.push_back(value);
      ++K.start[at(where.first) + 1];
    }
    std::partial_sum(K.start.begin(), K.start.end(), K.start.begin());
    return K;
  }

private:
  [[nodiscard]] bool are_neighbours(std::int64_t a, std::int64_t b) const {
    for (std::size_t c = 0; c < 3; ++c) {
      if (std::abs(cell(a).at(c) - cell(b).at(c)) > 1) {
        return false;
      }
    }
    return true;
  }
  void add_spring(std::int64_t a, std::int64_t b,
                  std::map<std::pair<std::int64_t, std::int64_t>, double>& entries) const {
    const Eigen::Vector3d d = place(b) - place(a);
    const Eigen::Matrix3d k = d * d.transpose() / std::pow(d.norm(), 3);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        entries[{3 * a + j, 3 * b + i}] -= k(i, j);
        if (i >= j) {
          entries[{3 * a + j, 3 * a + i}] += k(i, j);
          entries[{3 * b + j, 3 * b + i}] += k(i, j);
        }
      }
    }
  }
};

} // namespace spricka::solve::test_nets
