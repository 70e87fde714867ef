// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/version.hpp"
#include "results/store.hpp"
#include "solve/library_versions.hpp"

#include <CLI/Version.hpp>
#include <Eigen/src/Core/util/Macros.h>
#include <boost/version.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <xxhash.h>
#include <zlib.h>

namespace spricka::archive {

std::string version_text() {
  std::vector<std::pair<std::string, std::string>> libraries = solve::library_versions();
  libraries.emplace_back("gmsh", SPRICKA_GMSH_VERSION);
  libraries.emplace_back("HDF5", results::store_library_version());
  libraries.emplace_back("Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                              EIGEN_MINOR_VERSION));
  libraries.emplace_back("Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000,
                                              BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100));
  libraries.emplace_back("fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000,
                                            FMT_VERSION / 100 % 100, FMT_VERSION % 100));
  libraries.emplace_back("CLI11", CLI11_VERSION);
  libraries.emplace_back("nlohmann-json",
                         fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                     NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH));
  libraries.emplace_back("zlib", zlibVersion());
  const unsigned hash = XXH_versionNumber();
  libraries.emplace_back("xxHash",
                         fmt::format("{}.{}.{}", hash / 10000, hash / 100 % 100, hash % 100));
  std::string out = fmt::format("spricka {}\n", SPRICKA_VERSION);
  for (const auto& [name, version] : libraries) {
    out += fmt::format("  {:<14} {}\n", name, version);
  }
  out.pop_back();
  return out;
}

} // namespace spricka::archive
