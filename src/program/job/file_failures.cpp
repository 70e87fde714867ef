// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/file_failures.hpp"

#include "archive/safe_file.hpp"

#include <system_error>

namespace spricka::program {

base::Outcome run_reporting_file_failures(const Log& log,
                                          const std::function<base::Outcome()>& work) {
  try {
    return work();
  } catch (const archive::FileFailure& failure) {
    log.message(base::Severity::error, failure.code(), failure.what());
  } catch (const std::system_error& failure) {
    log.message(base::Severity::error, "E530", failure.what());
  }
  return base::Outcome::file_trouble;
}

} // namespace spricka::program
