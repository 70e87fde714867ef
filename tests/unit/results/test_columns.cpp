// SPDX-License-Identifier: GPL-3.0-or-later
// The manual describes the columns that there are, in their order, and says where else they stand.
#include "results/contact_result.hpp"
#include "results/front_result.hpp"
#include "results/tip_result.hpp"
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
template <class Quantities>
void expect_places(const std::vector<ManualRow>& rows, const Quantities& all, unsigned own,
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
        EXPECT_EQ(q->places, places) << name << " in the manual: " << row.also_in;
      }
    }
  }
}

TEST(Columns, of_k_csv_are_those_of_the_manual) {
  Words columns{"increment", "step", "crack"};
  for (const TipQuantity& q : tip_quantities) {
    if (q.appears_in(in_k_csv)) {
      columns.emplace_back(q.name);
    }
  }
  const std::vector<ManualRow> rows = manual_rows("k.csv");
  EXPECT_EQ(manual_names(rows, columns), columns);
  expect_places(rows, tip_quantities, in_k_csv,
                {{"results.h5", in_results_h5},
                 {"listing", in_listing},
                 {"shell", in_shell},
                 {"`$OUTPUT`", in_output},
                 {"sweeps", in_sweep},
                 {"`$CHECK`", in_check},
                 {"everywhere", everywhere}});
}

TEST(Columns, of_k_csv_in_space_are_those_of_the_manual) {
  Words columns{"increment", "step", "crack", "a", "point", "at_surface", "closed"};
  for (const FrontQuantity& q : front_quantities) {
    columns.emplace_back(q.name);
  }
  const std::vector<ManualRow> rows = manual_rows("k.csv of cracks in space");
  EXPECT_EQ(manual_names(rows, columns), columns);
  for (const ManualRow& row : rows) {
    for (const std::string& name : row.names) {
      if (const auto* const q = find_by_name(front_quantities, name)) {
        EXPECT_EQ(q->listed, row.also_in.find("listing") != std::string::npos) << name;
        EXPECT_EQ(q->checked, row.also_in.find("`$CHECK`") != std::string::npos) << name;
      }
    }
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
  expect_places(rows, point_quantities, in_pressure_csv,
                {{"results.h5", in_pressure_h5}, {"`$OUTPUT`", in_pressure_output}});
}

TEST(Columns, of_K2_are_where_those_of_K1_are) {
  for (const TipQuantity& q : tip_quantities) {
    if (std::string name = q.name; name.starts_with("K1")) {
      name[1] = '2';
      const TipQuantity* const other = find_by_name(tip_quantities, name);
      ASSERT_NE(other, nullptr) << name;
      EXPECT_EQ(other->places, q.places) << name;
      EXPECT_EQ(other->given, q.given) << name;
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
  expect_sound(tip_quantities);
  expect_sound(point_quantities);
  for (const TipQuantity& q : tip_quantities) {
    EXPECT_NE(q.member != nullptr, q.computed != nullptr) << q.name;
  }
  for (const ContactPointQuantity& q : point_quantities) {
    EXPECT_EQ(
        (q.member != nullptr ? 1 : 0) + (q.computed != nullptr ? 1 : 0) + (q.is_word() ? 1 : 0), 1)
        << q.name;
  }
  EXPECT_EQ(find_tip_quantity("K"), find_tip_quantity("K1"));
  EXPECT_EQ(std::string(find_tip_quantity("K2.BEST")->name), "K2_best");
  EXPECT_EQ(find_tip_quantity("A"), nullptr);
}

} // namespace
} // namespace spricka::results::test_columns
