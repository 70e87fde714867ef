// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/columns.hpp"
#include "results/results.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

/// Results as rows of tables: what increments and steps hold, one after another.
namespace spricka::report {

/// A front at the end of a step.
struct FrontRow {
  const results::CrackLengthResult& increment;
  const results::LoadStepResult& step;
  const results::FrontResult& front;
};
/// The fronts of all steps of these increments.
std::vector<FrontRow> front_rows(std::span<const results::CrackLengthResult> increments);

/// A point of a front at the end of a step.
struct FrontPointRow : FrontRow {
  const results::FrontPointResult& point;
};
/// The points of the fronts of all steps of these increments.
std::vector<FrontPointRow> front_point_rows(std::span<const results::CrackLengthResult> increments);

/// A contact at the end of a step.
struct ContactRow {
  const results::CrackLengthResult& increment;
  const results::LoadStepResult& step;
  const results::ContactResult& contact;
};
/// The contacts of all steps of these increments.
std::vector<ContactRow> contact_rows(std::span<const results::CrackLengthResult> increments);

/// The columns that files of what is found at the ends of steps begin with.
template <class Row> Columns<Row> step_columns() {
  return Columns<Row>()
      .exact("increment", [](const Row& row) { return row.increment.number; })
      .exact("step", [](const Row& row) { return row.step.step; });
}

/// The front of that name at the end of that step of an increment; null: there is none.
const results::FrontResult* find_front_at_step(const results::CrackLengthResult& increment,
                                               std::string_view step, std::string_view front);

/// Adds a name to those that are known, once.
template <class Name> void add_unique(std::vector<Name>& names, const Name& name) {
  if (std::ranges::find(names, name) == names.end()) {
    names.push_back(name);
  }
}

} // namespace spricka::report
