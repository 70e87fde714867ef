// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "model/wanted_steps.hpp"
#include "report/report.hpp"
#include "report/requested_values.hpp"
#include "report/sweep_files.hpp"
#include "report/topics/result_rows.hpp"
#include "results/k_quantities.hpp"
#include "results/result_unit.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace spricka::report {

namespace {

using results::SweepResultValue;

/// Cells of one run, which are in units of output.
struct SweepCells {
  const base::UnitSystem& units;
  std::vector<SweepResultValue> cells;

  void add(SweepResultValue cell, base::QuantityKind kind) {
    cell.value = base::output_unit(units, kind).from_deck(cell.value);
    cells.push_back(std::move(cell));
  }
};

void add_contact(SweepCells& cells, const results::ContactResult& contact, const std::string& step,
                 int increment) {
  if (!contact.mounted) {
    return;
  }
  for (const results::ContactQuantity& q : results::contact_quantities) {
    if (!q.sweep.empty()) {
      cells.add({std::string(q.sweep), contact.name, step, increment, contact.*q.member}, q.kind);
    }
  }
}

void add_front(SweepCells& cells, const results::FrontResult& front, const std::string& step,
               const results::CrackLengthResult& increment) {
  for (const results::KQuantity& q : results::k_quantities) {
    if (q.appears_in(results::in_sweep, increment.mesh.dim) && q.is_given_or_zero(front)) {
      cells.add({q.name, front.name, step, increment.number, q.extract_value(front)}, q.kind);
    }
  }
}

/// Sums as they are, of values at nodes the smallest and the largest of each component.
void add_values(SweepCells& cells, const model::RequestedQuantity& request,
                std::vector<RequestedValue> values, const std::string& step, int increment) {
  std::stable_partition(values.begin(), values.end(),
                        [](const RequestedValue& v) { return v.component != "MISES"; });
  std::vector<std::string> components;
  for (const RequestedValue& value : values) {
    add_unique(components, value.component);
  }
  for (const std::string& component : components) {
    const auto add = [&](const char* which, const RequestedValue& value) {
      cells.add(
          {request.quantity + "." + component + which, request.name, step, increment, value.value},
          value.kind);
    };
    std::vector<RequestedValue> same;
    std::ranges::copy_if(values, std::back_inserter(same),
                         [&](const RequestedValue& v) { return v.component == component; });
    const auto [low, high] = std::ranges::minmax(same, {}, &RequestedValue::value);
    if (low.where) {
      add(".MIN", low);
      add(".MAX", high);
    } else {
      add("", low);
    }
  }
}

/// The cells of one request at the end of one step.
void add_requested(SweepCells& cells, const results::CrackLengthResult& increment,
                   const results::LoadStepResult& step, const model::RequestedQuantity& request) {
  if (request.quantity == "K") {
    for (const results::FrontResult& front : step.fronts) {
      if (request_names_front(request, front) && front.is_tip()) {
        cells.add({"a", front.name, step.step, increment.number, front.a},
                  base::QuantityKind::length);
        add_front(cells, front, step.step, increment);
      }
    }
  } else if (request.quantity == "CPRESS") {
    if (const auto* contact = results::find_contact(step, request.name)) {
      add_contact(cells, *contact, step.step, increment.number);
    }
  } else {
    add_values(cells, request, collect_requested_values(increment, step, request), step.step,
               increment.number);
  }
}

} // namespace

std::vector<SweepResultValue> collect_sweep_values_of_run(const model::Model& model,
                                                          const results::RunResult& run) {
  SweepCells cells{model.units, {}};
  if (run.growth) {
    const base::OutputUnit life = results::life_unit(model.units, *run.growth);
    cells.cells.push_back({"N", "", "", 0, life.from_deck(run.growth->final_cycles())});
  }
  for (const results::CrackLengthResult& increment : run.increments) {
    if (increment.a > 0.0) {
      cells.add({"a", "", "", increment.number, increment.a}, base::QuantityKind::length);
    }
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        add_front(cells, front, step.step, increment);
      }
      for (const results::ContactResult& contact : step.contacts) {
        add_contact(cells, contact, step.step, increment.number);
      }
    }
  }
  return std::move(cells.cells);
}

std::vector<SweepResultValue> collect_requested_end_values(const model::Model& model,
                                                           const model::OutputFileRequest& output,
                                                           const results::RunResult& run) {
  SweepCells cells{model.units, {}};
  if (run.increments.empty()) {
    return {};
  }
  const results::CrackLengthResult& last = run.increments.back();
  for (const std::size_t s : model::output_step_indices(model, output, true)) {
    for (const model::RequestedQuantity& request : output.requests) {
      add_requested(cells, last, last.steps[s], request);
    }
  }
  return std::move(cells.cells);
}

} // namespace spricka::report
