// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/label.hpp"
#include "base/vec.hpp"
#include "mesh/import/inp_text.hpp"
#include "mesh/inp_elements.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <unordered_set>
#include <vector>

namespace spricka::mesh {

/// The model part of an input file as it is written: numbers and names, nothing looked up yet.
struct InpData {
  template <class T> struct Named {
    std::string name;
    std::vector<T> members;
    InpLocation place;
  };
  struct InpSurfaceSide {
    std::string elements; ///< a set, or empty
    base::Label element = 0;
    int side = 0;
    InpLocation place;
  };
  struct InpSection {
    std::string elements, material;
    double thickness = 1.0;
    InpLocation place;
  };
  struct InpEquation {
    struct InpEquationTerm {
      base::Label node = 0;
      int dof = 0; ///< from 0
      double coefficient = 0.0;
    };
    std::vector<InpEquationTerm> terms;
    InpLocation place;
  };
  struct InpMaterial {
    std::string name;
    double E = 0.0, nu = 0.0, rho = 0.0, alpha = 0.0;
    bool elastic = false;
    InpLocation place;
  };

  std::vector<base::Label> node; ///< numbers, in the order of the file
  std::vector<base::Vec3> x;

  std::vector<base::Label> element;
  std::vector<InpElementType> type;
  std::vector<InpLocation> element_place;
  std::vector<std::size_t> first{0}; ///< [element + 1] into `connectivity`
  std::vector<base::Label> connectivity;

  std::vector<Named<base::Label>> node_sets;
  std::vector<Named<base::Label>> element_sets;
  std::vector<Named<InpSurfaceSide>> surfaces;
  std::vector<InpMaterial> materials;
  std::vector<InpSection> sections;
  std::vector<InpEquation> equations;
  std::vector<std::string> files;             ///< paths, for places
  std::map<std::string, InpLocation> special; ///< element names taken in full integration instead
  /// Passed over, by name: bars (T3D3), and keywords of loads where that is wished.
  struct InpSkippedItems {
    InpLocation first;
    std::size_t count = 0;
  };
  std::map<std::string, InpSkippedItems> bars, keywords;
  std::unordered_set<base::Label> bar; ///< their numbers
};

/// Something wrong or not understood.
struct InpIssue {
  InpLocation place;
  std::string text;
  std::string hint;
};

} // namespace spricka::mesh
