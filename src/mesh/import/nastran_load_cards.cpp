// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_fields.hpp"
#include "mesh/set_name.hpp"

#include <algorithm>
#include <array>

namespace spricka::mesh {
namespace {

constexpr std::array<std::string_view, 29> load_entries{
    "SPC",    "SPC1",    "SPCADD", "SPCD",    "SUPORT",  "SUPORT1", "LOAD",   "FORCE",
    "FORCE1", "FORCE2",  "MOMENT", "MOMENT1", "MOMENT2", "PLOAD",   "PLOAD1", "PLOAD2",
    "PLOAD4", "PLOADX1", "GRAV",   "RFORCE",  "ACCEL",   "ACCEL1",  "TEMP",   "TEMPD",
    "TEMPP1", "TEMPRB",  "DEFORM", "BOLT",    "LSEQ"};

void read_single_supports(NastranFields& card, NastranBulk& bulk) {
  const base::Label set = card.label(0, "SID");
  for (const std::size_t at : {1U, 4U}) { // two a line
    if (at == 1 || !card.is_blank(at)) {
      const base::Label node = card.label(at, "a node");
      bulk.supports.push_back({set, std::string(card.text(at + 1)), {{node, node}}, card.place()});
    }
  }
}

void read_pressure(NastranFields& card, NastranBulk& bulk) {
  NastranBulk::NastranPressure pressure;
  pressure.set = card.label(0, "SID");
  const base::Label element = card.label(1, "EID");
  pressure.elements = {element, element};
  pressure.place = card.place();
  if (upper_case(card.text(6)) == "THRU") {
    pressure.elements.second = card.label(7, "EID2");
  } else {
    pressure.corner = card.label_or(6, "G1", 0);
    pressure.other = card.label_or(7, "G3 or G4", 0);
  }
  if (card.is_sound()) {
    bulk.pressures.push_back(pressure);
  }
}

} // namespace

bool read_nastran_load_card(NastranFields& card, NastranBulk& bulk) {
  const std::string& name = card.name();
  if (std::ranges::find(load_entries, name) == load_entries.end()) {
    return false;
  }
  bulk.loads[name].add(card.place());
  if (name == "SPC") {
    read_single_supports(card, bulk);
  } else if (name == "SPC1") {
    bulk.supports.push_back(
        {card.label(0, "SID"), std::string(card.text(1)), card.ranges(2, "a node"), card.place()});
  } else if (name == "SPCADD") {
    const base::Label set = card.label(0, "SID");
    for (const auto& [first, last] : card.ranges(1, "a set")) {
      for (base::Label part = first; part <= last && part - first < 1000; ++part) {
        bulk.support_sums[set].push_back(part);
      }
    }
  } else if (name == "PLOAD4") {
    read_pressure(card, bulk);
  } else if (name == "FORCE") {
    bulk.forces.push_back({card.label(0, "SID"), card.label(1, "G"), card.place()});
  }
  return true;
}

} // namespace spricka::mesh
