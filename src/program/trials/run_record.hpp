// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/trials/child_run.hpp"

#include <filesystem>
#include <optional>
#include <string>

/// How runs that the tasks of a job array share have ended, kept beside their run folders: what
/// they cost, and why one has no results.
namespace spricka::program {

/// The folder of the record of a run: lug.end beside its run folder lug.
std::filesystem::path record_folder(const std::filesystem::path& run_folder);

/// Keeps how a run has ended. Throws std::system_error or archive::FileFailure.
void write_run_record(const std::filesystem::path& run_folder, const ChildProcessResult& end,
                      const std::string& digest);

/// How it has ended; empty where there is no record, none that is whole, or one of another digest.
std::optional<ChildProcessResult> read_run_record(const std::filesystem::path& run_folder,
                                                  const std::string& digest);

/// Whether a run that has ended so has results: its checks may have failed.
bool ended_with_results(const ChildProcessResult& end);

/// Whether it has ended so because of its deck, or its time limit: not because somebody stopped it
/// or another process was at it.
bool ended_by_itself(const ChildProcessResult& end);

} // namespace spricka::program
