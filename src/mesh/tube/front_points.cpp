// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/front_points.hpp"

namespace spricka::mesh {

void weigh_points(bool closed, Front& front) {
  const std::size_t n = front.points.size();
  for (FrontPoint& point : front.points) {
    point.weight = 0.0;
  }
  for (std::size_t k = 0; k < (closed ? n : n - 1); ++k) {
    const std::size_t next = (k + 1) % n;
    const double end = next == 0 ? front.curve->length() : front.points[next].s;
    const double half = 0.5 * (end - front.points[k].s);
    front.points[k].weight += half;
    front.points[next].weight += half;
  }
}

void place_points(const model::Mesh& mesh, Front& front) {
  const bool closed = front.points.size() > 1 && !front.points.front().at_surface;
  double first = 0.0;
  for (std::size_t k = 0; k < front.points.size(); ++k) {
    FrontPoint& point = front.points[k];
    point.x = mesh.x[point.node.index()];
    const double s = front.curve->nearest(point.x);
    point.growth = front.curve->at(s).m;
    first = k == 0 ? s : first;
    point.s = s - first;
    point.s += closed && point.s < 0.0 ? front.curve->length() : 0.0;
  }
  weigh_points(closed, front);
}

} // namespace spricka::mesh
