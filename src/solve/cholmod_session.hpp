// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cholmod.h>
#include <cstdint>
#include <omp.h>
#include <type_traits>

namespace spricka::solve {

static_assert(std::is_same_v<SuiteSparse_long, std::int64_t>);

/// CHOLMOD's workspace, freed with its owner. While it lives, OpenMP regions of the calling thread
/// run serially: the CHOLMOD of Debian would start four threads inside each net otherwise.
class CholmodSession {
public:
  CholmodSession() {
    omp_set_max_active_levels(0);
    cholmod_l_start(&common_);
    common_.print = 0;
    common_.try_catch = 1; // outcomes are read from status
    common_.useGPU = 0;
  }
  ~CholmodSession() {
    cholmod_l_finish(&common_);
    omp_set_max_active_levels(levels_);
  }
  CholmodSession(const CholmodSession&) = delete;
  CholmodSession& operator=(const CholmodSession&) = delete;

  [[nodiscard]] cholmod_common* get() { return &common_; }
  cholmod_common* operator->() { return &common_; }

private:
  int levels_ = omp_get_max_active_levels();
  cholmod_common common_{};
};

/// A symmetric matrix (lower triangle, sorted columns) as CHOLMOD sees it; nothing is copied.
/// Without values it is a pattern.
inline cholmod_sparse cholmod_lower_view(std::int64_t n, const std::int64_t* start,
                                         const std::int64_t* row, const double* value) {
  cholmod_sparse A{};
  A.nrow = static_cast<std::size_t>(n);
  A.ncol = static_cast<std::size_t>(n);
  A.nzmax = static_cast<std::size_t>(start[n]);
  A.p = const_cast<std::int64_t*>(start); // NOLINT: CHOLMOD's type is not const, its use is
  A.i = const_cast<std::int64_t*>(row);   // NOLINT
  A.x = const_cast<double*>(value);       // NOLINT
  A.stype = -1;
  A.itype = CHOLMOD_LONG;
  A.xtype = value == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
  A.dtype = CHOLMOD_DOUBLE;
  A.sorted = 1;
  A.packed = 1;
  return A;
}

} // namespace spricka::solve
