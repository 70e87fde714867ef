// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/checkpoint_list.hpp"

#include "model/model.hpp"
#include "results/store_fields.hpp"

#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace spricka::archive {

/// The columns of a card in the table cards; the place in the deck that is read now is not kept.
template <class V, results::RecordOfType<CardFingerprint> T> void fields(V& v, T& card) {
  v("name", card.name);
  v("hash", card.hash);
  v("uses", card.uses);
  v("file", card.file);
  v("line", card.line);
}

namespace {

/// An entry as the table increments has it: all logs stand in one table beside it, one increment's
/// lines behind the other's.
struct EntryRow {
  CheckpointEntry entry;
  std::int64_t log_lines = 0;
};

template <class V, results::RecordOfType<EntryRow> T> void fields(V& v, T& row) {
  v("round", row.entry.round);
  v("number", row.entry.number);
  v("a", row.entry.asked);
  v("law", row.entry.law);
  v("file", row.entry.file);
  v("hash", row.entry.hash);
  v("cpu", row.entry.cpu);
  v("wall", row.entry.wall);
  v("log_lines", row.log_lines);
}

/// A table that every list has. Throws StoreError where it is missing.
template <class Row>
std::vector<Row> read_table(const results::StoreGroup& group, const std::string& name) {
  if (!group.has_member(name)) {
    throw results::StoreError(fmt::format("table {} is missing", name));
  }
  return results::read_record_list<Row>(group, name);
}

void write_entries(const results::StoreGroup& group, const std::vector<CheckpointEntry>& entries) {
  std::vector<EntryRow> rows;
  std::vector<results::LogLine> log;
  for (const CheckpointEntry& e : entries) {
    rows.push_back({e, static_cast<std::int64_t>(e.log.size())});
    log.insert(log.end(), e.log.begin(), e.log.end());
  }
  results::write_record_list(group, "increments", rows);
  results::write_record_list(group, "log", log);
}

std::vector<CheckpointEntry> entries_from(const results::StoreGroup& group) {
  const auto log = results::read_record_list<results::LogLine>(group, "log");
  auto line = log.begin();
  std::vector<CheckpointEntry> entries;
  for (EntryRow& row : read_table<EntryRow>(group, "increments")) {
    if (row.log_lines < 0 || row.log_lines > log.end() - line) {
      throw results::StoreError("the log is incomplete");
    }
    row.entry.log.assign(line, line + row.log_lines);
    line += row.log_lines;
    entries.push_back(std::move(row.entry));
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

void write_checkpoint_list_group(results::StoreGroup root, const CheckpointList& list) {
  root.set_attribute("growth", list.growth);
  root.set_attribute("course", list.course);
  root.set_attribute("amax", list.ends[0]);
  root.set_attribute("cycles", list.ends[1]);
  results::write_record_list(root, "cards", list.cards);
  write_entries(root, list.entries);
}

CheckpointList read_checkpoint_list_group(const results::StoreGroup& root) {
  CheckpointList list;
  list.cards = read_table<CardFingerprint>(root, "cards");
  list.entries = entries_from(root);
  list.growth = root.text_attribute("growth");
  list.course = root.text_attribute("course");
  list.ends = {root.real_attribute("amax"), root.real_attribute("cycles")};
  return list;
}

std::string growth_settings_text(const model::Model& model) {
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
  if (c.k_part_through) { // left out, texts are those of earlier files
    add(text, c.k_part_through);
  }
  if (c.at_negative_ratio != model::NegativeRatioRule::positive_part) {
    add(text, {static_cast<double>(c.at_negative_ratio), c.p_below});
  }
  if (c.threshold_over_ratio) {
    const model::ThresholdOverRatio& t = *c.threshold_over_ratio;
    add(text, {t.delta_k, t.at_zero_ratio ? 1.0 : 0.0, t.slope_above, t.slope_below,
               t.intrinsic_length, t.largest_ratio});
  }
  for (const std::optional<std::size_t>& interaction : g.interactions) {
    text += " by " + (interaction ? model.interactions[*interaction].name : "NONE");
  }
  add(text, c.delta_k);
  add(text, c.growth);
  if (!c.table_ratios.empty()) {
    add(text, c.table_ratios);
  }
  const model::GrowthLawData& data = g.data; // stations keep what lies outside of it
  if (data.lowest_delta_k || data.highest_delta_k || data.lowest_ratio || data.highest_ratio) {
    for (const std::optional<double>& limit :
         {data.lowest_delta_k, data.highest_delta_k, data.lowest_ratio, data.highest_ratio}) {
      add(text, limit);
    }
  }
  add(text, g.largest_advance);
  add(text, g.flow_stress);
  add(text, g.tolerance);
  return text;
}

std::string growth_law_text(const model::Model& model, const std::vector<CardFingerprint>& cards) {
  std::string text = growth_settings_text(model);
  for (const CardFingerprint& spectrum : select_cards(cards, {"SPECTRUM", "INTERACTION"})) {
    text += " " + spectrum.hash;
  }
  return text;
}

std::string growth_course_text(const model::Model& model) {
  if (!model.growth) {
    return "none";
  }
  const model::CrackGrowthSettings& g = *model.growth;
  std::string text =
      fmt::format("direction {} shape {} history {} mounted {} corrected {} advance",
                  static_cast<int>(g.direction), static_cast<int>(g.shape),
                  static_cast<int>(g.history), static_cast<int>(g.mounted), g.corrected);
  add(text, g.largest_advance);
  add(text, g.flow_stress);
  for (const base::CrackId crack : g.cracks) {
    text += " " + model.cracks[crack.index()].name;
  }
  return text;
}

std::array<double, 2> growth_length_and_cycle_limits(const model::Model& model) {
  constexpr double never = std::numeric_limits<double>::infinity();
  return model.growth ? std::array{model.growth->last_length.value_or(never),
                                   model.growth->cycles.value_or(never)}
                      : std::array{never, never};
}

} // namespace spricka::archive
