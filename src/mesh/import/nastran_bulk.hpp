// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/label.hpp"
#include "base/vec.hpp"
#include "mesh/import/nastran_elements.hpp"
#include "mesh/import/nested_text_files.hpp"

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Something wrong, or entries that are not understood.
struct NastranIssue {
  InpLocation place;
  std::string text;
  std::string hint;
};

/// Entries of one kind.
struct NastranEntries {
  InpLocation first;
  std::size_t count = 0;

  void add(InpLocation at) { first = count++ == 0 ? at : first; }
};

/// What bulk data say that is imported, as it is written: numbers of entries, nothing looked up.
struct NastranBulk {
  static constexpr base::Label blank = -1; ///< a field that GRDSET may fill

  struct NastranGrid {
    base::Label label = 0;
    base::Label system = blank; ///< of the coordinates
    base::Vec3 x;
    std::string held;               ///< PS, digits of freedoms
    base::Label directions = blank; ///< of the freedoms, by the number of a system: CD
    InpLocation place;
  };
  struct NastranSystem {
    char kind = 'R'; ///< rectangular, C: cylindrical, S: spherical
    base::Label reference = 0;
    std::array<base::Vec3, 3> points; ///< origin, on the z axis, in the x-z plane
    InpLocation place;
  };
  struct NastranElement {
    base::Label label = 0, property = 0;
    const NastranElementEntry* entry = nullptr;
    bool quadratic = false;
    bool own_thickness = false;
    std::size_t first = 0; ///< into `connectivity`, in Nastran's order
    InpLocation place;
  };
  struct NastranBar {
    base::Label label = 0, property = 0;
    std::array<base::Label, 2> nodes{};
    std::string name;
    InpLocation place;
  };
  struct NastranProperty {
    bool shell = false;
    bool plane_strain = false;
    base::Label material = 0; ///< 0: none
    double thickness = 0.0;
    InpLocation place;
  };
  struct NastranMaterial {
    double E = 0.0, nu = 0.0, rho = 0.0, alpha = 0.0;
    InpLocation place;
  };
  using LabelRange = std::pair<base::Label, base::Label>; ///< both are in it
  struct NastranSupport {
    base::Label set = 0;
    std::string freedoms;
    std::vector<LabelRange> nodes;
    InpLocation place;
  };
  struct NastranPressure {
    base::Label set = 0;
    LabelRange elements;
    base::Label corner = 0, other = 0; ///< 0: not given; the other of a face, or off it
    InpLocation place;
  };
  struct NastranList {
    base::Label set = 0;
    bool elements = false; ///< else nodes
    std::vector<LabelRange> members;
    InpLocation place;
  };
  struct NastranForce {
    base::Label set = 0, node = 0;
    InpLocation place;
  };

  std::vector<NastranGrid> grids;
  base::Label default_system = 0; ///< by GRDSET
  std::string default_held;
  base::Label default_directions = 0;
  std::map<base::Label, NastranSystem> systems;
  std::map<base::Label, std::string> other_systems; ///< CORD1R .. by number

  std::vector<NastranElement> elements;
  std::vector<base::Label> connectivity;
  std::vector<NastranBar> bars;
  std::set<base::Label> bar_properties;

  std::map<base::Label, NastranProperty> properties;
  std::map<base::Label, std::string> property_names;
  std::map<base::Label, NastranMaterial> materials;
  std::set<base::Label> empty_materials; ///< without any constant: the deck gives the properties
  double density_factor = 1.0;           ///< PARAM,WTMASS

  std::vector<NastranSupport> supports;
  std::map<base::Label, std::vector<base::Label>> support_sums; ///< SPCADD
  std::vector<NastranList> lists;                               ///< SET3, and SET of OptiStruct
  std::map<base::Label, std::string> set_names;
  std::vector<NastranPressure> pressures;
  std::vector<NastranForce> forces;

  std::map<std::string, NastranEntries> loads;   ///< entries of supports and loads
  std::map<std::string, NastranEntries> refused; ///< all others that are not read
  std::vector<std::string> files;                ///< paths, for places
};

} // namespace spricka::mesh
