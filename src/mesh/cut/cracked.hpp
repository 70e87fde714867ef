// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/front_curve.hpp"
#include "model/mesh.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Cracks in meshes: a patch is cut out of the host and refilled round the crack, or nodes of the
/// deck's own mesh are doubled (PATCH=NO).
namespace spricka::mesh {

/// A crack of one length, as a polyline in the plane, mouth first, tip last. A crack along a
/// symmetry line is a half: the body lies on one side of it and only that side is meshed. Both ends
/// of an embedded crack are tips; its `a` is half its length.
struct CrackLine {
  base::CrackId crack;
  std::vector<base::Vec3> points; ///< [>= 2]; its length is a, or 2 a
  base::NetId net;
  bool embedded = false;          ///< starts inside the body
  bool symmetric_half = false;    ///< the line lies on the boundary, held by symmetry
  std::vector<base::NodeId> path; ///< kind path: the ordered host nodes it runs along
  /// Of a crack that the host has already: nodes of its right face, as many as `path`.
  std::vector<base::NodeId> right_face_nodes = {};
  std::string name; ///< for messages; empty: "crack 2" by its number

  [[nodiscard]] std::string display_name() const {
    return "crack " + (name.empty() ? std::to_string(crack.index() + 1) : name);
  }
};

/// How to mesh round one tip; all sizes in deck length, already chosen.
struct TipMeshParameters {
  double radius = 0.0; ///< of the rosette
  double size = 0.0;   ///< radial length of the tip elements
  int rings = 5;       ///< rings of elements in the rosette, tip ring included
  int sectors = 24;    ///< of a full circle
  bool quarter_point = true;
  bool patch = true; ///< false: double nodes of the deck's own mesh along the path
  /// The patch's rim is finer than the host's edges and tied to them (else edge to edge).
  bool transition = false;
  double finer = 1.0;   ///< divides sizes, and their growth, outside the rosette
  bool pressed = false; ///< the mouth lies on a contact surface, whose pressure peaks there
};

/// A node that takes the displacement of its place on an edge or a face: on the rim of a patch that
/// is finer than its host the place on the host's edge (ends and middle); the middle of the
/// diagonal where two triangles meet one quadrilateral; the nodes inside a quadrilateral where four
/// do.
struct HangingNodeTie {
  base::NodeId slave;
  std::vector<base::NodeId> master;
  std::vector<double> weight; ///< as many
  base::CrackId crack;
};

/// A point of a crack's front and the axes of the crack there.
struct FrontPoint {
  base::NodeId node;
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 growth = base::Vec3::Zero(); ///< unit, the way the crack grows
  // In space:
  double s = 0.0;          ///< length along the front from its first point
  double weight = 1.0;     ///< length of front that the point stands for, that of its linear hat
  double size = 0.0;       ///< radial length of the elements at the front, there
  double radius = 0.0;     ///< of the tube
  bool at_surface = false; ///< the front leaves the body there
};

/// Where a crack in space lies in its body.
enum class CrackConfiguration {
  embedded, ///< inside
  surface,  ///< one mouth on one smooth piece of the surface
  corner,   ///< one mouth across one edge of the body
  through,  ///< several mouths, or across several edges
};
inline const char* configuration_name(CrackConfiguration kind) {
  return kind == CrackConfiguration::embedded  ? "embedded"
         : kind == CrackConfiguration::surface ? "surface"
         : kind == CrackConfiguration::corner  ? "corner"
                                               : "through";
}

/// Where a front of a crack ended up in the mesh. K belongs to its points; in the plane there is
/// one, the tip, in space one for each corner node on the front, in the order of t = m x b.
struct CrackFront {
  base::CrackId crack;
  int number = 1;      ///< 1, or 1 and 2 of an embedded crack
  double a = 0.0;      ///< crack length, half of it if embedded
  double size = 0.0;   ///< radial length of the tip elements
  double radius = 0.0; ///< of the rosette
  bool symmetric_half = false;
  std::vector<FrontPoint> points{FrontPoint{}}; ///< along the front
  std::shared_ptr<const FrontCurve> curve;      ///< in space: the front, with the crack's axes
  CrackConfiguration kind = CrackConfiguration::embedded; ///< in space, of the whole crack

  /// Whether it is a front in the plane, of one point.
  [[nodiscard]] bool is_tip() const { return curve == nullptr; }
  /// The one point of a front in the plane.
  [[nodiscard]] const FrontPoint& tip_point() const { return points.front(); }
  [[nodiscard]] FrontPoint& tip_point() { return points.front(); }
};

/// The two faces of a crack by their nodes, the left one first, seen along the crack; of a
/// symmetric half the one that is meshed. In the plane their order is that along the crack, from
/// the mouth to the tip, which both have. In space the upper face, towards which b points, is the
/// left one; the nodes are in no order, those of the front on both.
struct CrackFaceNodes {
  std::vector<base::NodeId> left;
  std::vector<base::NodeId> right;                      ///< as many as left, where both are meshed
  std::vector<model::Face> left_sides{}, right_sides{}; ///< in space: element sides that make them

  /// Whether the cut has told which element sides make the faces.
  [[nodiscard]] bool has_sides() const { return !left_sides.empty() || !right_sides.empty(); }
  /// Whether one is the mirror image of the other and not meshed.
  [[nodiscard]] bool has_one_face() const { return left.empty() || right.empty(); }
  /// The face that is meshed, the left one of two.
  [[nodiscard]] const std::vector<base::NodeId>& meshed_face_nodes() const {
    return left.empty() ? right : left;
  }
  /// Nodes of both faces that lie on one another, left and right; not those that are one node.
  [[nodiscard]] std::vector<std::pair<base::NodeId, base::NodeId>> coincident_node_pairs() const {
    std::vector<std::pair<base::NodeId, base::NodeId>> pairs;
    for (std::size_t i = 0; i < left.size() && i < right.size(); ++i) {
      if (left[i] != right[i]) {
        pairs.emplace_back(left[i], right[i]);
      }
    }
    return pairs;
  }
};

/// A mesh with cracks in it. Host nodes keep their numbers (some may be left without an element);
/// new nodes follow. Kept host elements come first, in host order; new ones follow and inherit
/// net, property and sets of what they replace. Faces, nodes and element sets are those of the
/// host with the cavity's members replaced, under the same set numbers.
struct CrackedMesh {
  model::Mesh mesh;
  std::vector<CrackFront> fronts;
  std::vector<base::ElementId> host; ///< [element] the host element it is, or invalid if new
  std::vector<CrackFaceNodes> faces; ///< [crack line]
  std::vector<HangingNodeTie> ties;  ///< of patches with a transition
  /// [node set] members that a cavity took and nothing stands in for: single nodes, as the new
  /// nodes of whole sides and of cavities take their place. Empty where no patch was cut.
  std::vector<std::vector<base::NodeId>> unreplaced_set_nodes;
  std::vector<std::string> notes; ///< what was chosen, for the listing

  /// Nodes of the points of all fronts, one front after another.
  [[nodiscard]] std::vector<base::NodeId> front_nodes() const {
    std::vector<base::NodeId> nodes;
    for (const CrackFront& front : fronts) {
      std::ranges::transform(front.points, std::back_inserter(nodes), &FrontPoint::node);
    }
    return nodes;
  }
};

} // namespace spricka::mesh
