// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "solve/condensed_equations.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace spricka::solve {

/// One step of a factorisation that all ranks take together: its number, that of the matrix, and
/// what this rank does in it.
using CollectiveStep =
    std::function<void(std::int64_t matrix, int job, const std::function<void()>&)>;

/// Messages between the processes, the ranks, that mpirun has started as one run. Rank 0 runs the
/// program; the others work for it. A rank that is lost ends them all. Any thread may call.
class Communicator {
public:
  Communicator() = default;
  virtual ~Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// Ranks on the machine of this one, itself included.
  [[nodiscard]] virtual int ranks_on_machine() const = 0;
  [[nodiscard]] virtual std::string machine_name() const = 0;
  /// Returns when the bytes may be overwritten; they arrive in the order of sending.
  virtual void send(int to, const void* data, std::size_t bytes) = 0;
  /// Waits, without taking the core, for as many bytes as were sent at once.
  virtual void receive(int from, void* data, std::size_t bytes) = 0;

  /// On rank 0: the equations of a net by MUMPS, all ranks together, as condense_by_module(). Every
  /// step goes through `step`, which announces it to the others.
  [[nodiscard]] virtual std::unique_ptr<CondensedEquations>
  condense_together(base::SymmetricCsc& K, std::int64_t externals,
                    const CondensationSettings& settings, const CollectiveStep& step) = 0;
  /// On the others: takes part in a step that rank 0 has announced.
  virtual void join_step(std::int64_t matrix, int job) = 0;
  /// On the others: the memory [bytes] that their parts of the factors were to take, the most at a
  /// time, as analysed.
  [[nodiscard]] virtual double memory_of_steps() const = 0;

  /// Ends all ranks at once with this exit code.
  virtual void abort(int exit_code) = 0;
};

} // namespace spricka::solve
