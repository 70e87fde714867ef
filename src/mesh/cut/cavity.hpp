// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/plane.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Where a crack starts: on a boundary edge of the host, at a node of it if `node` is valid.
struct Mouth {
  model::Face face;
  double xi = 0.0;
  base::NodeId node;
};

/// A tip in the crack's frame.
struct TipPlace {
  base::Vec2 at = base::Vec2::Zero();
  double direction = 0.0; ///< of growth, angle from the frame's x

  [[nodiscard]] base::Vec2 ahead() const { return {std::cos(direction), std::sin(direction)}; }
};

/// A crack put into its host, in its own frame: mouth at (0, 0), length 1; an embedded one has its
/// first tip there and length 2.
struct Placement {
  CrackFrame frame;
  std::vector<base::Vec2> line; ///< the crack, mouth first
  std::optional<Mouth> mouth;   ///< none: embedded
  base::ElementId seed;         ///< host element that it starts in
  std::vector<TipPlace> tips;   ///< in the order of the line
  double radius = 0.0;          ///< of the rosettes
  double size = 0.0;            ///< of the tip elements
  /// Symmetric half: +1 if the body lies on the left of the line, -1 on the right; else 0.
  int half = 0;
};

/// Puts a crack with a patch into its host. Empty, with an error at `span`, if it does not start
/// where it should or a rosette does not fit.
std::optional<Placement> place(const Host& host, const CrackLine& line, const TipMesh& tip,
                               base::Span span, base::Diagnostics& diagnostics);

/// Distance from the last point of a line to some faces of its net, but for the line itself of a
/// symmetric half [a].
double tip_clearance(const Host& host, const CrackFrame& frame, const std::vector<base::Vec2>& line,
                     bool half, base::NetId net, const std::vector<model::Face>& faces);

/// The same to the net's boundary and to borders of other properties.
double tip_room(const Host& host, const CrackFrame& frame, const std::vector<base::Vec2>& line,
                bool half, base::NetId net);

/// The nearest point of a net's boundary (any net: invalid) and how far it is.
struct BoundaryPoint {
  base::Vec3 x = base::Vec3::Zero();
  double distance = 0.0;
};
BoundaryPoint nearest_boundary(const Host& host, const base::Vec3& point, base::NetId net);

/// Whether an edge is longer than its room, times `part`: its distance from the crack and from the
/// rosettes.
bool is_long(const model::Mesh& mesh, const Placement& placement, const Edge& edge, double part);

/// Frame of a crack from its first point on; `a` is half the length of an embedded one.
CrackFrame frame_of(const CrackLine& line);

/// An edge of a cavity, cavity on the left.
struct OutlineEdge {
  model::Face face; ///< of the host element inside the cavity
  Edge edge;
  bool free = false; ///< on the host's boundary; else elements that stay lie beyond
};

/// The host elements that a patch replaces, ascending, and the closed loops that bound them.
struct Cavity {
  std::vector<base::ElementId> elements;
  std::vector<std::vector<OutlineEdge>> loops;
};

/// Elements that cracks and rosettes touch or come near, and as much as one layer more: connected
/// cavities of one property without pinched nodes. Cavities share no element: where they would, the
/// layers give way; cracks too near to each other for that have one cavity together.
struct Cavities {
  std::vector<Cavity> each;
  std::vector<std::vector<std::size_t>> cracks; ///< [cavity] numbers of its placements, ascending
};
Cavities find_cavities(const Host& host, std::span<const Placement> placements);

/// Whether the crack stays inside its cavity, in one material; errors at `span`.
bool check_cavity(const Host& host, const Placement& placement, const Cavity& cavity,
                  base::Span span, base::Diagnostics& diagnostics);

/// The same crack in another frame; unchanged in its own.
Placement seen_from(const Placement& placement, const CrackFrame& frame);

/// Corner and mid nodes of an element in the crack's frame, in order round it.
std::vector<base::Vec2> polygon(const model::Mesh& mesh, base::ElementId e,
                                const CrackFrame& frame);

} // namespace spricka::mesh
