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
    InpPlace place;
  };
  struct SideOf {
    std::string elements; ///< a set, or empty
    base::Label element = 0;
    int side = 0;
    InpPlace place;
  };
  struct Section {
    std::string elements, material;
    double thickness = 1.0;
    InpPlace place;
  };
  struct Equation {
    struct Term {
      base::Label node = 0;
      int dof = 0; ///< from 0
      double coefficient = 0.0;
    };
    std::vector<Term> terms;
    InpPlace place;
  };
  struct Material {
    std::string name;
    double E = 0.0, nu = 0.0, rho = 0.0, alpha = 0.0;
    bool elastic = false;
    InpPlace place;
  };

  std::vector<base::Label> node; ///< numbers, in the order of the file
  std::vector<base::Vec3> x;

  std::vector<base::Label> element;
  std::vector<InpElement> type;
  std::vector<InpPlace> element_place;
  std::vector<std::size_t> first{0}; ///< [element + 1] into `connectivity`
  std::vector<base::Label> connectivity;

  std::vector<Named<base::Label>> node_sets;
  std::vector<Named<base::Label>> element_sets;
  std::vector<Named<SideOf>> surfaces;
  std::vector<Material> materials;
  std::vector<Section> sections;
  std::vector<Equation> equations;
  std::vector<std::string> files;          ///< paths, for places
  std::map<std::string, InpPlace> special; ///< element names taken in full integration instead
  /// Passed over, by name: bars (T3D3), and keywords of loads where that is wished.
  struct LeftOut {
    InpPlace first;
    std::size_t count = 0;
  };
  std::map<std::string, LeftOut> bars, keywords;
  std::unordered_set<base::Label> bar; ///< their numbers
};

/// Something wrong or not understood.
struct InpComplaint {
  InpPlace place;
  std::string text;
  std::string hint;
};

} // namespace spricka::mesh
