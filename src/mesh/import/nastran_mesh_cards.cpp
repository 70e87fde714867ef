// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_fields.hpp"
#include "mesh/set_name.hpp"

#include <algorithm>
#include <array>

namespace spricka::mesh {
namespace {

constexpr std::array<std::string_view, 4> bar_entries{"CBAR", "CBEAM", "CROD", "CTUBE"};

void read_grid(NastranFields& card, NastranBulk& bulk) {
  NastranBulk::NastranGrid grid;
  grid.label = card.label(0, "ID");
  grid.system = card.label_or(1, "CP", NastranBulk::blank);
  grid.x = {card.real_or(2, "X1", 0.0), card.real_or(3, "X2", 0.0), card.real_or(4, "X3", 0.0)};
  grid.directions = card.label_or(5, "CD", NastranBulk::blank);
  grid.held = card.text(6);
  grid.place = card.place();
  if (card.is_sound()) {
    bulk.grids.push_back(std::move(grid));
  }
}

void read_coordinate_system(NastranFields& card, NastranBulk& bulk) {
  NastranBulk::NastranSystem system;
  system.kind = card.name().back();
  system.place = card.place();
  const base::Label label = card.label(0, "CID");
  system.reference = card.label_or(1, "RID", 0);
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t i = 0; i < 3; ++i) {
      system.points[p][static_cast<Eigen::Index>(i)] =
          card.real_or(2 + 3 * p + i, "a point of the system", 0.0);
    }
  }
  if (card.is_sound() && !bulk.systems.try_emplace(label, system).second) {
    card.complain("there is a coordinate system of this number already");
  }
}

void read_element(NastranFields& card, const NastranElementEntry& entry, NastranBulk& bulk) {
  NastranBulk::NastranElement element;
  element.label = card.label(0, "EID");
  element.property = card.label_or(1, "PID", element.label);
  element.entry = &entry;
  element.first = bulk.connectivity.size();
  element.place = card.place();
  std::size_t middles = 0;
  for (std::size_t n = entry.corners; n < entry.nodes; ++n) {
    middles += card.label_or(2 + n, "a node", 0) > 0 ? 1U : 0U;
  }
  element.quadratic = middles > 0;
  if (card.is_sound() && element.quadratic && middles < entry.nodes - entry.corners) {
    card.complain("some of the nodes between corners are missing: all or none of them are read");
  }
  for (std::size_t n = 0; n < (element.quadratic ? entry.nodes : entry.corners); ++n) {
    bulk.connectivity.push_back(card.is_sound() ? card.label(2 + n, "a node") : 0);
  }
  for (std::size_t t = 10; t < 10 + entry.thicknesses; ++t) {
    element.own_thickness = element.own_thickness || !card.is_blank(t);
  }
  if (card.is_sound()) {
    bulk.elements.push_back(element);
  } else {
    bulk.connectivity.resize(element.first);
  }
}

void read_bar(NastranFields& card, NastranBulk& bulk) {
  NastranBulk::NastranBar bar;
  bar.label = card.label(0, "EID");
  bar.property = card.label_or(1, "PID", bar.label);
  bar.nodes = {card.label(2, "a node"), card.label(3, "a node")};
  bar.name = card.name();
  bar.place = card.place();
  if (card.is_sound()) {
    bulk.bars.push_back(std::move(bar));
  }
}

/// SET3, SID, GRID or ELEM, numbers; OptiStruct has SET, SID, GRID or ELEM, LIST, and the numbers
/// from its second line on. Lists of others are of no use here.
void read_list(NastranFields& card, NastranBulk& bulk) {
  const bool of_optistruct = card.name() == "SET";
  const std::string kind = upper_case(card.text(1));
  const std::string form = upper_case(card.text(2));
  if ((kind != "GRID" && kind != "ELEM") || (of_optistruct && !form.empty() && form != "LIST")) {
    return;
  }
  bulk.lists.push_back({card.label(0, "SID"), kind == "ELEM",
                        card.ranges(of_optistruct ? 8 : 2, "a number"), card.place()});
}

} // namespace

bool read_nastran_mesh_card(NastranFields& card, NastranBulk& bulk) {
  const std::string& name = card.name();
  if (name == "GRID") {
    read_grid(card, bulk);
  } else if (name == "GRDSET") {
    bulk.default_system = card.label_or(1, "CP", 0);
    bulk.default_directions = card.label_or(5, "CD", 0);
    bulk.default_held = card.text(6);
  } else if (name == "CORD2R" || name == "CORD2C" || name == "CORD2S") {
    read_coordinate_system(card, bulk);
  } else if (name == "CORD1R" || name == "CORD1C" || name == "CORD1S") {
    for (const std::size_t at : {0U, 4U}) { // two a line
      if (!card.is_blank(at)) {
        bulk.other_systems.try_emplace(card.label(at, "CID"), name);
      }
    }
  } else if (name == "SET3" || name == "SET") {
    read_list(card, bulk);
  } else if (const NastranElementEntry* entry = find_nastran_element(name)) {
    read_element(card, *entry, bulk);
  } else if (std::ranges::find(bar_entries, name) != bar_entries.end()) {
    read_bar(card, bulk);
  } else {
    return false;
  }
  return true;
}

} // namespace spricka::mesh
