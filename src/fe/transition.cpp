// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/transition.hpp"

#include "base/by_dimension.hpp"
#include "model/freedoms.hpp"
#include "model/mesh.hpp"
#include "model/mesh_side.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace spricka::fe {

namespace {

using base::Matrix;
using base::Vec3;

// A slave farther off the master faces than this share of a face is not meant to be tied to them;
// the two sides of a faceted arc of 30 degrees per face are 0.065 apart.
constexpr double farthest = 0.1;
// Worth a note: more than round-off of coordinates.
constexpr double noticeable = 1e-6;
// How far a slave node may lie off the face of its side's middle, in sizes of that face.
constexpr double straddle = 1e-3;

/// What ties a slave node to a face: u_s = sum of weight[i] u_i, weight [dim, dim * nodes].
struct Hit {
  model::Face face;
  Matrix weight;
  std::vector<base::NodeId> nodes;
  double distance = std::numeric_limits<double>::infinity();
  double size = 1.0;
};

struct FaceBall {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
};

FaceBall ball_of(const model::Mesh& mesh, const model::Face& face) {
  const std::vector<base::NodeId> nodes = model::side_nodes(mesh, face);
  FaceBall ball;
  for (const base::NodeId n : nodes) {
    ball.centre += mesh.x[n.index()];
  }
  ball.centre /= static_cast<double>(nodes.size());
  for (const base::NodeId n : nodes) {
    ball.radius = std::max(ball.radius, (mesh.x[n.index()] - ball.centre).norm());
  }
  ball.radius *= 1.25; // curved sides bulge beyond their nodes
  return ball;
}

// The matrix of a cross product: cross(a) b = a x b.
Eigen::Matrix3d cross(const Vec3& a) {
  Eigen::Matrix3d A;
  A << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return A;
}

// Corners of a plane side lie on a line: about it the inertia is zero.
Eigen::Matrix3d inverse_about_normal(const Eigen::Matrix3d& inertia) {
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  inverse(2, 2) = 1.0 / inertia(2, 2);
  return inverse;
}
Eigen::Matrix3d inverse_in_space(const Eigen::Matrix3d& inertia) {
  return inertia.inverse();
}
constexpr base::ByDimension inverse_inertia{&inverse_about_normal, &inverse_in_space};

// Rotation of the corners X [3, n] by least squares: theta = sum of A_i u_i, A_i [3, 3]. In the
// plane only that about z.
std::vector<Eigen::Matrix3d> rotation_of(const Eigen::Matrix3Xd& X, int dim) {
  const Vec3 centre = X.rowwise().mean();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < X.cols(); ++i) {
    const Vec3 r = X.col(i) - centre;
    inertia += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
  }
  const Eigen::Matrix3d inverse = inverse_inertia.at(dim)(inertia);
  std::vector<Eigen::Matrix3d> A;
  for (Eigen::Index i = 0; i < X.cols(); ++i) {
    // theta = I^-1 sum of r_i x u_i: translations drop out, as the r_i sum to zero.
    A.emplace_back(inverse * cross(X.col(i) - centre));
  }
  return A;
}

Hit hit_of(const model::Mesh& mesh, const model::Face& face, const Vec3& x) {
  Hit hit;
  hit.face = face;
  const geometry::ElementSide side = model::element_side(mesh, face);
  hit.nodes = side.nodes;
  const geometry::SideValues N = side.N(side.nearest_local_coordinates(x));
  const Vec3 off = x - side.X * N;
  hit.distance = off.norm();
  hit.size = (side.X.colwise() - side.X.col(0)).colwise().norm().maxCoeff();
  const Eigen::Index dim = mesh.dim;
  hit.weight = Matrix::Zero(dim, dim * N.size());
  for (Eigen::Index i = 0; i < N.size(); ++i) {
    hit.weight.middleCols(dim * i, dim).diagonal().setConstant(N[i]);
  }
  const Eigen::Index corners = side.corner_count();
  const auto A = rotation_of(side.X.leftCols(corners), mesh.dim);
  for (Eigen::Index i = 0; i < corners; ++i) {
    // omega x off = - off x omega (fe.31).
    const Eigen::Matrix3d carried = -cross(off) * A[static_cast<std::size_t>(i)];
    hit.weight.middleCols(dim * i, dim) += carried.topLeftCorner(dim, dim);
  }
  return hit;
}

