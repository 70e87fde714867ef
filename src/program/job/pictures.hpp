// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace spricka::program {

/// Makes a file of that name with `write`, which gets its path.
using FileCreator = std::function<void(
    const std::string& name, const std::function<void(const std::filesystem::path&)>& write)>;

/// The .vtu files of all steps whose stresses were recovered, and the .pvd files that collect them.
/// Their time is the number of cycles where a law tells it, else the crack length; of a run with
/// one increment the number of the step. Throws std::system_error.
void write_vtu_files(const model::Model& model, const results::RunResult& run,
                     const FileCreator& put);

} // namespace spricka::program
