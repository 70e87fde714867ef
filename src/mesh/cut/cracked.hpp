// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <array>
#include <string>
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
  std::string name;               ///< for messages; empty: "crack 2" by its number

  [[nodiscard]] std::string title() const {
    return "crack " + (name.empty() ? std::to_string(crack.index() + 1) : name);
  }
};

/// How to mesh round one tip; all sizes in deck length, already chosen.
struct TipMesh {
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

/// A node on the rim of a patch that is finer than its host: it takes the displacement of its place
/// on the host's edge, by the shape functions of that edge.
struct RimTie {
  base::NodeId slave;
  std::array<base::NodeId, 3> master; ///< ends and middle of the edge
  std::array<double, 3> weight{};
  base::CrackId crack;
};

/// Where a tip ended up in the mesh.
struct Tip {
  base::CrackId crack;
  int number = 1; ///< 1, or 1 and 2 of an embedded crack
  base::NodeId node;
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 direction = base::Vec3::Zero(); ///< unit, the way the crack grows
  double a = 0.0;                            ///< crack length, half of it if embedded
  double size = 0.0;                         ///< radial length of the tip elements
  double radius = 0.0;                       ///< of the rosette
  bool symmetric_half = false;
};

/// A mesh with cracks in it. Host nodes keep their numbers (some may be left without an element);
/// new nodes follow. Kept host elements come first, in host order; new ones follow and inherit
/// net, property and sets of what they replace. Faces, nodes and element sets are those of the
/// host with the cavity's members replaced, under the same set numbers.
struct CrackedMesh {
  model::Mesh mesh;
  std::vector<Tip> tips;
  std::vector<base::ElementId> host; ///< [element] the host element it is, or invalid if new
  /// [crack line] the two lips, ordered from the mouth to the tip (tips included in both); one lip
  /// for a symmetric half (the other is empty). Left lip first, seen along the crack.
  struct Lips {
    std::vector<base::NodeId> left;
    std::vector<base::NodeId> right;
  };
  std::vector<Lips> lips;
  std::vector<RimTie> ties; ///< of patches with a transition
  /// [node set] members that a cavity took and nothing stands in for: single nodes, as the new
  /// nodes of whole sides and of cavities take their place. Empty where no patch was cut.
  std::vector<std::vector<base::NodeId>> lost;
  std::vector<std::string> notes; ///< what was chosen, for the listing
};

} // namespace spricka::mesh
