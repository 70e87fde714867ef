// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/library_versions.hpp"

#include <array>

#include <cholmod.h>
#include <fmt/format.h>

// OpenBLAS says here how it was built and which processor it found; it has no header in Debian.
extern "C" char* openblas_get_config(); // NOLINT(readability-identifier-naming)

namespace spricka::solve {

std::vector<std::pair<std::string, std::string>> library_versions() {
  std::array<int, 3> cholmod{};
  cholmod_version(cholmod.data());
  return {{"CHOLMOD", fmt::format("{}", fmt::join(cholmod, "."))},
          {"SuiteSparse", fmt::format("{}.{}.{}", SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION,
                                      SUITESPARSE_SUBSUB_VERSION)},
          {"OpenBLAS", openblas_get_config()}};
}

} // namespace spricka::solve
