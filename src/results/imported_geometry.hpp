// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "results/script_constant.hpp"

#include <string>
#include <vector>

namespace spricka::results {

/// A solid of a STEP file; lengths in those of the deck.
struct ReportedSolid {
  std::string file; ///< without its folder
  int number = 0;   ///< in the file, from 1
  std::string name;
  double volume = 0.0;
  base::Vec3 low = base::Vec3::Zero(); ///< of the box about it
  base::Vec3 high = base::Vec3::Zero();
  std::vector<std::string> sets; ///< of its elements; empty: it is not meshed
};

/// A face of a solid that is meshed; lengths in those of the deck.
struct ReportedSolidFace {
  std::vector<std::string> sets;             ///< all that it belongs to, its number first
  std::string kind;                          ///< "cylinder, bore"
  double radius = 0.0;                       ///< of a cylinder or sphere, else 0
  base::Vec3 direction = base::Vec3::Zero(); ///< outward normal of a plane, axis; zero: of none
  double area = 0.0;
  base::Vec3 centre = base::Vec3::Zero();
};

/// What there is to tell of the geometries that a deck imports.
struct ReportedGeometry {
  std::vector<ReportedScriptConstant> scripts;
  std::vector<ReportedSolid> solids;
  std::vector<ReportedSolidFace> faces;
};

} // namespace spricka::results
