// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/mumps/mumps_condensation.hpp"
#include "base/clock.hpp"
#include "base/index.hpp"
#include "base/memory.hpp"
#include "solve/factor_checks.hpp"
#include "solve/ordering.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <limits>
#include <new>
#include <numeric>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::engines {

using base::at;
using base::index;

namespace {

constexpr double number = 8.0; // bytes
constexpr double million = 1e6;
// A solution whose residual is larger than this part of its terms takes a step of refinement: what
// a stable elimination leaves is a few eps for each of the some hundred entries of a row.
constexpr double refined_from = 1024.0 * std::numeric_limits<double>::epsilon();
// [bytes] of right-hand sides that are solved at a time: out of core every block reads the factor.
constexpr double block_bytes = 256e6;

// Numbers of the manual of MUMPS 5.5: what ICNTL(26) asks of a solution.
constexpr int eliminate_locals = 1;
constexpr int expand_externals = 2;

} // namespace

MumpsCondensation::MumpsCondensation(base::SymmetricCsc& K, std::int64_t externals,
                                     const solve::CondensationSettings& settings)
    : externals_(externals) {
  report_.engine = solve::EquationEngine::mumps;
  report_.engine_reason = settings.engine_reason;
  report_.besides = settings.besides;
  n_ = K.n;
  try {
    if (locals() == 0) {
      keep_external_stiffness(K);
      return;
    }
    analyse(K, settings);
    if (report_.status == solve::FactorStatus::ok && report_.out_of_core &&
        !find_room_on_disk(settings)) {
      report_.status = solve::FactorStatus::engine_failed;
    }
    if (report_.status == solve::FactorStatus::ok) {
      const double begun = solve::thread_cpu_seconds();
      factorise();
      report_.numeric_cpu = solve::thread_cpu_seconds() - begun;
    }
  } catch (const std::bad_alloc&) {
    report_.status = solve::FactorStatus::out_of_memory;
  }
  if (report_.status != solve::FactorStatus::ok) {
    mumps_.reset();
    S_ = base::Matrix();
    if (K_) {
      K = K_->give_back();
      K_.reset();
    }
  }
}

solve::FactorReport MumpsCondensation::forecast(base::SymmetricCsc& pattern, std::int64_t externals,
                                                const solve::CondensationSettings& settings,
                                                const solve::SparseRightHandSides* rows) {
  MumpsCondensation plan(externals);
  plan.report_.engine = solve::EquationEngine::mumps;
  plan.report_.besides = settings.besides;
  plan.n_ = pattern.n;
  try {
    if (plan.locals() > 0) {
      plan.analyse(pattern, settings);
    }
    if (rows != nullptr) {
      const auto count = static_cast<double>(rows->count());
      plan.report_.row_flops = 4.0 * plan.report_.factor_entries * count;
      plan.report_.row_memory = 2.0 * number * static_cast<double>(plan.n_) *
                                static_cast<double>(plan.block_width(rows->count()));
    }
  } catch (const std::bad_alloc&) {
    plan.report_.status = solve::FactorStatus::out_of_memory;
  }
  return plan.report_;
}

// Nothing is eliminated: S is K.
void MumpsCondensation::keep_external_stiffness(const base::SymmetricCsc& K) {
  S_ = base::Matrix::Zero(n_, n_);
  for (std::int64_t j = 0; j < n_; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      S_(K.row[at(p)], j) = K.value[at(p)];
      S_(j, K.row[at(p)]) = K.value[at(p)];
    }
  }
}

