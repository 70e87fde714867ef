// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/store_run.hpp"

#include <cmath>
#include <limits>

namespace spricka::results {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A table that is filled cell by cell, row after row.
class Rows {
public:
  Rows& operator()(const char* name, double value) { return put(name, value); }
  Rows& operator()(const char* name, int value) { return put(name, std::int64_t{value}); }
  Rows& operator()(const char* name, std::string value) { return put(name, std::move(value)); }
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
  template <class T> Rows& put(const char* name, T value) {
    if (first_) {
      table_.columns.push_back({name, std::vector<T>()});
    }
    std::get<std::vector<T>>(table_.columns[next_++].values).push_back(std::move(value));
    return *this;
  }
  Table table_;
  std::size_t next_ = 0;
  bool first_ = true;
};

template <class Visit> void for_each_step(const Run& run, const Visit& visit) {
  for (const Increment& increment : run.increments) {
    for (const StepResult& step : increment.steps) {
      visit(increment, step);
    }
  }
}

// Not a number where there is none; but the spread between two materials is 0.
double kept(const TipQuantity& q, const TipResult& tip) {
  return q.is_given(tip) || q.member == &TipResult::spread ? q.of(tip) : no_number;
}

Rows k_rows(const Run& run) {
  Rows rows;
  for_each_step(run, [&](const Increment& increment, const StepResult& step) {
    for (const TipResult& tip : step.tips) {
      rows("increment", increment.number)("step", step.step)("crack", tip.name);
      for (const bool judges : {false, true}) {
        for (const TipQuantity& q : tip_quantities) {
          if (q.is(in_results_h5) && q.judges == judges) {
            rows(q.name, kept(q, tip));
          }
        }
      }
      rows("x", tip.x[0])("y", tip.x[1])("z", tip.x[2])("doubt", tip.doubt);
      rows.end_row();
    }
  });
  return rows;
}

Rows front_rows(const Run& run) {
  Rows rows;
  for_each_step(run, [&](const Increment& increment, const StepResult& step) {
    for (const FrontResult& front : step.fronts) {
      for (const FrontPlace& place : front.points) {
        rows("increment", increment.number)("step", step.step)("crack", front.name)("a", front.a);
        rows("point", place.number);
        for (const FrontQuantity& q : front_quantities) {
          const bool given =
              (q.given == nullptr || q.given(front)) && !(q.inside && place.at_surface);
          rows(q.name, given ? q.of(place) : no_number);
        }
        rows("at_surface", static_cast<int>(place.at_surface))("doubt", front.doubt);
        rows.end_row();
      }
    }
  });
  return rows;
}

Rows pressure_rows(const Run& run) {
  Rows rows;
  for_each_step(run, [&](const Increment& increment, const StepResult& step) {
    for (const ContactResult& contact : step.contacts) {
      for (const ContactPoint& point : contact.points) {
        if (!contact.mounted) {
          continue;
        }
        rows("increment", increment.number)("step", step.step)("contact", contact.name);
        rows("node", static_cast<int>(point.node.value));
        for (const bool words : {false, true}) {
          for (const PointQuantity& q : point_quantities) {
            if (q.is(in_pressure_h5) && q.is_word() == words) {
              if (words) {
                rows(q.name, std::string(word_of(point.*q.state)));
              } else {
                rows(q.name, q.of(point));
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

Rows path_front_rows(const Run& run) {
  Rows rows;
  for (const Increment& increment : run.increments) {
    for (const LoadPath& path : increment.paths) {
      for (const PathFront& front : path.fronts) {
        for (const PathPoint& point : front.points) {
          for (const double t : path.t) {
            rows("increment", increment.number)("path", path.name)("crack", front.is.name);
            rows("point", point.is.number)("t", t)("K1", point.K[0](t))("K2", point.K[1](t));
            rows("K3", point.K[2](t));
            rows.end_row();
          }
        }
      }
    }
  }
  return rows;
}

Rows path_rows(const Run& run) {
  Rows rows;
  for (const Increment& increment : run.increments) {
    for (const LoadPath& path : increment.paths) {
      for (const PathTip& tip : path.tips) {
        for (const double t : path.t) {
          rows("increment", increment.number)("path", path.name)("crack", tip.name)("a", tip.a);
          rows("t", t)("K1", tip.K1(t))("K2", tip.K2(t));
          rows.end_row();
        }
      }
    }
  }
  return rows;
}

} // namespace

void write_reader_tables(StoreGroup group, const Run& run) {
  k_rows(run).write(group, "k");
  front_rows(run).write(group, "fronts");
  pressure_rows(run).write(group, "pressure");
  path_rows(run).write(group, "load_path");
  path_front_rows(run).write(group, "load_path_fronts");
}

} // namespace spricka::results
