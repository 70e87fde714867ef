// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"
#include "base/vec.hpp"

#include <optional>
#include <string>
#include <vector>

/// Cracks, the nets round their tips and how K is taken.
namespace spricka::model {

/// In the plane along a path of nodes or free; in space a front of nodes, an ellipse, or a front
/// drawn by its points.
enum class CrackDefinitionKind { path, free, front, ellipse, drawn };
enum class CrackTipPlaneState { stress, strain, automatic };

/// Where a crack lies in space: its plane, and the part of it that it takes.
struct PlanarCrack {
  base::Vec3 place = base::Vec3::Zero();   ///< centre of the ellipse; of a drawn one a point in it
  base::Vec3 normal = base::Vec3::UnitY(); ///< unit, from its lower face to its upper
  base::Vec3 along = base::Vec3::UnitX();  ///< unit, of the semi-axis c; angles count from it
  double a = 0.0;                          ///< semi-axis across, along normal x along [length]
  double c = 0.0;                          ///< the other one
  bool closed = false;                     ///< drawn: the last point joins the first

  [[nodiscard]] base::Vec3 transverse_axis() const;
  /// The point of the ellipse at a parametric angle `phi` [rad], 0 at the end of `along`.
  [[nodiscard]] base::Vec3 ellipse_point(double phi) const;
};

/// What a crack in space has left behind where it has turned out of its plane: ruled strips between
/// the fronts it has had.
struct FrontHistory {
  /// [front][point] The first lies in the plane, the last is the present one. Closed ones end with
  /// their first point, open ones outside of the body.
  std::vector<std::vector<base::Vec3>> fronts;
  std::vector<base::Vec3> normals; ///< [point of the last front] b there, unit
};

struct CrackDefinition {
  std::string name;
  CrackDefinitionKind kind = CrackDefinitionKind::path;
  base::NodeSetId path; ///< ordered nodes: from the mouth (path), of the front (front)
  /// In the plane, of a crack that the mesh has already: the nodes of its right face, as many as
  /// `path`, which is the left one; the tip is on both.
  std::vector<base::NodeId> right_face_nodes = {};
  base::NetId net;                 ///< the net a free crack cuts
  std::vector<base::Vec3> points;  ///< free crack: from the mouth (or first tip) on; drawn: front
  bool smooth = false;             ///< free or drawn: a smooth curve through the points
  std::optional<double> angle;     ///< free crack with one point [rad], from +x
  std::optional<double> a0;        ///< first length [length]
  PlanarCrack plane;               ///< in space, as it began
  FrontHistory front_history = {}; ///< empty: all of it lies in that plane
  CrackTipPlaneState state = CrackTipPlaneState::automatic;
  bool faces_in_contact = true;
  double mu = 0.0;
  /// Its crack faces, "C1.LEFT" and "C1.RIGHT", seen along the crack: empty in the host, filled in
  /// the mesh of each length. One of them stays empty on a symmetry line.
  base::FaceSetId left, right;
  base::SourceSpan span;

  /// Whether it is a line in the plane; in space a crack is given by its front.
  [[nodiscard]] bool is_line() const {
    return kind == CrackDefinitionKind::path || kind == CrackDefinitionKind::free;
  }
  /// Whether the deck's own mesh has it already.
  [[nodiscard]] bool is_in_mesh() const {
    return kind == CrackDefinitionKind::front || !right_face_nodes.empty();
  }
};

enum class PatchCoupling { conforming, transition };

/// How the patch round a tip is made; what is empty follows the crack (see mesh/cut/patch.hpp).
struct TipMeshSettings {
  base::CrackId crack;
  std::optional<double> radius; ///< of the rosette [length]
  std::optional<double> size;   ///< of the tip elements [length]
  int rings = 5;
  int sectors = 24;         ///< of a full circle
  bool sizes_given = false; ///< the deck has SIZE, RINGS or SECTORS
  bool quarter_point = true;
  PatchCoupling join = PatchCoupling::conforming;
  bool patch = true;
  bool tube = true;                ///< in space; false: tetrahedra up to the front
  std::optional<double> tolerance; ///< of K, as a part of it
  double finer = 1.0;              ///< divides the sizes of the patch's elements
  base::SourceSpan span;
};

struct VirtualCrackExtensionSettings {
  base::CrackId crack;
  std::optional<double> shift; ///< finite shift in tip element sizes; empty: analytic derivative
  std::vector<int> domains;    ///< rings that move rigidly, one value of K each; empty: default
  bool opening = false;        ///< K from the opening of the faces beside it, as a check
  base::SourceSpan span;
};

} // namespace spricka::model
