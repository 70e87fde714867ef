// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/trials/child_run.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Variants of a deck, run as processes of their own in a folder that goes with the object.
namespace spricka::program {

/// A folder beside `place` that is removed at the end, whole. Throws std::system_error where none
/// can be made.
class ScratchFolder {
public:
  explicit ScratchFolder(const std::filesystem::path& place);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void remove() const;

private:
  std::filesystem::path path_;
};

/// How one variant has ended, and its results if there are some.
struct VariantOutcome {
  ChildEnd end;
  std::optional<results::RunResult> run;
  std::size_t unknowns = 0; ///< of its largest increment
  std::string trouble;      ///< why there are no results, in one line
};

/// Runs one deck into `out`, reads what it has found and removes its folder.
VariantOutcome run_variant(ChildRunner& children, const ChildRun& variant);

/// The same for several, at most `at_once` at a time; `ended` as of ChildRunner::run.
void run_variants(ChildRunner& children, const std::vector<ChildRun>& variants, int at_once,
                  const std::function<void(std::size_t, VariantOutcome)>& ended);

} // namespace spricka::program
