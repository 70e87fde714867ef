// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/chart_maps.hpp"

#include "base/dense_solve.hpp"
#include "geometry/box.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

namespace {

constexpr double is_flat = 1e-8;     // of the patch's extent
constexpr double is_cylinder = 1e-3; // of the radius
constexpr double widest = 100.0;     // extents: a wider cylinder is unrolled by least squares
constexpr double longest = 8.0;      // radii of a ring: sizes in its map change by e^8

Vec3 area_vector(const FacetTriangulation& net, const FacetTriangulation::SurfaceFacet& facet) {
  const auto [a, b, c] = net.corners(facet);
  return 0.5 * (b - a).cross(c - a);
}

/// What a direction has across another one, unit; what a second one has where that is little.
Vec3 across(const Vec3& normal, const Vec3& wanted, const Vec3& instead) {
  const Vec3 lying = wanted - wanted.dot(normal) * normal;
  return (lying.norm() > 0.1 ? lying : Vec3(instead - instead.dot(normal) * normal)).normalized();
}

/// e1 along the crack's normal where that lies in the plane.
ChartPlaneFrame frame_across(const Vec3& normal, const CrackReferencePlane& plane) {
  const Vec3 e1 = across(normal, plane.normal, plane.axis);
  return {plane.origin, e1, normal.cross(e1), plane.length};
}

/// Of a line's two directions the one along the crack's normal; along other axes of the crack
/// where it lies in its plane.
bool along_crack(const Vec3& axis, const CrackReferencePlane& plane) {
  for (const Vec3& way : {plane.normal, plane.axis, plane.normal.cross(plane.axis).eval()}) {
    const double up = rounded(axis.dot(way));
    if (up != 0.0) {
      return up > 0.0;
    }
  }
  return true;
}

struct Cylinder {
  Vec3 point, axis, start; ///< start: unit, where the angle is 0
  double radius = 0.0;
};

std::optional<Cylinder> fit_cylinder(const ChartPatch& patch) {
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (const FacetTriangulation::SurfaceFacet& facet : patch.net.facets()) {
    const Vec3 n = area_vector(patch.net, facet);
    moment += n * n.transpose() / std::max(n.norm(), 1e-300);
  }
  Vec3 axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moment).eigenvectors().col(0);
  axis *= along_crack(axis, patch.plane) ? 1.0 : -1.0;
  const Vec3 t1 = across(axis, patch.plane.normal, patch.plane.axis);
  const Vec3 t2 = axis.cross(t1);
  const double extent = geometry::Box<3>::around(patch.net.vertices()).diagonal();
  const Vec3 middle = patch.net.vertices().front();
  std::vector<Vec2> points;
  for (const std::size_t f : patch.faces) {
    const geometry::ElementSide& face = patch.surface.face(f);
    for (Eigen::Index i = 0; i < face.X.cols(); ++i) {
      const Vec3 d = (face.X.col(i) - middle) / extent;
      points.emplace_back(d.dot(t1), d.dot(t2));
    }
  }
  Eigen::MatrixXd A(static_cast<Eigen::Index>(points.size()), 3);
  base::Vector right(A.rows());
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    const Vec2& p = points[static_cast<std::size_t>(i)];
    A.row(i) << 2.0 * p.x(), 2.0 * p.y(), 1.0;
    right[i] = p.squaredNorm();
  }
  const base::Vector s = base::least_squares(A, right);
  const double radius = std::sqrt(std::max(0.0, s[2] + s.head<2>().squaredNorm()));
  double off = 0.0;
  for (const Vec2& p : points) {
    off = std::max(off, std::abs((p - s.head<2>()).norm() - radius));
  }
  if (!(radius > 0.0) || radius > widest || off > is_cylinder * radius) {
    return std::nullopt;
  }
  Cylinder cylinder;
  cylinder.point = middle + extent * (s[0] * t1 + s[1] * t2);
  cylinder.axis = axis;
  cylinder.radius = extent * radius;
  Vec3 start = patch.plane.origin - cylinder.point;
  start -= start.dot(axis) * axis;
  start = start.norm() > 1e-6 * cylinder.radius ? start : t1;
  cylinder.start = start.normalized();
  return cylinder;
}

/// Angles of vertices about an axis, each near that of its neighbours, from the first on.
class Angles {
public:
  Angles(const FacetTriangulation& net, const Cylinder& cylinder) : net_(net) {
    const Vec3 across = cylinder.axis.cross(cylinder.start);
    for (const Vec3& x : net.vertices()) {
      const Vec3 d = x - cylinder.point;
      angle_.push_back(std::atan2(d.dot(across), d.dot(cylinder.start)));
    }
    spread();
  }
  [[nodiscard]] const std::vector<double>& angle() const { return angle_; }
  [[nodiscard]] bool round() const { return round_; }

private:
  static constexpr double pi = std::numbers::pi;

