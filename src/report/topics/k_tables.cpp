// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/k_tables.hpp"

#include "base/quantity.hpp"
#include "model/model.hpp"
#include "report/topics/k_bars.hpp"
#include "results/k_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace spricka::report {
namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

/// Which quantities a table of K has.
struct KTableColumns {
  const model::Model& model;
  bool angles = false;
  bool bars = true; ///< a column behind each K

  /// Those by opening where the deck asks for them.
  [[nodiscard]] bool has(const results::KQuantity& q) const {
    if (!q.appears_in(results::in_listing, model.mesh.dim)) {
      return false;
    }
    if (q.given == results::KQuantityCondition::with_opening) {
      return std::ranges::any_of(model.vces, &model::CrackExtensionSettings::opening);
    }
    return q.given != results::KQuantityCondition::with_angles || angles;
  }
};

/// What K and G are beside which only round-off is left.
struct CrackScale {
  double K = 0.0;
  double G = 0.0; ///< of tips; along a front G is shown as it is

  void add(const results::Increment& increment) {
    K = std::max(K, largest_K(increment));
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        if (front.is_tip()) {
          G = std::max(G, 1e-9 * std::abs(front.tip().G)); // it goes with the square of K
        }
      }
    }
  }
};

void add_k_columns(ReportTable& table, const KTableColumns& columns) {
  for (const results::KQuantity& q : results::k_quantities) {
    if (!columns.has(q)) {
      continue;
    }
    const std::string unit =
        q.kind == base::Quantity::angle ? "deg" : base::unit_name(columns.model.units, q.kind);
    table.columns.push_back({q.heading.empty() ? q.name : std::string(q.heading), unit, false});
    if (q.is_k() && columns.bars) {
      table.columns.push_back({fmt::format("+- {}", q.name), unit, false});
    }
  }
}

std::string k_cell(const results::KQuantity& q, const results::FrontResult& front,
                   const results::FrontPointResult& point, const CrackScale& scale) {
  const double value = q.extract_value(front, point);
  if (q.kind == base::Quantity::angle) {
    return fmt::format("{:.2f}", std::round(value * degrees_per_radian * 100.0) / 100.0 + 0.0);
  }
  switch (q.digits) {
  case results::KQuantityDigits::two:
    return front.is_tip() ? fmt::format("{:.2e}", value) : fmt::format("{:.2g}", value);
  case results::KQuantityDigits::six_beside_largest:
    return six_digits_beside(value, q.kind == base::Quantity::energy_release ? scale.G : scale.K);
  case results::KQuantityDigits::six:
    break;
  }
  return six_digits(value);
}

void add_k_cells(std::vector<std::string>& row, const KTableColumns& columns,
                 const results::FrontResult& front, const results::FrontPointResult& point,
                 const CrackScale& scale) {
  for (const results::KQuantity& q : results::k_quantities) {
    if (!columns.has(q)) {
      continue;
    }
    const bool given = q.is_given(front, point);
    row.push_back(given ? k_cell(q, front, point, scale) : "");
    if (q.is_k() && columns.bars) {
      const bool bar = given && front.has_error_bar() && !point.at_surface;
      row.push_back(bar ? format_error_bar(point.bar[static_cast<std::size_t>(q.mode)].size())
                        : "");
    }
  }
}

/// A row for each tip at the end of each step, or of one step, below the table's first column.
ReportTable tip_table(const model::Model& model, std::span<const results::Increment> increments,
                      std::optional<std::string_view> only_step, ReportTable table) {
  const KTableColumns columns{model};
  table.columns.push_back({"tip", "", true});
  add_k_columns(table, columns);
  CrackScale scale;
  std::ranges::for_each(increments, [&](const auto& increment) { scale.add(increment); });
  for (const results::Increment& increment : increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        if (front.is_tip() && step.step == only_step.value_or(step.step)) {
          std::vector<std::string> row{only_step ? fmt::format("{}", increment.number) : step.step,
                                       front.name};
          add_k_cells(row, columns, front, front.tip(), scale);
          table.rows.push_back(std::move(row));
        }
      }
    }
  }
  return table;
}

ReportTable front_table(const model::Model& model, const results::Increment& increment,
                        const results::FrontResult& first) {
  ReportTable table{fmt::format("Stress intensity factors along the front of {}", first.name),
                    {{"step", "", true}, {"point", "", false}},
                    {}};
  const KTableColumns columns{model, first.has_angles, first.has_error_bar()};
  add_k_columns(table, columns);
  table.columns.push_back({"", "", true});
  CrackScale scale;
  scale.add(increment);
  for (const results::StepResult& step : increment.steps) {
    for (const results::FrontResult& front : step.fronts) {
      if (front.name != first.name || largest_K(front) <= 1e-9 * scale.K) {
        continue;
      }
      for (const results::FrontPointResult& point : front.points) {
        std::vector<std::string> row{step.step, std::to_string(point.number)};
        add_k_cells(row, columns, front, point, scale);
        row.emplace_back(point.at_surface ? "surface" : point.closed ? "closed" : "");
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

} // namespace

ReportTable k_table(const model::Model& model, const results::Increment& increment) {
  return tip_table(model, {&increment, 1}, std::nullopt,
                   {"Stress intensity factors", {{"step", "", true}}, {}});
}

ReportTable k_history_table(const model::Model& model, const results::RunResult& run,
                            std::string_view step) {
  return tip_table(model, run.increments, step,
                   {fmt::format("Stress intensity factors at the end of step {}", step),
                    {{"increment", "", false}},
                    {}});
}

std::vector<ReportTable> front_tables(const model::Model& model,
                                      const results::Increment& increment) {
  std::vector<ReportTable> tables;
  for (const results::FrontResult* front : fronts_in_space(increment)) {
    tables.push_back(front_table(model, increment, *front));
  }
  return tables;
}

double largest_K(const results::FrontResult& front) {
  if (front.is_tip()) {
    return std::hypot(front.tip().K1, front.tip().K2);
  }
  double largest = 0.0;
  for (const results::FrontPointResult& point : front.points) {
    largest = std::max({largest, std::abs(point.K1), std::abs(point.K2), std::abs(point.K3)});
  }
  return largest;
}

double largest_K(const results::Increment& increment) {
  double largest = 0.0;
  for (const results::StepResult& step : increment.steps) {
    for (const results::FrontResult& front : step.fronts) {
      largest = std::max(largest, largest_K(front));
    }
  }
  return largest;
}

std::vector<const results::FrontResult*> fronts_in_space(const results::Increment& increment) {
  std::vector<const results::FrontResult*> fronts;
  for (const results::StepResult& step : increment.steps) {
    for (const results::FrontResult& front : step.fronts) {
      if (!front.is_tip() &&
          std::ranges::none_of(fronts, [&](const auto* f) { return f->name == front.name; })) {
        fronts.push_back(&front);
      }
    }
  }
  return fronts;
}

} // namespace spricka::report
