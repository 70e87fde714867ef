// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/hull.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>

#include <Eigen/Geometry>

namespace spricka::contact {

namespace {

constexpr double sharp_turn = 0.6; // turns of more belong to the shape, not to its facets [rad]

double angle_of(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The place of a triangle that is nearest to a point: which of its features it is on, and where
// (Ericson 2005, section 5.1.5).
struct NearestTriangleFeature {
  Vec3 x = Vec3::Zero();
  int corner = -1; ///< it is this corner
  int side = -1;   ///< or lies on this side; neither: within
};

NearestTriangleFeature nearest_on(const std::array<Vec3, 3>& t, const Vec3& x) {
  const Vec3 ab = t[1] - t[0];
  const Vec3 ac = t[2] - t[0];
  const double d1 = ab.dot(x - t[0]);
  const double d2 = ac.dot(x - t[0]);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return {t[0], 0, -1};
  }
  const double d3 = ab.dot(x - t[1]);
  const double d4 = ac.dot(x - t[1]);
  if (d3 >= 0.0 && d4 <= d3) {
    return {t[1], 1, -1};
  }
  const double c = d1 * d4 - d3 * d2;
  if (c <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    return {t[0] + d1 / (d1 - d3) * ab, -1, 0};
  }
  const double d5 = ab.dot(x - t[2]);
  const double d6 = ac.dot(x - t[2]);
  if (d6 >= 0.0 && d5 <= d6) {
    return {t[2], 2, -1};
  }
  const double b = d5 * d2 - d1 * d6;
  if (b <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    return {t[0] + d2 / (d2 - d6) * ac, -1, 2};
  }
  const double a = d3 * d6 - d5 * d4;
  if (a <= 0.0 && d4 >= d3 && d5 >= d6) {
    return {t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]), -1, 1};
  }
  return {t[0] + (b * ab + c * ac) / (a + b + c), -1, -1};
}

} // namespace

BoundaryTriangulation::BoundaryTriangulation(const model::Mesh& mesh,
                                             const std::vector<model::Face>& faces,
                                             const base::Vector& u)
    : tree_({}), low_(Vec3::Constant(std::numeric_limits<double>::infinity())), high_(-low_) {
  std::vector<std::array<base::NodeId, 3>> nodes;
  std::vector<ContactBoundingBox> boxes;
  for (const model::Face& side : faces) {
    const SolidFace face = make_solid_face(mesh, side);
    for (const FaceTriangle& t : face_triangles(face.shape)) {
      BoundaryTriangle piece;
      std::array<base::NodeId, 3>& own = nodes.emplace_back();
      for (std::size_t i = 0; i < own.size(); ++i) {
        own[i] = face.nodes[static_cast<std::size_t>(t[i])];
        piece.x[i] = mesh.x[own[i].index()];
        if (u.size() > 0) {
          piece.x[i] += u.segment<3>(3 * static_cast<Eigen::Index>(own[i].index()));
        }
      }
      const ContactBoundingBox box{piece.x[0].cwiseMin(piece.x[1]).cwiseMin(piece.x[2]),
                                   piece.x[0].cwiseMax(piece.x[1]).cwiseMax(piece.x[2])};
      low_ = low_.cwiseMin(box.low);
      high_ = high_.cwiseMax(box.high);
      boxes.push_back(box);
      size_ += (box.high - box.low).norm();
      piece.normal = (piece.x[1] - piece.x[0]).cross(piece.x[2] - piece.x[0]).normalized();
      pieces_.push_back(piece);
    }
  }
  size_ /= static_cast<double>(std::max<std::size_t>(boxes.size(), 1));
  tree_ = BoxTree(boxes);
  join(nodes);
}

