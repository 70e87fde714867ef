// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/verdict.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// All that is shown of a study.
struct Study {
  std::vector<Answer> answers;
  std::vector<Trial> trials;
  std::vector<std::string> notes; ///< what was not varied or run, and why
  StudyVerdict verdict;
};

} // namespace spricka::program
