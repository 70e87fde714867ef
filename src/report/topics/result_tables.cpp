// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/result_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/round_off.hpp"
#include "report/topics/dimension_columns.hpp"
#include "report/topics/result_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace spricka::report {
namespace {

constexpr const char* short_number = "{:.2e}";

using Directions = std::vector<Eigen::Index>;

/// Directions that a resultant has: about an axis radial forces balance, whatever they are.
Directions directions(const model::Model& model, const results::CrackLengthResult& increment) {
  if (model::is_axisymmetric(model)) {
    return {1};
  }
  Directions all(static_cast<std::size_t>(increment.mesh.dim));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// A column for each direction of a vector; what is round-off beside the scale is 0.
template <class Row, class Value>
void add_vector(Columns<Row>& columns, const std::string& what, const base::OutputUnit& unit,
                const Directions& along, double scale, Value value) {
  for (const Eigen::Index i : along) {
    columns.number(fmt::format("{} {}", what, "xyz"[i]), unit.name, [=](const Row& row) {
      return six_digits_or_zero(unit.from_deck(std::invoke(value, row)[i]), unit.from_deck(scale));
    });
  }
}

/// Tables of contacts begin with these columns.
Columns<ContactRow> contact_columns() {
  return Columns<ContactRow>()
      .words("step", [](const ContactRow& row) { return row.step.step; })
      .words("contact", [](const ContactRow& row) { return row.contact.name; });
}

/// Where all forces balance on each body they are round-off themselves: then they are measured by
/// the stiffness.
double least_force(const model::Model& model, const results::CrackLengthResult& increment) {
  return 1e-3 * reference_elastic_force(model, increment);
}

double largest_displacement(const results::CrackLengthResult& increment) {
  double largest = 0.0;
  for (const results::LoadStepResult& step : increment.steps) {
    largest = step.u.size() > 0 ? std::max(largest, step.u.lpNorm<Eigen::Infinity>()) : largest;
  }
  return largest;
}

} // namespace

ReportTable contact_result_table(const model::Model& model,
                                 const results::CrackLengthResult& increment) {
  const base::OutputUnit length = model.units.output_length();
  const base::OutputUnit stress = model.units.output_stress();
  const std::vector<ContactRow> rows = contact_rows({&increment, 1});
  double force = least_force(model, increment);
  for (const ContactRow& row : rows) {
    force = std::max(force, row.contact.force_on_slave.norm());
  }
  const double pressure = least_contact_pressure(model, increment);
  Columns<ContactRow> columns = contact_columns();
  columns.words("closed", [](const ContactRow& row) {
    return row.contact.mounted ? fmt::format("{}/{}", row.contact.closed, row.contact.rows)
                               : "absent";
  });
  columns.fill_only_if([](const ContactRow& row) { return row.contact.mounted; });
  const double way = largest_displacement(increment);
  columns.number("penetration", length.name, [=](const ContactRow& row) {
    const double deep = row.contact.max_penetration;
    return cell_text(deep > 1e-9 * way ? length.from_deck(deep) : 0.0,
                     deep > 1e-9 * way ? short_number : nullptr);
  });
  for (const auto& [name, member] : {std::pair("p min", &results::ContactResult::min_pressure),
                                     {"p mean", &results::ContactResult::mean_pressure},
                                     {"p max", &results::ContactResult::max_pressure}}) {
    columns.number(name, stress.name, [=, member = member](const ContactRow& row) {
      const double here = row.contact.*member;
      return std::abs(here) > pressure ? format_six_digits(stress.from_deck(here)) : "0";
    });
  }
  add_vector(columns, "force", model.units.output_force(), directions(model, increment), force,
             [](const ContactRow& row) { return row.contact.force_on_slave; });
  if (dimension_columns.at(increment.mesh.dim).arcs) { // an angle on a circle, else a length
    for (const auto& [name, member] : {std::pair("arc from", &results::ContactResult::arc_from),
                                       {"to", &results::ContactResult::arc_to}}) {
      columns.number(name, "", [length, member = member](const ContactRow& row) {
        const double at = row.contact.*member;
        return row.contact.closed == 0 ? ""
               : row.contact.round     ? fmt::format("{:.1f} deg", at * 180.0 / std::numbers::pi)
                                       : length.text(at, 4);
      });
    }
  } else {
    columns.number("area", base::raised(length, 2),
                   [](const ContactRow& row) { return row.contact.area; });
  }
  columns.number("iterations", "", [](const ContactRow& row) { return row.step.iterations; });
  return columns.table("Contact", rows);
}

ReportTable contact_moment_table(const model::Model& model,
                                 const results::CrackLengthResult& increment) {
  Columns<ContactRow> columns = contact_columns();
  std::vector<ContactRow> rows;
  if (!dimension_columns.at(increment.mesh.dim).arcs) {
    double scale = 0.0;
    for (const ContactRow& row : contact_rows({&increment, 1})) {
      scale = std::max(scale, row.contact.moment_on_slave.norm());
      if (row.contact.mounted) {
        rows.push_back(row);
      }
    }
    add_vector(columns, "moment", base::output_unit(model.units, base::QuantityKind::energy),
               directions(model, increment), scale,
               [](const ContactRow& row) { return row.contact.moment_on_slave; });
  }
  return columns.table("Moments of contact on the slave, about the origin", rows);
}

ReportTable friction_table(const model::Model& model, const results::CrackLengthResult& increment) {
  const base::UnitSystem& units = model.units;
  std::vector<ContactRow> rows;
  std::ranges::copy_if(contact_rows({&increment, 1}), std::back_inserter(rows),
                       [](const ContactRow& row) { return row.contact.rubs; });
  const auto shear = [](const ContactRow& row, bool largest) {
    double found = 0.0;
    for (const results::ContactPoint& point : row.contact.points) {
      found = largest ? std::max(found, point.q_lumped) : std::min(found, point.q_lumped);
    }
    return found;
  };
  Columns<ContactRow> columns = contact_columns();
  columns.number("stick", "", [](const ContactRow& row) { return row.contact.sticking; })
      .number("slip", "", [](const ContactRow& row) { return row.contact.slipping; })
      .number("open", "",
              [](const ContactRow& row) {
                return row.contact.rows - row.contact.sticking - row.contact.slipping;
              })
      .number(
          "|q|/(mu p)", "", [](const ContactRow& row) { return row.contact.shear_ratio; }, "{:.4f}")
      .number("q min, lumped", units.output_stress(),
              [=](const ContactRow& row) { return shear(row, false); })
      .number("q max, lumped", units.output_stress(),
              [=](const ContactRow& row) { return shear(row, true); })
      .number(
          "slip path", units.output_length(),
          [](const ContactRow& row) { return row.contact.max_slip; }, short_number)
      .number(
          "work", base::output_unit(units, base::QuantityKind::energy),
          [](const ContactRow& row) { return row.contact.friction_work; }, short_number)
      .number("increments", "", [](const ContactRow& row) { return row.step.increments; });
  return columns.table("Friction", rows);
}

namespace {

/// The balance of a body or of a net at the end of a step.
struct BalanceRow {
  const results::LoadStepResult& step;
  const results::ForceBalance& balance;
};

/// Resultants and energies of bodies or of nets, as `part` of a step says; rigid targets last.
ReportTable resultants(const model::Model& model, const results::CrackLengthResult& increment,
                       const std::string& title, const std::string& what,
                       std::vector<results::ForceBalance> results::LoadStepResult::*part) {
  std::vector<BalanceRow> rows;
  double scale = least_force(model, increment);
  double most = 0.0;
  for (const results::LoadStepResult& step : increment.steps) {
    most = std::max(most, std::abs(step.energy));
    for (const std::vector<results::ForceBalance>* const list : {&(step.*part), &step.targets}) {
      for (const results::ForceBalance& b : *list) {
        rows.push_back({step, b});
        scale =
            std::max({scale, b.applied.norm(), b.reaction.norm(), b.contact.norm(), b.tie.norm()});
      }
    }
  }
  const base::OutputUnit unit = model.units.output_force();
  Columns<BalanceRow> columns;
  columns.words("step", [](const BalanceRow& row) { return row.step.step; });
  columns.words(what, [](const BalanceRow& row) { return row.balance.body; });
  for (const auto& [name, member] : {std::pair("applied", &results::ForceBalance::applied),
                                     {"reaction", &results::ForceBalance::reaction},
                                     {"contact", &results::ForceBalance::contact},
                                     {"tie", &results::ForceBalance::tie}}) {
    if (member != &results::ForceBalance::tie ||
        std::ranges::any_of(increment.steps, &results::LoadStepResult::tied)) {
      add_vector(columns, name, unit, directions(model, increment), scale,
                 [member = member](const BalanceRow& row) { return row.balance.*member; });
    }
  }
  columns.number(
      "left over", unit,
      [](const BalanceRow& row) {
        const results::ForceBalance& b = row.balance;
        return (b.applied + b.reaction + b.contact + b.tie).norm();
      },
      short_number);
  const base::OutputUnit energy = base::output_unit(model.units, base::QuantityKind::energy);
  columns.number("energy", energy.name, [=](const BalanceRow& row) {
    return six_digits_or_zero(energy.from_deck(row.balance.energy), energy.from_deck(most));
  });
  return columns.table(title, rows);
}

} // namespace

ReportTable force_balance_table(const model::Model& model,
                                const results::CrackLengthResult& increment) {
  return resultants(model, increment, "Force balance", "body", &results::LoadStepResult::balance);
}

ReportTable net_balance_table(const model::Model& model,
                              const results::CrackLengthResult& increment) {
  const bool same = std::ranges::all_of(increment.steps, [](const results::LoadStepResult& step) {
    const bool one = step.balance.size() == 1 && step.nets.size() == 1;
    return one || std::ranges::equal(step.balance, step.nets, {}, &results::ForceBalance::body,
                                     &results::ForceBalance::body);
  });
  ReportTable table =
      resultants(model, increment, "Force balance by net", "net", &results::LoadStepResult::nets);
  if (same) {
    table.rows.clear();
  }
  return table;
}

namespace {

struct ErrorRow {
  const results::LoadStepResult& step;
  const results::NetErrorEstimate& error;
  [[nodiscard]] bool of_all() const { return error.net == "*"; }
};

} // namespace

ReportTable energy_error_table(const results::CrackLengthResult& increment) {
  std::vector<ErrorRow> rows;
  for (const results::LoadStepResult& step : increment.steps) {
    for (const results::NetErrorEstimate& error : step.errors) {
      if (error.net != "*" || step.errors.size() != 2) { // else of one net
        rows.push_back({step, error});
      }
    }
  }
  Columns<ErrorRow> columns;
  columns.words("step", [](const ErrorRow& row) { return row.step.step; })
      .words("net", [](const ErrorRow& row) { return row.of_all() ? "all" : row.error.net; })
      .number(
          "error", "%", [](const ErrorRow& row) { return 100.0 * row.error.part; }, "{:.1f}")
      .fill_only_if([](const ErrorRow& row) { return !row.of_all(); })
      .words("most of it in elements",
             [&](const ErrorRow& row) {
               std::vector<base::Label> labels;
               for (const base::ElementId e : row.error.worst) {
                 labels.push_back(increment.mesh.element_label[e.index()]);
               }
               return fmt::format("{}", fmt::join(labels, " "));
             })
      .number(
          "share", "%", [](const ErrorRow& row) { return 100.0 * row.error.worst_share; },
          "{:.0f}");
  return columns.table("Estimated energy error", rows);
}

std::string force_direction_note(const model::Model& model) {
  return model::is_axisymmetric(model)
             ? "forces and energies are of the full circumference; radial forces balance round it "
               "and are not shown"
             : "";
}

std::string leading_step_name(const model::Model& model) {
  if (model.growth && model.growth->kmax.valid()) {
    return model.steps[model.growth->kmax.index()].name;
  }
  return model.steps.empty() ? std::string() : model.steps.back().name;
}

} // namespace spricka::report
