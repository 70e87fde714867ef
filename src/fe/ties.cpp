// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/ties.hpp"

#include "fe/transition.hpp"
#include "model/model.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::fe {

namespace {

using base::NodeId;
using base::Vec3;

// Nodes closer together than this share of the body count as one point or one line.
constexpr double together = 1e-9;

Tie equation(const model::Mesh& mesh, const model::ConstraintEquation& given, std::size_t mpc) {
  Tie tie;
  tie.mpc = mpc;
  tie.rhs = given.rhs;
  for (const model::ConstraintEquation::ConstraintTerm& t : given.terms) {
    tie.terms.push_back(
        {static_cast<std::int32_t>(t.node.index()) * mesh.dim + t.dof, t.coefficient});
  }
  return tie;
}

/// One rigid body: a node a, whose displacement it has, and rotations about it told by others.
/// With e1 from a to the farthest node b, and e2 across it to the node c farthest from that line,
/// the rotation is theta = theta_1 e1 + theta_2 e2 + theta_3 e3, where u_b - u_a = theta x (b - a)
/// gives theta_2 and theta_3 and u_c - u_a gives theta_1.
class RigidBody {
public:
  RigidBody(const model::Mesh& mesh, std::vector<NodeId> nodes, std::size_t mpc)
      : mesh_(mesh), nodes_(std::move(nodes)), mpc_(mpc), a_(nodes_.front()) {
    // Long levers: rotations told by nodes close together would magnify round-off.
    b_ = farthest([&](const Vec3& d) { return d.norm(); });
    const Vec3 along = at(b_);
    length_ = along.norm();
    if (length_ == 0.0) {
      return;
    }
    e_[0] = along / length_;
    if (mesh.dim == 2) {
      e_[2] = Vec3::UnitZ();
      e_[1] = e_[2].cross(e_[0]);
      return;
    }
    c_ = farthest([&](const Vec3& d) { return d.cross(e_[0]).norm(); });
    const Vec3 across = at(c_) - at(c_).dot(e_[0]) * e_[0];
    alpha_ = at(c_).dot(e_[0]);
    beta_ = across.norm();
    if (beta_ <= together * length_) { // all on a line: nothing turns about it
      beta_ = 0.0;
      e_[1] = e_[0].unitOrthogonal();
    } else {
      e_[1] = across / beta_;
    }
    e_[2] = e_[0].cross(e_[1]);
  }

  void add_ties(std::vector<Tie>& ties) const {
    for (const NodeId s : nodes_) {
      if (s == a_) {
        continue;
      }
      if (length_ > 0.0 && s == b_) {
        // Across e1 b moves freely: that is what tells the rotation. Likewise c along e3 (fe.32).
        ties.push_back(along(b_, e_[0]));
      } else if (beta_ > 0.0 && s == c_) {
        ties.push_back(along(c_, e_[0]));
        ties.push_back(along(c_, e_[1]));
      } else {
        for (int i = 0; i < mesh_.dim; ++i) {
          ties.push_back(along(s, Vec3::Unit(i)));
        }
      }
    }
  }

private:
  using Sum = std::map<std::int32_t, double>;

  [[nodiscard]] Vec3 at(NodeId n) const { return mesh_.x[n.index()] - mesh_.x[a_.index()]; }

  template <class Measure> NodeId farthest(Measure&& measure) const {
    return *std::ranges::max_element(
        nodes_, [&](NodeId p, NodeId q) { return measure(at(p)) < measure(at(q)); });
  }

  // factor * direction . (u_n - u_a)
  void add_motion(NodeId n, const Vec3& direction, double factor, Sum& sum) const {
    for (int i = 0; i < mesh_.dim; ++i) {
      const double c = factor * direction[i];
      sum[static_cast<std::int32_t>(n.index()) * mesh_.dim + i] += c;
      sum[static_cast<std::int32_t>(a_.index()) * mesh_.dim + i] -= c;
    }
  }

  // theta_k times a factor.
  void add_rotation(int k, double factor, Sum& sum) const {
    if (factor == 0.0) {
      return;
    }
    if (k == 2) {
      // (u_b - u_a) . e2 = theta_3 length; . e3 = - theta_2 length.
      add_motion(b_, e_[1], factor / length_, sum);
    } else if (k == 1) {
      add_motion(b_, e_[2], -factor / length_, sum);
    } else if (beta_ > 0.0) { // (u_c - u_a) . e3 = theta_1 beta - theta_2 alpha
      add_motion(c_, e_[2], factor / beta_, sum);
      add_rotation(1, factor * alpha_ / beta_, sum);
    }
  }

  // direction . (u_s - u_a - theta x (x_s - x_a)) = 0, to be solved for the component of u_s that
  // the direction holds most of.
  [[nodiscard]] Tie along(NodeId s, const Vec3& direction) const {
    Sum sum;
    add_motion(s, direction, 1.0, sum);
    if (length_ > 0.0) {
      for (int k = 0; k < 3; ++k) { // in the plane only the last one is not 0
        add_rotation(k, -e_[static_cast<std::size_t>(k)].cross(at(s)).dot(direction), sum);
      }
    }
    Eigen::Index most = 0;
    direction.head(mesh_.dim).cwiseAbs().maxCoeff(&most);
    const auto first =
        static_cast<std::int32_t>(s.index()) * mesh_.dim + static_cast<std::int32_t>(most);
    Tie tie;
    tie.mpc = mpc_;
    tie.terms.push_back({first, sum.at(first)});
    for (const auto& [freedom, c] : sum) {
      // Coefficients are of order 1 beside that of the direction: less is round-off.
      if (freedom != first && std::abs(c) > 1e-14) {
        tie.terms.push_back({freedom, c});
      }
    }
    return tie;
  }

  const model::Mesh& mesh_;
  std::vector<NodeId> nodes_;
  std::size_t mpc_;
  NodeId a_, b_, c_;
  std::array<Vec3, 3> e_{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double length_ = 0.0;
  double alpha_ = 0.0, beta_ = 0.0; ///< c - a along e1 and e2
};

} // namespace

std::vector<Tie> make_ties(const model::Model& model, const model::Mesh& mesh,
                           std::vector<TieFailure>& troubles) {
  std::vector<Tie> ties;
  for (std::size_t m = 0; m < model.mpcs.size(); ++m) {
    if (const auto* given = std::get_if<model::ConstraintEquation>(&model.mpcs[m])) {
      ties.push_back(equation(mesh, *given, m));
    } else if (const auto* rigid = std::get_if<model::RigidTie>(&model.mpcs[m])) {
      const std::vector<NodeId>& nodes = mesh.set_with_id(rigid->slave).nodes;
      if (nodes.size() > 1) {
        RigidBody(mesh, nodes, m).add_ties(ties);
      }
    } else if (const auto* transition = std::get_if<model::TransitionTie>(&model.mpcs[m])) {
      tie_slaves_to_master_faces(mesh, *transition, m, ties, troubles);
    }
  }
  return ties;
}

} // namespace spricka::fe
