// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "base/id.hpp"
#include "base/vec.hpp"
#include "shape/shape.hpp"

#include <array>
#include <vector>

/// Hierarchical modes that raise quadratic solids to complete cubics (manual, estimate.20 to 22):
/// zero at all nodes of the element; those of an edge and of a face are the same for all elements
/// that share it.
namespace spricka::estimate {

/// Where a mode of a reference solid belongs.
struct SolidMode {
  enum class SolidModeSite : char { edge, triangle, quadrilateral, inside };
  SolidModeSite on = SolidModeSite::inside;
  int which = 0;  ///< edge (shape::edge_corners) or side
  int number = 0; ///< of a quadrilateral: 1, u, w, u w along its own axes; else counts
};

/// The modes of a type of solid in its reference coordinates.
class SolidModes {
public:
  /// Whether elements of a type have modes.
  static bool has_modes_for_type(base::ElementType type);
  /// Of a type that has some; made once.
  static const SolidModes& for_type(base::ElementType type);

  [[nodiscard]] const std::vector<SolidMode>& modes() const { return modes_; }
  /// Values [mode] and derivatives by reference coordinates [mode, 3].
  [[nodiscard]] base::Vector psi(const base::Vec3& r) const;
  /// Derivatives of the modes by the reference coordinates at a point. [mode, 3]
  [[nodiscard]] Eigen::MatrixX3d dpsi(const base::Vec3& r) const;

private:
  explicit SolidModes(base::ElementType type);
  base::ElementType type_;
  std::vector<SolidMode> modes_;
};

/// Of a quadrilateral side whose corners are these nodes: which of the functions 1, u, w, u w along
/// the face's common axes (from its lowest node to the lower of the neighbours, then the other way)
/// the element's own are, and their signs.
struct FaceModeAxes {
  std::array<int, 4> number{};
  std::array<double, 4> sign{};
};
/// Axes of the modes of a quadrilateral face as an element with these corners sees them, so that
/// two elements that share it agree.
FaceModeAxes face_mode_axes(const std::array<base::NodeId, 4>& corners);

} // namespace spricka::estimate
