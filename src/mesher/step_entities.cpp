// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/step_entities.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace spricka::mesher {
namespace {

void append_points(const std::vector<double>& x, std::vector<base::Vec3>& points) {
  for (std::size_t i = 0; i + 2 < x.size(); i += 3) {
    points.emplace_back(x[i], x[i + 1], x[i + 2]);
  }
}

/// Length of a face along a direction of its parameters, through its middle.
double length_along(int face, const std::vector<double>& low, const std::vector<double>& high,
                    std::size_t direction) {
  constexpr std::size_t parts = 16;
  std::vector<double> uv;
  for (std::size_t i = 0; i <= parts; ++i) {
    const double part = static_cast<double>(i) / parts;
    std::array<double, 2> at{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
    at.at(direction) = low[direction] + part * (high[direction] - low[direction]);
    uv.insert(uv.end(), at.begin(), at.end());
  }
  std::vector<double> x;
  gmsh::model::getValue(2, face, uv, x);
  std::vector<base::Vec3> points;
  append_points(x, points);
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    length += (points[i + 1] - points[i]).norm();
  }
  return length;
}

} // namespace

std::vector<int> model_volumes() {
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, 3);
  std::vector<int> tags;
  for (const auto& [dim, tag] : entities) {
    tags.push_back(tag);
  }
  std::sort(tags.begin(), tags.end());
  return tags;
}

std::vector<int> faces_of_volume(int volume) {
  gmsh::vectorpair entities;
  gmsh::model::getBoundary({{3, volume}}, entities, false, false, false);
  std::vector<int> tags;
  for (const auto& [dim, tag] : entities) {
    tags.push_back(std::abs(tag));
  }
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  return tags;
}

FacePoints points_inside_face(int face, double apart) {
  std::vector<double> low;
  std::vector<double> high;
  gmsh::model::getParametrizationBounds(2, face, low, high);
  FacePoints result;
  std::array<int, 2> parts{};
  for (std::size_t d = 0; d < 2; ++d) {
    constexpr double least = 4.0;
    constexpr double most = 60.0;
    const double length = length_along(face, low, high, d);
    const double wanted = std::ceil(length / apart);
    parts.at(d) = static_cast<int>(std::isfinite(wanted) ? std::clamp(wanted, least, most) : least);
    result.apart = std::max(result.apart, length / parts.at(d));
  }
  std::vector<double> inside;
  for (int i = 0; i < parts[0]; ++i) {
    for (int j = 0; j < parts[1]; ++j) {
      const std::vector<double> uv{low[0] + (high[0] - low[0]) * (i + 0.5) / parts[0],
                                   low[1] + (high[1] - low[1]) * (j + 0.5) / parts[1]};
      if (gmsh::model::isInside(2, face, uv) > 0) {
        inside.insert(inside.end(), uv.begin(), uv.end());
      }
    }
  }
  if (!inside.empty()) {
    std::vector<double> x;
    gmsh::model::getValue(2, face, inside, x);
    append_points(x, result.points);
  }
  return result;
}

std::vector<base::Vec3> points_of_face_edges(int face) {
  gmsh::vectorpair edges;
  gmsh::model::getBoundary({{2, face}}, edges, false, false, false);
  std::vector<base::Vec3> points;
  for (const auto& [dim, tag] : edges) {
    std::vector<double> low;
    std::vector<double> high;
    gmsh::model::getParametrizationBounds(1, std::abs(tag), low, high);
    constexpr int parts = 12;
    std::vector<double> t;
    for (int i = 0; i <= parts; ++i) {
      t.push_back(low[0] + (high[0] - low[0]) * i / parts);
    }
    std::vector<double> x;
    gmsh::model::getValue(1, std::abs(tag), t, x);
    append_points(x, points);
  }
  return points;
}

} // namespace spricka::mesher