void MumpsCondensation::analyse(base::SymmetricCsc& K,
                                const solve::CondensationSettings& settings) {
  const double begun = solve::thread_cpu_seconds();
  // MUMPS without MPI has no order of the quality of ours (2.3 times the flops of METIS).
  order_.resize(at(n_));
  {
    const std::vector<std::int64_t> rows = solve::elimination_order(K, locals(), settings.ordering);
    for (std::size_t place = 0; place < rows.size(); ++place) {
      order_[at(rows[place])] = static_cast<int>(place + 1);
    }
  }
  K_.emplace(K, locals());
  DMUMPS_STRUC_C& problem = mumps_.emplace().data();
  problem.n = static_cast<MUMPS_INT>(n_);
  problem.nnz = K_->entries();
  problem.irn = K_->rows().data();
  problem.jcn = K_->columns().data();
  problem.a = K_->values().data();
  problem.perm_in = order_.data();
  mumps_->control(7) = 1; // the order that is given
  if (externals_ > 0) {
    external_rows_.resize(at(externals_));
    std::iota(external_rows_.begin(), external_rows_.end(), static_cast<int>(locals() + 1));
    mumps_->control(19) = 1; // a Schur complement, of which one triangle is filled
    problem.size_schur = static_cast<MUMPS_INT>(externals_);
    problem.listvar_schur = external_rows_.data();
  }
  const bool done = mumps_->run(MumpsJob::analysis);
  report_.analysis_cpu = solve::thread_cpu_seconds() - begun;
  if (!done) {
    fail(mumps_->failure());
    return;
  }
  report_.flops = mumps_->real_info(1);
  report_.factor_entries = mumps_->count(20);
  choose_where_the_factor_goes(settings);
}

void MumpsCondensation::choose_where_the_factor_goes(const solve::CondensationSettings& settings) {
  const auto n = static_cast<double>(n_);
  const auto e = static_cast<double>(externals_);
  // The triplets and the order, S, and what MUMPS wants.
  const double own = 16.0 * static_cast<double>(K_->entries()) + 24.0 * n + number * e * e;
  const double in_core = own + million * mumps_->info(16);
  const double on_disk = own + million * mumps_->info(26);
  report_.memory_left = static_cast<double>(base::process_memory_limit()) -
                        static_cast<double>(base::resident_memory());
  report_.out_of_core = settings.out_of_core || in_core + report_.besides > report_.memory_left;
  report_.memory = report_.out_of_core ? on_disk : in_core;
  report_.kept_memory = 12.0 * static_cast<double>(K_->entries()) + 40.0 * n +
                        (report_.out_of_core ? 0.0 : number * report_.factor_entries);
  report_.disk = report_.out_of_core ? number * report_.factor_entries : 0.0;
  mumps_->control(22) = report_.out_of_core ? 1 : 0;
  if (report_.memory + report_.besides > report_.memory_left) {
    report_.status = solve::FactorStatus::out_of_memory;
  }
}

bool MumpsCondensation::find_room_on_disk(const solve::CondensationSettings& settings) {
  if (settings.scratch_folder.empty()) {
    report_.trouble = "there is no folder for temporary files that can be written to (TMPDIR)";
    return false;
  }
  if (!mumps_->set_folder(settings.scratch_folder)) {
    report_.trouble = fmt::format("the name of the folder {} is too long for MUMPS: set TMPDIR",
                                  settings.scratch_folder);
    return false;
  }
  std::error_code unknown;
  const std::filesystem::space_info space =
      std::filesystem::space(settings.scratch_folder, unknown);
  if (!unknown && static_cast<double>(space.available) < report_.disk) {
    report_.trouble = fmt::format(
        "its factor needs {:.0f} MB of disk in {}, {:.0f} MB are free: set TMPDIR to "
        "a folder with more room",
        1e-6 * report_.disk, settings.scratch_folder, 1e-6 * static_cast<double>(space.available));
    return false;
  }
  return true;
}

void MumpsCondensation::factorise() {
  S_.resize(externals_, externals_);
  mumps_->data().schur = S_.data();
  if (!mumps_->run(MumpsJob::factorisation)) {
    fail(mumps_->failure());
    return;
  }
  check_pivots();
  if (report_.status != solve::FactorStatus::ok) {
    return;
  }
  // Rows of the lower triangle are columns of the upper one here; the other is not written.
  S_.triangularView<Eigen::StrictlyLower>() = S_.transpose();
  K_->drop_columns();
  mumps_->data().jcn = nullptr;
  order_ = {};
  mumps_->data().perm_in = nullptr;
  estimate_error();
}

