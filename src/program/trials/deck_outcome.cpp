// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/deck_outcome.hpp"

#include "program/job/point_record.hpp"
#include "program/job/run_folder.hpp"
#include "results/store.hpp"
#include "results/store_run.hpp"

#include <algorithm>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

DeckRunChecks read_results(const fs::path& file) {
  const results::Store store = results::Store::from_file(file);
  const results::StoreGroup root = store.root();
  DeckRunChecks outcome{.checks = results::read_checks(root),
                        .title = root.text_attribute("title")};
  const results::StoreGroup increments = root.group("increments");
  for (const std::string& name : increments.names()) {
    outcome.unknowns =
        std::max(outcome.unknowns,
                 static_cast<std::size_t>(increments.group(name).integer_attribute("unknowns")));
  }
  return outcome;
}

} // namespace

std::vector<DeckRunChecks> read_run_folder_checks(const fs::path& folder) {
  std::vector<DeckRunChecks> all;
  if (fs::exists(folder / results_name)) {
    all.push_back(read_results(folder / results_name));
    return all;
  }
  std::vector<fs::path> points;
  if (fs::is_directory(folder)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (fs::exists(entry.path() / point_record_name) && fs::exists(entry.path() / results_name)) {
        points.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(points);
  for (const fs::path& point : points) {
    DeckRunChecks& outcome = all.emplace_back(read_results(point / results_name));
    outcome.values = sweep_point_text(read_point_values(point / point_record_name));
  }
  return all;
}

std::string first_error_line(const std::string& messages) {
  const std::size_t error = messages.find("error");
  const std::size_t at = error == std::string::npos ? messages.find_last_not_of(" \n\r") : error;
  if (at == std::string::npos) {
    return {};
  }
  const std::size_t begin = messages.rfind('\n', at) + 1; // behind npos: 0
  const std::size_t end = error == std::string::npos ? at + 1 : messages.find('\n', at);
  return messages.substr(begin, std::min(end, messages.size()) - begin);
}

} // namespace spricka::program
