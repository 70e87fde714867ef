// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "solve/communicator.hpp"
#include "solve/condensed_equations.hpp"

#include <cstddef>
#include <cstdint>

/// What a module with an engine defines: a shared object that solve/engine_module.hpp opens. No C++
/// names pass between the two but those of these headers, which both are compiled from
/// (spricka_engine_abi says so).
#define SPRICKA_ENGINE_EXPORT extern "C" __attribute__((visibility("default")))

/// What the module is made of: must return spricka::solve::engine_abi().
SPRICKA_ENGINE_EXPORT const char* spricka_engine_abi();

/// As spricka::solve::condense_equations, of the one engine; the caller owns the result. K is moved
/// from; it is put back, for the next engine, where the status is out_of_memory or engine_failed.
SPRICKA_ENGINE_EXPORT spricka::solve::CondensedEquations*
spricka_condense_equations(spricka::base::SymmetricCsc* K, std::int64_t externals,
                           const spricka::solve::CondensationSettings* settings);

/// As spricka::solve::forecast_equations, of the one engine, written into the report; `rows` may be
/// null. The pattern is moved from and need not be put back.
SPRICKA_ENGINE_EXPORT void
spricka_forecast_equations(spricka::base::SymmetricCsc* pattern, std::int64_t externals,
                           const spricka::solve::CondensationSettings* settings,
                           const spricka::solve::SparseRightHandSides* rows,
                           spricka::solve::FactorReport* report);

/// Joins the ranks that mpirun has started this process among; the caller owns the result. Null:
/// `trouble` [size], ended by 0, says why. Of the module with MPI alone, which has the two
/// functions above as Communicator::condense_together.
SPRICKA_ENGINE_EXPORT spricka::solve::Communicator* spricka_open_communicator(char* trouble,
                                                                              std::size_t size);
