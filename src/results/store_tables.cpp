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

const char* word_of(ContactState state) {
  switch (state) {
  case ContactState::open:
    return "open";
  case ContactState::closed:
    return "closed";
  case ContactState::stick:
    return "stick";
  case ContactState::slip:
    break;
  }
  return "slip";
}

Rows k_rows(const Run& run) {
  Rows rows;
  for_each_step(run, [&](const Increment& increment, const StepResult& step) {
    for (const TipResult& tip : step.tips) {
      const auto bar = [&](std::size_t k) {
        return tip.no_bar.empty() ? tip.bar[k].size() : no_number;
      };
      const auto best = [&](std::size_t k) {
        return tip.no_bar.empty() ? tip.bar[k].best : no_number;
      };
      const auto K = [&](double value) { return tip.two_materials ? no_number : value; };
      rows("increment", increment.number)("step", step.step)("crack", tip.name)("a", tip.a);
      rows("K1", K(tip.K1))("K2", K(tip.K2))("G", tip.G)("T", K(tip.T))("spread", tip.spread);
      rows("K1_bar", bar(0))("K1_best", best(0))("K2_bar", bar(1))("K2_best", best(1));
      rows("x", tip.x[0])("y", tip.x[1])("z", tip.x[2])("doubt", tip.doubt);
      rows.end_row();
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
        rows("node", static_cast<int>(point.node.value))("x", point.x[0])("y", point.x[1]);
        rows("z", point.x[2])("theta", point.theta)("arc", point.arc)("p_lumped", point.p_lumped);
        rows("p_consistent", point.p_consistent)("q_lumped", point.q_lumped);
        rows("q_consistent", point.q_consistent)("slip", point.slip)("gap", point.gap);
        rows("state", std::string(word_of(point.state)));
        rows.end_row();
      }
    }
  });
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
  pressure_rows(run).write(group, "pressure");
  path_rows(run).write(group, "load_path");
}

} // namespace spricka::results