  void spread() {
    std::vector<std::vector<std::size_t>> near(angle_.size());
    for (const FacetTriangulation::SurfaceFacet& facet : net_.facets()) {
      for (std::size_t c = 0; c < 3; ++c) {
        near[static_cast<std::size_t>(facet.vertex[c])].push_back(
            static_cast<std::size_t>(facet.vertex[(c + 1) % 3]));
        near[static_cast<std::size_t>(facet.vertex[(c + 1) % 3])].push_back(
            static_cast<std::size_t>(facet.vertex[c]));
      }
    }
    std::vector<bool> known(angle_.size(), false);
    // From the vertex nearest to angle 0, so that most of a patch keeps its angles.
    std::size_t first = 0;
    for (std::size_t v = 0; v < angle_.size(); ++v) {
      first = std::abs(angle_[v]) < std::abs(angle_[first]) - coordinate_tolerance ? v : first;
    }
    std::vector<std::size_t> queue{first};
    known[first] = true;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const std::size_t next : near[queue[i]]) {
        const double turn = angle_[next] - angle_[queue[i]];
        if (!known[next]) {
          angle_[next] -= 2.0 * pi * std::round(turn / (2.0 * pi));
          known[next] = true;
          queue.push_back(next);
        }
      }
    }
    for (std::size_t v = 0; v < angle_.size(); ++v) {
      for (const std::size_t next : near[v]) {
        round_ = round_ || std::abs(angle_[next] - angle_[v]) > pi;
      }
    }
  }

  const FacetTriangulation& net_;
  std::vector<double> angle_;
  bool round_ = false;
};

/// The vertex farthest from a point, the first of several.
int farthest_from(const ChartPatch& patch, const Vec3& from) {
  int best = 0;
  double most = -1.0;
  for (std::size_t v = 0; v < patch.net.vertices().size(); ++v) {
    const double away = rounded((patch.net.vertices()[v] - from).norm() / patch.plane.length);
    if (away > most) {
      most = away;
      best = static_cast<int>(v);
    }
  }
  return best;
}

/// For each facet sum W_j U_j = 0, real and imaginary part, in the sense of least squares; U of two
/// vertices is given, 0 and 1.
class ConformalEquations {
public:
  ConformalEquations(const FacetTriangulation& net, int p, int q)
      : p_(p), q_(q), size_(2 * static_cast<Eigen::Index>(net.vertices().size())),
        right_(base::Vector::Zero(2 * static_cast<Eigen::Index>(net.facets().size()))) {
    for (const FacetTriangulation::SurfaceFacet& facet : net.facets()) {
      add(net, facet);
    }
  }

  /// [2 v], [2 v + 1] parameters of vertex v.
  [[nodiscard]] std::optional<base::Vector> solve() const {
    Eigen::SparseMatrix<double> A(right_.size(), size_);
    A.setFromTriplets(entries_.begin(), entries_.end());
    Eigen::SparseMatrix<double> N = A.transpose() * A;
    for (const int fixed : {2 * p_, 2 * p_ + 1, 2 * q_, 2 * q_ + 1}) {
      N.coeffRef(fixed, fixed) = 1.0;
    }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(N);
    if (factor.info() != Eigen::Success) {
      return std::nullopt;
    }
    base::Vector u = factor.solve(A.transpose() * right_);
    u[2 * static_cast<Eigen::Index>(q_)] = 1.0;
    return u;
  }

private:
  void add(const FacetTriangulation& net, const FacetTriangulation::SurfaceFacet& facet) {
    const auto [a, b, c] = net.corners(facet);
    const Vec3 normal = area_vector(net, facet);
    const Vec3 e1 = (b - a).normalized();
    const Vec3 e2 = normal.normalized().cross(e1);
    const double part = 1.0 / std::sqrt(std::max(2.0 * normal.norm(), 1e-300));
    const std::array<Vec3, 3> against{c - b, a - c, b - a};
    for (std::size_t j = 0; j < 3; ++j) {
      const double re = part * against[j].dot(e1);
      const double im = part * against[j].dot(e2);
      const int v = facet.vertex[j];
      if (v == q_) {
        right_[row_] -= re;
        right_[row_ + 1] -= im;
      } else if (v != p_) {
        entries_.insert(entries_.end(), {{row_, 2 * v, re},
                                         {row_, 2 * v + 1, -im},
                                         {row_ + 1, 2 * v, im},
                                         {row_ + 1, 2 * v + 1, re}});
      }
    }
    row_ += 2;
  }

