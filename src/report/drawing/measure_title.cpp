// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/measure_title.hpp"

#include "report/drawing/table.hpp"

#include <fmt/format.h>

namespace spricka::report {

MeasureTitle axis_title(std::string_view name, const base::OutputUnit& unit) {
  return {unit.name.empty() ? std::string(name)
                            : fmt::format("{}  [{}]", name, typeset_unit(unit.name)),
          unit};
}

MeasureTitle legend_title(std::string_view name, const base::OutputUnit& unit) {
  return {fmt::format("{}, {}", name, typeset_unit(unit.name)), unit};
}

} // namespace spricka::report
