// SPDX-License-Identifier: GPL-3.0-or-later
// The manual describes the columns that there are, in their order, and says where else they stand.
#include "results/contact_result.hpp"
#include "results/k_quantities.hpp"
#include "tests/places.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace spricka::results::test_columns {
namespace {

using Words = std::vector<std::string>;

/// A row of a table of the manual: names of columns, and where else they are.
struct ManualRow {
  Words names;
  std::string also_in;
};

// What stands between backticks; the rest is dropped.
Words in_backticks(const std::string& cell) {
  Words words;
  std::istringstream parts(cell);
  bool inside = false;
  for (std::string part; std::getline(parts, part, '`'); inside = !inside) {
    if (inside) {
      words.push_back(part);
    }
  }
  return words;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// The rows of all tables of three columns in a section of manual/run_folder.md.
std::vector<ManualRow> manual_rows(const std::string& section) {
  std::ifstream in(test::source_folder() + "/manual/run_folder.md");
  std::vector<ManualRow> rows;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    inside = line.starts_with("## ") ? line == "## " + section : inside;
    if (!inside || !line.starts_with("| `")) {
      continue;
    }
    Words cells;
    std::istringstream parts(line.substr(1));
    for (std::string cell; std::getline(parts, cell, '|');) {
      cells.push_back(cell);
    }
    EXPECT_EQ(cells.size(), 3U) << line;
    if (cells.size() == 3) {
      const bool range = cells[0].find("` .. `") != std::string::npos;
      Words names = in_backticks(cells[0]);
      names.insert(names.begin() + (range ? 1 : 0), range ? 1U : 0U, "..");
      rows.push_back({names, trimmed(cells[2])});
    }
  }
  return rows;
}

// All names of the rows; "A .. B" stands for the columns from A to B.
Words manual_names(const std::vector<ManualRow>& rows, const Words& columns) {
  Words names;
  for (const ManualRow& row : rows) {
    for (std::size_t i = 0; i < row.names.size(); ++i) {
      if (row.names[i] != "..") {
        names.push_back(row.names[i]);
        continue;
      }
      const auto from = std::ranges::find(columns, row.names[i - 1]);
      const auto to = std::ranges::find(columns, row.names[i + 1]);
      if (from < to) {
        names.insert(names.end(), from + 1, to);
      }
    }
  }
  return names;
}

template <class Quantities> const auto* find_by_name(const Quantities& all, std::string_view name) {
  const auto* const found =
      std::ranges::find_if(all, [&](const auto& q) { return q.name == name; });
  return found == all.end() ? nullptr : found;
}

// Every row says the places of its columns; "as K1" is left to a test of its own.
template <class Quantities, class Places>
void expect_places(const std::vector<ManualRow>& rows, const Quantities& all,
                   const Places& places_of, unsigned own,
                   const std::map<std::string, unsigned>& words) {
  for (const ManualRow& row : rows) {
    unsigned places = own;
    std::istringstream parts(row.also_in);
    for (std::string part; std::getline(parts, part, ',') && !part.starts_with("as ");) {
      ASSERT_TRUE(words.contains(trimmed(part))) << part;
      places |= words.at(trimmed(part));
    }
    for (const std::string& name : row.names) {
      const auto* const q = find_by_name(all, name);
      if (q != nullptr && !row.also_in.starts_with("as ")) {
        EXPECT_EQ(places_of(*q), places) << name << " in the manual: " << row.also_in;
      }
    }
  }
}

// Names of what a place has in `dim` dimensions, in the order of the table; `front` of them first.
Words k_columns(KOutputPlace place, int dim, Words front = {}) {
  for (const KQuantity& q : k_quantities) {
    if (q.appears_in(place, dim)) {
      front.emplace_back(q.name);
    }
  }
  return front;
}

TEST(Columns, of_k_csv_are_those_of_the_manual) {
  const Words columns = k_columns(in_k_csv, 2, {"increment", "step", "crack"});
  const std::vector<ManualRow> rows = manual_rows("k.csv");
  EXPECT_EQ(manual_names(rows, columns), columns);
  expect_places(rows, k_quantities, [](const KQuantity& q) { return q.places.plane; }, in_k_csv,
                {{"results.h5", in_results_h5},
                 {"listing", in_listing},
                 {"`$OUTPUT`", in_output},
                 {"sweeps", in_sweep},
                 {"`$CHECK`", in_check},
                 {"everywhere", everywhere}});
}

TEST(Columns, of_k_csv_in_space_are_those_of_the_manual) {
  const Words columns = k_columns(in_k_csv, 3, {"increment", "step", "crack"});
  const std::vector<ManualRow> rows = manual_rows("k.csv of cracks in space");
  EXPECT_EQ(manual_names(rows, columns), columns);
  for (const ManualRow& row : rows) {
    for (const std::string& name : row.names) {
      if (const auto* const q = find_by_name(k_quantities, name)) {
        EXPECT_EQ(q->appears_in(in_listing, 3), row.also_in.find("listing") != std::string::npos)
            << name;
        EXPECT_EQ(q->appears_in(in_check, 3), row.also_in.find("`$CHECK`") != std::string::npos)
            << name;
      }
    }
  }
}

// Readers count columns: those of the plane stand as they did when tips had a table of their own.
TEST(Columns, of_tips_have_kept_their_order) {
  EXPECT_EQ(
      k_columns(in_k_csv, 2),
      (Words{"a", "K1", "K2", "G", "spread", "T", "K1_bar", "K1_raw", "K1_eta", "K1_sum", "K1_flip",
             "K2_bar", "K2_raw", "K2_eta", "K2_sum", "K2_flip", "K1_opening", "K2_opening"}));
  EXPECT_EQ(k_columns(in_results_h5, 2), (Words{"a", "x", "y", "z", "K1", "K2", "G", "spread", "T",
                                                "K1_bar", "K1_raw", "K2_bar", "K2_raw"}));
  EXPECT_EQ(k_columns(in_listing, 2),
            (Words{"a", "K1", "K2", "G", "G_from_K", "spread", "T", "K1_opening", "K2_opening"}));
  EXPECT_EQ(k_columns(in_output, 2),
            (Words{"a", "K1", "K2", "G", "K1_bar", "K1_raw", "K2_bar", "K2_raw"}));
  EXPECT_EQ(k_columns(in_sweep, 2), (Words{"K1", "K2", "G", "K1_bar", "K2_bar"}));
  EXPECT_EQ(k_columns(in_check, 2),
            (Words{"K1", "K2", "G", "T", "K1_bar", "K1_raw", "K2_bar", "K2_raw"}));
  const std::set<std::string> judge{"spread", "K1_bar", "K1_raw", "K2_bar", "K2_raw"};
  for (const KQuantity& q : k_quantities) {
    if (q.appears_in(in_results_h5, 2)) {
      EXPECT_EQ(q.is_quality_measure, judge.contains(q.name))
          << q.name << " behind the others among the points of results.h5";
    }
  }
}

// K by the opening of the faces stands with the points of the steps' fronts alone. What a deck may
// ask of a front it may have in a table.
TEST(Columns, of_fronts_are_those_of_their_points) {
  EXPECT_EQ(k_columns(in_k_csv, 3),
            (Words{"a",      "point",  "at_surface", "closed",    "s",         "phi",    "x",
                   "y",      "z",      "K1",         "K2",        "K3",        "G",      "G_from_K",
                   "spread", "T",      "K1_smooth",  "K2_smooth", "K3_smooth", "K1_bar", "K1_raw",
                   "K2_bar", "K2_raw", "K3_bar",     "K3_raw"}));
  EXPECT_EQ(k_columns(in_listing, 3),
            (Words{"s", "phi", "x", "y", "z", "K1", "K2", "K3", "G", "spread", "T"}));
  EXPECT_EQ(k_columns(in_check, 3), (Words{"K1", "K2", "K3", "G", "T", "K1_bar", "K1_raw", "K2_bar",
                                           "K2_raw", "K3_bar", "K3_raw"}));
  EXPECT_EQ(k_columns(in_output, 3), k_columns(in_check, 3));
  EXPECT_EQ(k_columns(in_results_h5, 3), k_columns(in_k_csv, 3));
  for (const char* name : {"K1_opening", "K2_opening"}) {
    const KQuantity* const q = find_by_name(k_quantities, name);
    ASSERT_NE(q, nullptr) << name;
    EXPECT_EQ(q->places.space, 0U) << name;
  }
}

TEST(Columns, of_pressure_csv_are_those_of_the_manual) {
  Words columns{"increment", "step", "contact"};
  for (const bool friction : {false, true}) {
    for (const ContactPointQuantity& q : point_quantities) {
      if (q.appears_in(in_pressure_csv) && q.friction == friction) {
        columns.emplace_back(q.name);
      }
    }
  }
  const std::vector<ManualRow> rows = manual_rows("pressure.csv");
  EXPECT_EQ(manual_names(rows, columns), columns);
  expect_places(rows, point_quantities, [](const ContactPointQuantity& q) { return q.places; },
                in_pressure_csv,
                {{"results.h5", in_pressure_h5}, {"`$OUTPUT`", in_pressure_output}});
}

TEST(Columns, of_K2_are_where_those_of_K1_are) {
  for (const KQuantity& q : k_quantities) {
    if (std::string name = q.name; name.starts_with("K1")) {
      name[1] = '2';
      const KQuantity* const other = find_by_name(k_quantities, name);
      ASSERT_NE(other, nullptr) << name;
      EXPECT_EQ(other->places.plane, q.places.plane) << name;
      EXPECT_EQ(other->places.space, q.places.space) << name;
      EXPECT_EQ(other->given, q.given) << name;
      EXPECT_EQ(other->mode, q.mode < 0 ? -1 : 1) << name;
    }
  }
}

// In space; the plane has no K3.
TEST(Columns, of_K3_are_where_those_of_K1_are) {
  for (const KQuantity& q : k_quantities) {
    if (std::string name = q.name; name.starts_with("K1") && q.places.space != 0) {
      name[1] = '3';
      const KQuantity* const other = find_by_name(k_quantities, name);
      ASSERT_NE(other, nullptr) << name;
      EXPECT_EQ(other->places.plane, 0U) << name;
      EXPECT_EQ(other->places.space, q.places.space) << name;
      EXPECT_EQ(other->given, q.given) << name;
      EXPECT_EQ(other->mode, q.mode < 0 ? -1 : 2) << name;
    }
  }
}

template <class Quantities> void expect_sound(const Quantities& all) {
  std::set<std::string> names;
  for (const auto& q : all) {
    EXPECT_TRUE(names.insert(q.name).second) << q.name << " twice";
    EXPECT_FALSE(q.doc.empty()) << q.name;
  }
}

TEST(Columns, have_one_source_each) {
  expect_sound(k_quantities);
  expect_sound(point_quantities);
  for (const KQuantity& q : k_quantities) {
    EXPECT_NE(q.member != nullptr, q.computed != nullptr) << q.name;
  }
  for (const ContactPointQuantity& q : point_quantities) {
    EXPECT_EQ(
        (q.member != nullptr ? 1 : 0) + (q.computed != nullptr ? 1 : 0) + (q.is_word() ? 1 : 0), 1)
        << q.name;
  }
}

TEST(Columns, are_found_by_their_words_of_checks) {
  for (const int dim : {2, 3}) {
    std::set<std::string> words;
    for (const KQuantity& q : k_quantities) {
      if (q.appears_in(in_check, dim)) {
        EXPECT_TRUE(words.insert(q.check_word()).second) << q.check_word() << " twice in " << dim;
        EXPECT_EQ(find_k_quantity(q.check_word(), dim), &q) << q.check_word();
      }
    }
    ASSERT_NE(find_k_quantity("K", dim), nullptr);
    EXPECT_EQ(find_k_quantity("K", dim), find_k_quantity("K1", dim));
    ASSERT_NE(find_k_quantity("K2.RAW", dim), nullptr);
    EXPECT_EQ(std::string(find_k_quantity("K2.RAW", dim)->name), "K2_raw");
    for (const char* word : {"A", "S", "SPREAD", "K1.SMOOTH", "K1.OPENING", "K2_RAW", ""}) {
      EXPECT_EQ(find_k_quantity(word, dim), nullptr) << word;
    }
  }
  for (const char* word : {"K3", "K3.BAR", "K3.RAW"}) {
    EXPECT_EQ(find_k_quantity(word, 2), nullptr) << word;
    EXPECT_NE(find_k_quantity(word, 3), nullptr) << word;
  }
}

} // namespace
} // namespace spricka::results::test_columns
