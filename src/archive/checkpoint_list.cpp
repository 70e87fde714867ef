// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/checkpoint_list.hpp"

#include "model/model.hpp"
#include "results/store_run.hpp"

#include <limits>
#include <optional>
#include <variant>

#include <fmt/format.h>

namespace spricka::archive {

namespace {

results::ColumnTable card_table(const std::vector<CardFingerprint>& cards) {
  std::vector<std::string> name;
  std::vector<std::string> hash;
  std::vector<std::string> uses;
  std::vector<std::string> file;
  std::vector<std::int64_t> line;
  for (const CardFingerprint& card : cards) {
    name.push_back(card.name);
    hash.push_back(card.hash);
    uses.push_back(card.uses);
    file.push_back(card.file);
    line.push_back(card.line);
  }
  return {{{"name", name}, {"hash", hash}, {"uses", uses}, {"file", file}, {"line", line}}};
}

template <class T>
const std::vector<T>& column(const results::ColumnTable& table, std::size_t c, const char* name) {
  const std::vector<T>* values = c < table.columns.size() && table.columns[c].name == name
                                     ? std::get_if<std::vector<T>>(&table.columns[c].values)
                                     : nullptr;
  if (values == nullptr) {
    throw results::StoreError(fmt::format("column {} is missing", name));
  }
  return *values;
}

std::vector<CardFingerprint> cards_from(const results::ColumnTable& table) {
  std::vector<CardFingerprint> cards(table.rows());
  for (std::size_t i = 0; i < cards.size(); ++i) {
    cards[i].name = column<std::string>(table, 0, "name")[i];
    cards[i].hash = column<std::string>(table, 1, "hash")[i];
    cards[i].uses = column<std::string>(table, 2, "uses")[i];
    cards[i].file = column<std::string>(table, 3, "file")[i];
    cards[i].line = static_cast<int>(column<std::int64_t>(table, 4, "line")[i]);
  }
  return cards;
}

void write_entries(results::StoreGroup group, const std::vector<CheckpointEntry>& entries) {
  std::vector<std::int64_t> round;
  std::vector<std::int64_t> number;
  std::vector<double> asked;
  std::vector<std::string> file;
  std::vector<std::string> hash;
  std::vector<double> cpu;
  std::vector<double> wall;
  std::vector<std::int64_t> lines;
  std::vector<results::LogLine> log;
  for (const CheckpointEntry& e : entries) {
    round.push_back(e.round);
    number.push_back(e.number);
    asked.push_back(e.asked);
    file.push_back(e.file);
    hash.push_back(e.hash);
    cpu.push_back(e.cpu);
    wall.push_back(e.wall);
    lines.push_back(static_cast<std::int64_t>(e.log.size()));
    log.insert(log.end(), e.log.begin(), e.log.end());
  }
  group.write("increments", results::ColumnTable{{{"round", round},
                                                  {"number", number},
                                                  {"a", asked},
                                                  {"file", file},
                                                  {"hash", hash},
                                                  {"cpu", cpu},
                                                  {"wall", wall},
                                                  {"log_lines", lines}}});
  results::write_log(group, "log", log);
}

std::vector<CheckpointEntry> entries_from(const results::StoreGroup& group) {
  const results::ColumnTable table = group.read_table("increments");
  const std::vector<results::LogLine> log = results::read_log(group, "log");
  auto line = log.begin();
  std::vector<CheckpointEntry> entries(table.rows());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    CheckpointEntry& e = entries[i];
    e.round = static_cast<int>(column<std::int64_t>(table, 0, "round")[i]);
    e.number = static_cast<int>(column<std::int64_t>(table, 1, "number")[i]);
    e.asked = column<double>(table, 2, "a")[i];
    e.file = column<std::string>(table, 3, "file")[i];
    e.hash = column<std::string>(table, 4, "hash")[i];
    e.cpu = column<double>(table, 5, "cpu")[i];
    e.wall = column<double>(table, 6, "wall")[i];
    const std::int64_t lines = column<std::int64_t>(table, 7, "log_lines")[i];
    if (lines < 0 || lines > log.end() - line) {
      throw results::StoreError("the log is incomplete");
    }
    // All logs stand in one table, one increment's lines behind the other's.
    e.log.assign(line, line + lines);
    line += lines;
  }
  return entries;
}

void add(std::string& text, double value) {
  // Hexadecimal: equal texts are equal numbers to the last bit.
  text += fmt::format(" {:a}", value);
}

void add(std::string& text, const std::vector<double>& values) {
  for (const double value : values) {
    add(text, value);
  }
  text += ';';
}

void add(std::string& text, const std::optional<double>& value) {
  add(text, value ? std::vector{*value} : std::vector<double>());
}

} // namespace

void write_checkpoint_list(results::StoreGroup root, const CheckpointList& list) {
  root.set_attribute("growth", list.growth);
  root.set_attribute("amax", list.ends[0]);
  root.set_attribute("cycles", list.ends[1]);
  root.write("cards", card_table(list.cards));
  write_entries(root, list.entries);
}

CheckpointList read_checkpoint_list(const results::StoreGroup& root) {
  CheckpointList list;
  list.cards = cards_from(root.read_table("cards"));
  list.entries = entries_from(root);
  list.growth = root.text_attribute("growth");
  list.ends = {root.real_attribute("amax"), root.real_attribute("cycles")};
  return list;
}

std::string growth_rules(const model::Model& model) {
  if (!model.growth) {
    return "none";
  }
  const model::CrackGrowthSettings& g = *model.growth;
  std::string text =
      fmt::format("law {} direction {} shape {} history {} mounted {}", static_cast<int>(g.law),
                  static_cast<int>(g.direction), static_cast<int>(g.shape),
                  static_cast<int>(g.history), static_cast<int>(g.mounted));
  for (const base::CrackId crack : g.cracks) {
    text += " " + model.cracks[crack.index()].name;
  }
  // Given lengths do not hang on K: the rest has no part in them.
  if (g.law == model::CrackGrowthLaw::increment) {
    return text;
  }
  const model::GrowthLawConstants& c = g.constants;
  text += fmt::format(" from {} to {} corrected {} law", g.kmin.value, g.kmax.value, g.corrected);
  add(text, {c.C, c.m, c.p, c.q, c.alpha, c.stress_ratio, c.threshold, c.k_unit, c.a_unit});
  add(text, c.k_c);
  add(text, c.delta_k);
  add(text, c.growth);
  add(text, g.largest_advance);
  add(text, g.flow_stress);
  add(text, g.tolerance);
  return text;
}

std::array<double, 2> growth_ends(const model::Model& model) {
  constexpr double never = std::numeric_limits<double>::infinity();
  return model.growth ? std::array{model.growth->last_length.value_or(never),
                                   model.growth->cycles.value_or(never)}
                      : std::array{never, never};
}

} // namespace spricka::archive
