// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "report/report.hpp"
#include "report/units_line.hpp"
#include "results/k_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <vector>

// fmt writes the shortest decimal number that reads back to the same bits, whatever the locale.

namespace spricka::report {

namespace {

constexpr double degree = 180.0 / std::numbers::pi;

// Those by opening where the deck asks for them.
std::vector<const results::KQuantity*> k_columns(const model::Model& model) {
  const bool opening =
      std::any_of(model.vces.begin(), model.vces.end(),
                  [](const model::CrackExtensionSettings& vce) { return vce.opening; });
  std::vector<const results::KQuantity*> columns;
  for (const results::KQuantity& q : results::k_quantities) {
    if (q.appears_in(results::in_k_csv, model.mesh.dim) &&
        (opening || q.given != results::KQuantityCondition::with_opening)) {
      columns.push_back(&q);
    }
  }
  return columns;
}

std::vector<const results::ContactPointQuantity*> pressure_columns(bool rubs, bool space) {
  std::vector<const results::ContactPointQuantity*> columns;
  for (const results::ContactPointQuantity& q : results::point_quantities) {
    if (q.appears_in(results::in_pressure_csv) && (rubs || !q.friction) && (space || !q.space)) {
      columns.push_back(&q);
    }
  }
  return columns;
}

template <class Column> std::string header(const char* first, const std::vector<Column>& columns) {
  std::string text = first;
  for (const Column q : columns) {
    text += fmt::format(",{}", q->name);
  }
  return text + "\n";
}

std::string cell(const results::ContactPointQuantity& q, const results::ContactPoint& point) {
  if (q.is_word()) {
    return results::display_word(point.*q.state);
  }
  return fmt::format("{}", q.kind == base::Quantity::angle ? q.extract_value(point) * degree
                                                           : q.extract_value(point));
}

std::string k_units(const model::Model& model,
                    const std::vector<const results::KQuantity*>& columns) {
  ColumnUnits units;
  units.add_column(base::Quantity::number, "increment");
  for (const results::KQuantity* q : columns) { // K1_bar and its like are made of K1 and K2
    const bool follows = q->judges && q->kind == base::Quantity::stress_intensity;
    units.add_column(q->kind, follows ? "and what begins with them" : q->name);
  }
  return units.units_text(model.units);
}

// Empty where the point has none of it.
std::string cell(const results::KQuantity& q, const results::FrontResult& front,
                 const results::FrontPointResult& point) {
  const double unit = q.kind == base::Quantity::angle ? degree : 1.0;
  return q.is_given(front, point) ? fmt::format("{}", q.extract_value(front, point) * unit) : "";
}

} // namespace

void write_k_csv(const std::filesystem::path& file, const model::Model& model,
                 const results::RunResult& run) {
  const std::vector<const results::KQuantity*> columns = k_columns(model);
  std::string text = fmt::format("# units: {}\n{}", k_units(model, columns),
                                 header("increment,step,crack", columns));
  auto out = std::back_inserter(text);
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        for (const results::FrontPointResult& point : front.points) {
          fmt::format_to(out, "{},{},{}", increment.number, step.step, front.name);
          for (const results::KQuantity* q : columns) {
            text += "," + cell(*q, front, point);
          }
          text += '\n';
        }
      }
    }
  }
  write_file(file, text);
}

void write_pressure_csv(const std::filesystem::path& file, const model::Model& model,
                        const results::RunResult& run) {
  const bool rubs =
      std::any_of(model.contacts.begin(), model.contacts.end(),
                  [](const model::Contact& c) { return c.mu > 0.0; }) ||
      std::any_of(model.cracks.begin(), model.cracks.end(),
                  [](const model::CrackDefinition& c) { return c.faces_in_contact && c.mu > 0.0; });
  const std::vector<const results::ContactPointQuantity*> columns =
      pressure_columns(rubs, model.mesh.dim == 3);
  ColumnUnits units;
  units.add_column(base::Quantity::number, "increment");
  for (const results::ContactPointQuantity* q : columns) {
    if (!q->is_word()) {
      units.add_column(q->kind, q->name);
    }
  }
  std::string text = fmt::format("# units: {}\n{}", units.units_text(model.units),
                                 header("increment,step,contact", columns));
  auto out = std::back_inserter(text);
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::ContactResult& contact : step.contacts) {
        if (!contact.mounted) {
          continue; // absent, not open: it has no pressure
        }
        for (const results::ContactPoint& point : contact.points) {
          fmt::format_to(out, "{},{},{}", increment.number, step.step, contact.name);
          for (const results::ContactPointQuantity* q : columns) {
            text += "," + cell(*q, point);
          }
          text += '\n';
        }
      }
    }
  }
  write_file(file, text);
}

} // namespace spricka::report
