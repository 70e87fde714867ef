// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"
#include "sense/section_plane.hpp"

#include <optional>
#include <string>
#include <vector>

/// Plane meshes that stand for solids: bodies that are the same all along an axis, or round it.
namespace spricka::sense {

struct PlaneSectionMesh {
  SectionPlane plane;
  /// Of the plane: nodes, elements, labels, nets and properties of the solid's faces there; sets
  /// under their old numbers, those that do not reach the section are empty.
  model::Mesh mesh;
  /// [face set] Whether it takes the whole thickness or angle, and none of the flat faces.
  std::vector<bool> whole;
  std::vector<bool> whole_elements; ///< [element set] the same
};

/// Sections of bodies that are the same along z, y or x from one flat face to another, all with the
/// same thickness: of a block three, mostly one or none.
std::vector<PlaneSectionMesh> find_extruded_sections(const model::Mesh& mesh);

/// Sections of bodies that are sectors of one angle about z, y or x through the origin.
std::vector<PlaneSectionMesh> find_revolved_sections(const model::Mesh& mesh);

/// The nodes of the section behind which (along the axis, or round it) nodes of space lie.
std::vector<base::NodeId> project_nodes_onto_section(const PlaneSectionMesh& section,
                                                     const model::Mesh& space,
                                                     const std::vector<base::NodeId>& nodes);

/// Where the line from a place inside of a net (any net: invalid) leaves the net first; empty:
/// nowhere.
std::optional<base::Vec3> find_line_exit_from_net(const model::Mesh& section, base::NetId net,
                                                  const base::Vec3& from,
                                                  const base::Vec3& through);

} // namespace spricka::sense
