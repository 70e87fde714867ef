// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/result_rows.hpp"

namespace spricka::report {

std::vector<FrontRow> front_rows(std::span<const results::CrackLengthResult> increments) {
  std::vector<FrontRow> rows;
  for (const results::CrackLengthResult& increment : increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        rows.push_back({increment, step, front});
      }
    }
  }
  return rows;
}

std::vector<FrontPointRow>
front_point_rows(std::span<const results::CrackLengthResult> increments) {
  std::vector<FrontPointRow> rows;
  for (const FrontRow& row : front_rows(increments)) {
    for (const results::FrontPointResult& point : row.front.points) {
      rows.push_back({row, point});
    }
  }
  return rows;
}

std::vector<ContactRow> contact_rows(std::span<const results::CrackLengthResult> increments) {
  std::vector<ContactRow> rows;
  for (const results::CrackLengthResult& increment : increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::ContactResult& contact : step.contacts) {
        rows.push_back({increment, step, contact});
      }
    }
  }
  return rows;
}

const results::FrontResult* find_front_at_step(const results::CrackLengthResult& increment,
                                               std::string_view step, std::string_view front) {
  const results::LoadStepResult* const found = results::find_step(increment, step);
  return found == nullptr ? nullptr : results::find_front(*found, front);
}

} // namespace spricka::report
