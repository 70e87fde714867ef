// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/solid_host.hpp"
#include "model/cracks.hpp"

#include <optional>

namespace spricka::growth {

/// The way to a surface before a place of a front.
struct LigamentDepths {
  double behind = 0.0; ///< how far the crack reaches back from there [length]
  double left = 0.0;   ///< from there to the surface [length]
  [[nodiscard]] double ligament_to_depth_ratio() const { return left / (behind + left); }
};

/// The body that a crack in space grows in: which places are inside of it, and how far it is to its
/// surface.
class SolidBodyQuery {
public:
  explicit SolidBodyQuery(const model::Mesh& host) : host_(host) {}

  /// Whether a place lies in a body of the net (invalid: any), its surface included.
  [[nodiscard]] bool inside(const base::Vec3& x, base::NetId net) const {
    return host_.find_element_at(x, net).has_value();
  }
  /// The surface ahead: how far, which of its pieces between sharp edges, how steeply met.
  struct SurfaceAhead {
    double distance = 0.0;
    std::size_t piece = 0;
    double sine = 1.0; ///< of the angle between the way and the surface there
  };
  /// The surface along `way` (unit) of the body that x lies in; empty: x lies in none, or on the
  /// surface that `way` leaves it by.
  [[nodiscard]] std::optional<SurfaceAhead>
  surface_ahead(const base::Vec3& x, const base::Vec3& way, base::NetId net) const;
  /// The piece of the surface that x lies on, or is nearest to, of the body round `within`; empty:
  /// that lies in none.
  [[nodiscard]] std::optional<std::size_t>
  surface_piece(const base::Vec3& x, const base::Vec3& within, base::NetId net) const;
  /// Whether the body is on the straight way between two places in it or at its surface: no hole
  /// parts them.
  [[nodiscard]] bool is_line_inside(const base::Vec3& one, const base::Vec3& other,
                                    base::NetId net) const;

private:
  mesh::SolidHostMesh host_;
};

} // namespace spricka::growth
