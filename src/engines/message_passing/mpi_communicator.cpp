// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/message_passing/mpi_communicator.hpp"
#include "base/memory.hpp"
#include "engines/mumps/mumps_condensation.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace spricka::engines {

namespace {

constexpr std::size_t largest_piece = std::size_t{1} << 28U; ///< [bytes]; MPI counts in int
constexpr int message_tag = 0;

// A factorisation takes long enough for a nap, a small question does not.
void pause_between_tests(int tests) {
  if (tests < 2000) {
    std::this_thread::yield();
  } else {
    std::this_thread::sleep_for(std::chrono::microseconds(std::min(tests / 20, 1000)));
  }
}

} // namespace

MpiCommunicator::MpiCommunicator() {
  int provided = MPI_THREAD_SINGLE;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS) {
    throw std::runtime_error("MPI cannot be initialised");
  }
  if (provided < MPI_THREAD_SERIALIZED) {
    throw std::runtime_error("this MPI allows no calls from several threads");
  }
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &ranks_on_machine_);
  MPI_Comm_free(&machine);
  base::divide_memory_limit(ranks_on_machine_); // as MUMPS sees it: the module has its own count
  std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
  int length = 0;
  MPI_Get_processor_name(name.data(), &length);
  machine_name_.assign(name.data(), static_cast<std::size_t>(length));
}

MpiCommunicator::~MpiCommunicator() {
  MPI_Finalize();
}

void MpiCommunicator::wait_for(MPI_Request& request) {
  for (int tests = 0;; ++tests) {
    int done = 0;
    {
      const std::scoped_lock lock(calls_);
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    }
    if (done != 0) {
      return;
    }
    pause_between_tests(tests);
  }
}

void MpiCommunicator::send(int to, const void* data, std::size_t bytes) {
  const auto* from = static_cast<const std::byte*>(data);
  for (std::size_t begun = 0; begun < bytes; begun += largest_piece) {
    MPI_Request request = MPI_REQUEST_NULL;
    {
      const std::scoped_lock lock(calls_);
      MPI_Isend(from + begun, static_cast<int>(std::min(bytes - begun, largest_piece)), MPI_BYTE,
                to, message_tag, MPI_COMM_WORLD, &request);
    }
    wait_for(request);
  }
}

void MpiCommunicator::receive(int from, void* data, std::size_t bytes) {
  auto* to = static_cast<std::byte*>(data);
  for (std::size_t begun = 0; begun < bytes; begun += largest_piece) {
    MPI_Request request = MPI_REQUEST_NULL;
    {
      const std::scoped_lock lock(calls_);
      MPI_Irecv(to + begun, static_cast<int>(std::min(bytes - begun, largest_piece)), MPI_BYTE,
                from, message_tag, MPI_COMM_WORLD, &request);
    }
    wait_for(request);
  }
}

std::unique_ptr<solve::CondensedEquations>
MpiCommunicator::condense_together(base::SymmetricCsc& K, std::int64_t externals,
                                   const solve::CondensationSettings& settings,
                                   const solve::CollectiveStep& step) {
  return std::make_unique<MumpsCondensation>(K, externals, settings, step);
}

void MpiCommunicator::join_step(std::int64_t matrix, int job) {
  switch (static_cast<MumpsJob>(job)) {
  case MumpsJob::initialise:
    parts_.emplace(matrix, std::make_unique<MumpsInstance>());
    return;
  case MumpsJob::terminate:
    parts_.erase(matrix);
    return;
  case MumpsJob::factorisation:
  case MumpsJob::analysis:
  case MumpsJob::solution:
    break;
  }
  MumpsInstance& part = *parts_.at(matrix);
  part.take_part(job);
  // What the factors have allocated and keep, and beside them the solution.
  double all = 0.0;
  for (const auto& [number, held] : parts_) {
    all += held->memory_of_factorisation();
  }
  if (static_cast<MumpsJob>(job) == MumpsJob::solution) {
    all += std::max(0.0, part.memory_of_solution() - part.memory_of_factorisation());
  }
  memory_of_steps_ = std::max(memory_of_steps_, all);
}

void MpiCommunicator::abort(int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
}

} // namespace spricka::engines
