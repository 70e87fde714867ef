// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/named_arrays.hpp"
#include "results/results.hpp"
#include "results/store.hpp"

#include <string>
#include <vector>

/// Runs in a store, whole: what is read is what was written, to the bit. manual/results_file.md
/// names the folders and arrays.
namespace spricka::results {

enum class TimeRecording { kept, left_out };

/// One crack length into a folder: mesh, surface, load paths and steps.
void write_crack_length_result(const StoreGroup& given, const CrackLengthResult& increment);
/// Reads back what write_crack_length_result has written. Throws StoreError.
CrackLengthResult read_crack_length_result(const StoreGroup& group);

/// A run: increments/0001, ..., checks, warnings, rounds, growth; with times also the log, CPU
/// time, wall time and memory. Increments whose `fields` are false are written without mesh, nodal
/// and element values; empty: all whole. [increment]
void write_run(const StoreGroup& given, const RunResult& run, TimeRecording times,
               const std::vector<bool>& fields = {});
/// Reads back what write_run has written; times and log stay empty where the file has none. Throws
/// StoreError.
RunResult read_run(const StoreGroup& group);
/// The checks of a run alone.
std::vector<CheckResult> read_checks(const StoreGroup& group);

/// Writes arrays for a restart into the folders reals, integers and texts.
void write_restart_arrays(const StoreGroup& group, const NamedArrays& arrays);
/// Reads back what write_restart_arrays has written. Throws StoreError.
NamedArrays read_restart_arrays(const StoreGroup& group);

/// The tables that people ask for first, of all increments and steps in one piece: k, pressure,
/// load_path.
void write_summary_tables(StoreGroup group, const RunResult& run);

} // namespace spricka::results
