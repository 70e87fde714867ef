// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/ranks.hpp"

#include "base/exit_codes.hpp"
#include "base/memory.hpp"
#include "program/job/failures.hpp"
#include "program/job/log.hpp"
#include "solve/engine_module.hpp"
#include "solve/equation_ranks.hpp"
#include "solve/one_thread.hpp"
#include "solve/serve_rank.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>

#include <fmt/format.h>

namespace spricka::program {

namespace {

/// Where those who start the processes of a run tell each its rank, and how many there are.
struct LauncherVariables {
  const char* rank;
  const char* count;
};
constexpr std::array launchers{
    LauncherVariables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, // mpirun of Open MPI
    LauncherVariables{"PMIX_RANK", "SLURM_STEP_NUM_TASKS"},            // srun --mpi=pmix
    LauncherVariables{"PMI_RANK", "PMI_SIZE"},                         // srun --mpi=pmi2
};

int number_in_environment(const char* name, int otherwise) {
  const char* const text = std::getenv(name); // NOLINT(concurrency-mt-unsafe): no thread yet
  return text == nullptr ? otherwise : std::atoi(text); // NOLINT(cert-err34-c): 0 is no count
}

struct PlaceInRun {
  int rank = 0;
  int count = 1;
};

PlaceInRun place_in_run() {
  for (const LauncherVariables& launcher : launchers) {
    const int rank = number_in_environment(launcher.rank, -1);
    const int count = number_in_environment(launcher.count, 0);
    if (rank >= 0 && count > 1) {
      return {rank, count};
    }
  }
  return {};
}

// A program that this one starts, the mesher or another run of itself, is no rank.
void forget_launcher() {
  for (const LauncherVariables& launcher : launchers) {
    unsetenv(launcher.rank); // NOLINT(concurrency-mt-unsafe)
  }
}

int report_no_ranks(const PlaceInRun& place, const std::string& why) {
  if (place.rank == 0) {
    Log(LogFormat::text)
        .report_message(base::Severity::error, "E530",
                        fmt::format("started {} times as one run: {}", place.count, why));
  }
  return base::exit_code(base::ProgramOutcome::file_trouble);
}

// What ends the run is for rank 0 to say: it may have to write what it has. If it does not live to
// say it, mpirun ends this one.
int serve(solve::Communicator& communicator) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    std::signal(signal, SIG_IGN); // NOLINT(cert-err33-c)
  }
  auto outcome = base::ProgramOutcome::defect;
  try {
    solve::reserve_blas_workspace(1);
    return solve::serve_rank(communicator);
  } catch (const std::exception& e) {
    const bool memory = is_out_of_memory(e);
    outcome = memory ? base::ProgramOutcome::not_solvable : outcome;
    Log(LogFormat::text)
        .report_message(base::Severity::error, memory ? "E466" : "E530",
                        fmt::format("rank {} on {}: {}", communicator.rank(),
                                    communicator.machine_name(),
                                    memory ? out_of_memory_message() : e.what()));
  }
  communicator.abort(base::exit_code(outcome));
  return base::exit_code(outcome);
}

} // namespace

int run_on_first_rank(const std::function<int()>& program) {
  const PlaceInRun place = place_in_run();
  if (place.count == 1) {
    return program();
  }
  const solve::CommunicatorOrTrouble opened = solve::open_communicator();
  if (!opened.communicator) {
    return report_no_ranks(place, opened.trouble);
  }
  solve::Communicator& communicator = *opened.communicator;
  if (communicator.size() != place.count) {
    return report_no_ranks(
        place, fmt::format("what started them is not of the MPI that spricka was built with, "
                           "which sees {} of them",
                           communicator.size()));
  }
  forget_launcher();
  base::divide_memory_limit(communicator.ranks_on_machine());
  if (communicator.rank() > 0) {
    return serve(communicator);
  }
  solve::EquationRanks ranks(communicator);
  solve::set_equation_ranks(&ranks);
  const int code = program();
  solve::set_equation_ranks(nullptr);
  ranks.end(code);
  return code;
}

} // namespace spricka::program
