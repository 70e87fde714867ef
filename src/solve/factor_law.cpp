// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/factor_law.hpp"

#include "base/by_dimension.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace spricka::solve {

namespace {

// Separators of the orders that are in use over planes of nodes: minimum degree in the plane, METIS
// in space. Between those of blocks (1.0, 0.95) and of meshes fine at cracks and contacts.
constexpr base::ByDimension separator_width{1.12, 1.05};
// Of what is stored full, over the fronts: columns with nearly the same rows are put together.
constexpr double stored_over_fronts = 1.1;
// Fronts of contact rows that are held at a time, in sizes of the largest.
constexpr double held_fronts = 3.0;
// Time of the symbolic phase [s] for each unknown.
constexpr base::ByDimension analysis_time{0.8e-6, 6e-6};
constexpr double entry = 8.0;         // [bytes] of a factor
constexpr double matrix_entry = 16.0; // [bytes] of the matrix, (solve.8)

/// All boxes that a depth of the dissection makes: of one size, told apart by how many of their
/// sides along each axis are separators.
class DissectedBoxes {
public:
  explicit DissectedBoxes(const NetOutline& net) : net_(net), side_(net.cells) {
    for (std::size_t c = 0; c < 3; ++c) {
      side_[c] = c < axes() ? std::max(1.0, side_[c]) : 1.0;
    }
    density_ = net.locals / (side_[0] * side_[1] * side_[2]);
    width_ = separator_width.at(net.dim) * net.layer_share;
    count_[0][0][0] = 1.0;
  }

  [[nodiscard]] FactorReport dissect() {
    const double e = net_.externals;
    report_.flops = e * e * e / 3.0;
    report_.factor_entries = 0.5 * e * e;
    full_entries_ = e * e;
    constexpr std::size_t most = 3 * 64; // halvings; no side is longer than 2^64 cells
    for (std::size_t depth = 0; depth < most; ++depth) {
      const auto longest =
          static_cast<std::size_t>(std::max_element(side_.begin(), side_.end()) - side_.begin());
      const bool last = side_[longest] <= 1.0;
      eliminate(longest, last, static_cast<double>(depth));
      if (last) {
        break;
      }
      halve(longest);
    }
    report_.kept_memory = entry * stored_over_fronts * full_entries_;
    const double entries = 0.5 * net_.dim * net_.row_neighbours * (net_.locals + e);
    report_.memory = report_.kept_memory + std::max(matrix_entry * entries, entry * e * e);
    report_.analysis_cpu = analysis_time.at(net_.dim) * (net_.locals + e);
    return report_;
  }

private:
  template <class F> void for_kinds(F&& f) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t k = 0; k < 3; ++k) {
          if (count_[i][j][k] > 0.0) {
            f(std::array{i, j, k}, count_[i][j][k]);
          }
        }
      }
    }
  }

  [[nodiscard]] std::size_t axes() const { return static_cast<std::size_t>(net_.dim); }

  // The separators of one depth, or what is left in the boxes at the last.
  void eliminate(std::size_t across, bool last, double depth) {
    // Externals and rows of contact lie on a surface: so many of the boxes reach it, with so much
    // of it each.
    const double reaching = std::exp2(-depth / net_.dim);
    const double part = std::exp2(-depth * (net_.dim - 1) / net_.dim);
    const double surface = net_.externals + net_.rows > 0.0 ? reaching : 0.0;
    for_kinds([&](const std::array<std::size_t, 3>& separators, double count) {
      double inside = density_; // what earlier separators have left of the box
      double around = 0.0;
      for (std::size_t c = 0; c < axes(); ++c) {
        const auto sides = static_cast<double>(separators.at(c));
        inside *= c == across && !last ? width_ : std::max(0.0, side_.at(c) - 0.5 * width_ * sides);
        around += sides * width_ * density_ * side_[0] * side_[1] * side_[2] / side_.at(c);
      }
      add_fronts((1.0 - surface) * count, inside, around, 0.0);
      add_fronts(surface * count, inside, around + part * net_.externals, part * net_.rows);
    });
  }

  // Fronts of s columns with r rows below, on which k rows of contact have entries.
  void add_fronts(double count, double s, double r, double k) {
    if (count <= 0.0) {
      return;
    }
    report_.flops += count * (std::pow(s + r, 3) - std::pow(r, 3)) / 3.0;
    report_.factor_entries += count * s * (0.5 * s + r);
    full_entries_ += count * s * (s + r);
    report_.row_flops += count * k * s * (s + 2.0 * r + k);
    report_.row_memory = std::max(report_.row_memory, held_fronts * entry * k * (s + r));
  }

  // Of two halves each has the new separator at one side, and what the whole had at the other.
  void halve(std::size_t across) {
    side_.at(across) *= 0.5;
    Counts halves{};
    for_kinds([&](const std::array<std::size_t, 3>& separators, double count) {
      for (const std::size_t old :
           {std::min<std::size_t>(1, separators.at(across)), separators.at(across) / 2}) {
        std::array<std::size_t, 3> half = separators;
        half.at(across) = old + 1;
        halves.at(half[0]).at(half[1]).at(half[2]) += count;
      }
    });
    count_ = halves;
  }

  using Counts = std::array<std::array<std::array<double, 3>, 3>, 3>;
  const NetOutline& net_;
  std::array<double, 3> side_; ///< [cells] of a box
  double density_ = 0.0;       ///< unknowns of a cell
  double width_ = 0.0;         ///< of a separator [cells]
  Counts count_{};             ///< by separators across each axis
  FactorReport report_;
  double full_entries_ = 0.0; ///< of fronts stored full
};

} // namespace

FactorReport estimate_factor(const NetOutline& net) {
  return net.locals + net.externals > 0.0 ? DissectedBoxes(net).dissect() : FactorReport();
}

} // namespace spricka::solve
