// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/variant_runs.hpp"

#include "base/exit_codes.hpp"
#include "base/input_file.hpp"
#include "program/job/run_folder.hpp"
#include "results/store.hpp"
#include "results/store_run.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>
#include <stdlib.h> // NOLINT(modernize-deprecated-headers): mkdtemp is of POSIX

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// The first error among the messages of a run, without its place in a deck that nobody has written.
std::string first_trouble(const ChildEnd& end) {
  if (end.late) {
    return "took too long";
  }
  const std::size_t error = end.messages.find("error");
  if (error != std::string::npos) {
    const std::size_t stop = std::min(end.messages.find('\n', error), end.messages.size());
    return end.messages.substr(error, stop - error);
  }
  return end.signal != 0 ? fmt::format("ended by signal {}", end.signal)
                         : fmt::format("exit code {}", end.exit_code);
}

VariantOutcome read_end(const ChildRun& variant, const ChildEnd& end) {
  VariantOutcome found{end, std::nullopt, 0, {}};
  const std::optional<base::Outcome> outcome = base::exit_outcome(end.exit_code);
  const bool has_results =
      outcome && (*outcome == base::Outcome::done || *outcome == base::Outcome::check_failed);
  if (has_results && fs::exists(variant.out / results_name)) {
    const std::string bytes = base::read_file(variant.out / results_name, base::largest_mesh_file);
    found.run = results::read_run(results::Store::from_bytes(bytes).root());
    for (const results::Increment& increment : found.run->increments) {
      found.unknowns = std::max(found.unknowns, increment.unknowns);
    }
  } else {
    found.trouble = first_trouble(end);
  }
  std::error_code ignored;
  fs::remove_all(variant.out, ignored);
  return found;
}

} // namespace

ScratchFolder::ScratchFolder(const fs::path& place) {
  std::string name = resolved_folder(place).string() + ".XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  remove();
}

void ScratchFolder::remove() const {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

VariantOutcome run_variant(ChildRunner& children, const ChildRun& variant) {
  VariantOutcome found;
  run_variants(children, {variant}, 1,
               [&](std::size_t, VariantOutcome end) { found = std::move(end); });
  return found;
}

void run_variants(ChildRunner& children, const std::vector<ChildRun>& variants, int at_once,
                  const std::function<void(std::size_t, VariantOutcome)>& ended) {
  children.run_all(variants, at_once, [&](std::size_t i, const ChildEnd& end) {
    ended(i, read_end(variants[i], end));
  });
}

} // namespace spricka::program
