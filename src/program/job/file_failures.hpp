// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/log.hpp"

#include <functional>

namespace spricka::program {

/// Does `work` and gives its outcome. A failure of a file that it throws (FileFailure with its own
/// code, std::system_error as E530) goes to the log and gives file_trouble.
base::Outcome run_reporting_file_failures(const Log& log,
                                          const std::function<base::Outcome()>& work);

} // namespace spricka::program
