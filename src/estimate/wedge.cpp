// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/wedge.hpp"

#include "base/vec.hpp"
#include "shape/quadrature.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::estimate {

namespace {

constexpr int degree = 4;
constexpr int nodes = degree + 1;
constexpr double widest = std::numbers::pi / 4.0; // of an element; 1e-6 of an exponent
// Exponents of rigid translations are 0, of rotations 1: as far as round-off moves them.
constexpr double no_exponent = 0.02;
constexpr double regular = 0.995;

// Of the rule: products of shape functions have 8, the rest goes to the sines and cosines of the
// strains.
constexpr int rule_exactness = 11;

struct Shapes {
  std::array<double, nodes> N{};
  std::array<double, nodes> dN{};
};

// Lagrange's polynomials on evenly spaced nodes of -1 .. 1.
Shapes shapes(double x) {
  const auto node = [](int i) { return -1.0 + 2.0 * i / degree; };
  Shapes s;
  for (int i = 0; i < nodes; ++i) {
    double value = 1.0;
    double slope = 0.0;
    for (int j = 0; j < nodes; ++j) {
      if (j != i) {
        const double part = 1.0 / (node(i) - node(j));
        slope = slope * (x - node(j)) * part + value * part;
        value *= (x - node(j)) * part;
      }
    }
    s.N[static_cast<std::size_t>(i)] = value;
    s.dN[static_cast<std::size_t>(i)] = slope;
  }
  return s;
}

// lambda^2 M = K0 + lambda K1 for displacements r^lambda Phi(angle) in x and y.
struct Pencil {
  base::Matrix K0, K1, M;
};

// Strains of r^lambda Phi are r^(lambda - 1) (lambda B1 Phi + B2 Phi').
void add_element(double from, double to, const fe::ConstitutiveLaw& law,
                 const std::array<Eigen::Index, nodes>& at, Pencil& pencil) {
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  C(0, 0) = C(1, 1) = law.lambda + 2.0 * law.mu;
  C(0, 1) = C(1, 0) = law.lambda;
  C(2, 2) = law.mu;
  C *= law.thickness;
  const double half = 0.5 * (to - from);
  for (const auto& point : shape::line_rule(rule_exactness)) {
    const Shapes s = shapes(point.r[0]);
    const double angle = from + half * (1.0 + point.r[0]);
    const double c = std::cos(angle);
    const double n = std::sin(angle);
    Eigen::Matrix<double, 3, 2> B1;
    B1 << c, 0.0, 0.0, n, n, c;
    Eigen::Matrix<double, 3, 2> B2;
    B2 << -n, 0.0, 0.0, c, c, -n;
    const Eigen::Matrix2d K22 = B2.transpose() * C * B2;
    const Eigen::Matrix2d K21 = B2.transpose() * C * B1;
    const Eigen::Matrix2d K11 = B1.transpose() * C * B1;
    for (std::size_t i = 0; i < nodes; ++i) {
      for (std::size_t j = 0; j < nodes; ++j) {
        const double w = point.weight * half;
        const double di = s.dN[i] / half;
        const double dj = s.dN[j] / half;
        // (estimate.15) by powers of lambda: 1, lambda and, on the other side, lambda^2.
        pencil.K0.block<2, 2>(2 * at[i], 2 * at[j]) += w * di * dj * K22;
        pencil.K1.block<2, 2>(2 * at[i], 2 * at[j]) +=
            w * (di * s.N[j] * K21 - s.N[i] * dj * K21.transpose());
        pencil.M.block<2, 2>(2 * at[i], 2 * at[j]) += w * s.N[i] * s.N[j] * K11;
      }
    }
  }
}

struct WedgePiece {
  double from, to;
  const fe::ConstitutiveLaw* law;
};

std::vector<WedgePiece> pieces_of(const MultiMaterialWedge& wedge) {
  std::vector<WedgePiece> pieces;
  for (const WedgeSector& sector : wedge.sectors) {
    const int count = std::max(1, static_cast<int>(std::ceil((sector.to - sector.from) / widest)));
    const double width = (sector.to - sector.from) / count;
    for (int i = 0; i < count; ++i) {
      pieces.push_back({.from = sector.from + i * width,
                        .to = sector.from + (i + 1) * width,
                        .law = &sector.law});
    }
  }
  return pieces;
}

Pencil pencil_of(const MultiMaterialWedge& wedge) {
  const std::vector<WedgePiece> pieces = pieces_of(wedge);
  const auto ends = static_cast<Eigen::Index>(degree * pieces.size());
  const Eigen::Index size = 2 * (wedge.whole ? ends : ends + 1);
  Pencil pencil{.K0 = base::Matrix::Zero(size, size),
                .K1 = base::Matrix::Zero(size, size),
                .M = base::Matrix::Zero(size, size)};
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    std::array<Eigen::Index, nodes> at{};
    for (std::size_t i = 0; i < nodes; ++i) {
      // A wedge all round closes: its last node is the first.
      at[i] = static_cast<Eigen::Index>(degree * p + i) % (size / 2);
    }
    add_element(pieces[p].from, pieces[p].to, *pieces[p].law, at, pencil);
  }
  return pencil;
}

base::Matrix part(const base::Matrix& A, const std::vector<Eigen::Index>& kept) {
  return A(kept, kept);
}

} // namespace

double singularity_exponent(const MultiMaterialWedge& wedge) {
  const Pencil all = pencil_of(wedge);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < all.M.rows(); ++i) {
    const auto c = static_cast<std::size_t>(i % 2);
    const bool first = i < 2;
    const bool last = i + 2 >= all.M.rows();
    const bool held = !wedge.whole && ((first && wedge.held[0][c]) || (last && wedge.held[1][c]));
    if (!held) {
      kept.push_back(i);
    }
  }
  const auto n = static_cast<Eigen::Index>(kept.size());
  // M is positive definite; K0 is not where translations are free.
  const Eigen::LLT<base::Matrix> M(part(all.M, kept));
  // lambda^2 M Phi = (K0 + lambda K1) Phi as an eigenvalue problem of (Phi, lambda Phi).
  base::Matrix companion = base::Matrix::Zero(2 * n, 2 * n);
  companion.topRightCorner(n, n).setIdentity();
  companion.bottomLeftCorner(n, n) = M.solve(part(all.K0, kept));
  companion.bottomRightCorner(n, n) = M.solve(part(all.K1, kept));
  const Eigen::EigenSolver<base::Matrix> solver(companion, false);
  double least = 1.0;
  for (const std::complex<double>& value : solver.eigenvalues()) {
    // Complex exponents count by their real part: it tells how fast the error falls.
    if (value.real() > no_exponent && value.real() < regular) {
      least = std::min(least, value.real());
    }
  }
  return least;
}

} // namespace spricka::estimate