bool has_node(const model::Mesh& mesh, const model::Face& face, base::NodeId node) {
  const std::vector<base::NodeId> nodes = model::side_nodes(mesh, face);
  return std::ranges::find(nodes, node) != nodes.end();
}

void add_ties(const model::Mesh& mesh, base::NodeId slave, const Hit& hit, std::size_t mpc,
              std::vector<Tie>& ties) {
  const int dim = mesh.dim;
  const auto freedom = [&](base::NodeId n, int c) {
    return static_cast<std::int32_t>(n.index()) * dim + c;
  };
  for (int c = 0; c < dim; ++c) {
    Tie tie;
    tie.mpc = mpc;
    tie.terms.push_back({freedom(slave, c), 1.0});
    for (std::size_t i = 0; i < hit.nodes.size(); ++i) {
      for (int b = 0; b < dim; ++b) {
        const double w = hit.weight(c, static_cast<Eigen::Index>(i) * dim + b);
        // Weights of a face are of order 1: less is round-off.
        if (std::abs(w) > 1e-14) {
          tie.terms.push_back({freedom(hit.nodes[i], b), -w});
        }
      }
    }
    ties.push_back(std::move(tie));
  }
}

// The master face nearest to a point, at an infinite distance where there is none.
Hit nearest(const model::Mesh& mesh, const std::vector<model::Face>& faces,
            const std::vector<FaceBall>& balls, const Vec3& x) {
  Hit best;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    // No point of the face is nearer than its ball.
    if ((x - balls[f].centre).norm() - balls[f].radius < best.distance) {
      Hit hit = hit_of(mesh, faces[f], x);
      if (hit.distance < best.distance) {
        best = std::move(hit);
      }
    }
  }
  return best;
}

// A master face that ends where `best` does but hangs together with it in no node: a crack opens
// there, or two bodies stand side by side.
std::optional<Hit> across_mouth(const model::Mesh& mesh, const std::vector<model::Face>& faces,
                                const std::vector<FaceBall>& balls, const Vec3& x,
                                const Hit& best) {
  constexpr double same = 1e-9;
  for (std::size_t f = 0; f < faces.size() && mesh.dim == 2; ++f) {
    const double reach = best.distance + same * best.size;
    if (faces[f] == best.face || (x - balls[f].centre).norm() - balls[f].radius > reach) {
      continue;
    }
    Hit hit = hit_of(mesh, faces[f], x);
    const bool joined = std::ranges::any_of(
        hit.nodes, [&](base::NodeId n) { return has_node(mesh, best.face, n); });
    if (!joined && hit.distance <= reach) {
      return hit;
    }
  }
  return std::nullopt;
}

// At a mouth the slave is tied to the faces that its own sides go along.
struct SidesAlongFaces {
  bool best = false, other = false;
};

SidesAlongFaces goes_along(const model::Mesh& mesh, const std::vector<model::Face>& sides,
                           base::NodeId slave, const Hit& best, const Hit& other) {
  const Vec3& x = mesh.x[slave.index()];
  const Vec3 to_best = (ball_of(mesh, best.face).centre - x).normalized();
  const Vec3 to_other = (ball_of(mesh, other.face).centre - x).normalized();
  SidesAlongFaces along;
  for (const model::Face& side : sides) {
    if (has_node(mesh, side, slave)) {
      const Vec3 way = ball_of(mesh, side).centre - x;
      (way.dot(to_best) >= way.dot(to_other) ? along.best : along.other) = true;
    }
  }
  return along;
}

