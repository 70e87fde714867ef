// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/triangle.hpp"
#include "mesh/boundary.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/surface/surface_geometry.hpp"
#include "mesh/tube/set_use.hpp"
#include "model/mesh.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spricka::mesh {

/// Borders of which sets are edges of a surface.
enum class SetBorderPreservation {
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
  [[nodiscard]] const SurfaceGeometry&
  geometry(SetBorderPreservation borders = SetBorderPreservation::all) const;
  /// Names of the sets of the geometries; empty for those of single cards.
  [[nodiscard]] const std::string& name_of_surface_face_set(std::size_t set) const {
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

/// A mesh of solids with its neighbourhoods, for cuts: made once, good for any number of cracks.
/// Elements that hang together by faces and have one property are a part; what a part ends at
/// (surface of the body, other properties) is its skin.
class SolidHostMesh : public HostMesh {
public:
  /// By default all sets are used and none is held.
  SolidHostMesh(const model::Mesh& mesh, SetUsage use = {});

  [[nodiscard]] const SetUsage& set_usage() const { return use_; }
  [[nodiscard]] std::size_t property_part_index(base::ElementId e) const {
    return part_[e.index()];
  }
  /// Elements of a part, ascending.
  [[nodiscard]] const std::vector<base::ElementId>& property_part_elements(std::size_t part) const {
    return members_[part];
  }
  [[nodiscard]] const geometry::TriangleTree& skin_tree(std::size_t part) const {
    return skin_[part];
  }
  /// Where a part meets others.
  [[nodiscard]] const geometry::TriangleTree& interface_tree(std::size_t part) const {
    return border_[part];
  }
  /// The surface of the body, of whatever parts, that an element belongs to. Made when first asked
  /// for, by one thread at a time.
  [[nodiscard]] const BodySurface& body_surface(base::ElementId e) const;

  /// A ball that holds the nodes of an element, and its longest edge.
  struct ElementBoundingBall {
    base::Vec3 middle = base::Vec3::Zero();
    double radius = 0.0;
    double edge = 0.0;
  };
  [[nodiscard]] const ElementBoundingBall& bounding_ball(base::ElementId e) const {
    return extent_[e.index()];
  }

  /// The element of a net (any: invalid) that a place lies in; empty outside of all.
  [[nodiscard]] std::optional<base::ElementId> find_element_at(const base::Vec3& x,
                                                               base::NetId net) const;

  /// Of some elements the first that a place lies in, else the one it is least outside of, by that
  /// element's own coordinates.
  [[nodiscard]] base::ElementId nearest_element(std::span<const base::ElementId> elements,
                                                const base::Vec3& x) const;

private:
  void find_parts();
  void find_skins();
  void find_extents();

  SetUsage use_;
  std::vector<std::size_t> part_; ///< [element]
  std::vector<std::vector<base::ElementId>> members_;
  std::vector<geometry::TriangleTree> skin_;   ///< [part]
  std::vector<geometry::TriangleTree> border_; ///< [part]
  /// [part] that of its body
  mutable std::vector<std::shared_ptr<const BodySurface>> surface_;
  std::vector<ElementBoundingBall> extent_; ///< [element]
};

/// How far a place lies outside of an element, in its own coordinates; at most 0 inside.
double distance_outside(const model::Mesh& mesh, base::ElementId e, const base::Vec3& x);

/// Triangles between all nodes of a face: its shape, for distances.
void add_face_triangles(const model::Mesh& mesh, const model::Face& face,
                        std::vector<geometry::CornerPlaces>& triangles);

} // namespace spricka::mesh
