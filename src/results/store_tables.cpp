// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/k_quantities.hpp"
#include "results/store_run.hpp"

#include <cmath>
#include <limits>

namespace spricka::results {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A table that is filled cell by cell, row after row.
class SummaryTableRows {
public:
  SummaryTableRows& operator()(const char* name, double value) { return put(name, value); }
  SummaryTableRows& operator()(const char* name, int value) {
    return put(name, std::int64_t{value});
  }
  SummaryTableRows& operator()(const char* name, std::string value) {
    return put(name, std::move(value));
  }
  void end_row() {
    next_ = 0;
    first_ = false;
  }
  void write(StoreGroup& group, const std::string& name) const {
    if (!table_.columns.empty()) {
      group.write(name, table_);
    }
  }

private:
  template <class T> SummaryTableRows& put(const char* name, T value) {
    if (first_) {
      table_.columns.push_back({name, std::vector<T>()});
    }
    std::get<std::vector<T>>(table_.columns[next_++].values).push_back(std::move(value));
    return *this;
  }
  ColumnTable table_;
  std::size_t next_ = 0;
  bool first_ = true;
};

template <class Visit> void for_each_step(const RunResult& run, const Visit& visit) {
  for (const CrackLengthResult& increment : run.increments) {
    for (const LoadStepResult& step : increment.steps) {
      visit(increment, step);
    }
  }
}

// Not a number where there is none; but the spread between two materials is 0.
double kept(const KQuantity& q, const FrontResult& front, const FrontPointResult& point) {
  return q.is_given(front, point) || q.member == &FrontPointResult::spread
             ? q.extract_value(front, point)
             : no_number;
}

SummaryTableRows k_rows(const RunResult& run) {
  SummaryTableRows rows;
  for_each_step(run, [&](const CrackLengthResult& increment, const LoadStepResult& step) {
    for (const FrontResult& front : step.fronts) {
      for (const FrontPointResult& point : front.points) {
        rows("increment", increment.number)("step", step.step)("crack", front.name);
        for (const KQuantity& q : k_quantities) {
          if (q.appears_in(in_results_h5, increment.mesh.dim)) {
            rows(q.name, kept(q, front, point));
          }
        }
        rows("doubt", front.invalid_reason);
        rows.end_row();
      }
    }
  });
  return rows;
}

SummaryTableRows pressure_rows(const RunResult& run) {
  SummaryTableRows rows;
  for_each_step(run, [&](const CrackLengthResult& increment, const LoadStepResult& step) {
    for (const ContactResult& contact : step.contacts) {
      for (const ContactPoint& point : contact.points) {
        if (!contact.mounted) {
          continue;
        }
        rows("increment", increment.number)("step", step.step)("contact", contact.name);
        rows("node", static_cast<int>(point.node.value));
        for (const bool words : {false, true}) {
          for (const ContactPointQuantity& q : point_quantities) {
            if (q.appears_in(in_pressure_h5) && q.is_word() == words) {
              if (words) {
                rows(q.name, std::string(display_word(point.*q.state)));
              } else {
                rows(q.name, q.extract_value(point));
              }
            }
          }
        }
        rows.end_row();
      }
    }
  });
  return rows;
}

SummaryTableRows path_rows(const RunResult& run) {
  SummaryTableRows rows;
  for (const CrackLengthResult& increment : run.increments) {
    for (const LoadPathResult& path : increment.paths) {
      for (const LoadPathFront& front : path.fronts) {
        for (const LoadPathFrontPoint& point : front.points) {
          for (const double t : path.t) {
            rows("increment", increment.number)("path", path.name)("crack",
                                                                   front.front_without_points.name);
            rows("a", front.front_without_points.a)("point", point.point_at_start.number)("t", t);
            for (const KQuantity& q : k_quantities) {
              if (q.is_k() && q.appears_in(in_results_h5, increment.mesh.dim)) {
                rows(q.name, point.K[static_cast<std::size_t>(q.mode)](t));
              }
            }
            rows.end_row();
          }
        }
      }
    }
  }
  return rows;
}

} // namespace

void write_summary_tables(StoreGroup group, const RunResult& run) {
  k_rows(run).write(group, "k");
  pressure_rows(run).write(group, "pressure");
  path_rows(run).write(group, "load_path");
}

} // namespace spricka::results
