// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/label.hpp"
#include "base/vec.hpp"
#include "mesh/import/inp_joint.hpp"
#include "mesh/import/inp_label_list.hpp"
#include "mesh/import/inp_text.hpp"
#include "mesh/inp_elements.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace spricka::mesh {

/// Something wrong or not understood, or a word about what is read.
struct InpIssue {
  InpLocation place;
  std::string text;
  std::string hint;
};

/// The model part of an input file as it is written: numbers and names, nothing looked up yet.
struct InpData {
  struct InpLabelSet {
    std::string name;
    InpLabelList members;
    std::vector<std::string> element_sets; ///< of a node set: the nodes of these, too
    InpLocation place;
  };
  struct InpSurfaceSide {
    std::string elements; ///< a set, or empty
    base::Label element = 0;
    std::optional<int> side; ///< from 0; empty: every free side, of a facet the facet itself
    InpLocation place;
  };
  struct InpSurface {
    std::string name;
    std::vector<InpSurfaceSide> members;
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
  /// An element that may lie on a side of others: a bar, a facet.
  struct InpSurfaceElement {
    base::Label label = 0;
    std::array<base::Label, 4> corner{}; ///< of a bar its nodes, the middle one second or last
    std::size_t corners = 0;             ///< 2 of a bar
    std::size_t type = 0;                ///< its place in `surface_types`
  };
  struct InpElementKind {
    std::string name;
    InpLocation first;
    std::size_t count = 0; ///< lines, where it is not known how many of them an element takes
  };
  /// Cards of one kind that are passed over.
  struct InpLeftOut {
    InpLocation first;
    std::size_t count = 0;
  };

  std::vector<base::Label> node; ///< numbers, in the order of the file
  std::vector<base::Vec3> x;

  std::vector<base::Label> element;
  std::vector<InpElementType> type;
  std::vector<InpLocation> element_place;
  std::vector<std::size_t> first{0}; ///< [element + 1] into `connectivity`
  std::vector<base::Label> connectivity;
  std::map<std::string, InpLocation> special; ///< element names taken in full integration instead

  std::vector<InpSurfaceElement> surface_elements;
  std::vector<InpElementKind> surface_types;
  std::vector<InpElementKind> connectors; ///< springs, masses ..; with SKIP=ALL
  std::vector<InpElementKind> unknown;
  InpLabelList connector; ///< their numbers

  std::vector<InpLabelSet> node_sets;
  std::vector<InpLabelSet> element_sets;
  std::vector<InpSurface> surfaces;
  std::vector<InpMaterial> materials;
  std::vector<InpSection> sections;
  std::vector<InpEquation> equations;
  InpJointCards joint; ///< with SKIP=ALL

  std::vector<std::string> files;             ///< paths, for places
  std::map<std::string, InpLeftOut> left_out; ///< by keyword, "TIE", or keyword and parameter
  std::vector<InpIssue> remarks;              ///< what is read otherwise than it may be meant
};

} // namespace spricka::mesh
