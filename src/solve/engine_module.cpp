// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/engine_module.hpp"
#include "base/shipped_files.hpp"
#include "solve/engine_exports.hpp"
#include "solve/source_digest.hpp"
#include "solve/unsolved_equations.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <utility>

#include <dlfcn.h>
#include <fmt/format.h>

namespace spricka::solve {

namespace {

struct EngineModuleFile {
  const char* file;     ///< in libexec/spricka
  const char* library;  ///< as messages call it
  const char* packages; ///< of Debian, with which it is built
};

constexpr std::array<EngineModuleFile, 3> module_files{
    EngineModuleFile{"spricka-mumps.so", "MUMPS", "libmumps-seq-dev"},
    EngineModuleFile{"spricka-mumps-mpi.so", "MUMPS over MPI", "libmumps-dev and libopenmpi-dev"},
    EngineModuleFile{"spricka-multigrid.so", "the multigrid of PETSc", "libpetsc-real-dev"},
};

/// One module: opened at most once, and never closed, as what it has handed out may outlive any
/// asker.
struct EngineModuleSlot {
  bool asked = false;
  std::string trouble;
  decltype(&spricka_condense_equations) condense = nullptr;
  decltype(&spricka_forecast_equations) forecast = nullptr;
  decltype(&spricka_open_communicator) communicate = nullptr;
};

struct EngineModuleTable {
  std::mutex mutex;
  std::array<EngineModuleSlot, module_files.size()> slots;
  /// That one of the two builds of MUMPS which is in the process.
  std::optional<EngineModule> mumps_build;
};

EngineModuleTable& module_table() {
  static EngineModuleTable table;
  return table;
}

bool has_mumps_names(EngineModule module) {
  return module == EngineModule::mumps || module == EngineModule::mumps_over_mpi;
}

template <class Function> bool find_function(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name)); // NOLINT: as POSIX has it
  return function != nullptr;
}

std::filesystem::path path_of(EngineModule module) {
  return base::find_shipped_file(std::filesystem::path("libexec/spricka") /
                                 module_files[static_cast<std::size_t>(module)].file);
}

std::string open_module(EngineModule module, EngineModuleSlot& slot) {
  const EngineModuleFile& about = module_files[static_cast<std::size_t>(module)];
  const std::filesystem::path path = path_of(module);
  if (path.empty()) {
    return fmt::format("this spricka was built without {} (there is no libexec/spricka/{}): "
                       "install {} and build it again",
                       about.library, about.file, about.packages);
  }
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return fmt::format("{} cannot be loaded: {}", about.library, dlerror());
  }
  decltype(&spricka_engine_abi) abi = nullptr;
  if (!find_function(library, "spricka_engine_abi", abi) || std::string(abi()) != engine_abi()) {
    return fmt::format("{} is of another spricka ({}, not {}): build or install both together",
                       path.string(), abi == nullptr ? "unknown" : abi(), engine_abi());
  }
  // What works over several ranks is asked through the communicator.
  const bool complete =
      module == EngineModule::mumps_over_mpi
          ? find_function(library, "spricka_open_communicator", slot.communicate)
          : find_function(library, "spricka_condense_equations", slot.condense) &&
                find_function(library, "spricka_forecast_equations", slot.forecast);
  if (!complete) {
    return fmt::format("{} is no engine of spricka", path.string());
  }
  return {};
}

/// The module, open; its trouble says why it is not.
const EngineModuleSlot& open_engine_module(EngineModule module) {
  EngineModuleTable& table = module_table();
  const std::scoped_lock lock(table.mutex);
  EngineModuleSlot& slot = table.slots[static_cast<std::size_t>(module)];
  if (slot.asked) {
    return slot;
  }
  // Both builds export the same names, and calls of one would end in the other.
  if (has_mumps_names(module) && table.mumps_build && *table.mumps_build != module) {
    slot.trouble = fmt::format("{} and {} cannot work in one process",
                               module_files[static_cast<std::size_t>(module)].library,
                               module_files[static_cast<std::size_t>(*table.mumps_build)].library);
    slot.asked = true;
    return slot;
  }
  slot.trouble = open_module(module, slot);
  slot.asked = true;
  if (slot.trouble.empty() && has_mumps_names(module)) {
    table.mumps_build = module;
  }
  return slot;
}

EquationEngine engine_of(EngineModule module) {
  return module == EngineModule::multigrid ? EquationEngine::multigrid : EquationEngine::mumps;
}

FactorReport report_of_missing_module(EngineModule module, std::string trouble) {
  FactorReport report;
  report.status = FactorStatus::engine_failed;
  report.engine = engine_of(module);
  report.trouble = std::move(trouble);
  report.engine_reason = report.trouble;
  return report;
}

} // namespace

const char* engine_abi() {
  static const std::string abi = fmt::format("{} {}", SPRICKA_VERSION, source_digest());
  return abi.c_str();
}

std::string why_engine_module_is_missing(EngineModule module) {
  return open_engine_module(module).trouble;
}

bool is_engine_module_installed(EngineModule module) {
  {
    EngineModuleTable& table = module_table();
    const std::scoped_lock lock(table.mutex);
    const EngineModuleSlot& slot = table.slots[static_cast<std::size_t>(module)];
    if (slot.asked) {
      return slot.trouble.empty();
    }
  }
  return !path_of(module).empty();
}

std::unique_ptr<CondensedEquations> condense_by_module(EngineModule module, base::SymmetricCsc& K,
                                                       std::int64_t externals,
                                                       const CondensationSettings& settings) {
  const EngineModuleSlot& opened = open_engine_module(module);
  if (!opened.trouble.empty()) {
    return std::make_unique<UnsolvedEquations>(report_of_missing_module(module, opened.trouble));
  }
  return std::unique_ptr<CondensedEquations>(opened.condense(&K, externals, &settings));
}

FactorReport forecast_by_module(EngineModule module, base::SymmetricCsc& pattern,
                                std::int64_t externals, const CondensationSettings& settings,
                                const SparseRightHandSides* rows) {
  const EngineModuleSlot& opened = open_engine_module(module);
  if (!opened.trouble.empty()) {
    return report_of_missing_module(module, opened.trouble);
  }
  FactorReport report;
  opened.forecast(&pattern, externals, &settings, rows, &report);
  return report;
}

CommunicatorOrTrouble open_communicator() {
  const EngineModuleSlot& opened = open_engine_module(EngineModule::mumps_over_mpi);
  CommunicatorOrTrouble out;
  out.trouble = opened.trouble;
  if (out.trouble.empty()) {
    std::array<char, 200> reason{};
    out.communicator.reset(opened.communicate(reason.data(), reason.size()));
    out.trouble = reason.data();
  }
  return out;
}

} // namespace spricka::solve
