// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/contacts.hpp"
#include "model/forward.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/svg.hpp"

#include <string>
#include <utility>
#include <vector>

namespace spricka::report {

/// A window onto a plane mesh. Curved edges are drawn as the parabolas they are; edges of one
/// element only, outlines and crack faces, are heavy.
struct MeshView {
  const model::Mesh* mesh = nullptr;
  std::string id; ///< unique on the page
  std::string title;
  DrawingPoint low; ///< the window's corners [length]
  DrawingPoint high;
  base::NetId net;                 ///< the only net to be drawn; invalid: all
  const base::Vector* u = nullptr; ///< displacements to add; null: none
  double magnify = 1.0;
  base::Vec2 rest = base::Vec2::Zero(); ///< the displacement that stays where it is
  std::vector<std::pair<DrawingPoint, std::string>> labels;
  std::vector<model::RigidTarget> rigids; ///< targets to be drawn
  const model::Model* marks = nullptr; ///< its supports, loads and contacts are shown; null: none
  /// Colours in the place of tints and inner edges, with their legend below the picture.
  std::vector<double> field; ///< [connectivity index] values; empty: none
  ColourScale scale;
  std::string field_words; ///< "von Mises, MPa"
  std::string length_name;
  double width = 320.0; ///< [px]
};

/// The picture of a plane mesh as SVG: areas, edges, rigid targets, marks and legend.
std::string draw_svg(const MeshView& view);

} // namespace spricka::report
