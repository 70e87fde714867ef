// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "contact/space/pair_point.hpp"
#include "contact/surface.hpp"
#include "model/contacts.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Constraint rows: what contact pairs demand of the displacements. A row is scaled by the area it
/// stands for, so that its multiplier is a pressure [stress] in every pairing.
namespace spricka::contact {

struct RowEntry {
  base::NodeId node;
  base::Vec3 weight = base::Vec3::Zero(); ///< [area]
};

/// g = gap + sum weight . u >= 0 (normal row) or = 0 (bonded rows); with friction the slip v of a
/// tangential row obeys Coulomb's law with the pressure of its normal row.
struct ConstraintRow {
  std::vector<RowEntry> entries; ///< ascending by node, each node once
  double gap = 0.0;              ///< weighted initial gap [length * area]
  /// The same where surfaces whose nodes lie on circles were those circles; else as `gap`.
  double round_gap = 0.0;
  double area = 0.0; ///< integral of the row's function over the paired part
  base::NodeId node; ///< contact node that the function belongs to
  bool tangential = false;
  int normal = -1; ///< of a tangential row: its normal row among those of the pair
  int along = 0;   ///< of a tangential row of a SEGMENT pair: which tangent of the surface, 1 or 2
};

/// A place where one surface of a pair ends while the other goes on: the end of a rigid line, the
/// edge of a punch or of a hub, the mouth of a crack. Where contact is closed up to it, the exact
/// pressure has no bound, and the largest one found belongs to the mesh. In space an edge.
struct SingularContactEdge {
  base::Vec3 x = base::Vec3::Zero(); ///< in space some place of the edge
  std::vector<base::NodeId> nodes;   ///< contact nodes whose pressure acts there
  bool bounded = false;  ///< in space: the body that ends is so soft that its corner gives way
  bool is_point = false; ///< it is x, not an edge through it
};

/// What presses at a node of a surface: one function for each smooth part that the node belongs to,
/// with a row of its own, that of the neighbour it joined, or none.
struct MultiplierFunction {
  base::NodeId node;
  std::size_t part = 0;       ///< of the contact surface
  int row = -1;               ///< among the pair's normal rows; -1: nothing lies opposite
  double area = 0.0;          ///< integral over what is covered
  double whole = 0.0;         ///< integral over all faces
  bool joined = false;        ///< the row is that of another node
  std::array<bool, 3> held{}; ///< a support holds the node along that axis
};

/// The rows of one contact pair.
struct PairConstraints {
  std::vector<ConstraintRow> normal;
  std::vector<ConstraintRow> tangent;      ///< bonded pairs and those with friction
  ContactSurface contact;                  ///< side that carries the multipliers
  ContactSurface target;                   ///< no edges where `rigid` stands in its place
  std::optional<model::RigidTarget> rigid; ///< rows then weigh nodes of the contact side only
  bool swapped = false;                    ///< the deck's master carries the multipliers
  bool segments = false; ///< rows are weighted by hats on half edges, else by single nodes
  /// [element of the contact surface] what its rows were integrated over; null without `segments`.
  std::shared_ptr<const std::vector<std::vector<PairQuadraturePoint>>> opposite;
  bool faces = false;  ///< of a crack: they end together at its mouth and its tips
  bool found = false;  ///< the surfaces face each other somewhere
  std::string trouble; ///< why there are no rows (node pairing that does not match)
  std::string choice;  ///< which side carries the multipliers and why, for the listing
  int merged = 0;      ///< rows covered by less than 20 % that went to a neighbour
  std::vector<SingularContactEdge>
      sharp_ends; ///< in the order of the contact surface; none on crack faces
  std::vector<MultiplierFunction>
      functions; ///< as smooth_part_nodes(); none of crack faces in the plane
  std::optional<AnalyticShape> rigid_shape; ///< in space, of `rigid`
  double unprojected_area =
      0.0; ///< in space: area that lies opposite, but whose normal meets nothing there
};

/// Maps each contact node to its place in `pair.normal`; where a node has several normal rows, to
/// the first of them.
std::map<base::NodeId, std::size_t> map_nodes_to_normal_rows(const PairConstraints& pair);

} // namespace spricka::contact
