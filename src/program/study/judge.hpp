// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/verdict.hpp"

#include <vector>

namespace spricka::program {

/// Errors of all trials. A deck's reference counts where the finest setting agrees with it within
/// its own bar, or without one within its change from the next coarser setting; else the finest
/// setting's value does, corrected where it has a bar.
StudyVerdict assess_trials(const std::vector<Answer>& answers, const std::vector<Trial>& trials);

} // namespace spricka::program
