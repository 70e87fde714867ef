// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/communicator.hpp"
#include "solve/factor_report.hpp"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>

#include <dmumps_c.h>

namespace spricka::engines {

/// The steps of MUMPS by the numbers of its manual (JOB).
enum class MumpsJob {
  initialise = -1,
  terminate = -2,
  analysis = 1,
  factorisation = 2,
  solution = 3
};

/// One problem in MUMPS: symmetric positive definite, on one process or, built with MPI, on all
/// ranks together, each of which has its instance; silent, with one thread.
/// Calls of all instances take turns, as the library keeps some of its state for itself.
class MumpsInstance {
public:
  /// `step`, on rank 0 of several, takes every step: it announces it to the others first.
  explicit MumpsInstance(solve::CollectiveStep step = {});
  ~MumpsInstance();
  MumpsInstance(const MumpsInstance&) = delete;
  MumpsInstance& operator=(const MumpsInstance&) = delete;

  /// What the manual calls ICNTL(number), INFOG(number), RINFOG(number).
  [[nodiscard]] int& control(int number) { return data_.icntl[number - 1]; }
  [[nodiscard]] int info(int number) const { return data_.infog[number - 1]; }
  [[nodiscard]] double real_info(int number) const { return data_.rinfog[number - 1]; }
  /// A count that is given in millions where it is negative.
  [[nodiscard]] double count(int number) const {
    const double given = info(number);
    return given < 0.0 ? -1e6 * given : given;
  }
  /// Of each row in the order of its pivots, counted from 1; once it is analysed.
  [[nodiscard]] const int* places() const { return data_.sym_perm; }
  /// What the factorisation has allocated in this process [bytes], by its own count; 0 before it.
  [[nodiscard]] double memory_of_factorisation() const { return 1e6 * data_.info[16 - 1]; }
  /// The same of the last solution, with the factor where that is in memory.
  [[nodiscard]] double memory_of_solution() const { return 1e6 * data_.info[26 - 1]; }
  [[nodiscard]] DMUMPS_STRUC_C& data() { return data_; }

  /// Does it: whether INFOG(1) is no error. A factorisation that finds its estimated workspace too
  /// small is given more, some times.
  bool run(MumpsJob job);
  /// The same of a rank other than 0, where the run has several: what rank 0 has announced.
  void take_part(int job) { call(job); }
  /// The factor goes to files in this folder. False: its name is too long for MUMPS.
  bool set_folder(const std::string& folder);
  /// What the last error comes to; the trouble is for messages.
  struct Failure {
    solve::FactorStatus status;
    std::string trouble;
  };
  [[nodiscard]] Failure failure() const;

private:
  void call(int job);
  solve::CollectiveStep step_;
  std::int64_t number_; ///< among those of the process
  DMUMPS_STRUC_C data_{};
};

} // namespace spricka::engines
