// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/array_task.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace spricka::program {

namespace {

// A whole number from 0 that is all of the text.
std::optional<std::size_t> whole_number_from(std::string_view text) {
  std::size_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return !text.empty() && status == std::errc() && end == text.data() + text.size()
             ? std::optional(value)
             : std::nullopt;
}

std::optional<std::size_t> number_of_environment(const char* name) {
  const char* const text = std::getenv(name); // NOLINT(concurrency-mt-unsafe): nobody sets any
  return text == nullptr ? std::nullopt : whole_number_from(text);
}

std::optional<ArrayTask> slurm_task(std::string& why) {
  const auto id = number_of_environment("SLURM_ARRAY_TASK_ID");
  const auto first = number_of_environment("SLURM_ARRAY_TASK_MIN");
  const auto last = number_of_environment("SLURM_ARRAY_TASK_MAX");
  const auto count = number_of_environment("SLURM_ARRAY_TASK_COUNT");
  const std::size_t step = number_of_environment("SLURM_ARRAY_TASK_STEP").value_or(1);
  if (!id || !first || !last || !count) {
    why = "--array slurm is for a task of a job array, sbatch --array=1-8: SLURM_ARRAY_TASK_ID is "
          "not set; --array K/N says it without Slurm";
    return std::nullopt;
  }
  // A list as --array=1,3,7 has gaps, in which runs would be lost.
  const bool range = step > 0 && *first <= *id && *id <= *last &&
                     (*last - *first) / step + 1 == *count && (*id - *first) % step == 0;
  if (!range) {
    why = fmt::format("the array of Slurm has {} tasks from {} to {}, which is no plain range: "
                      "say --array K/N",
                      *count, *first, *last);
    return std::nullopt;
  }
  return ArrayTask{.number = (*id - *first) / step + 1, .count = *count};
}

} // namespace

std::optional<ArrayTask> parse_array_task(const std::string& text, std::string& why) {
  if (text == "slurm") {
    return slurm_task(why);
  }
  const std::size_t slash = std::min(text.find('/'), text.size());
  // Zero is no number of a task.
  const std::size_t number = whole_number_from(text.substr(0, slash)).value_or(0);
  const std::size_t count =
      whole_number_from(text.substr(std::min(slash + 1, text.size()))).value_or(0);
  if (number < 1 || number > count) {
    why = fmt::format("write --array K/N, task K of N from 1 on, or --array slurm, not '{}'", text);
    return std::nullopt;
  }
  return ArrayTask{.number = number, .count = count};
}

std::string missing_runs_text(const std::vector<std::string>& missing, std::size_t count,
                              const std::string& kind, const std::filesystem::path& folder) {
  return fmt::format(
      "{} of {} {}s {} missing in {}: {}; run their tasks again, what is finished is "
      "passed over",
      missing.size(), count, kind, missing.size() == 1 ? "is" : "are", folder.string(),
      fmt::join(missing, ", "));
}

std::optional<int> scheduler_cpu_count() {
  const std::optional<std::size_t> count = number_of_environment("SLURM_CPUS_PER_TASK");
  constexpr std::size_t most = 65536;
  return count && *count > 0 && *count <= most ? std::optional(static_cast<int>(*count))
                                               : std::nullopt;
}

} // namespace spricka::program
