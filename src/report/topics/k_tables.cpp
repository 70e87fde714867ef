// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/k_tables.hpp"

#include "base/quantity.hpp"
#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/topics/front_places.hpp"
#include "report/topics/k_bars.hpp"
#include "report/topics/result_rows.hpp"
#include "results/k_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string>

namespace spricka::report {
namespace {

/// What K and G are beside which only round-off is left.
struct CrackScale {
  double K = 0.0;
  double G = 0.0; ///< of tips; along a front G is shown as it is
};

CrackScale crack_scale(std::span<const results::CrackLengthResult> increments) {
  CrackScale scale;
  for (const FrontRow& row : front_rows(increments)) {
    scale.K = std::max(scale.K, largest_K(row.front));
    if (row.front.is_tip()) {
      scale.G =
          std::max(scale.G, 1e-9 * std::abs(row.front.single_point().G)); // it goes with K squared
    }
  }
  return scale;
}

std::string k_cell(const results::KQuantity& q, const FrontPointRow& row,
                   const base::OutputUnit& unit, const CrackScale& scale) {
  const double value = unit.from_deck(q.extract_value(row.front, row.point));
  if (q.kind == base::QuantityKind::angle) {
    return fmt::format("{:.2f}", std::round(value * 100.0) / 100.0 + 0.0);
  }
  switch (q.digits) {
  case results::KQuantityDigits::two:
    return cell_text(value, row.front.is_tip() ? "{:.2e}" : "{:.2g}");
  case results::KQuantityDigits::six_beside_largest:
    return six_digits_or_zero(
        value, unit.from_deck(q.kind == base::QuantityKind::energy_release ? scale.G : scale.K));
  case results::KQuantityDigits::six:
    break;
  }
  return format_six_digits(value);
}

/// K with the digits that its bar leaves meaning to.
std::string k_by_bar_cell(const results::KQuantity& q, const FrontPointRow& row,
                          const base::OutputUnit& unit) {
  return k_by_bar_text(unit.from_deck(q.extract_value(row.front, row.point)),
                       unit.from_deck(row.point.bar[static_cast<std::size_t>(q.mode)].size()));
}

bool any_is_corrected(const std::vector<FrontPointRow>& rows) {
  return std::ranges::any_of(rows,
                             [](const FrontPointRow& row) { return row.point.raw.has_value(); });
}

/// What a table of K has beside its quantities.
struct KTableParts {
  bool angles = false;
  bool bars = false;
  bool raw = false; ///< K as the mesh has it, where that is not K itself
  KTableExtent extent = KTableExtent::full;
  bool G = false; ///< in a brief table too: of tips that have no K
};

/// A column for each quantity that the listing has; behind each K one for its error bar, and one
/// for K as the mesh has it.
void add_k_columns(Columns<FrontPointRow>& columns, const model::Model& model,
                   const KTableParts& parts, const CrackScale& scale) {
  for (const results::KQuantity* const q : shown_k_quantities(model, results::in_listing)) {
    if (q->given == results::KQuantityCondition::with_angles && !parts.angles) {
      continue;
    }
    const bool brief = parts.extent == KTableExtent::brief;
    if (brief && !q->is_k() && q->kind != base::QuantityKind::length &&
        !(parts.G && std::string_view(q->name) == "G")) {
      continue;
    }
    const base::OutputUnit unit = base::output_unit(model.units, q->kind);
    columns.fill_only_if(
        [q](const FrontPointRow& row) { return q->is_given(row.front, row.point); });
    columns.number(q->heading.empty() ? q->name : std::string(q->heading), unit.name,
                   [q, unit, scale, brief](const FrontPointRow& row) {
                     return brief && q->is_k() && row.front.has_error_bar()
                                ? k_by_bar_cell(*q, row, unit)
                                : k_cell(*q, row, unit, scale);
                   });
    if (q->is_k() && parts.bars) {
      columns.fill_only_if([q](const FrontPointRow& row) {
        return q->is_given(row.front, row.point) && row.front.has_error_bar() &&
               !row.point.at_surface;
      });
      columns.number(fmt::format("+- {}", q->name), unit.name, [q, unit](const FrontPointRow& row) {
        return format_error_bar(
            unit.from_deck(row.point.bar[static_cast<std::size_t>(q->mode)].size()));
      });
    }
    if (q->is_k() && parts.raw && !brief) {
      columns.fill_only_if(
          [q](const FrontPointRow& row) { return q->is_given(row.front) && row.point.raw; });
      columns.number(fmt::format("raw {}", q->name), unit.name,
                     [q, unit, scale](const FrontPointRow& row) {
                       const double raw = row.point.raw_K()[static_cast<std::size_t>(q->mode)];
                       return six_digits_or_zero(unit.from_deck(raw), unit.from_deck(scale.K));
                     });
    }
  }
  columns.fill_only_if({});
}

template <class Condition>
std::vector<FrontPointRow> rows_where(std::span<const results::CrackLengthResult> increments,
                                      const Condition& condition) {
  std::vector<FrontPointRow> rows;
  std::ranges::copy_if(front_point_rows(increments), std::back_inserter(rows), condition);
  return rows;
}

std::string step_name(const FrontPointRow& row) {
  return row.step.step;
}

/// A row for each tip of these rows, below the table's first column.
ReportTable tip_table(const model::Model& model,
                      std::span<const results::CrackLengthResult> increments,
                      Columns<FrontPointRow> columns, const std::string& title,
                      const std::vector<FrontPointRow>& rows, KTableExtent extent) {
  columns.words("tip", [](const FrontPointRow& row) { return row.front.name; });
  add_k_columns(columns, model,
                {.bars = true,
                 .raw = any_is_corrected(rows),
                 .extent = extent,
                 .G = std::ranges::any_of(
                     rows, [](const FrontPointRow& row) { return row.front.two_materials; })},
                crack_scale(increments));
  return columns.table(title, rows);
}

ReportTable front_table(const model::Model& model, const results::CrackLengthResult& increment,
                        const results::FrontResult& first) {
  const CrackScale scale = crack_scale({&increment, 1});
  Columns<FrontPointRow> columns;
  columns.words("step", step_name);
  columns.number("point", "", [](const FrontPointRow& row) { return row.point.number; });
  const auto rows = rows_where({&increment, 1}, [&](const FrontPointRow& row) {
    return row.front.name == first.name && largest_K(row.front) > 1e-9 * scale.K;
  });
  add_k_columns(
      columns, model,
      {.angles = first.has_angles, .bars = first.has_error_bar(), .raw = any_is_corrected(rows)},
      scale);
  columns.words("", [](const FrontPointRow& row) {
    return row.point.at_surface ? "surface" : row.point.closed ? "closed" : "";
  });
  return columns.table(fmt::format("Stress intensity factors along the front of {}", first.name),
                       rows);
}

/// A point of a front with the name of its place.
struct FrontPlaceRow : FrontPointRow {
  std::string place;
};

/// K of a mode at a place, at the end of a front that which the points within go on to.
double place_K(const FrontPlaceRow& row, std::size_t mode) {
  return row.point.at_surface ? row.point.smooth[mode] : row.point.K()[mode];
}

std::vector<FrontPlaceRow> place_rows(const results::CrackLengthResult& increment,
                                      const std::string& name, double least_K) {
  const FaceNames faces(increment.mesh);
  std::vector<FrontPlaceRow> rows;
  for (const FrontRow& row : front_rows({&increment, 1})) {
    if (row.front.name == name && largest_K(row.front) > least_K) {
      for (const FrontPlace& place : front_places(row.front, faces)) {
        rows.push_back({{row, *place.point}, place.name});
      }
    }
  }
  return rows;
}

ReportTable front_place_table(const model::Model& model,
                              const results::CrackLengthResult& increment,
                              const results::FrontResult& first) {
  constexpr double shown_beside_largest = 1e-3;
  const CrackScale scale = crack_scale({&increment, 1});
  const std::vector<FrontPlaceRow> rows = place_rows(increment, first.name, 1e-9 * scale.K);
  const base::OutputUnit unit = model.units.output_stress_intensity();
  Columns<FrontPlaceRow> columns;
  columns.words("step", [](const FrontPlaceRow& row) { return row.step.step; })
      .words("place", &FrontPlaceRow::place)
      .number("point", "", [](const FrontPlaceRow& row) { return row.point.number; });
  for (std::size_t mode = 0; mode < 3; ++mode) {
    const bool reported = mode == 0 || std::ranges::any_of(rows, [&](const FrontPlaceRow& row) {
                            return std::abs(place_K(row, mode)) > shown_beside_largest * scale.K;
                          });
    if (!reported) {
      continue;
    }
    columns.number(fmt::format("K{}", mode + 1), unit.name, [=](const FrontPlaceRow& row) {
      const double K = unit.from_deck(place_K(row, mode));
      return row.front.has_error_bar()
                 ? k_by_bar_text(K, unit.from_deck(row.point.bar[mode].size()))
                 : six_digits_or_zero(K, unit.from_deck(scale.K));
    });
    if (first.has_error_bar()) {
      columns.fill_only_if([](const FrontPlaceRow& row) { return row.front.has_error_bar(); });
      columns.number("+-", unit.name, [=](const FrontPlaceRow& row) {
        return format_error_bar(unit.from_deck(row.point.bar[mode].size()));
      });
      columns.fill_only_if({});
    }
  }
  columns.number(
      "length along the front", model.units.output_length(),
      [](const FrontPlaceRow& row) { return row.point.s; }, "{:.4g}");
  if (first.has_angles) {
    columns.number(
        "angle", "deg", [](const FrontPlaceRow& row) { return row.point.phi * degrees_per_radian; },
        "{:.1f}");
  }
  columns.words("", [](const FrontPlaceRow& row) { return row.point.closed ? "closed" : ""; });
  return columns.table(fmt::format("Stress intensity factors of {}, a = {}", first.name,
                                   model.units.output_length().text(first.a, 4)),
                       rows);
}

} // namespace

ReportTable tip_k_table(const model::Model& model, const results::CrackLengthResult& increment,
                        KTableExtent extent) {
  const std::span<const results::CrackLengthResult> one(&increment, 1);
  return tip_table(
      model, one, Columns<FrontPointRow>().words("step", step_name), "Stress intensity factors",
      rows_where(one, [](const FrontPointRow& row) { return row.front.is_tip(); }), extent);
}

ReportTable tip_k_table_over_increments(const model::Model& model, const results::RunResult& run,
                                        std::string_view step, KTableExtent extent) {
  const auto number = [](const FrontPointRow& row) { return row.increment.number; };
  return tip_table(model, run.increments, Columns<FrontPointRow>().number("increment", "", number),
                   fmt::format("Stress intensity factors at the end of step {}", step),
                   rows_where(run.increments,
                              [&](const FrontPointRow& row) {
                                return row.front.is_tip() && row.step.step == step;
                              }),
                   extent);
}

std::vector<ReportTable> front_tables(const model::Model& model,
                                      const results::CrackLengthResult& increment) {
  std::vector<ReportTable> tables;
  for (const results::FrontResult* front : find_fronts_in_space(increment)) {
    tables.push_back(front_table(model, increment, *front));
  }
  return tables;
}

std::vector<ReportTable> front_place_tables(const model::Model& model,
                                            const results::CrackLengthResult& increment) {
  std::vector<ReportTable> tables;
  for (const results::FrontResult* front : find_fronts_in_space(increment)) {
    tables.push_back(front_place_table(model, increment, *front));
  }
  return tables;
}

std::vector<const results::KQuantity*> shown_k_quantities(const model::Model& model,
                                                          results::KOutputPlace place) {
  const bool opening =
      std::ranges::any_of(model.vces, &model::VirtualCrackExtensionSettings::opening);
  std::vector<const results::KQuantity*> shown;
  for (const results::KQuantity& q : results::k_quantities) {
    if (q.appears_in(place, model.mesh.dim) &&
        (opening || q.given != results::KQuantityCondition::with_opening)) {
      shown.push_back(&q);
    }
  }
  return shown;
}

double largest_K(const results::FrontResult& front) {
  if (front.is_tip()) {
    return std::hypot(front.single_point().K1, front.single_point().K2);
  }
  double largest = 0.0;
  for (const results::FrontPointResult& point : front.points) {
    largest = std::max({largest, std::abs(point.K1), std::abs(point.K2), std::abs(point.K3)});
  }
  return largest;
}

double largest_K(const results::CrackLengthResult& increment) {
  return crack_scale({&increment, 1}).K;
}

std::vector<const results::FrontResult*>
find_fronts_in_space(const results::CrackLengthResult& increment) {
  std::vector<const results::FrontResult*> fronts;
  for (const FrontRow& row : front_rows({&increment, 1})) {
    if (!row.front.is_tip() &&
        std::ranges::none_of(fronts, [&](const auto* f) { return f->name == row.front.name; })) {
      fronts.push_back(&row.front);
    }
  }
  return fronts;
}

} // namespace spricka::report
