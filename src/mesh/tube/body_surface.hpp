// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_geometry.hpp"
#include "mesh/tube/set_use.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace spricka::mesh {

/// Borders of which sets are edges of a surface.
enum class KeptSetBorders {
  all,
  used, ///< sets that something asks for
  none, ///< sharp edges only
};

/// The surface of one body of a mesh, other bodies left out. Borders of all face sets, and of what
/// node sets have of the surface in whole faces, are edges of it, so that what is meshed anew
/// belongs to the same sets; so are edges that only nodes are held of.
class BodySurface {
public:
  BodySurface(const model::Mesh& mesh, const std::vector<base::ElementId>& elements,
              const SetUsage& use);

  /// With fewer borders where a crack leaves no room for all. Made when first asked for, by one
  /// thread at a time. Faces have the same numbers in all of them, sets in `all` and `none`.
  [[nodiscard]] const SurfaceGeometry& geometry(KeptSetBorders borders = KeptSetBorders::all) const;
  /// Names of the sets of the geometries; empty for those of single cards.
  [[nodiscard]] const std::string& face_set_name(std::size_t set) const {
    return body_.face_sets[set].name;
  }
  [[nodiscard]] bool is_face_set_used(std::size_t set) const { return used_[set]; }
  /// The number of a face of the mesh in the geometry; `nowhere` if it is none of its surface.
  [[nodiscard]] std::size_t face_index(const model::Face& face) const;
  /// The face of the mesh with a number of the geometry.
  [[nodiscard]] model::Face face(std::size_t index) const;

private:
  void add_face_sets(const model::Mesh& mesh, const SetUsage& use);
  void add_node_sets(const model::Mesh& mesh, const SetUsage& use);
  std::vector<base::ElementId> elements_; ///< [number in the geometry]
  std::vector<std::int32_t> number_;      ///< [element] or -1
  model::Mesh body_;                      ///< with face sets for all sets
  std::vector<bool> used_;                ///< [set of body_]
  std::vector<base::FaceSetId> kept_;
  std::vector<base::NodeSetId> lines_;
  mutable std::array<std::optional<SurfaceGeometry>, 3> geometry_; ///< [borders]
};

} // namespace spricka::mesh
