// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

/// What stands twice at one place: slips of whoever made the mesh.
namespace spricka::mesh {

/// One number for all points within `reach` [length] of each other: that of the first such point,
/// counted from 0. Points are kept by cells much larger than that, so that a look into one of them
/// nearly always tells.
class CoincidentPoints {
public:
  explicit CoincidentPoints(double reach) : reach_(reach), width_(1e3 * reach) {}

  /// The number of the first point met within reach of x, which is x if there was none.
  std::size_t find_or_add_number(const base::Vec3& x);

private:
  using Cell = std::array<std::int64_t, 3>;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  [[nodiscard]] Cell cell_of(const base::Vec3& x) const;
  [[nodiscard]] std::optional<std::size_t> find(const Cell& cell, const base::Vec3& x) const;
  [[nodiscard]] std::size_t slot_of(const Cell& cell) const;
  void add(const Cell& cell, const base::Vec3& x);
  void widen();

  double reach_;
  double width_;
  std::vector<base::Vec3> points_;
  std::vector<Cell> cell_;            ///< [point]
  std::vector<std::size_t> previous_; ///< [point] the one before it in its cell
  std::vector<std::size_t> last_; ///< [slot] last point of a cell: a hash table, open addressing
  std::size_t used_ = 0;          ///< slots
};

/// Two sides of elements with corners at the same places but nodes of their own.
struct CoincidentFacePair {
  model::Face first;
  model::Face second;
};

/// Boundary sides that lie on each other, corner on corner within 1e-4 of the shortest boundary
/// side: nothing in the mesh joins the bodies there. In order of their first side.
std::vector<CoincidentFacePair> find_coincident_faces(const model::Mesh& mesh,
                                                      const std::vector<model::Face>& boundary);

/// Elements whose corners all stand where those of an earlier element do, each with that element.
std::vector<std::pair<base::ElementId, base::ElementId>>
find_coincident_elements(const model::Mesh& mesh);

} // namespace spricka::mesh
