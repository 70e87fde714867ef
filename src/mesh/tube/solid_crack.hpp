// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/triangle.hpp"
#include "mesh/cut/crack_frame.hpp"
#include "mesh/cut/cracked.hpp"
#include "mesh/surface/crack_relief.hpp"
#include "model/forward.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spricka::model {
struct CrackDefinition;
}

/// A crack that is to be cut into a mesh of solids: its front, its frame, its areas of a plane, and
/// the points of the front after the cut.
namespace spricka::mesh {

/// A crack in space of one size, before it is cut: what its front encloses of a plane, inside the
/// body, or of what it has made of that plane as it turned. Where the front leaves the body the
/// crack has a mouth.
struct SolidCrack {
  base::CrackId crack;
  base::NetId net;
  base::Vec3 normal = base::Vec3::UnitZ(); ///< b, unit; of one that has turned that of its plane
  /// Dense points of the front in the order of t = m x b, m pointing out of the crack. A closed one
  /// (first point not repeated) may lie partly outside of the body: the arcs inside are fronts. An
  /// open one starts and ends outside or on the surface.
  std::vector<base::Vec3> front;
  bool closed = true;
  std::string name;                                         ///< for messages
  std::shared_ptr<const NonPlanarCrackSurface> relief = {}; ///< of one that has turned
  /// The middle of an ellipse. Parts of the body that it lies in or at have the crack; with none of
  /// them all that the ellipse reaches.
  std::optional<base::Vec3> middle = {};

  /// The crack's normals b at points of its front.
  [[nodiscard]] std::vector<base::Vec3> normals_at(const std::vector<base::Vec3>& points) const;

  [[nodiscard]] std::string display_name() const;
};

/// The cracks of a deck in space, ready to be cut. [crack]
std::vector<SolidCrack> make_solid_cracks(const model::Model& model);

/// Parametric angle of a place on the front of an ellipse, from its axis C [rad], -pi .. pi.
double ellipse_parametric_angle(const model::CrackDefinition& crack, const base::Vec3& x);

/// How to mesh round a front; what is 0 follows the front (lengths in deck units).
struct TubeMeshParameters {
  double radius = 0.0; ///< of the tube
  double size = 0.0;   ///< radial length of the elements at the front
  double length = 0.0; ///< of elements along the front
  int rings = 3;       ///< rings of elements in the tube, that at the front included
  int sectors = 8;     ///< of a full circle
  bool quarter_point = true;
  bool tube = true;   ///< false: tetrahedra with the front as edges; `radius` is that of even sizes
  double finer = 1.0; ///< divides all sizes, and their growth with the distance outside the tube
  /// How sizes grow with the distance from the tube, for each unit of length. 0.3 holds K as the
  /// mesh has it to 0.5 %; where its estimated error is taken out of it wide_growth is enough.
  double growth = usual_growth;
  static constexpr double usual_growth = 0.3;
  static constexpr double wide_growth = 0.5;
};

/// Frame of a crack in space. Of an open front the area between it and the chord of its ends
/// counts; of a straight one a quarter of its length stands for the radius.
CrackFrame make_crack_frame(const SolidCrack& crack);

/// What a crack has made of its plane, in a frame; empty: it has not turned.
std::shared_ptr<const NonPlanarCrackSurface>
nonplanar_crack_surface_in_frame(const CrackFrame& frame, const SolidCrack& crack);

/// A plane in space with coordinates, (u, v) of places on it, and what a crack has made of it.
struct PlaneBasis {
  base::Vec3 origin = base::Vec3::Zero();
  base::Vec3 u = base::Vec3::UnitX();
  base::Vec3 v = base::Vec3::UnitY();
  base::Vec3 normal = base::Vec3::UnitZ();
  std::shared_ptr<const NonPlanarCrackSurface> relief =
      {}; ///< of a crack that has turned out of it

  [[nodiscard]] base::Vec2 project(const base::Vec3& p) const {
    return {u.dot(p - origin), v.dot(p - origin)};
  }
  /// Along the normal, above the crack.
  [[nodiscard]] double height_over_crack(const base::Vec3& p) const {
    return relief ? -relief->crack_height_over_plane(p) : normal.dot(p - origin);
  }
  /// On the crack.
  [[nodiscard]] base::Vec3 lift_to_crack(const base::Vec2& q) const {
    const base::Vec3 p = origin + q.x() * u + q.y() * v;
    return relief ? base::Vec3(p + relief->crack_height_over_plane(p) * normal) : p;
  }
};

/// Areas of a plane, within closed polygons; those within others are holes.
class PlanePolygons {
public:
  PlanePolygons(const PlaneBasis& plane, const std::vector<std::vector<base::Vec3>>& outlines);
  /// In the plane of a crack.
  PlanePolygons(const SolidCrack& crack, const std::vector<std::vector<base::Vec3>>& outlines);

  [[nodiscard]] const PlaneBasis& plane() const { return plane_; }
  [[nodiscard]] const std::vector<std::vector<base::Vec2>>& outlines() const { return outlines_; }
  [[nodiscard]] bool contains(const base::Vec2& q) const;
  [[nodiscard]] double area() const; ///< without holes
  /// Of a place in space from the areas; of a place in the plane from their outlines.
  [[nodiscard]] double distance(const base::Vec3& x) const;
  [[nodiscard]] double distance_to_outlines(const base::Vec2& q) const;
  /// Whether a place of the plane lies within the areas, farther than `rim` from their outlines.
  [[nodiscard]] bool is_well_within(const base::Vec2& q, double rim) const {
    return contains(q) && distance_to_outlines(q) > rim;
  }
  /// Places along the line in which a triangle cuts the plane; empty: it does not.
  [[nodiscard]] std::vector<base::Vec3>
  intersect_plane_with_triangle(const geometry::CornerPlaces& triangle) const;
  /// Where the line from q along d leaves the areas, as a multiple of d; of the first that is not
  /// at q. Empty: it does not.
  [[nodiscard]] std::optional<double> exit_multiple_of_direction(const base::Vec2& q,
                                                                 const base::Vec2& d) const;

private:
  PlaneBasis plane_;
  std::vector<std::vector<base::Vec2>> outlines_;
};

/// The front as smooth as its elements have it: the spline through its points, near the ends of an
/// open one through those that lie half a radius of the tube or more apart. What is shorter than
/// that in a front as it was drawn or grown, elements round it do not follow, and the axes along it
/// would waver from it all over the domains.
std::shared_ptr<const FrontCurve> fit_front_curve(const CrackFront& front, const SolidCrack& crack);

/// Places, growth directions, s and weights of points whose nodes or curve have been moved.
void recompute_front_point_geometry(const model::Mesh& mesh, CrackFront& front);

} // namespace spricka::mesh
