// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "contact/space/box_tree.hpp"
#include "contact/space/solid_face.hpp"
#include "model/mesh.hpp"

#include <array>
#include <optional>
#include <vector>

/// The boundary of a body in space as triangles, to ask whether points lie inside.
namespace spricka::contact {

/// The nearest place of a hull.
struct TriangulationDistance {
  double distance = 0.0; ///< negative inside the body [length]
  double facet = 0.0;    ///< how far the triangles may leave the curved face there [length]
};

class BoundaryTriangulation {
public:
  /// The sides `faces` of a body, moved by u [3 * node] [length]; empty: as drawn. Each face is cut
  /// into the triangles between its nodes.
  BoundaryTriangulation(const model::Mesh& mesh, const std::vector<model::Face>& faces,
                        const base::Vector& u);

  /// The nearest place no further off than `reach`, if there is one. Inside and outside are told by
  /// the normals of all triangles that meet there, each by its angle (Baerentzen and Aanaes 2005).
  [[nodiscard]] std::optional<TriangulationDistance> signed_distance(const Vec3& x,
                                                                     double reach) const;
  [[nodiscard]] const Vec3& lower_corner() const { return low_; } ///< corners of the bounding box
  [[nodiscard]] const Vec3& upper_corner() const { return high_; }

private:
  struct BoundaryTriangle {
    std::array<Vec3, 3> x{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; ///< corners
    Vec3 normal = Vec3::Zero();                                      ///< unit
    std::array<Vec3, 3> at_corner{normal, normal, normal}; ///< sums of normals that meet there
    std::array<Vec3, 3> at_side{normal, normal, normal};   ///< side i from corner i to the next
    double rise = 0.0; ///< what a smooth face may rise above the triangle [length]
  };
  [[nodiscard]] std::optional<TriangulationDistance> nearest_within(const Vec3& x,
                                                                    double reach) const;
  void join(const std::vector<std::array<base::NodeId, 3>>& nodes);

  std::vector<BoundaryTriangle> pieces_;
  BoxTree tree_;
  double size_ = 0.0; ///< mean diagonal of the triangles' boxes
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
};

} // namespace spricka::contact