void MumpsCondensation::fail(MumpsInstance::Failure failure) {
  report_.status = failure.status;
  report_.trouble = std::move(failure.trouble);
  if (report_.status == solve::FactorStatus::engine_failed && report_.out_of_core) {
    report_.trouble += fmt::format(" (its factor takes {:.0f} MB of disk): set TMPDIR to a folder "
                                   "with more room",
                                   1e-6 * report_.disk);
  }
}

// (solve.7): the matrix is scaled to diagonals between 1/2 and 2, so that a pivot is a ratio.
void MumpsCondensation::check_pivots() {
  report_.smallest_pivot = std::min(1.0, mumps_->real_info(19));
  const bool negative = mumps_->info(12) != 0;
  // Written so that a pivot that is not a number is refused.
  if (negative || !(mumps_->real_info(19) > solve::smallest_allowed_pivot(n_))) {
    report_.status = solve::FactorStatus::not_positive_definite;
    report_.failed_row = loosest_row();
  }
}

// What hardly any force holds moves most under any load.
std::int64_t MumpsCondensation::loosest_row() const {
  base::Matrix X(n_, 1);
  for (std::int64_t i = 0; i < n_; ++i) {
    X(i, 0) = i < locals() ? 1.0 + 0.37 * static_cast<double>(i % 11) : 0.0;
  }
  const std::scoped_lock lock(in_use_);
  eliminate(X);
  back_substitute(base::Matrix::Zero(externals_, 1), X);
  std::int64_t row = 0;
  for (std::int64_t i = 0; i < locals(); ++i) {
    if (!(std::abs(X(i, 0)) <= std::abs(X(row, 0)))) {
      row = i;
    }
  }
  return row;
}

// The error of displacements that are known: what the factor makes of the forces that hold them.
void MumpsCondensation::estimate_error() {
  base::Matrix given(n_, 1);
  for (std::int64_t i = 0; i < n_; ++i) {
    given(i, 0) = i < locals() ? 1.0 + 0.25 * static_cast<double>(i % 7) : 0.0;
  }
  base::Matrix X = -K_->residual_of(given, base::Matrix::Zero(n_, 1)).value;
  const std::scoped_lock lock(in_use_);
  eliminate(X);
  back_substitute(base::Matrix::Zero(externals_, 1), X);
  report_.relative_error = (X - given).topRows(locals()).norm() / given.norm();
}

base::Matrix MumpsCondensation::take_schur() {
  return std::exchange(S_, base::Matrix());
}

std::int64_t MumpsCondensation::block_width(std::int64_t columns) const {
  const double fit =
      block_bytes / (2.0 * number * static_cast<double>(std::max<std::int64_t>(n_, 1)));
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(fit), 8,
                                  std::max<std::int64_t>(columns, 8));
}

void MumpsCondensation::run_solution() const {
  if (mumps_->run(MumpsJob::solution)) {
    return;
  }
  const MumpsInstance::Failure failure = mumps_->failure();
  if (failure.status == solve::FactorStatus::out_of_memory) {
    throw std::bad_alloc();
  }
  throw std::system_error(std::make_error_code(std::errc::io_error), failure.trouble);
}

// What right-hand sides and solutions have in common.
void MumpsCondensation::ask(int what, base::Matrix& X, base::Matrix& external) const {
  DMUMPS_STRUC_C& problem = mumps_->data();
  problem.rhs = X.data();
  problem.nrhs = static_cast<MUMPS_INT>(X.cols());
  problem.lrhs = static_cast<MUMPS_INT>(n_);
  problem.redrhs = external.data();
  problem.lredrhs = static_cast<MUMPS_INT>(externals_);
  mumps_->control(26) = externals_ > 0 ? what : 0;
  mumps_->control(27) = static_cast<int>(X.cols()); // all of them in one pass over the factor
  run_solution();
}

