// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/rank_messages.hpp"

#include <tuple>

namespace spricka::solve {

namespace {

// All members but the words, in one order for both ways.
template <typename Report> auto numbers_of(Report& r) {
  return std::tie(r.status, r.failed_row, r.flops, r.memory, r.besides, r.memory_left,
                  r.smallest_pivot, r.kept_memory, r.factor_entries, r.analysis_cpu, r.numeric_cpu,
                  r.row_flops, r.row_memory, r.engine, r.out_of_core, r.disk, r.relative_error);
}

} // namespace

void put_report(RankMessages& other, const FactorReport& report) {
  std::apply([&](const auto&... number) { (other.put(number), ...); }, numbers_of(report));
  other.put_list(report.engine_reason);
  other.put_list(report.trouble);
}

FactorReport get_report(RankMessages& other) {
  FactorReport report;
  std::apply(
      [&](auto&... number) {
        ((number = other.get<std::remove_reference_t<decltype(number)>>()), ...);
      },
      numbers_of(report));
  report.engine_reason = other.get_list<std::string>();
  report.trouble = other.get_list<std::string>();
  return report;
}

} // namespace spricka::solve
