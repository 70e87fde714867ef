// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "engines/mumps/mumps_instance.hpp"
#include "solve/communicator.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include <mpi.h>

namespace spricka::engines {

/// The ranks of MPI_COMM_WORLD. One call of MPI at a time, whichever thread makes it, and none that
/// waits within MPI: a rank without work leaves its core to the others.
class MpiCommunicator final : public solve::Communicator {
public:
  /// Initialises MPI, which can be done once in a process.
  MpiCommunicator();
  ~MpiCommunicator() override;
  MpiCommunicator(const MpiCommunicator&) = delete;
  MpiCommunicator& operator=(const MpiCommunicator&) = delete;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  [[nodiscard]] int ranks_on_machine() const override { return ranks_on_machine_; }
  [[nodiscard]] std::string machine_name() const override { return machine_name_; }
  void send(int to, const void* data, std::size_t bytes) override;
  void receive(int from, void* data, std::size_t bytes) override;
  [[nodiscard]] std::unique_ptr<solve::CondensedEquations>
  condense_together(base::SymmetricCsc& K, std::int64_t externals,
                    const solve::CondensationSettings& settings,
                    const solve::CollectiveStep& step) override;
  void join_step(std::int64_t matrix, int job) override;
  [[nodiscard]] double memory_of_steps() const override { return memory_of_steps_; }
  void abort(int exit_code) override;

private:
  void wait_for(MPI_Request& request);

  int rank_ = 0;
  int size_ = 1;
  int ranks_on_machine_ = 1;
  std::string machine_name_;
  std::map<std::int64_t, std::unique_ptr<MumpsInstance>> parts_; ///< of rank 0's matrices
  double memory_of_steps_ = 0.0;
  std::mutex calls_; ///< MPI is asked by one thread at a time
};

} // namespace spricka::engines
