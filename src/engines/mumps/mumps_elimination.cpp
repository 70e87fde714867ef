// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/mumps/mumps_elimination.hpp"
#include "base/index.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <system_error>
#include <utility>

namespace spricka::engines {

using base::at;

namespace {

// Numbers of the manual of MUMPS 5.5: what ICNTL(26) asks of a solution.
constexpr int eliminate_locals = 1;
constexpr int expand_externals = 2;

// Place of each row in our order, counted from 1. MUMPS without MPI has none as good: its own takes
// 2.3 times the flops of METIS.
std::vector<int> places_in_order(const base::SymmetricCsc& K, std::int64_t locals,
                                 solve::OrderingMethod ordering) {
  const std::vector<std::int64_t> rows = solve::elimination_order(K, locals, ordering);
  std::vector<int> places(rows.size());
  for (std::size_t place = 0; place < rows.size(); ++place) {
    places[at(rows[place])] = static_cast<int>(place + 1);
  }
  return places;
}

// [bytes] of right-hand sides that are solved at a time: out of core every block reads the factor.
constexpr double block_bytes = 256e6;

} // namespace

MumpsElimination::MumpsElimination(base::SymmetricCsc& K, std::int64_t externals,
                                   solve::OrderingMethod ordering, solve::CollectiveStep step)
    : externals_(externals), order_(places_in_order(K, K.n - externals, ordering)),
      external_rows_(at(externals)), K_(K, K.n - externals), mumps_(std::move(step)) {
  DMUMPS_STRUC_C& problem = mumps_.data();
  problem.n = static_cast<MUMPS_INT>(size());
  problem.nnz = K_.entries();
  problem.irn = K_.rows().data();
  problem.jcn = K_.columns().data();
  problem.a = K_.values().data();
  problem.perm_in = order_.data();
  mumps_.control(7) = 1; // the order that is given
  if (externals > 0) {
    std::iota(external_rows_.begin(), external_rows_.end(), static_cast<int>(locals() + 1));
    mumps_.control(19) = 1; // a Schur complement, of which one triangle is filled
    problem.size_schur = static_cast<MUMPS_INT>(externals);
    problem.listvar_schur = external_rows_.data();
  }
}

bool MumpsElimination::factorise(base::Matrix& S) {
  S.resize(externals_, externals_);
  mumps_.data().schur = S.data();
  if (!mumps_.run(MumpsJob::factorisation)) {
    return false;
  }
  // Rows of the lower triangle are columns of the upper one here; the other is not written.
  S.triangularView<Eigen::StrictlyLower>() = S.transpose();
  K_.drop_columns();
  mumps_.data().jcn = nullptr;
  return true;
}

std::int64_t MumpsElimination::stopped_at_row() const {
  // It has stopped behind so many pivots, in the order that it has made of ours.
  const int* const place = mumps_.places();
  const auto row = std::find(place, place + size(), mumps_.info(2) + 1) - place;
  return row < locals() ? row : -1;
}

std::int64_t MumpsElimination::loosest_row() {
  base::Matrix X = base::Matrix::Zero(size(), 1);
  for (std::int64_t i = 0; i < locals(); ++i) {
    X(i, 0) = 1.0 + 0.37 * static_cast<double>(i % 11);
  }
  eliminate(X);
  back_substitute(base::Matrix::Zero(externals_, 1), X);
  std::int64_t row = 0;
  for (std::int64_t i = 0; i < locals(); ++i) {
    // What is not a number counts as the most.
    row = std::abs(X(i, 0)) <= std::abs(X(row, 0)) ? row : i;
  }
  return row;
}

double MumpsElimination::error_of_known_displacements() {
  base::Matrix given = base::Matrix::Zero(size(), 1);
  for (std::int64_t i = 0; i < locals(); ++i) {
    given(i, 0) = 1.0 + 0.25 * static_cast<double>(i % 7);
  }
  base::Matrix X = -K_.residual_of(given, base::Matrix::Zero(size(), 1)).value;
  eliminate(X);
  back_substitute(base::Matrix::Zero(externals_, 1), X);
  return (X - given).topRows(locals()).norm() / given.norm();
}

// What right-hand sides and solutions have in common.
void MumpsElimination::ask(int what, base::Matrix& X, base::Matrix& external) {
  if (X.cols() == 0) {
    return; // MUMPS takes that for a mistake
  }
  DMUMPS_STRUC_C& problem = mumps_.data();
  problem.rhs = X.data();
  problem.nrhs = static_cast<MUMPS_INT>(X.cols());
  problem.lrhs = static_cast<MUMPS_INT>(size());
  problem.redrhs = external.data();
  problem.lredrhs = static_cast<MUMPS_INT>(externals_);
  mumps_.control(26) = externals_ > 0 ? what : 0;
  mumps_.control(27) = static_cast<int>(X.cols()); // all of them in one pass over the factor
  if (mumps_.run(MumpsJob::solution)) {
    return;
  }
  const MumpsInstance::Failure failure = mumps_.failure();
  if (failure.status == solve::FactorStatus::out_of_memory) {
    throw std::bad_alloc();
  }
  throw std::system_error(std::make_error_code(std::errc::io_error), failure.trouble);
}

base::Matrix MumpsElimination::eliminate(base::Matrix& X) {
  base::Matrix left(externals_, X.cols());
  ask(eliminate_locals, X, left);
  return left;
}

void MumpsElimination::back_substitute(const base::Matrix& u_external, base::Matrix& X) {
  if (externals_ == 0) {
    return; // without externals the elimination has solved it
  }
  base::Matrix given = u_external; // MUMPS does not promise to leave it
  ask(expand_externals, X, given);
  X.bottomRows(externals_) = u_external;
}

std::int64_t MumpsElimination::block_width(std::int64_t columns) const {
  constexpr std::int64_t narrowest = 8;
  const double column = 2.0 * sizeof(double) * static_cast<double>(size()); // ours and MUMPS'
  return std::clamp(static_cast<std::int64_t>(block_bytes / column), narrowest,
                    std::max(columns, narrowest));
}

// Sparse right-hand sides, which MUMPS would take, were measured to gain nothing.
solve::RowCompliance MumpsElimination::compliance_of_rows(const solve::SparseRightHandSides& F) {
  const std::int64_t count = F.count();
  solve::RowCompliance out;
  out.W = base::Matrix::Zero(count, count);
  out.condensed = base::Matrix::Zero(externals_, count);
  const std::int64_t width = block_width(count);
  for (std::int64_t first = 0; first < count; first += width) {
    const std::int64_t k = std::min(width, count - first);
    base::Matrix X = base::Matrix::Zero(size(), k);
    for (std::int64_t c = 0; c < k; ++c) {
      for (std::int64_t p = F.start[at(first + c)]; p < F.start[at(first + c + 1)]; ++p) {
        X(F.row[at(p)], c) += F.value[at(p)] * K_.scale(F.row[at(p)]);
      }
    }
    out.condensed.middleCols(first, k) = eliminate(X);
    back_substitute(base::Matrix::Zero(externals_, k), X); // no external moves
    for (std::int64_t row = first; row < count; ++row) {
      for (std::int64_t p = F.start[at(row)]; p < F.start[at(row + 1)]; ++p) {
        const std::int64_t place = F.row[at(p)];
        if (place < locals()) {
          out.W.block(row, first, 1, k) += F.value[at(p)] * K_.scale(place) * X.row(place);
        }
      }
    }
  }
  // Of each pair of rows only the one below the diagonal, or within its block, was made.
  out.W.triangularView<Eigen::StrictlyUpper>() = out.W.transpose();
  return out;
}

} // namespace spricka::engines
