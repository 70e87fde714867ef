// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "report/report.hpp"
#include "report/units_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <vector>

// fmt writes the shortest decimal number that reads back to the same bits, whatever the locale.

namespace spricka::report {

namespace {

constexpr double degree = 180.0 / std::numbers::pi;

// The columns of tips: those by opening where the deck asks for them.
std::vector<const results::TipQuantity*> k_columns(const model::Model& model) {
  const bool opening =
      std::any_of(model.vces.begin(), model.vces.end(),
                  [](const model::CrackExtensionSettings& vce) { return vce.opening; });
  std::vector<const results::TipQuantity*> columns;
  for (const results::TipQuantity& q : results::tip_quantities) {
    if (q.appears_in(results::in_k_csv) &&
        (opening || q.given != results::TipQuantityCondition::with_opening)) {
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

void write_fronts_csv(const std::filesystem::path& file, const model::Model& model,
                      const results::RunResult& run) {
  ColumnUnits units;
  units.add_column(base::Quantity::number, "increment");
  units.add_column(base::Quantity::length, "a");
  std::string columns = "increment,step,crack,a,point,at_surface,closed";
  for (const results::FrontQuantity& q : results::front_quantities) {
    units.add_column(q.kind, q.name);
    columns += fmt::format(",{}", q.name);
  }
  std::string text = fmt::format("# units: {}\n{}\n", units.units_text(model.units), columns);
  auto out = std::back_inserter(text);
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        for (const results::FrontPointResult& place : front.points) {
          fmt::format_to(out, "{},{},{},{},{},{:d},{:d}", increment.number, step.step, front.name,
                         front.a, place.number, place.at_surface, place.closed);
          for (const results::FrontQuantity& q : results::front_quantities) {
            const bool given =
                (q.given == nullptr || q.given(front)) && !(q.inside && place.at_surface);
            const double unit = q.kind == base::Quantity::angle ? degree : 1.0;
            text += given ? fmt::format(",{}", q.extract_value(place) * unit) : ",";
          }
          text += '\n';
        }
      }
    }
  }
  write_file(file, text);
}

} // namespace

void write_k_csv(const std::filesystem::path& file, const model::Model& model,
                 const results::RunResult& run) {
  if (model.mesh.dim == 3) {
    write_fronts_csv(file, model, run);
    return;
  }
  const std::vector<const results::TipQuantity*> columns = k_columns(model);
  ColumnUnits units;
  units.add_column(base::Quantity::number, "increment");
  for (const results::TipQuantity* q : columns) { // K1_bar and its like are made of K1 and K2
    units.add_column(q->kind, q->member != nullptr ? q->name : "and what begins with them");
  }
  std::string text = fmt::format("# units: {}\n{}", units.units_text(model.units),
                                 header("increment,step,crack", columns));
  auto out = std::back_inserter(text);
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        fmt::format_to(out, "{},{},{}", increment.number, step.step, tip.name);
        for (const results::TipQuantity* q : columns) {
          text += q->is_given(tip) ? fmt::format(",{}", q->extract_value(tip)) : ",";
        }
        text += '\n';
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