base::Matrix MumpsCondensation::eliminate(base::Matrix& X) const {
  base::Matrix left(externals_, X.cols());
  mumps_->control(20) = 0; // dense
  ask(eliminate_locals, X, left);
  return left;
}

void MumpsCondensation::back_substitute(const base::Matrix& u_external, base::Matrix& X) const {
  if (externals_ == 0) {
    return; // without externals the elimination has solved it
  }
  base::Matrix given = u_external; // MUMPS does not promise to leave it
  mumps_->control(20) = 0;
  ask(expand_externals, X, given);
  X.bottomRows(externals_) = u_external;
}

base::Matrix MumpsCondensation::condense_load(const base::Matrix& f) const {
  assert(f.rows() == n_ && report_.status == solve::FactorStatus::ok);
  if (externals_ == 0 || locals() == 0) {
    return f.bottomRows(externals_);
  }
  base::Matrix X = f;
  K_->apply_scale(X);
  const std::scoped_lock lock(in_use_);
  return eliminate(X);
}

base::Matrix MumpsCondensation::solve(const base::Matrix& f,
                                      const solve::ExternalDisplacementSolver& displacement) const {
  assert(f.rows() == n_ && report_.status == solve::FactorStatus::ok);
  if (locals() == 0) {
    return n_ == 0 ? f : displacement(f);
  }
  base::Matrix load = f;
  K_->apply_scale(load);
  base::Matrix u = load;
  const std::scoped_lock lock(in_use_);
  const base::Matrix left = eliminate(u);
  back_substitute(externals_ > 0 ? displacement(left) : left, u);
  MumpsMatrix::Residual rest = K_->residual_of(u, load);
  if (rest.backward_error > refined_from) {
    eliminate(rest.value);
    back_substitute(base::Matrix::Zero(externals_, f.cols()), rest.value);
    u += rest.value;
  }
  K_->apply_scale(u);
  return u;
}

solve::RowCompliance
MumpsCondensation::compliance_with_externals_held(solve::SparseRightHandSides F) const {
  assert(report_.status == solve::FactorStatus::ok);
  const std::int64_t count = F.count();
  for (std::size_t p = 0; p < F.row.size(); ++p) {
    F.value[p] *= locals() > 0 ? K_->scale(F.row[p]) : 1.0;
  }
  solve::RowCompliance out;
  out.W = base::Matrix::Zero(count, count);
  out.condensed = base::Matrix::Zero(externals_, count);
  out.flops = 4.0 * report_.factor_entries * static_cast<double>(count);
  const std::int64_t width = block_width(count);
  for (std::int64_t first = 0; first < count; first += width) {
    const std::int64_t k = std::min(width, count - first);
    base::Matrix X = base::Matrix::Zero(n_, k);
    for (std::int64_t c = 0; c < k; ++c) {
      for (std::int64_t p = F.start[at(first + c)]; p < F.start[at(first + c + 1)]; ++p) {
        X(F.row[at(p)], c) += F.value[at(p)];
      }
    }
    if (locals() == 0) {
      out.condensed.middleCols(first, k) = X;
      continue;
    }
    {
      const std::scoped_lock lock(in_use_);
      out.condensed.middleCols(first, k) = eliminate(X);
      back_substitute(base::Matrix::Zero(externals_, k), X); // no external moves
    }
    for (std::int64_t row = first; row < count; ++row) {
      for (std::int64_t p = F.start[at(row)]; p < F.start[at(row + 1)]; ++p) {
        if (F.row[at(p)] < locals()) {
          out.W.block(row, first, 1, k) += F.value[at(p)] * X.row(F.row[at(p)]);
        }
      }
    }
  }
  // Of each pair of rows only the one below the diagonal, or within its block, was made.
  out.W.triangularView<Eigen::StrictlyUpper>() = out.W.transpose();
  return out;
}

} // namespace spricka::engines
