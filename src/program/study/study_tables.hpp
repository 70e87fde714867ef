// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/study_record.hpp"
#include "report/drawing/table.hpp"

namespace spricka::program {

/// A row for each setting: freedoms, CPU, memory, the largest error of each group.
report::ReportTable settings_table(const Study& study);

/// A row for each series of each group: the power that errors fall by, where they stop, and why.
report::ReportTable series_table(const Study& study);

/// References of the deck that are not used, and what they are off by; the largest of each source.
report::ReportTable distrusted_table(const Study& study);

} // namespace spricka::program
