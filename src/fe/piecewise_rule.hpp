// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/field_lines.hpp"

/// Quadrature of a field that jumps or bends, by pieces; for adaptive_rule.cpp alone.
namespace spricka::fe {

/// Lines through cells of the directions across, the cell with the largest error halved next. So a
/// jump across a surface is integrated up to its place, and cells have to follow no more than the
/// curve in which that surface leaves the element.
template <int dim> class PiecewiseRule {
public:
  /// `amount`: of the field, by a first look.
  PiecewiseRule(const AdaptiveDomain<dim>& domain, const ReferenceField<dim>& value,
                const AdaptiveSettings& settings, double amount, const FieldOutlier& outlier)
      : lines_(domain, value, part_of_line * settings.tolerance * amount, settings.smooth, outlier),
        tolerance_(settings.tolerance), least_amount_(amount) {}

  /// The points of the rule over the reference element: cells are halved until the estimate of the
  /// error is within the tolerance or the bound on evaluations is reached; then `missed` is what is
  /// left.
  FieldAdaptedRule<dim> build_rule() {
    std::vector<HalvedCell> heap{split(cell({}, {1.0, 1.0, 1.0}))};
    double error = heap.front().error;
    while (heap.front().halved && error > tolerance_ * std::max(amount_of(heap), least_amount_) &&
           lines_.evaluations() < adaptive_rule_limits<dim>.evaluations && std::isfinite(error)) {
      std::ranges::pop_heap(heap, less);
      HalvedCell worst = std::move(heap.back());
      heap.pop_back();
      for (QuadratureCell& half : worst.halves) {
        heap.push_back(split(std::move(half)));
        std::ranges::push_heap(heap, less);
      }
      error = 0.0;
      for (const HalvedCell& s : heap) {
        error += s.error;
      }
    }
    return collect_points(heap, error);
  }

  [[nodiscard]] const ValueRange& value_range() const { return lines_.value_range(); }

private:
  static constexpr double part_of_line = 0.1;

  /// A part of the directions across.
  struct QuadratureCell {
    UnitPoint low{}, size{};
    LineIntegrals<dim> sums;
  };
  struct HalvedCell {
    QuadratureCell whole;
    bool halved = false; ///< a line alone has no halves
    std::array<QuadratureCell, 2> halves;
    double error = 0.0;
  };
  static bool less(const HalvedCell& a, const HalvedCell& b) { return a.error < b.error; }

  QuadratureCell cell(const UnitPoint& low, const UnitPoint& size) {
    QuadratureCell result;
    result.low = low;
    result.size = size;
    add_lines(result, dim - 1, {}, 1.0);
    return result;
  }

  // Adds the integrals along the lines through a cell, spread over the last `open` directions
  // behind that of the lines.
  void add_lines(QuadratureCell& cell, std::size_t open, UnitPoint t, double weight) {
    if (open == 0) {
      lines_.integrate_line(t, weight, cell.sums);
      return;
    }
    const std::size_t k = (lines_.line_direction() + dim - open) % dim;
    for (const auto& p : shape::line_rule(adaptive_rule_limits<dim>.across_degree)) {
      t[k] = cell.low[k] + 0.5 * cell.size[k] * (1.0 + p.r[0]);
      add_lines(cell, open - 1, t, 0.5 * cell.size[k] * p.weight * weight);
    }
  }

  // Halved across the lines in the direction that changes the integrals most.
  HalvedCell split(QuadratureCell whole) {
    HalvedCell result;
    result.error = -1.0;
    for (std::size_t k = 0; k < dim; ++k) {
      if (k == lines_.line_direction()) {
        continue;
      }
      UnitPoint size = whole.size;
      size[k] *= 0.5;
      UnitPoint high = whole.low;
      high[k] += size[k];
      std::array<QuadratureCell, 2> halves{cell(whole.low, size), cell(high, size)};
      // Of an error by bends a quarter is left in halves, of one by jumps a half.
      constexpr double left = 0.5;
      const Moments<dim> change =
          whole.sums.moments - halves[0].sums.moments - halves[1].sums.moments;
      const double error =
          left * change.cwiseAbs().maxCoeff() + halves[0].sums.missed + halves[1].sums.missed;
      if (error > result.error || !std::isfinite(error)) {
        result.error = error;
        result.halves = std::move(halves);
        result.halved = true;
      }
    }
    result.error = result.halved ? result.error : whole.sums.missed;
    result.whole = std::move(whole);
    return result;
  }

  static double amount_of(const std::vector<HalvedCell>& heap) {
    double amount = 0.0;
    for (const HalvedCell& s : heap) {
      amount += s.whole.sums.amount;
    }
    return amount;
  }

  FieldAdaptedRule<dim> collect_points(std::vector<HalvedCell>& heap, double error) {
    FieldAdaptedRule<dim> rule;
    rule.amount = amount_of(heap);
    const double room = tolerance_ * std::max(rule.amount, least_amount_);
    for (HalvedCell& s : heap) {
      const bool agreed = !s.halved || !(s.error > 0.01 * room);
      for (QuadratureCell* cell :
           agreed ? std::vector<QuadratureCell*>{&s.whole}
                  : std::vector<QuadratureCell*>{s.halves.data(), &s.halves[1]}) {
        rule.points.insert(rule.points.end(), cell->sums.points.begin(), cell->sums.points.end());
      }
    }
    rule.missed = error > room ? error : 0.0;
    rule.jumps = lines_.has_jumps();
    return rule;
  }

  LineQuadrature<dim> lines_;
  double tolerance_;
  double least_amount_;
};

} // namespace spricka::fe
