// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_fields.hpp"
#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::mesh {
namespace {

constexpr std::array<std::string_view, 8> bar_property_entries{"PBAR",   "PBARL", "PBEAM", "PBEAML",
                                                               "PBCOMP", "PBEND", "PROD",  "PTUBE"};
/// Of elements that are refused themselves, where there are any.
constexpr std::array<std::string_view, 8> spring_property_entries{
    "PELAS", "PELAST", "PBUSH", "PBUSHT", "PBUSH1D", "PDAMP", "PGAP", "PFAST"};

void add_property(NastranFields& card, base::Label label,
                  const NastranBulk::NastranProperty& property, NastranBulk& bulk) {
  if (card.is_sound() && !bulk.properties.try_emplace(label, property).second) {
    card.complain(fmt::format("there is a property {} already", label));
  }
}

void read_shell_property(NastranFields& card, NastranBulk& bulk) {
  NastranBulk::NastranProperty property;
  property.shell = true;
  property.place = card.place();
  const base::Label label = card.label(0, "PID");
  property.material = card.label_or(1, "MID1", 0);
  property.thickness = card.real_or(2, "T", 0.0);
  property.plane_strain = card.text(3) == "-1"; // MID2
  add_property(card, label, property, bulk);
}

void read_solid_property(NastranFields& card, NastranBulk& bulk) {
  NastranBulk::NastranProperty property;
  property.place = card.place();
  const base::Label label = card.label(0, "PID");
  property.material = card.label(1, "MID");
  if (upper_case(card.text(6)) == "PFLUID") {
    card.complain("fluids (PFLUID) are not imported");
  }
  add_property(card, label, property, bulk);
}

void read_material(NastranFields& card, NastranBulk& bulk) {
  NastranBulk::NastranMaterial material;
  material.place = card.place();
  const base::Label label = card.label(0, "MID");
  material.E = card.real_or(1, "E", 0.0);
  const double shear = card.real_or(2, "G", 0.0);
  material.nu = card.real_or(3, "NU", 0.0);
  material.rho = card.real_or(4, "RHO", 0.0);
  material.alpha = card.real_or(5, "A", 0.0);
  if (!card.is_sound()) {
    return;
  }
  const int given = 3 - static_cast<int>(card.is_blank(1)) - static_cast<int>(card.is_blank(2)) -
                    static_cast<int>(card.is_blank(3));
  if (given == 0) { // Femap writes such for materials that nobody filled in
    bulk.empty_materials.insert(label);
    return;
  }
  if (given < 2) {
    card.complain("two of E, G and NU are needed");
  } else if (card.is_blank(1)) {
    material.E = 2.0 * (1.0 + material.nu) * shear;
  } else if (card.is_blank(3)) {
    material.nu = shear > 0.0 ? material.E / (2.0 * shear) - 1.0 : -1.0;
  } else if (given == 3 &&
             std::abs(2.0 * (1.0 + material.nu) * shear - material.E) > 0.01 * material.E) {
    card.complain(fmt::format("E = {}, G = {} and NU = {} do not fit: an isotropic material has E "
                              "= 2 (1 + NU) G; leave one of them blank",
                              material.E, shear, material.nu));
  }
  if (card.is_sound() && !(material.E > 0.0 && material.nu > -1.0 && material.nu < 0.5)) {
    card.complain("E is positive and Poisson's ratio between -1 and 0.5");
  }
  if (card.is_sound() && !bulk.materials.try_emplace(label, material).second) {
    card.complain(fmt::format("there is a material {} already", label));
  }
}

} // namespace

bool read_nastran_property_card(NastranFields& card, NastranBulk& bulk) {
  const std::string& name = card.name();
  if (name == "PSHELL") {
    read_shell_property(card, bulk);
  } else if (name == "PSOLID") {
    read_solid_property(card, bulk);
  } else if (name == "MAT1") {
    read_material(card, bulk);
  } else if (name == "PARAM") {
    if (upper_case(card.text(0)) == "WTMASS") {
      bulk.density_factor = card.real_or(1, "WTMASS", 1.0);
    }
  } else if (std::ranges::find(bar_property_entries, name) != bar_property_entries.end()) {
    bulk.bar_properties.insert(card.label(0, "PID"));
  } else {
    return std::ranges::find(spring_property_entries, name) != spring_property_entries.end();
  }
  return true;
}

} // namespace spricka::mesh
