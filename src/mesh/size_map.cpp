// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/size_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace spricka::mesh {

using base::Vec2;

namespace {

// Cells of the grid along each side of the square that covers all points.
constexpr int along = 64;

} // namespace

SizeMap::SizeMap(std::vector<SizeRequest> requests)
    : given_(std::move(requests)), levelled_(given_) {
  if (levelled_.empty()) {
    return;
  }
  low_ = levelled_.front().at;
  Vec2 high = low_;
  for (const SizeRequest& request : levelled_) {
    low_ = low_.cwiseMin(request.at);
    high = high.cwiseMax(request.at);
  }
  const double extent = (high - low_).maxCoeff();
  pitch_ = extent > 0.0 ? extent / along : 1.0;
  cells_.resize(std::size_t{along} * along);
  for (std::size_t i = 0; i < levelled_.size(); ++i) {
    const auto [column, row] = cell_of(levelled_[i].at);
    cells_[static_cast<std::size_t>(row * along + column)].push_back(i);
  }
  level();
}

SizeMap::GridCell SizeMap::cell_of(const Vec2& p) const {
  const Vec2 at = (p - low_) / pitch_;
  const auto clamped = [](double x) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0, along - 1.0));
  };
  return {clamped(at.x()), clamped(at.y())};
}

const std::vector<std::size_t>& SizeMap::in_cell(int i, int j) const {
  static const std::vector<std::size_t> none;
  const bool inside = i >= 0 && j >= 0 && i < along && j < along;
  return inside ? cells_[static_cast<std::size_t>(j * along + i)] : none;
}

// Distances in the plane obey the triangle inequality, so that one pass over the sources is enough.
void SizeMap::level() {
  double largest = 0.0;
  for (const SizeRequest& request : levelled_) {
    largest = std::max(largest, request.size);
  }
  for (const SizeRequest& source : levelled_) {
    if (!source.fresh) {
      continue;
    }
    const double radius = (largest - source.size) / growth;
    const GridCell from = cell_of(source.at - Vec2(radius, radius));
    const GridCell to = cell_of(source.at + Vec2(radius, radius));
    for (int j = from.second; j <= to.second; ++j) {
      for (int i = from.first; i <= to.first; ++i) {
        for (const std::size_t k : in_cell(i, j)) {
          SizeRequest& request = levelled_[k];
          request.size =
              std::min(request.size, source.size + growth * (request.at - source.at).norm());
        }
      }
    }
  }
}

double SizeMap::operator()(const Vec2& p) const {
  double closest = std::numeric_limits<double>::infinity();
  double size = closest;
  if (levelled_.empty()) {
    return size;
  }
  const auto [column, row] = cell_of(p);
  const auto look = [&](int i, int j) {
    for (const std::size_t k : in_cell(i, j)) {
      const double distance = (levelled_[k].at - p).norm();
      if (distance < closest) {
        closest = distance;
        size = levelled_[k].size;
      }
    }
  };
  // rings of cells: what lies in ring k is at least k - 1 pitches away
  for (int ring = 0; ring <= along && (ring - 1) * pitch_ <= closest; ++ring) {
    for (int d = -ring; d <= ring; ++d) {
      look(column + d, row - ring);
      if (ring > 0) {
        look(column + d, row + ring);
        if (std::abs(d) < ring) {
          look(column - ring, row + d);
          look(column + ring, row + d);
        }
      }
    }
  }
  return size;
}

} // namespace spricka::mesh
