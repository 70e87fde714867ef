// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/model.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <string>

namespace spricka::run {

/// Files by which a folder is known as a run's or a sweep's.
inline constexpr const char* listing_name = "listing.txt";
inline constexpr const char* sweep_table_name = "sweep.csv";
inline constexpr const char* results_name = "results.h5"; ///< whole, for programs

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
  /// Adds a file of that name.
  void keep(const std::string& name, const std::string& text);
  /// Puts the folder in place; without it nothing stays.
  void commit();

private:
  std::filesystem::path folder_;
  std::filesystem::path part_; ///< where it is written
};

} // namespace spricka::run
