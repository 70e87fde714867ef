// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/host.hpp"
#include "model/mesh.hpp"
#include "model/model.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Cracks in meshes: a patch is cut out of the host and refilled round the crack (manual,
/// mesh.1 to 5 and 12), or nodes of the deck's own mesh are doubled (PATCH=NO).
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

/// Where the first point of a free crack lies: on the boundary of the net (any net if invalid),
/// inside it, or neither.
enum class CrackStart { boundary, inside, outside };
CrackStart crack_start(const Host& host, const base::Vec3& point, base::NetId net);

/// Sizes where the deck is silent: from the crack's length and its last straight part, and the
/// distance of a tip to the nearest boundary (the ligament, a hole, a contact surface), to other
/// cracks in `all` and to earlier parts of its own. What the deck gives is taken as it is.
TipMesh choose_tip_mesh(const Host& host, const CrackLine& line, const model::TipNet* wishes,
                        std::span<const CrackLine> all = {});

/// Cuts the cracks into the host. Cracks that cannot be placed (touch no element, leave the body,
/// cross a material boundary) are reported at the crack's card (`span[i]`) and give an empty
/// result. Patches are meshed in the crack's frame, coordinates divided by a and rounded (to 2^-26,
/// for the choice of elements only), so that units and position do not change the mesh. Always cuts
/// from the host.
std::optional<CrackedMesh> insert_cracks(const Host& host, std::span<const CrackLine> lines,
                                         std::span<const TipMesh> tips,
                                         std::span<const base::Span> spans,
                                         base::Diagnostics& diagnostics);

/// Host elements that the cavity of any of these lines may touch, with a margin of one layer of
/// elements: the region that is condensed anew at each length. Ascending.
std::vector<base::ElementId> crack_region(const Host& host, std::span<const CrackLine> lines,
                                          std::span<const TipMesh> tips);

} // namespace spricka::mesh
