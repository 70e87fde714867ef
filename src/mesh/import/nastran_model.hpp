// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "mesh/import/nastran_bulk.hpp"
#include "model/materials.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// An element of one dimension less than the parts: a shell on a solid, a bar on an edge.
struct NastranSkin {
  base::Label label = 0, property = 0;
  std::vector<base::Label> corners;
  std::string name;
  InpLocation place;
  bool lies_on_side = false; ///< found by add_nastran_surfaces
};

/// Bulk data as a model part; numbers of nodes and elements are those of the file.
struct NastranModel {
  struct NastranSet {
    std::string name;
    std::vector<base::Label> members;
    InpLocation place;
  };
  struct NastranSurface {
    std::string name;
    std::vector<std::pair<base::Label, int>> sides; ///< element, side from 0
    InpLocation place;
  };
  struct NastranSection {
    std::string elements; ///< a set
    std::string material;
    double thickness = 1.0;
    InpLocation place;
  };

  int dim = 2;
  std::vector<base::Label> node;
  std::vector<base::Vec3> x;
  std::vector<base::Label> element;
  std::vector<base::ElementType> type;
  std::vector<model::StressState> state;
  std::vector<InpLocation> element_place;
  std::vector<std::size_t> first{0}; ///< [element + 1] into `connectivity`
  std::vector<base::Label> connectivity;
  std::map<std::string, InpLocation> special; ///< entries that are no plain elements in Nastran
  std::vector<NastranSet> node_sets, element_sets;
  std::vector<NastranSurface> surfaces;
  std::vector<NastranSection> sections;

  std::map<std::string, NastranEntries> bars; ///< that are left out
  /// What lies on sides of the parts and carries load in the file: "CQUAD4 of property 5".
  std::vector<std::string> skins_with_stiffness;
  std::vector<NastranIssue> stray_skins; ///< those on no side: one for each property and entry
  std::vector<std::string> load_sets;    ///< where supports and loads act
};

} // namespace spricka::mesh
