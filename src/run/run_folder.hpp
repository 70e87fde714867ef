// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/model.hpp"
#include "results/results.hpp"

#include <filesystem>

namespace spricka::run {

/// The run folder. A folder of an earlier run of spricka is emptied first, so that nothing old can
/// be taken for a new result; a folder that holds anything else is refused. Everything is written
/// beside it and put in place in one move, or not at all.
class RunFolder {
public:
  /// Throws std::system_error when the folder cannot be used.
  explicit RunFolder(std::filesystem::path folder);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  /// Writes listing, k.csv, pressure.csv, pictures and requested files, and adds its own cost to
  /// the run's log before the listing is made. Throws std::system_error.
  void write(const base::Sources& sources, const model::Model& model, results::Run& run);

private:
  std::filesystem::path folder_;
  std::filesystem::path part_; ///< where it is written
};

} // namespace spricka::run
