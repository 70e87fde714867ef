// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/requests.hpp"
#include "model/wanted_steps.hpp"
#include "report/drawing/set_members.hpp"
#include "report/report.hpp"
#include "report/sweep_files.hpp"
#include "results/k_quantities.hpp"

#include <algorithm>
#include <array>

namespace spricka::report {

namespace {

using results::SweepCell;

void add_contact(std::vector<SweepCell>& cells, const results::ContactResult& contact,
                 const std::string& step, int increment) {
  if (!contact.mounted) {
    return;
  }
  for (const results::ContactQuantity& q : results::contact_quantities) {
    if (!q.sweep.empty()) {
      cells.push_back({std::string(q.sweep), contact.name, step, increment, contact.*q.member});
    }
  }
}

void add_front(std::vector<SweepCell>& cells, const results::FrontResult& front,
               const std::string& step, const results::Increment& increment) {
  for (const results::KQuantity& q : results::k_quantities) {
    if (q.appears_in(results::in_sweep, increment.mesh.dim) && q.is_number(front)) {
      cells.push_back({q.name, front.name, step, increment.number, q.extract_value(front)});
    }
  }
}

/// The cells of one request at one step's end.
class Requested {
public:
  Requested(const results::Increment& increment, const results::StepResult& step,
            std::vector<SweepCell>& cells)
      : increment_(increment), step_(step), cells_(cells) {}

  void add(const model::OutputRequest& request) {
    if (request.quantity == "K") {
      for (const results::FrontResult& front : step_.fronts) {
        const bool wanted =
            front.name == request.name || front.name.starts_with(request.name + ".");
        if (wanted && front.is_tip()) {
          cell("a", front.name, front.a);
          add_front(cells_, front, step_.step, increment_);
        }
      }
    } else if (request.quantity == "CPRESS") {
      if (const auto* contact = results::find_contact(step_, request.name)) {
        add_contact(cells_, *contact, step_.step, increment_.number);
      }
    } else if (request.quantity == "REACTION") {
      reactions(request.name);
    } else {
      ranges(request);
    }
  }

private:
  void reactions(const std::string& set) {
    const int dim = increment_.mesh.dim;
    base::Vec3 sum = base::Vec3::Zero();
    for (const base::NodeId n : set_members(increment_.mesh, set)) {
      sum.head(dim) += step_.reaction.segment(static_cast<Eigen::Index>(n.index()) * dim, dim);
    }
    for (int c = 0; c < dim; ++c) {
      cell(std::string("REACTION.") + "XYZ"[c], set, sum[c]);
    }
  }

  void ranges(const model::OutputRequest& request) {
    if (request.quantity == "S") {
      stress_ranges(request.name);
      return;
    }
    const int dim = increment_.mesh.dim;
    for (int c = 0; c < dim; ++c) {
      std::vector<double> values;
      for (const base::NodeId n : set_members(increment_.mesh, request.name)) {
        values.push_back(step_.u[static_cast<Eigen::Index>(n.index()) * dim + c]);
      }
      range(std::string("U.") + "XYZ"[c], request.name, values);
    }
  }

  void stress_ranges(const std::string& set) {
    static constexpr std::array<const char*, 10> names{"XX", "YY", "ZZ", "XY", "YZ",
                                                       "XZ", "P1", "P2", "P3", "MISES"};
    std::array<std::vector<double>, 10> values;
    if (step_.stress.empty()) {
      return;
    }
    for (const StressPoint& at : stress_points(increment_.mesh, set)) {
      const results::Stress& s = step_.stress[at.point];
      const std::array<double, 3> p = results::principal_stresses(s);
      for (std::size_t c = 0; c < 9; ++c) {
        values[c].push_back(c < 6 ? s[c] : p[c - 6]);
      }
      values[9].push_back(results::von_mises(s));
    }
    for (std::size_t c = 0; c < names.size(); ++c) {
      range(std::string("S.") + names[c], set, values[c]);
    }
  }

  void range(const std::string& quantity, const std::string& set,
             const std::vector<double>& values) {
    if (!values.empty()) {
      const auto [low, high] = std::ranges::minmax(values);
      cell(quantity + ".MIN", set, low);
      cell(quantity + ".MAX", set, high);
    }
  }

  void cell(const std::string& quantity, const std::string& name, double value) {
    cells_.push_back({quantity, name, step_.step, increment_.number, value});
  }

  const results::Increment& increment_;
  const results::StepResult& step_;
  std::vector<SweepCell>& cells_;
};

} // namespace

std::vector<SweepCell> sweep_cells(const results::RunResult& run) {
  std::vector<SweepCell> cells;
  if (run.growth) {
    cells.push_back({"N", "", "", 0, run.growth->final_cycles()});
  }
  for (const results::Increment& increment : run.increments) {
    if (increment.a > 0.0) {
      cells.push_back({"a", "", "", increment.number, increment.a});
    }
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        add_front(cells, front, step.step, increment);
      }
      for (const results::ContactResult& contact : step.contacts) {
        add_contact(cells, contact, step.step, increment.number);
      }
    }
  }
  return cells;
}

std::vector<SweepCell> requested_cells(const model::Model& model, const model::Output& output,
                                       const results::RunResult& run) {
  std::vector<SweepCell> cells;
  if (run.increments.empty()) {
    return cells;
  }
  const results::Increment& last = run.increments.back();
  for (const std::size_t s : model::output_steps(model, output, true)) {
    Requested requested(last, last.steps[s], cells);
    for (const model::OutputRequest& request : output.requests) {
      requested.add(request);
    }
  }
  return cells;
}

} // namespace spricka::report
