// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/contacts.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"
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
  std::vector<model::Face> crack_faces;   ///< sides drawn in the colour of the labels
  bool inner_edges = true;                ///< edges between elements are drawn
  std::vector<model::RigidTarget> rigids; ///< targets to be drawn
  const model::Model* marks = nullptr; ///< its supports, loads and contacts are shown; null: none
  /// Colours in the place of tints and inner edges, with their legend below the picture.
  std::vector<double> field; ///< [connectivity index] values; empty: none
  ColourScale scale;
  MeasureTitle field_title; ///< "von Mises, MPa"
  base::OutputUnit length;  ///< of the bar
  double width = 320.0;     ///< [px]
};

/// The most that a picture's window may take [px].
struct PictureLimits {
  double width = 660.0;
  double height = 480.0;
};

/// A view of a whole mesh and the model's rigid targets, with room for what stands beside bodies.
MeshView whole_mesh_view(const model::Model& model, const model::Mesh& mesh,
                         const PictureLimits& limits);

/// The picture of a plane mesh as SVG: areas, edges, rigid targets, marks and legend.
std::string draw_svg(const MeshView& view);

} // namespace spricka::report
