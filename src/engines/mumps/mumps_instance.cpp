// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/mumps/mumps_instance.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace spricka::engines {

namespace {

// Numbers of the manual of MUMPS 5.5.
constexpr int all_ranks = -987654; // "use MPI_COMM_WORLD": the build without MPI has no other
// Errors of INFOG(1).
constexpr int integer_workspace_too_small = -8;
constexpr int real_workspace_too_small = -9;
constexpr int numerically_singular = -10;
constexpr int not_definite_at_root = -40;
constexpr int trouble_with_files = -90;

std::mutex& turn() {
  static std::mutex mutex;
  return mutex;
}

std::int64_t next_number() {
  static std::atomic<std::int64_t> next = 0;
  return next++;
}

} // namespace

MumpsInstance::MumpsInstance(solve::CollectiveStep step)
    : step_(std::move(step)), number_(next_number()) {
  solve::blas::force_single_blas_thread();
  data_.sym = 1; // positive definite
  data_.par = 1;
  data_.comm_fortran = all_ranks;
  call(static_cast<int>(MumpsJob::initialise));
  for (const int stream : {1, 2, 3}) {
    control(stream) = -1; // standard output is ours
  }
  control(4) = 0;  // prints nothing
  control(6) = 0;  // no permutation to a better diagonal
  control(8) = 0;  // no scaling: MumpsMatrix has done it
  control(10) = 0; // refinement is done here
  control(13) = 1; // root front in the same way as the others, so that every pivot is seen
  control(14) = 5; // per cent of workspace beyond the estimate: without pivoting that holds
  control(16) = 1; // threads
  control(28) = 1; // sequential analysis
}

MumpsInstance::~MumpsInstance() {
  call(static_cast<int>(MumpsJob::terminate));
}

void MumpsInstance::call(int job) {
  const auto own_part = [&] {
    const std::scoped_lock lock(turn());
    data_.job = job;
    dmumps_c(&data_);
  };
  if (step_) {
    step_(number_, job, own_part);
  } else {
    own_part();
  }
}

bool MumpsInstance::run(MumpsJob job) {
  constexpr int most_relaxation = 200; // per cent
  call(static_cast<int>(job));
  while (job == MumpsJob::factorisation && control(14) < most_relaxation &&
         (info(1) == integer_workspace_too_small || info(1) == real_workspace_too_small)) {
    control(14) = std::max(20, 2 * control(14));
    call(static_cast<int>(job));
  }
  return info(1) >= 0;
}

bool MumpsInstance::set_folder(const std::string& folder) {
  const std::span<char> place(data_.ooc_tmpdir);
  if (folder.size() + 1 > place.size()) {
    return false;
  }
  std::ranges::copy(folder, place.begin());
  place[folder.size()] = '\0';
  const std::string prefix = "factor";
  std::ranges::copy(prefix, data_.ooc_prefix);
  data_.ooc_prefix[prefix.size()] = '\0';
  return true;
}

MumpsInstance::Failure MumpsInstance::failure() const {
  switch (info(1)) {
  case numerically_singular:
  case not_definite_at_root:
    return {solve::FactorStatus::not_positive_definite, {}};
  case trouble_with_files:
    return {solve::FactorStatus::engine_failed, "MUMPS cannot write or read its files"};
  case -5:  // real array of the analysis
  case -7:  // integer array of the analysis
  case -11: // workspace of the solution
  case -13: // array of the factorisation or the solution
  case -14:
  case integer_workspace_too_small:
  case real_workspace_too_small:
    return {solve::FactorStatus::out_of_memory, {}};
  default:
    return {solve::FactorStatus::engine_failed,
            fmt::format("MUMPS has stopped with its error {}, {}", info(1), info(2))};
  }
}

} // namespace spricka::engines
