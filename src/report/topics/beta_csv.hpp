// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <filesystem>

namespace spricka::report {

/// beta.csv: K1, K2 and K1/sqrt(pi a) of every length, tip and step, and of every breakpoint of the
/// load paths, with the factors of load cases and fits that belong to them. In space the tips are
/// the ends of the two axes of a crack, each with K over the root of its own size. Columns in
/// manual/run_folder.md.
void write_beta_csv(const std::filesystem::path& file, const model::Model& model,
                    const results::RunResult& run);

} // namespace spricka::report
