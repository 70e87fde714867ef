// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/result_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/round_off.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace spricka::report {
namespace {

using Row = std::vector<std::string>;

constexpr std::array<const char*, 3> axis{"x", "y", "z"};

std::string small(double value) {
  return fmt::format("{:.2e}", value);
}
/// Where contact begins or ends: an angle on a circle, else a length.
std::string arc(const results::ContactResult& contact, double at, const base::UnitSystem& units) {
  return contact.round ? fmt::format("{:.1f} deg", at * 180.0 / std::numbers::pi)
                       : fmt::format("{:.4g} {}", at, units.length_name);
}

/// Directions that a resultant has: about an axis radial forces balance, whatever they are.
std::vector<std::size_t> directions(const model::Model& model,
                                    const results::Increment& increment) {
  if (model::axisymmetric(model)) {
    return {1};
  }
  std::vector<std::size_t> all(static_cast<std::size_t>(increment.mesh.dim));
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

using Directions = std::vector<std::size_t>;

void add_columns(ReportTable& table, const char* what, const Directions& along,
                 const std::string& unit) {
  for (const std::size_t i : along) {
    table.columns.push_back({fmt::format("{} {}", what, axis[i]), unit, false});
  }
}

void add_cells(Row& row, const base::Vec3& force, const Directions& along, double scale) {
  for (const std::size_t i : along) {
    row.push_back(six_digits_beside(force[static_cast<Eigen::Index>(i)], scale));
  }
}

/// Where all forces balance on each body they are round-off themselves: then they are measured by
/// the stiffness.
double least_force(const model::Model& model, const results::Increment& increment) {
  return 1e-3 * reference_elastic_force(model, increment);
}

/// The largest force and the largest pressure of an increment's contacts.
struct ContactScale {
  double force = 0.0;
  double pressure = 0.0;
};

ContactScale contact_scale(const model::Model& model, const results::Increment& increment) {
  ContactScale scale{least_force(model, increment), 0.0};
  for (const results::StepResult& step : increment.steps) {
    for (const results::ContactResult& contact : step.contacts) {
      scale.force = std::max(scale.force, contact.force_on_slave.norm());
      scale.pressure = std::max(
          {scale.pressure, std::abs(contact.min_pressure), std::abs(contact.max_pressure)});
    }
  }
  return scale;
}

Row contact_row(const results::StepResult& step, const results::ContactResult& contact,
                const Directions& along, const ContactScale& scale, const base::UnitSystem& units) {
  Row row{step.step, contact.name};
  if (!contact.mounted) {
    row.push_back("absent");
    row.resize(row.size() + (contact.space ? 6 : 7) + along.size());
    return row;
  }
  row.push_back(fmt::format("{}/{}", contact.closed, contact.rows));
  row.push_back(small(contact.max_penetration));
  row.push_back(six_digits_beside(contact.min_pressure, scale.pressure));
  row.push_back(six_digits_beside(contact.mean_pressure, scale.pressure));
  row.push_back(six_digits_beside(contact.max_pressure, scale.pressure));
  add_cells(row, contact.force_on_slave, along, scale.force);
  if (contact.space) {
    row.push_back(six_digits(contact.area));
  } else {
    for (const double end : {contact.arc_from, contact.arc_to}) {
      row.push_back(contact.closed == 0 ? "" : arc(contact, end, units));
    }
  }
  row.push_back(fmt::format("{}", step.iterations));
  return row;
}

} // namespace

ReportTable contact_table(const model::Model& model, const results::Increment& increment) {
  const base::UnitSystem& units = model.units;
  const std::string stress = units.stress_name();
  ReportTable table{"Contact",
                    {{"step", "", true},
                     {"contact", "", true},
                     {"closed", "", true},
                     {"penetration", units.length_name, false},
                     {"p min", stress, false},
                     {"p mean", stress, false},
                     {"p max", stress, false}},
                    {}};
  const Directions along = directions(model, increment);
  add_columns(table, "force", along, units.force_name);
  if (increment.mesh.dim == 3) {
    table.columns.push_back({"area", units.length_name + "^2", false});
  } else {
    table.columns.push_back({"arc from", "", false});
    table.columns.push_back({"to", "", false});
  }
  table.columns.push_back({"iterations", "", false});
  const ContactScale scale = contact_scale(model, increment);
  for (const results::StepResult& step : increment.steps) {
    for (const results::ContactResult& contact : step.contacts) {
      table.rows.push_back(contact_row(step, contact, along, scale, units));
    }
  }
  return table;
}

ReportTable moment_table(const model::Model& model, const results::Increment& increment) {
  ReportTable table{"Moments of contact on the slave, about the origin",
                    {{"step", "", true}, {"contact", "", true}},
                    {}};
  if (increment.mesh.dim != 3) {
    return table;
  }
  const Directions along = directions(model, increment);
  add_columns(table, "moment", along, model.units.force_name + "*" + model.units.length_name);
  double scale = 0.0;
  for (const results::StepResult& step : increment.steps) {
    for (const results::ContactResult& contact : step.contacts) {
      scale = std::max(scale, contact.moment_on_slave.norm());
    }
  }
  for (const results::StepResult& step : increment.steps) {
    for (const results::ContactResult& contact : step.contacts) {
      if (contact.mounted) {
        Row row{step.step, contact.name};
        add_cells(row, contact.moment_on_slave, along, scale);
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

ReportTable friction_table(const model::Model& model, const results::Increment& increment) {
  const base::UnitSystem& units = model.units;
  ReportTable table{"Friction",
                    {{"step", "", true},
                     {"contact", "", true},
                     {"stick", "", false},
                     {"slip", "", false},
                     {"open", "", false},
                     {"|q|/(mu p)", "", false},
                     {"q min, lumped", units.stress_name(), false},
                     {"q max, lumped", units.stress_name(), false},
                     {"slip path", units.length_name, false},
                     {"work", units.force_name + "*" + units.length_name, false},
                     {"increments", "", false}},
                    {}};
  for (const results::StepResult& step : increment.steps) {
    for (const results::ContactResult& contact : step.contacts) {
      if (!contact.rubs) {
        continue;
      }
      double least = 0.0;
      double most = 0.0;
      for (const results::ContactPoint& point : contact.points) {
        least = std::min(least, point.q_lumped);
        most = std::max(most, point.q_lumped);
      }
      table.rows.push_back({step.step, contact.name, fmt::format("{}", contact.sticking),
                            fmt::format("{}", contact.slipping),
                            fmt::format("{}", contact.rows - contact.sticking - contact.slipping),
                            fmt::format("{:.4f}", contact.shear_ratio), six_digits(least),
                            six_digits(most), small(contact.max_slip), small(contact.friction_work),
                            fmt::format("{}", step.increments)});
    }
  }
  return table;
}

namespace {

/// Resultants and energies of bodies or of nets, as `part` of a step says; rigid targets last.
ReportTable resultants(const model::Model& model, const results::Increment& increment,
                       ReportTable table,
                       std::vector<results::ForceBalance> results::StepResult::*part) {
  const Directions along = directions(model, increment);
  const std::string unit = model.units.force_name;
  const bool tied = std::ranges::any_of(increment.steps, &results::StepResult::tied);
  add_columns(table, "applied", along, unit);
  add_columns(table, "reaction", along, unit);
  add_columns(table, "contact", along, unit);
  if (tied) {
    add_columns(table, "tie", along, unit);
  }
  table.columns.push_back({"left over", unit, false});
  table.columns.push_back({"energy", unit + "*" + model.units.length_name, false});
  double scale = least_force(model, increment);
  double most = 0.0;
  for (const results::StepResult& step : increment.steps) {
    most = std::max(most, std::abs(step.energy));
    for (const std::vector<results::ForceBalance>* const list : {&(step.*part), &step.targets}) {
      for (const results::ForceBalance& b : *list) {
        scale =
            std::max({scale, b.applied.norm(), b.reaction.norm(), b.contact.norm(), b.tie.norm()});
      }
    }
  }
  for (const results::StepResult& step : increment.steps) {
    std::vector<results::ForceBalance> all = step.*part;
    all.insert(all.end(), step.targets.begin(), step.targets.end());
    for (const results::ForceBalance& b : all) {
      Row row{step.step, b.body};
      add_cells(row, b.applied, along, scale);
      add_cells(row, b.reaction, along, scale);
      add_cells(row, b.contact, along, scale);
      if (tied) {
        add_cells(row, b.tie, along, scale);
      }
      row.push_back(small((b.applied + b.reaction + b.contact + b.tie).norm()));
      row.push_back(six_digits_beside(b.energy, most));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

} // namespace

ReportTable balance_table(const model::Model& model, const results::Increment& increment) {
  return resultants(model, increment,
                    {"Force balance", {{"step", "", true}, {"body", "", true}}, {}},
                    &results::StepResult::balance);
}

ReportTable net_balance_table(const model::Model& model, const results::Increment& increment) {
  ReportTable table{"Force balance by net", {{"step", "", true}, {"net", "", true}}, {}};
  const bool same = std::ranges::all_of(increment.steps, [](const results::StepResult& step) {
    const bool one = step.balance.size() == 1 && step.nets.size() == 1;
    return one || std::ranges::equal(step.balance, step.nets, {}, &results::ForceBalance::body,
                                     &results::ForceBalance::body);
  });
  return same ? table : resultants(model, increment, table, &results::StepResult::nets);
}

ReportTable error_table(const results::Increment& increment) {
  ReportTable table{"Estimated energy error",
                    {{"step", "", true},
                     {"net", "", true},
                     {"error", "%", false},
                     {"most of it in elements", "", true},
                     {"share", "%", false}},
                    {}};
  for (const results::StepResult& step : increment.steps) {
    for (const results::NetErrorEstimate& error : step.errors) {
      if (error.net == "*" && step.errors.size() == 2) {
        continue; // of one net
      }
      std::string labels;
      for (const base::ElementId e : error.worst) {
        labels +=
            fmt::format("{}{}", labels.empty() ? "" : " ", increment.mesh.element_label[e.index()]);
      }
      const bool all = error.net == "*";
      table.rows.push_back({step.step, all ? "all" : error.net,
                            fmt::format("{:.1f}", 100.0 * error.part), all ? "" : labels,
                            all ? "" : fmt::format("{:.0f}", 100.0 * error.worst_share)});
    }
  }
  return table;
}

std::string direction_note(const model::Model& model) {
  return model::axisymmetric(model)
             ? "forces and energies are of the full circumference; radial forces balance round it "
               "and are not shown"
             : "";
}

std::string leading_step(const model::Model& model) {
  if (model.growth && model.growth->kmax.valid()) {
    return model.steps[model.growth->kmax.index()].name;
  }
  return model.steps.empty() ? std::string() : model.steps.back().name;
}

} // namespace spricka::report
