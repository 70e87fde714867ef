// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Element size in the plane from sizes wanted at many points (one for each element of an earlier
/// mesh): that of the nearest point, after sizes near a fresh request are levelled so that they
/// grow from it by no more than `growth` for each unit of distance.
class SizeMap {
public:
  static constexpr double growth = 0.5;

  struct SizeRequest {
    base::Vec2 at;
    double size = 0.0;
    bool fresh = true; ///< it may be smaller than its neighbours allow, so that these follow
  };
  explicit SizeMap(std::vector<SizeRequest> requests);

  /// Infinite if there are no requests.
  [[nodiscard]] double operator()(const base::Vec2& p) const;

  /// The requests as they came, from which the same map can be made anew.
  [[nodiscard]] const std::vector<SizeRequest>& requests() const { return given_; }

private:
  using GridCell = std::pair<int, int>;
  [[nodiscard]] GridCell cell_of(const base::Vec2& p) const;
  [[nodiscard]] const std::vector<std::size_t>& in_cell(int i, int j) const;
  void level();

  std::vector<SizeRequest> given_;
  std::vector<SizeRequest> levelled_; ///< levelled
  double pitch_ = 1.0;                ///< of the grid that finds near points
  base::Vec2 low_ = base::Vec2::Zero();
  std::vector<std::vector<std::size_t>> cells_; ///< row by row
};

} // namespace spricka::mesh