// Ties at points hand a constant stress over exactly only where meshes nest: a fine side on two
// coarse faces sends its forces to the wrong nodes of both.
void warn_of_straddling(const model::Mesh& mesh, const model::TransitionTie& transition,
                        std::size_t mpc, const std::vector<FaceBall>& balls,
                        const std::vector<model::Face>& sides, std::vector<TieFailure>& troubles) {
  const std::vector<model::Face>& faces = mesh.set_with_id(transition.master).faces;
  int count = 0;
  base::ElementId first;
  for (const model::Face& side : sides) {
    const Hit middle = nearest(mesh, faces, balls, ball_of(mesh, side).centre);
    for (const base::NodeId n : model::side_nodes(mesh, side)) {
      const Vec3& x = mesh.x[n.index()];
      const double off = hit_of(mesh, middle.face, x).distance;
      if (off > nearest(mesh, faces, balls, x).distance + straddle * middle.size) {
        first = count == 0 ? side.element : first;
        ++count;
        break;
      }
    }
  }
  if (count > 0) {
    troubles.push_back({mpc,
                        fmt::format("{} slave side(s) span several master faces (element {}): "
                                    "stresses near the tie are some per cent off; $CONTACT "
                                    "TYPE=BONDED joins such meshes exactly",
                                    count, mesh.element_label[first.index()]),
                        TieSeverity::warning});
  }
}

} // namespace

void tie_slaves_to_master_faces(const model::Mesh& mesh, const model::TransitionTie& transition,
                                std::size_t mpc, std::vector<Tie>& ties,
                                std::vector<TieFailure>& troubles) {
  const std::vector<model::Face>& faces = mesh.set_with_id(transition.master).faces;
  std::vector<FaceBall> balls;
  std::set<base::NodeId> master;
  for (const model::Face& face : faces) {
    balls.push_back(ball_of(mesh, face));
    std::ranges::copy(model::side_nodes(mesh, face), std::inserter(master, master.end()));
  }
  const std::vector<model::Face> sides =
      model::sides_with_all_nodes_in(mesh, mesh.set_with_id(transition.slave).nodes);
  double worst = 0.0;
  base::NodeId worst_node;
  for (const base::NodeId slave : mesh.set_with_id(transition.slave).nodes) {
    const Vec3& x = mesh.x[slave.index()];
    if (master.contains(slave)) {
      continue; // it is a node of the coarse side itself
    }
    const Hit best = nearest(mesh, faces, balls, x);
    if (!(best.distance <= farthest * best.size)) {
      troubles.push_back({mpc, fmt::format("node {} does not lie on the master faces: the nearest "
                                           "point of them is {:.3g} away",
                                           mesh.node_label[slave.index()], best.distance)});
      return;
    }
    if (best.distance > noticeable * best.size && best.distance > worst) {
      worst = best.distance;
      worst_node = slave;
    }
    const std::optional<Hit> other = across_mouth(mesh, faces, balls, x, best);
    const SidesAlongFaces along =
        other ? goes_along(mesh, sides, slave, best, *other) : SidesAlongFaces{true, false};
    if (!along.best && !along.other) {
      troubles.push_back({mpc, fmt::format("the master opens at node {}, and no side of the slave "
                                           "there tells to which part it is tied",
                                           mesh.node_label[slave.index()])});
      return;
    }
    if (along.best) {
      add_ties(mesh, slave, best, mpc, ties);
    }
    if (along.other) {
      add_ties(mesh, slave, *other, mpc, ties);
    }
  }
  if (worst > 0.0) {
    troubles.push_back({mpc,
                        fmt::format("slave nodes lie up to {:.3g} off the master faces (node {}); "
                                    "they are carried along rigidly",
                                    worst, mesh.node_label[worst_node.index()]),
                        TieSeverity::note});
  }
  warn_of_straddling(mesh, transition, mpc, balls, sides, troubles);
}

} // namespace spricka::fe
