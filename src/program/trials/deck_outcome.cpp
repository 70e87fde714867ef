// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/deck_outcome.hpp"

#include "base/input_file.hpp"
#include "program/job/point_record.hpp"
#include "program/job/run_folder.hpp"
#include "results/store.hpp"
#include "results/store_run.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

results::ColumnTable table_of(const results::StoreGroup& root, const std::string& name) {
  return root.has_member(name) ? root.read_table(name) : results::ColumnTable{};
}

DeckOutcome read_results(const fs::path& file) {
  const std::string bytes = base::read_file(file, base::largest_mesh_file);
  const results::Store store = results::Store::from_bytes(bytes);
  const results::StoreGroup root = store.root();
  DeckOutcome outcome{.title = root.text_attribute("title"),
                      .program = root.text_attribute("program"),
                      .point = {},
                      .checks = results::read_checks(root),
                      .warnings = root.has_member("warnings") ? root.read_texts("warnings")
                                                              : std::vector<std::string>(),
                      .unknowns = 0,
                      .k = table_of(root, "k"),
                      .pressure = table_of(root, "pressure")};
  const results::StoreGroup increments = root.group("increments");
  for (const std::string& name : increments.names()) {
    outcome.unknowns =
        std::max(outcome.unknowns,
                 static_cast<std::size_t>(increments.group(name).integer_attribute("unknowns")));
  }
  return outcome;
}

std::vector<std::pair<std::string, double>> point_of(const fs::path& record) {
  const nlohmann::json text =
      nlohmann::json::parse(base::read_file(record, base::largest_number_file), nullptr, false);
  std::vector<std::pair<std::string, double>> values;
  if (text.is_object() && text.contains("parameters") && text["parameters"].is_object()) {
    for (const auto& [name, value] : text["parameters"].items()) {
      values.emplace_back(name, value.is_number() ? value.get<double>() : 0.0);
    }
  }
  return values;
}

template <class T>
std::vector<T> column_of(const results::ColumnTable& table, const std::string& name) {
  const auto found =
      std::ranges::find(table.columns, name, &results::ColumnTable::NamedColumn::name);
  if (found == table.columns.end()) {
    return {};
  }
  const auto* values = std::get_if<std::vector<T>>(&found->values);
  return values == nullptr ? std::vector<T>() : *values;
}

} // namespace

std::vector<DeckOutcome> read_outcomes(const fs::path& folder) {
  std::vector<DeckOutcome> all;
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
    DeckOutcome& outcome = all.emplace_back(read_results(point / results_name));
    outcome.point = point_of(point / point_record_name);
  }
  return all;
}

std::vector<double> number_column(const results::ColumnTable& table, const std::string& column) {
  const std::vector<std::int64_t> whole = column_of<std::int64_t>(table, column);
  return whole.empty() ? column_of<double>(table, column)
                       : std::vector<double>(whole.begin(), whole.end());
}

std::vector<std::string> text_column(const results::ColumnTable& table, const std::string& column) {
  return column_of<std::string>(table, column);
}

} // namespace spricka::program
