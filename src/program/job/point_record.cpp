// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/point_record.hpp"

#include "base/exit_codes.hpp"
#include "base/input_file.hpp"
#include "program/job/run_folder.hpp"

#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace spricka::program {

namespace {

using nlohmann::json;
using results::SweepPoint;
using results::SweepResultValue;

json to_json(const std::vector<SweepResultValue>& cells) {
  json list = json::array();
  for (const SweepResultValue& c : cells) {
    list.push_back({c.quantity, c.name, c.step, c.increment, c.value}); // not finite: null
  }
  return list;
}

std::vector<SweepResultValue> cells_from(const json& list) {
  std::vector<SweepResultValue> cells;
  for (const json& c : list) {
    const double value =
        c.at(4).is_null() ? std::numeric_limits<double>::quiet_NaN() : c.at(4).get<double>();
    cells.push_back({.quantity = c.at(0).get<std::string>(),
                     .name = c.at(1).get<std::string>(),
                     .step = c.at(2).get<std::string>(),
                     .increment = c.at(3).get<int>(),
                     .value = value});
  }
  return cells;
}

// Empty: it ends with a number that no outcome has.
std::optional<SweepPoint> point_from(const json& record) {
  const std::optional<base::ProgramOutcome> outcome =
      base::outcome_of_exit_code(record.at("exit_code").get<int>());
  if (!outcome) {
    return std::nullopt;
  }
  SweepPoint point;
  point.outcome = *outcome;
  point.error = record.at("error").get<std::string>();
  point.checks = record.at("checks").get<int>();
  point.passed = record.at("passed").get<int>();
  point.warnings = record.at("warnings").get<int>();
  point.cells = cells_from(record.at("cells"));
  for (const auto& [file, cells] : record.at("requested").items()) {
    point.requested.emplace(file, cells_from(cells));
  }
  return point;
}

} // namespace

std::string point_record_text(const SweepPointValues& values, const SweepPoint& point,
                              const std::string& digest) {
  json record{{"spricka", SPRICKA_VERSION},
              {"digest", digest},
              {"exit_code", base::exit_code(point.outcome)},
              {"error", point.error},
              {"checks", point.checks},
              {"passed", point.passed},
              {"warnings", point.warnings},
              {"parameters", json::object()},
              {"cells", to_json(point.cells)},
              {"requested", json::object()}};
  for (const auto& [name, value] : values) {
    record["parameters"][name] = value;
  }
  for (const auto& [file, cells] : point.requested) {
    record["requested"][file] = to_json(cells);
  }
  return record.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::optional<SweepPoint> read_point_record(const std::filesystem::path& folder,
                                            const std::string& digest) {
  try {
    const json record =
        json::parse(base::read_file(folder / point_record_name, base::largest_number_file));
    if (record.at("digest").get<std::string>() != digest) {
      return std::nullopt;
    }
    const std::optional<SweepPoint> point = point_from(record);
    // A point is done when its run folder is whole.
    const bool whole =
        point && (!has_results(point->outcome) || std::filesystem::exists(folder / listing_name));
    return whole ? point : std::nullopt;
  } catch (const json::exception&) {
    return std::nullopt; // not whole: as good as none
  } catch (const base::UnreadableFile&) {
    return std::nullopt;
  }
}

SweepPointValues read_point_values(const std::filesystem::path& record) {
  const json text = json::parse(base::read_file(record, base::largest_number_file), nullptr, false);
  SweepPointValues values;
  if (text.is_object() && text.contains("parameters") && text["parameters"].is_object()) {
    for (const auto& [name, value] : text["parameters"].items()) {
      values.emplace_back(name, value.is_number() ? value.get<double>() : 0.0);
    }
  }
  return values;
}

std::string sweep_point_text(const SweepPointValues& point) {
  std::string text;
  for (const auto& [name, value] : point) {
    text += fmt::format("{}{} = {:.6g}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

} // namespace spricka::program
