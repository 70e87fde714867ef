// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression_range.hpp"
#include "fe/adaptive_rule.hpp"
#include "fe/face.hpp"
#include "model/forward.hpp"
#include "model/loads.hpp"

/// Quadrature rules for loads given as expressions: one for the loads, K and error bars.
namespace spricka::fe {

/// Components of a load at a point; missing ones are zero.
inline base::Vec3 load_value(const model::Load& load, const base::Vec3& x) {
  base::Vec3 value = base::Vec3::Zero();
  for (std::size_t c = 0; c < load.value.size(); ++c) {
    value[static_cast<Eigen::Index>(c)] = load.value[c](x);
  }
  return value;
}

inline bool is_constant(const model::Load& load) {
  return std::ranges::all_of(load.value, [](const base::Expression& v) { return v.is_constant(); });
}

/// Whether nothing in a load's expressions can jump or kink: no comparison, abs, min or max.
inline bool is_smooth(const model::Load& load) {
  using base::Op;
  return std::ranges::all_of(load.value, [](const base::Expression& v) {
    return std::ranges::none_of(v.code, [](const base::Instruction& i) {
      return (i.op >= Op::less && i.op <= Op::logical_or) || i.op == Op::abs || i.op == Op::min ||
             i.op == Op::max || i.op == Op::atan2 || i.op == Op::sqrt || i.op == Op::theta;
    });
  });
}

/// Tolerance of the integrals over an element or a side, of the load's mean value times its size:
/// jumps of plane and solid fields cost more than those along an edge.
constexpr double load_tolerance(int dim) {
  return dim == 1 ? 1e-9 : (dim == 2 ? 1e-7 : 1e-4);
}

/// Ends a cell, whose centre is known, where a side of its element runs along a coordinate: two
/// nodes or more are the outermost. A jump that stands on the border, to round-off, is none of the
/// element.
template <int nodes>
void end_at_sides(const Eigen::Matrix<double, 3, nodes>& X, base::PlaceCell& cell) {
  constexpr double round_off = 1e-9;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double low = X.row(k).minCoeff();
    const double high = X.row(k).maxCoeff();
    const double off = round_off * (high - low);
    if (high > low && (X.row(k).array() <= low + off).count() > 1) {
      cell.least[k] = low + 2.0 * off;
    }
    if (high > low && (X.row(k).array() >= high - off).count() > 1) {
      cell.most[k] = high - 2.0 * off;
    }
  }
  cell.least = cell.least.cwiseMin(cell.centre);
  cell.most = cell.most.cwiseMax(cell.centre);
}

/// Where a cell of the unit cube of a shape lies in space; X [3, nodes].
template <shape::Shape S>
base::PlaceCell place_cell(const Eigen::Matrix<double, 3, S::nodes>& X, std::array<double, 3> low,
                           std::array<double, 3> high) {
  constexpr double border = 1e-9; // to round-off
  for (std::size_t k = 0; k < S::dim; ++k) {
    if (low[k] < high[k]) {
      low[k] = std::max(low[k], border);
      high[k] = std::min(high[k], 1.0 - border);
    }
  }
  const auto at = [&](const std::array<double, 3>& s) { // s in [-1, 1]
    std::array<double, 3> t{};
    for (std::size_t k = 0; k < S::dim; ++k) {
      t[k] = 0.5 * (low[k] + high[k]) + 0.5 * s[k] * (high[k] - low[k]);
    }
    return base::Vec3(X * S::N(unit_cube_point<S>(t).r));
  };
  base::PlaceCell cell;
  cell.centre = at({});
  end_at_sides<S::nodes>(X, cell);
  for (std::size_t k = 0; k < S::dim; ++k) {
    std::array<double, 3> s{};
    s[k] = 1.0;
    const base::Vec3 ahead = at(s);
    s[k] = -1.0;
    cell.axes.col(static_cast<Eigen::Index>(k)) = 0.5 * (ahead - at(s));
  }
  constexpr int corners = S::dim == 1 ? 3 : (S::dim == 2 ? 9 : 27);
  for (int c = 0; c < corners; ++c) { // what is curved leaves the straight cell most at these
    std::array<double, 3> s{};
    for (int k = 0, rest = c; k < S::dim; ++k, rest /= 3) {
      s[static_cast<std::size_t>(k)] = rest % 3 - 1;
    }
    const base::Vec3 straight = cell.centre + cell.axes * base::Vec3(s[0], s[1], s[2]);
    cell.bulge = cell.bulge.cwiseMax((at(s) - straight).cwiseAbs());
  }
  return cell;
}

/// By how much a load may leave the values seen in a cell.
inline double hidden_value(const model::Load& load, const base::PlaceCell& cell,
                           const SeenValues& seen) {
  double most = 0.0;
  for (std::size_t c = 0; c < load.value.size(); ++c) {
    if (!load.value[c].is_constant()) {
      const base::ValueRange range = base::range_over(load.value[c], cell);
      const auto k = static_cast<Eigen::Index>(c);
      most = std::max({most, range.high - seen.high[k], seen.low[k] - range.low});
    }
  }
  return most;
}

/// The rule that a load wants over a side or an element with nodes X [3, nodes]; `scale` as
/// load_scale gives it. Compiled in load_rule.cpp for each.
template <shape::Shape S>
AdaptedRule<S::dim> load_rule(const Eigen::Matrix<double, 3, S::nodes>& X, const model::Load& load,
                              const FieldScale& scale);

/// The same with nodes in the plane or in space [dim, nodes].
template <shape::ElementShape S>
AdaptedRule<S::dim> body_load_rule(const NodeVectors<S>& X, const model::Load& load,
                                   const FieldScale& scale) {
  Eigen::Matrix<double, 3, S::nodes> x = Eigen::Matrix<double, 3, S::nodes>::Zero();
  x.template topRows<S::dim>() = X;
  return load_rule<S>(x, load, scale);
}

/// Part of a load's total magnitude that no rule could follow, 1 at most; 0 where all agree to
/// load_tolerance.
double unresolved_part(const model::Model& model, const model::Mesh& mesh, const model::Load& load);

/// How large a load spread over faces or elements is anywhere and in the mean: what counts as
/// small. `elements`: those it acts on, where it acts on elements.
FieldScale load_scale(const model::Mesh& mesh, const model::Load& load,
                      const std::vector<base::ElementId>& elements = {});

} // namespace spricka::fe
