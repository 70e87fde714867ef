// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <array>
#include <string>
#include <vector>

namespace spricka::mesh {

// What a STEP file holds and how it is meshed, as spricka and the mesher say it to each other: in
// millimetres, to which OpenCASCADE converts. Solids, and the faces of each, count from 0.

struct StepFace {
  int entity = 0;      ///< gmsh's number; two solids that share a face have the same
  std::string kind;    ///< "plane", "cylinder", "cone", "sphere", "torus" or "curved"
  double radius = 0.0; ///< of a cylinder or a sphere, else 0
  bool hollow = false; ///< of these: the solid lies outside of it, as round a bore
  base::Vec3 direction = base::Vec3::Zero(); ///< outward normal of a plane, axis of a cylinder
  double area = 0.0;
  base::Vec3 centre = base::Vec3::Zero(); ///< of its area
  std::vector<base::Vec3> points;         ///< of its edges and its inside
};

struct StepSolid {
  std::string name; ///< of the part in the file; empty: it has none of its own
  double volume = 0.0;
  base::Vec3 low = base::Vec3::Zero(); ///< of the box about it
  base::Vec3 high = base::Vec3::Zero();
  std::vector<StepFace> faces;
};

struct StepFileContents {
  std::vector<StepSolid> solids;
  int free_faces = 0;                        ///< of no solid
  std::vector<std::string> errors, warnings; ///< gmsh's words
  bool gave_up = false;                      ///< gmsh threw something
};

/// A set of the mesh: a solid, or some faces.
struct StepMeshGroup {
  std::string name;
  int solid = -1;                        ///< none: of faces
  std::vector<std::array<int, 2>> faces; ///< solid and face
  double size = 0.0;                     ///< of the elements on the faces; 0: as elsewhere
};

struct StepMeshRequest {
  std::vector<int> solids; ///< which are meshed
  double size = 0.0;       ///< of the elements
  double finer = 1.0;      ///< elements of round faces are smaller by it; sizes have it in them
  std::vector<StepMeshGroup> groups;

  /// Elements in one turn of a round face, times `finer`, where `size` would make fewer of them ..
  static constexpr double elements_in_a_turn = 12.0;
  /// .. but for that none is smaller than this part of `size`.
  static constexpr double smallest_part = 0.1;
};

} // namespace spricka::mesh
