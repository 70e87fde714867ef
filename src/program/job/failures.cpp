// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/failures.hpp"

#include "archive/safe_file.hpp"
#include "base/clock.hpp"
#include "base/memory.hpp"

#include <array>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

base::ProgramOutcome
run_reporting_file_failures(const Log& log, const std::function<base::ProgramOutcome()>& work) {
  try {
    return work();
  } catch (const archive::FileFailure& failure) {
    log.report_message(base::Severity::error, failure.code(), failure.what());
  } catch (const std::system_error& failure) {
    log.report_message(base::Severity::error, "E530", failure.what());
  } catch (const std::range_error& failure) { // of an engine that iterates
    log.report_message(base::Severity::error, "E520", failure.what());
    return base::ProgramOutcome::not_converged;
  }
  return base::ProgramOutcome::file_trouble;
}

bool is_out_of_memory(const std::exception& trouble) {
  return dynamic_cast<const std::bad_alloc*>(&trouble) != nullptr ||
         dynamic_cast<const std::length_error*>(&trouble) != nullptr; // more than can be counted
}

std::string out_of_memory_message() {
  constexpr double mebi = 1048576.0;
  return fmt::format("out of memory: {:.0f} MiB were in use, the machine or its limits (ulimit -v, "
                     "a job queue) allow {:.0f} MiB; spricka check foretells what the deck needs",
                     static_cast<double>(base::peak_memory()) / mebi,
                     static_cast<double>(base::process_memory_limit()) / mebi);
}

std::string failure_remedy(const base::OperationFailure& answer) {
  if (answer.kind == base::ProgramOutcome::not_converged) {
    return "with friction more SUBSTEPS or a smaller MU; spricka help E520 says more";
  }
  using Remedy = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Remedy, 14> remedies{
      {{"next to nothing holds",
        "hold it by a support ($FREEDOM), friction (MU=) or a contact that it runs against"},
       {"slides", "more friction, more pressure or less load, or a support: $FREEDOM"},
       {"is not mounted before", "mount it before the body is loaded, or hold the body until then"},
       {"was dismounted", "hold the body by a support or another contact before it is dismounted"},
       {"only presses",
        "look at the sign of the load and at its total (TYPE=FORCE acts on each node of a set, "
        "TYPE=RESULTANT once on all); else a support ($FREEDOM), or TYPE=BONDED"},
       {"not held", "add a support ($FREEDOM), or the $CONTACT that holds it"},
       {"singular", "add a support ($FREEDOM), or join the parts"},
       {"mechanism", "add a support ($FREEDOM), or join the parts"},
       {"TMPDIR", "the page of the manual on engines has what they keep on disk"},
       {"cannot be loaded", "install that library, or take another --engine"},
       {"iterations", "choose --engine cholesky or mumps"},
       {"memory",
        "take fewer or coarser elements or, where rows of contact take it, MULTIPLIER=CORNER on "
        "$CONTACT; or a machine with more memory"},
       {"build", "install it, or take another --engine: auto takes those that are there"},
       {"mesh", "another place or length of the crack, or RADIUS and SIZE on $TIPNET"}}};
  for (const auto& [word, remedy] : remedies) {
    if (answer.why.find(word) != std::string::npos) {
      return std::string(remedy);
    }
  }
  return "spricka help E510 says what can be done";
}

} // namespace spricka::program