// Sums of normals at corners, each by its angle, and at sides.
void BoundaryTriangulation::join(const std::vector<std::array<base::NodeId, 3>>& nodes) {
  std::map<base::NodeId, Vec3> at_corner;
  // Sides by their ends, so that the two triangles of one follow each other.
  std::vector<std::tuple<base::NodeId, base::NodeId, std::size_t, std::size_t>> sides;
  for (std::size_t t = 0; t < pieces_.size(); ++t) {
    BoundaryTriangle& piece = pieces_[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      const double angle = angle_of(piece.x[next] - piece.x[i], piece.x[(i + 2) % 3] - piece.x[i]);
      at_corner.try_emplace(nodes[t][i], Vec3::Zero()).first->second += angle * piece.normal;
      const auto [a, b] = std::minmax(nodes[t][i], nodes[t][next]);
      sides.emplace_back(a, b, t, i);
      piece.at_side[i] = piece.normal;
    }
  }
  std::ranges::sort(sides);
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const auto& [a, b, t, i] = sides[k];
    const auto& [c, d, s, j] = sides[k + 1];
    if (a != c || b != d) {
      continue;
    }
    const Vec3 sum = pieces_[t].normal + pieces_[s].normal;
    pieces_[t].at_side[i] = sum;
    pieces_[s].at_side[j] = sum;
    const double turn = angle_of(pieces_[t].normal, pieces_[s].normal);
    if (turn < sharp_turn) {
      // Round an equilateral triangle of side c a ball turns by 2 c / (sqrt(12) R) from face to
      // face, and rises (c / sqrt 3)^2 / 2R above it: c theta / sqrt(12).
      for (const std::size_t p : {t, s}) {
        const std::array<Vec3, 3>& x = pieces_[p].x;
        const double chord =
            std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
        pieces_[p].rise = std::max(pieces_[p].rise, chord * turn / std::sqrt(12.0));
      }
    }
  }
  for (std::size_t t = 0; t < pieces_.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      pieces_[t].at_corner[i] = at_corner.at(nodes[t][i]);
    }
  }
  // Of triangles of one face two may lie in a plane: the curve above is that beside them.
  std::vector<double> rise;
  std::ranges::transform(pieces_, std::back_inserter(rise), &BoundaryTriangle::rise);
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const auto& [a, b, t, i] = sides[k];
    const auto& [c, d, s, j] = sides[k + 1];
    if (a == c && b == d && angle_of(pieces_[t].normal, pieces_[s].normal) < sharp_turn) {
      pieces_[t].rise = std::max(pieces_[t].rise, rise[s]);
      pieces_[s].rise = std::max(pieces_[s].rise, rise[t]);
    }
  }
}

std::optional<TriangulationDistance> BoundaryTriangulation::signed_distance(const Vec3& x,
                                                                            double reach) const {
  // Twice as far each time: most places have something near, or nothing for a long way.
  for (double near = std::min(size_, reach);; near = std::min(2.0 * near, reach)) {
    const std::optional<TriangulationDistance> found = nearest_within(x, near);
    if (found || near >= reach) {
      return found;
    }
  }
}

std::optional<TriangulationDistance> BoundaryTriangulation::nearest_within(const Vec3& x,
                                                                           double reach) const {
  std::optional<TriangulationDistance> found;
  double best = reach;
  const Vec3 r = Vec3::Constant(reach);
  for (const std::size_t t : tree_.overlapping_boxes({x - r, x + r})) {
    const BoundaryTriangle& piece = pieces_[t];
    const NearestTriangleFeature at = nearest_on(piece.x, x);
    const Vec3 off = x - at.x;
    if (!(off.norm() <= best)) {
      continue;
    }
    best = off.norm();
    const Vec3& n = at.corner >= 0 ? piece.at_corner[static_cast<std::size_t>(at.corner)]
                    : at.side >= 0 ? piece.at_side[static_cast<std::size_t>(at.side)]
                                   : piece.normal;
    found = TriangulationDistance{off.dot(n) < 0.0 ? -best : best, piece.rise};
  }
  return found;
}

} // namespace spricka::contact
