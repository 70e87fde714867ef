// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "solve/communicator.hpp"
#include "solve/condensed_equations.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace spricka::solve {

/// Engines that the program is not linked with: each a shared object in libexec/spricka, opened
/// when it is first asked for, so that a run without them loads none of their libraries.
enum class EngineModule { mumps, mumps_over_mpi, multigrid };

/// Version and sources of the program: a module must be made of the same.
const char* engine_abi();

/// Whether a module can be used; empty: it can, and is open from now on. Else why not, and what
/// helps: it is not there, is made of other sources, or would bring names into the process that
/// another build of the same library has brought already.
std::string why_engine_module_is_missing(EngineModule module);

/// Whether a module is there. Until it is opened it is looked at from outside, as opening it takes
/// address space; the library that it needs may be missing.
bool is_engine_module_installed(EngineModule module);

/// As condense_equations, by a module. The status is engine_failed, with the trouble, where it
/// cannot be used. K is given up; it is as it was only where the status is out_of_memory or
/// engine_failed, and then not always: see its size.
std::unique_ptr<CondensedEquations> condense_by_module(EngineModule module, base::SymmetricCsc& K,
                                                       std::int64_t externals,
                                                       const CondensationSettings& settings);

/// As forecast_equations, by a module, likewise.
FactorReport forecast_by_module(EngineModule module, base::SymmetricCsc& pattern,
                                std::int64_t externals, const CondensationSettings& settings,
                                const SparseRightHandSides* rows);

/// The ranks that mpirun has started this process among, or why they cannot be had.
struct CommunicatorOrTrouble {
  std::unique_ptr<Communicator> communicator;
  std::string trouble;
};
/// Joins them; once, before the process starts threads.
CommunicatorOrTrouble open_communicator();

} // namespace spricka::solve
