// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/outline.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::contact {

namespace {

constexpr int parts = 4;       // straight pieces for a quadratic edge
constexpr double corner = 0.6; // turns of more belong to the shape, not to its facets [rad]

// Bodies are on the left: the outer normal is on the right of the way from a to b.
Vec2 normal_of(const Vec2& a, const Vec2& b) {
  const Vec2 t = (b - a).normalized();
  return {t.y(), -t.x()};
}

double turn_between(const Vec2& n, const Vec2& m) {
  const double angle = std::abs(std::atan2(n.x() * m.y() - n.y() * m.x(), n.dot(m)));
  return angle < corner ? angle : 0.0;
}

} // namespace

BoundaryPolyline::BoundaryPolyline(const ContactSurface& surface, const base::Vector& u) {
  for (const EdgeChain& chain : surface.plane.chains) {
    const std::span<const Edge> edges = surface.plane.edges_of_chain(chain);
    std::vector<Vec2> points;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      Edge edge = edges[e];
      for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count) && u.size() > 0; ++i) {
        edge.x[i] += u.segment<2>(2 * static_cast<Eigen::Index>(edge.nodes[i].index()));
      }
      const int n = edge.count == 3 ? parts : 1;
      for (int k = 0; k < n; ++k) {
        points.push_back(point_on(edge, -1.0 + 2.0 * k / n));
      }
      if (!chain.closed && e + 1 == edges.size()) {
        points.push_back(edge.x[1]);
      }
    }
    add_chain(std::move(points), chain.closed);
  }
  sort_in();
}

void BoundaryPolyline::add_chain(std::vector<Vec2> points, bool closed) {
  const std::size_t n = closed ? points.size() : points.size() - 1;
  if (points.size() < 2) {
    return;
  }
  std::vector<Vec2> normal;
  for (std::size_t i = 0; i < n; ++i) {
    normal.push_back(normal_of(points[i], points[(i + 1) % points.size()]));
  }
  for (std::size_t i = 0; i < n; ++i) {
    // Beyond the ends of an open chain a piece is its own neighbour.
    const std::size_t last = i > 0 ? i - 1 : (closed ? n - 1 : i);
    const std::size_t next = i + 1 < n ? i + 1 : (closed ? 0 : i);
    pieces_.push_back(
        {points[i], points[(i + 1) % points.size()], normal[last] + normal[i],
         normal[i] + normal[next],
         std::max(turn_between(normal[last], normal[i]), turn_between(normal[i], normal[next]))});
  }
}

BoundaryPolyline::QuadratureCell BoundaryPolyline::cell_of(const Vec2& x) const {
  return {std::lround(std::floor((x.x() - low_.x()) / size_)),
          std::lround(std::floor((x.y() - low_.y()) / size_))};
}

void BoundaryPolyline::sort_in() {
  double length = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const PolylineSegment& p = pieces_[i];
    low_ = i == 0 ? Vec2(p.a.cwiseMin(p.b)) : Vec2(low_.cwiseMin(p.a).cwiseMin(p.b));
    high_ = i == 0 ? Vec2(p.a.cwiseMax(p.b)) : Vec2(high_.cwiseMax(p.a).cwiseMax(p.b));
    length += (p.b - p.a).norm();
  }
  // Two mean pieces: a piece lies in few cells, and a cell holds few pieces.
  size_ = pieces_.empty() ? 1.0 : 2.0 * length / static_cast<double>(pieces_.size());
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const QuadratureCell a = cell_of(pieces_[i].a.cwiseMin(pieces_[i].b));
    const QuadratureCell b = cell_of(pieces_[i].a.cwiseMax(pieces_[i].b));
    for (long x = a.first; x <= b.first; ++x) {
      for (long y = a.second; y <= b.second; ++y) {
        cells_[{x, y}].push_back(i);
      }
    }
  }
}

// Takes a piece for the nearest one so far if it is.
void BoundaryPolyline::look(const Vec2& x, std::size_t i, double& best,
                            std::optional<BoundaryDistance>& found) const {
  const PolylineSegment& p = pieces_[i];
  const Vec2 chord = p.b - p.a;
  const double t = (x - p.a).dot(chord) / chord.squaredNorm();
  const Vec2 off = x - p.a - std::clamp(t, 0.0, 1.0) * chord;
  if (!(off.norm() <= best)) {
    return;
  }
  best = off.norm();
  // Nearest to an end, the normals of both pieces that meet there tell inside from outside: either
  // alone may be wrong before a sharp corner.
  const Vec2 n = t <= 0.0 ? p.at_a : (t >= 1.0 ? p.at_b : normal_of(p.a, p.b));
  // An arc over a chord c that turns by theta rises c theta / 8 above it.
  found = {off.dot(n) < 0.0 ? -best : best, chord.norm() * p.turn / 8.0};
}

std::optional<BoundaryDistance> BoundaryPolyline::signed_distance(const Vec2& x,
                                                                  double reach) const {
  std::optional<BoundaryDistance> found;
  double best = reach;
  const Vec2 r = Vec2::Constant(reach);
  const QuadratureCell from = cell_of((x - r).cwiseMax(low_).cwiseMin(high_));
  const QuadratureCell to = cell_of((x + r).cwiseMin(high_).cwiseMax(low_));
  const double cells = static_cast<double>(to.first - from.first + 1) *
                       static_cast<double>(to.second - from.second + 1);
  // With a long reach the pieces are fewer than the cells to be asked.
  if (cells > static_cast<double>(pieces_.size())) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      look(x, i, best, found);
    }
    return found;
  }
  for (long cx = from.first; cx <= to.first; ++cx) {
    for (long cy = from.second; cy <= to.second; ++cy) {
      const auto cell = cells_.find({cx, cy});
      if (cell != cells_.end()) {
        for (const std::size_t i : cell->second) {
          look(x, i, best, found);
        }
      }
    }
  }
  return found;
}

} // namespace spricka::contact
