// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/mumps/mumps_condensation.hpp"
#include "base/index.hpp"
#include "base/memory.hpp"
#include "solve/factor_checks.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::engines {

using base::at;

namespace {

constexpr double number = 8.0; // bytes
constexpr double million = 1e6;
// A solution whose residual is larger than this part of its terms takes a step of refinement: what
// a stable elimination leaves is a few eps for each of the some hundred entries of a row.
constexpr double refined_from = 1024.0 * std::numeric_limits<double>::epsilon();

} // namespace

MumpsCondensation::MumpsCondensation(base::SymmetricCsc& K, std::int64_t externals,
                                     const solve::CondensationSettings& settings,
                                     solve::CollectiveStep step)
    : externals_(externals), step_(std::move(step)) {
  report_.engine = solve::EquationEngine::mumps;
  report_.engine_reason = settings.engine_reason;
  report_.besides = settings.besides;
  n_ = K.n;
  try {
    if (local_count() == 0) {
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
    S_ = base::Matrix();
    if (locals_) {
      K = locals_->give_back_matrix();
      locals_.reset();
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
    if (plan.local_count() > 0) {
      plan.analyse(pattern, settings);
    }
    if (rows != nullptr) {
      plan.report_.row_flops = plan.solution_flops(rows->count());
      const std::int64_t width = plan.locals_ ? plan.locals_->block_width(rows->count()) : 0;
      plan.report_.row_memory = 2.0 * number * static_cast<double>(plan.n_ * width);
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
  report_.memory_left = base::available_memory(); // before any of what is counted below is there
  const bool done = locals_.emplace(K, externals_, settings.ordering, step_).analyse();
  report_.analysis_cpu = solve::thread_cpu_seconds() - begun;
  if (!done) {
    fail(locals_->mumps().failure());
    return;
  }
  report_.flops = locals_->mumps().real_info(1);
  report_.factor_entries = locals_->mumps().count(20);
  choose_where_the_factor_goes(settings);
}

void MumpsCondensation::choose_where_the_factor_goes(const solve::CondensationSettings& settings) {
  const auto n = static_cast<double>(n_);
  const auto e = static_cast<double>(externals_);
  // The triplets and the order, S, and what MUMPS wants.
  const double own =
      16.0 * static_cast<double>(locals_->matrix().entries()) + 24.0 * n + number * e * e;
  const double in_core = own + million * locals_->mumps().info(16);
  const double on_disk = own + million * locals_->mumps().info(26);
  report_.out_of_core = settings.out_of_core || in_core + report_.besides > report_.memory_left;
  report_.memory = report_.out_of_core ? on_disk : in_core;
  // In core MUMPS keeps the workspace in which it has made the factor.
  report_.kept_memory = report_.out_of_core
                            ? 16.0 * static_cast<double>(locals_->matrix().entries()) + 40.0 * n
                            : in_core - number * e * e;
  report_.disk = report_.out_of_core ? number * report_.factor_entries : 0.0;
  locals_->put_factor_on_disk(report_.out_of_core);
  if (report_.memory + report_.besides > report_.memory_left) {
    report_.status = solve::FactorStatus::out_of_memory;
  }
}

bool MumpsCondensation::find_room_on_disk(const solve::CondensationSettings& settings) {
  if (settings.scratch_folder.empty()) {
    report_.trouble = "there is no folder for temporary files that can be written to (TMPDIR)";
    return false;
  }
  if (!locals_->set_folder(settings.scratch_folder)) {
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
  if (!locals_->factorise(S_)) {
    fail(locals_->mumps().failure());
    return;
  }
  check_pivots();
  if (report_.status == solve::FactorStatus::ok) {
    report_.relative_error = locals_->error_of_known_displacements();
  }
}

void MumpsCondensation::fail(MumpsInstance::Failure failure) {
  report_.status = failure.status;
  if (report_.status == solve::FactorStatus::not_positive_definite) {
    report_.failed_row = locals_->stopped_at_row();
    report_.smallest_pivot = 0.0;
  }
  report_.trouble = std::move(failure.trouble);
  if (report_.status == solve::FactorStatus::engine_failed && report_.out_of_core) {
    report_.trouble += fmt::format(" (its factor takes {:.0f} MB of disk): set TMPDIR to a folder "
                                   "with more room",
                                   1e-6 * report_.disk);
  }
}

// (solve.7): the matrix is scaled to diagonals between 1/2 and 2, so that a pivot is a ratio.
void MumpsCondensation::check_pivots() {
  report_.smallest_pivot = std::min(1.0, locals_->mumps().real_info(19));
  const bool negative = locals_->mumps().info(12) != 0;
  // Written so that a pivot that is not a number is refused.
  if (negative || !(locals_->mumps().real_info(19) > solve::smallest_allowed_pivot(n_))) {
    report_.status = solve::FactorStatus::not_positive_definite;
    report_.failed_row = locals_->loosest_row();
  }
}

base::Matrix MumpsCondensation::take_schur() {
  return std::exchange(S_, base::Matrix());
}

base::Matrix MumpsCondensation::condense_load(const base::Matrix& f) const {
  assert(f.rows() == n_ && report_.status == solve::FactorStatus::ok);
  if (externals_ == 0 || local_count() == 0) {
    return f.bottomRows(externals_);
  }
  base::Matrix X = f;
  locals_->matrix().apply_scale(X);
  const std::scoped_lock lock(in_use_);
  return locals_->eliminate(X);
}

base::Matrix MumpsCondensation::solve(const base::Matrix& f,
                                      const solve::ExternalDisplacementSolver& displacement) const {
  assert(f.rows() == n_ && report_.status == solve::FactorStatus::ok);
  if (local_count() == 0) {
    return n_ == 0 ? f : displacement(f);
  }
  base::Matrix load = f;
  locals_->matrix().apply_scale(load);
  base::Matrix u = load;
  const std::scoped_lock lock(in_use_);
  const base::Matrix left = locals_->eliminate(u);
  locals_->back_substitute(externals_ > 0 ? displacement(left) : left, u);
  MumpsMatrix::Residual rest = locals_->matrix().residual_of(u, load);
  if (rest.backward_error > refined_from) {
    locals_->eliminate(rest.value);
    locals_->back_substitute(base::Matrix::Zero(externals_, f.cols()), rest.value);
    u += rest.value;
  }
  locals_->matrix().apply_scale(u);
  return u;
}

solve::RowCompliance
MumpsCondensation::compliance_with_externals_held(solve::SparseRightHandSides F) const {
  assert(report_.status == solve::FactorStatus::ok);
  solve::RowCompliance out;
  if (local_count() > 0) {
    const std::scoped_lock lock(in_use_);
    out = locals_->compliance_of_rows(F);
    out.flops = solution_flops(F.count());
    report_.row_memory = number * static_cast<double>(n_ * locals_->block_width(F.count())) +
                         std::max(0.0, locals_->mumps().memory_of_solution() -
                                           locals_->mumps().memory_of_factorisation());
    return out;
  }
  out.W = base::Matrix::Zero(F.count(), F.count());
  out.condensed = base::Matrix::Zero(n_, F.count());
  for (std::int64_t column = 0; column < F.count(); ++column) {
    for (std::int64_t p = F.start[at(column)]; p < F.start[at(column + 1)]; ++p) {
      out.condensed(F.row[at(p)], column) += F.value[at(p)];
    }
  }
  return out;
}

} // namespace spricka::engines
