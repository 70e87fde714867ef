// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/row_builder.hpp"
#include "contact/space/frames.hpp"
#include "contact/space/pair_point.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

/// What the functions of a contact surface gather from its elements.
namespace spricka::contact {

/// [node of a crack's front] the node behind it.
using NodesBehindFront = std::map<base::NodeId, base::NodeId>;

/// What the rows of a SEGMENT pair are made with.
struct MortarRowOptions {
  std::optional<double> declared_gap; ///< in the place of the measured ones [length]
  bool tangents = false;              ///< rows along the surface for each normal one
  /// Functions of nodes at a crack's front, where the faces cannot part, go to the nodes behind it.
  NodesBehindFront at_front = {};
};

/// Integrals of an element's hats times what the two surfaces move along one direction.
struct HatMotionIntegrals {
  using OfHats = std::array<geometry::SidePositions, 3>; ///< [hat] by node of the facet
  OfHats own;
  std::vector<OfHats> target;
};

/// Integrals over what an element has opposite.
struct HatIntegrals {
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero(); ///< hat times hat
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();
  Eigen::Vector3d round_gap = Eigen::Vector3d::Zero();
  std::vector<std::size_t> targets;         ///< facets met
  std::array<HatMotionIntegrals, 3> motion; ///< along the normal and the tangents
};

/// What an element adds to the sums of its functions.
struct ElementContribution {
  OppositePointsOfElement projection;
  HatIntegrals sum;        ///< where something lies opposite
  Eigen::Matrix3d weights; ///< [function, hat]
};

/// The sums of one function, a hat or its dual, over the elements round its node.
struct FunctionSums {
  std::array<ConstraintRowBuilder, 3> row; ///< along the normal and the tangents
  double whole = 0.0;                      ///< integral over all of the elements
  std::vector<std::size_t> beside;         ///< functions of the elements that are covered
};

/// Sums up rows of a SEGMENT pair element by element (fill_mortar_rows()).
class MortarSums {
public:
  /// Of the two surfaces in `pair`; all must outlive this.
  MortarSums(const PairConstraints& pair, const MortarRowOptions& options);

  /// 1, or with tangents 2 in the plane and 3 in space.
  [[nodiscard]] std::size_t direction_count() const { return directions_; }
  /// As smooth_part_nodes().
  [[nodiscard]] std::vector<FunctionSums>& functions() { return functions_; }
  [[nodiscard]] const std::vector<FunctionSums>& functions() const { return functions_; }
  [[nodiscard]] const std::map<SmoothPartNode, std::size_t>& places() const { return place_; }
  /// The functions of an element's nodes.
  [[nodiscard]] std::vector<std::size_t> functions_of(const HatElement& element) const;

  /// What an element adds; threads may ask at once.
  [[nodiscard]] ElementContribution contribution(const HatElement& element,
                                                 const ElementProjector& project) const;
  void add(const HatElement& element, const ElementContribution& own);

private:
  [[nodiscard]] HatIntegrals integrate(const HatElement& element,
                                       const OppositePointsOfElement& projection) const;
  void add_motion(const HatElement& element, const HatIntegrals& sum, std::size_t k,
                  const Eigen::RowVector3d& weight, ConstraintRowBuilder& row) const;

  const FacetSurface& own_;
  const FacetSurface& other_;
  const MortarRowOptions& options_;
  SurfaceFrames frames_;
  std::size_t directions_;
  std::map<SmoothPartNode, std::size_t> place_; ///< of a node's function
  std::vector<FunctionSums> functions_;
};

} // namespace spricka::contact