  int p_, q_;
  Eigen::Index size_;
  int row_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
  base::Vector right_;
};

} // namespace

bool has_no_inverted_facets(const FacetTriangulation& net,
                            const FlattenedVertexCoordinates& places) {
  return std::ranges::all_of(net.facets(), [&](const FacetTriangulation::SurfaceFacet& facet) {
    const Vec2& a = places[static_cast<std::size_t>(facet.vertex[0])];
    const Vec2& b = places[static_cast<std::size_t>(facet.vertex[1])];
    const Vec2& c = places[static_cast<std::size_t>(facet.vertex[2])];
    return cross(b - a, c - a) > 0.0;
  });
}

std::optional<ChartPlaneFrame> frame_of_plane_patch(const ChartPatch& patch) {
  const ChartPlaneFrame frame = mean_plane_frame(patch);
  const Vec3 normal = frame.e1.cross(frame.e2);
  const Vec3& first = patch.net.vertices().front();
  const double most = is_flat * geometry::Box<3>::around(patch.net.vertices()).diagonal();
  const bool flat = std::ranges::all_of(patch.net.vertices(), [&](const Vec3& x) {
    return std::abs((x - first).dot(normal)) <= most;
  });
  return flat ? std::optional(frame) : std::nullopt;
}

ChartPlaneFrame mean_plane_frame(const ChartPatch& patch) {
  Vec3 normal = Vec3::Zero();
  for (const FacetTriangulation::SurfaceFacet& facet : patch.net.facets()) {
    normal += area_vector(patch.net, facet);
  }
  return frame_across(normal.normalized(), patch.plane);
}

std::optional<FlattenedVertexCoordinates> unroll_cylinder(const ChartPatch& patch) {
  const std::optional<Cylinder> cylinder = fit_cylinder(patch);
  if (!cylinder) {
    return std::nullopt;
  }
  const Angles angles(patch.net, *cylinder);
  const double R = cylinder->radius;
  double sense = 0.0; // of a pin above 0
  for (const FacetTriangulation::SurfaceFacet& facet : patch.net.facets()) {
    const auto [a, b, c] = patch.net.corners(facet);
    const Vec3 d = (a + b + c) / 3.0 - cylinder->point;
    sense += area_vector(patch.net, facet).dot(d - d.dot(cylinder->axis) * cylinder->axis);
  }
  sense = sense < 0.0 ? -1.0 : 1.0;
  std::vector<double> z;
  for (const Vec3& x : patch.net.vertices()) {
    z.push_back((x - patch.plane.origin).dot(cylinder->axis));
  }
  const auto [low, high] = std::ranges::minmax(z);
  if (angles.round() && high - low > longest * R) {
    return std::nullopt;
  }
  FlattenedVertexCoordinates places;
  for (std::size_t v = 0; v < z.size(); ++v) {
    const double angle = sense * angles.angle()[v];
    if (angles.round()) {
      const double radius = R / patch.plane.length * std::exp((z[v] - 0.5 * (low + high)) / R);
      places.emplace_back(radius * std::cos(angle), -radius * std::sin(angle));
    } else {
      places.emplace_back(R / patch.plane.length * angle, z[v] / patch.plane.length);
    }
  }
  return places;
}

std::optional<FlattenedVertexCoordinates> conformal_map(const ChartPatch& patch) {
  const FacetTriangulation& net = patch.net;
  const int p = farthest_from(patch, net.vertices().front());
  const int q = farthest_from(patch, net.vertices()[static_cast<std::size_t>(p)]);
  const std::optional<base::Vector> u = ConformalEquations(net, p, q).solve();
  if (!u) {
    return std::nullopt;
  }
  FlattenedVertexCoordinates places;
  for (Eigen::Index v = 0; v < u->size(); v += 2) {
    places.emplace_back(u->segment<2>(v));
  }
  double area = 0.0;
  double flat = 0.0;
  for (const FacetTriangulation::SurfaceFacet& facet : net.facets()) {
    const auto at = [&](std::size_t k) {
      return places[static_cast<std::size_t>(facet.vertex[k])];
    };
    area += area_vector(net, facet).norm();
    flat += 0.5 * cross(at(1) - at(0), at(2) - at(0));
  }
  if (!(flat > 0.0)) {
    return std::nullopt;
  }
  for (Vec2& place : places) {
    place *= std::sqrt(area / flat) / patch.plane.length;
  }
  return places;
}

} // namespace spricka::mesh
