// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/ties.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"
#include "shape/topology.hpp"
#include "tests/unit/mesh/distorted.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

// TRANSITION on every side of every element against fields that the ties must let through, RIGID on
// clouds of nodes against rigid motions. Slave nodes belong to no element: ties do not ask.
namespace spricka::fe::test_ties {
namespace {

using base::NodeId;
using base::Vec2;
using base::Vec3;
using Motion = std::function<Vec3(const Vec3&)>;

class Random {
public:
  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }
  Vec3 vec(int dim) {
    const Vec3 all(number(), number(), number());
    return dim == 3 ? all : Vec3(all.x(), all.y(), 0.0);
  }

private:
  std::mt19937 engine_{20240131};
};

/// Residuals of all ties for a nodal vector, the largest of them.
double residual(const std::vector<Tie>& ties, const base::Vector& u) {
  double worst = 0.0;
  for (const Tie& tie : ties) {
    double sum = -tie.rhs;
    for (const FreedomTerm& t : tie.terms) {
      sum += t.coefficient * u[t.freedom];
    }
    worst = std::max(worst, std::abs(sum));
  }
  return worst;
}

base::Vector nodal(const model::Mesh& mesh, const Motion& motion) {
  base::Vector u(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    u.segment(mesh.dim * static_cast<Eigen::Index>(n), mesh.dim) = motion(mesh.x[n]).head(mesh.dim);
  }
  return u;
}

// A small rotation about the origin and a translation.
Motion rigid(const Vec3& t, const Vec3& theta) {
  return [t, theta](const Vec3& x) { return Vec3(t + theta.cross(x)); };
}

/// One master element with all its sides as masters; slave nodes are added on them.
class Master {
public:
  model::Model model;
  std::vector<TieFailure> troubles;

  // Straight sides (planes, for quadrilaterals too), or mid nodes and corners off their places.
  Master(base::ElementType type, bool curved) {
    const int dim = base::element_info(type).dim;
    mesh().dim = dim;
    std::vector<NodeId> nodes;
    Eigen::Matrix3d A;
    A << 1.7, 0.3, 0.2, -0.2, 1.1, 0.1, 0.1, -0.3, 1.4;
    for (int i = 0; i < base::element_info(type).nodes; ++i) {
      Vec3 r = Vec3::Zero();
      if (dim == 2) {
        r.head<2>() = shape::reference_element<2>(type).node_local_coordinates(i);
      } else {
        r = shape::reference_element<3>(type).node_local_coordinates(i);
      }
      Vec3 x = A.leftCols(dim) * r.head(dim) + Vec3(0.5, -2.0, 1.0);
      if (curved) {
        for (int c = 0; c < dim; ++c) {
          x[c] += 0.05 * std::sin(3.0 * i + 5.0 * c);
        }
      }
      x[2] = dim == 3 ? x[2] : 0.0;
      nodes.push_back(model::add_node(mesh(), x, 100 + i, base::NetId(0)));
    }
    model::add_element(mesh(), type, nodes, 1, base::NetId(0));
    model::FaceSet sides;
    for (int s = 0; s < base::element_info(type).sides; ++s) {
      sides.faces.push_back({base::ElementId(0), s});
    }
    mesh().face_sets.push_back(sides);
    mesh().node_sets.emplace_back();
    model.mpcs.emplace_back(model::TransitionTie{base::NodeSetId(0), base::FaceSetId(0), {}});
  }

  model::Mesh& mesh() { return model.mesh; }
  NodeId add_slave(const Vec3& x) {
    const NodeId n = model::add_node(mesh(), x, 1000 + next_++, base::NetId(0));
    add_slave(n);
    return n;
  }
  void add_slave(NodeId n) { mesh().node_sets[0].nodes.push_back(n); }

  // Calls f(side, face, r) for some points inside each side.
  template <class F> void for_points(F&& f) {
    const std::vector<model::Face> sides = mesh().face_sets[0].faces;
    for (const model::Face& face : sides) {
      const geometry::ElementSide side = model::element_side(mesh(), face);
      const bool triangle = side.domain() == shape::ReferenceDomain::triangle;
      for (const double a : {0.13, 0.4}) {
        for (const double b : {0.21, 0.55}) {
          const Vec2 r = triangle ? Vec2(a, b) : Vec2(2.0 * a - 1.0, 2.0 * b - 1.0);
          f(side, face, side.local_dim() == 1 ? Vec2(r[0], 0.0) : r);
        }
      }
    }
  }
  // Slaves off the sides by a share of the side's size along its normal.
  void add_slaves(double off) {
    for_points([&](const geometry::ElementSide& side, const model::Face&, const Vec2& r) {
      const double size = (side.X.colwise() - side.X.col(0)).colwise().norm().maxCoeff();
      add_slave(side.position(r) + off * size * side.point(r).normal());
    });
  }
  std::vector<Tie> ties() { return make_ties(model, mesh(), troubles); }

private:
  int next_ = 0;
};

class EveryMaster : public testing::TestWithParam<base::ElementType> {
protected:
  [[nodiscard]] static int dim() { return base::element_info(GetParam()).dim; }
};
INSTANTIATE_TEST_SUITE_P(Elements, EveryMaster, testing::ValuesIn(test::all_types),
                         [](const auto& type) {
                           return std::string(base::element_info(type.param).name);
                         });

TEST_P(EveryMaster, transition_passes_constant_strain_on_straight_sides) {
  Master master(GetParam(), false);
  master.add_slaves(0.0);
  const std::vector<Tie> ties = master.ties();
  EXPECT_TRUE(master.troubles.empty());
  EXPECT_EQ(ties.size(), static_cast<std::size_t>(dim()) * master.mesh().node_sets[0].nodes.size());
  Random random;
  for (int trial = 0; trial < 5; ++trial) {
    Eigen::Matrix3d H;
    H << random.vec(3), random.vec(3), random.vec(3);
    const base::Vector u =
        nodal(master.mesh(), [&](const Vec3& x) { return Vec3(H * x + H.col(0)); });
    EXPECT_LT(residual(ties, u), 1e-13);
  }
}

// Any displacement of the side's own nodes, quadratic where the side is, also on curved sides: the
// slave moves as the point of the side that it lies on.
TEST_P(EveryMaster, transition_follows_the_sides_own_field) {
  for (const bool curved : {false, true}) {
    Master master(GetParam(), curved);
    const int dim = EveryMaster::dim();
    Random random;
    const int nodes = base::element_info(GetParam()).nodes;
    std::vector<Vec3> U;
    U.reserve(static_cast<std::size_t>(nodes));
    for (int i = 0; i < nodes; ++i) {
      U.push_back(random.vec(dim));
    }
    master.for_points(
        [&](const geometry::ElementSide& side, const model::Face& face, const Vec2& r) {
          const geometry::SideValues N = side.N(r);
          master.add_slave(side.X * N);
          Vec3 u = Vec3::Zero();
          Eigen::Index i = 0; // of the element's own nodes, which are the first
          for (const int n : shape::side_nodes(GetParam(), face.side)) {
            u += N[i++] * U[static_cast<std::size_t>(n)];
          }
          U.push_back(u);
        });
    const std::vector<Tie> ties = master.ties();
    EXPECT_TRUE(master.troubles.empty());
    base::Vector u(dim * static_cast<Eigen::Index>(U.size()));
    for (std::size_t n = 0; n < U.size(); ++n) {
      u.segment(dim * static_cast<Eigen::Index>(n), dim) = U[n].head(dim);
    }
    EXPECT_LT(residual(ties, u), 1e-12) << (curved ? "curved" : "straight");
    for (const Tie& tie : ties) { // it is the slave that follows
      EXPECT_GE(tie.terms.front().freedom, dim * base::element_info(GetParam()).nodes);
    }
  }
}

TEST_P(EveryMaster, transition_leaves_rigid_motions_free_off_curved_sides) {
  for (const double off : {0.05, -0.03}) {
    Master master(GetParam(), true);
    master.add_slaves(off);
    const std::vector<Tie> ties = master.ties();
    ASSERT_EQ(master.troubles.size(), 1U);
    EXPECT_EQ(master.troubles.front().severity, TieSeverity::note); // carried along, which is said
    Random random;
    for (int trial = 0; trial < 5; ++trial) {
      const Vec3 theta = dim() == 3 ? random.vec(3) : Vec3(Vec3(0.0, 0.0, random.number()));
      const base::Vector u = nodal(master.mesh(), rigid(random.vec(dim()), theta));
      EXPECT_LT(residual(ties, u), 1e-12);
    }
  }
}

TEST_P(EveryMaster, transition_refuses_a_node_far_away_by_its_name) {
  Master master(GetParam(), false);
  master.add_slaves(0.0);
  const NodeId far = master.add_slave(master.mesh().x[0] - Vec3(9.0, 9.0, 0.0));
  master.ties();
  ASSERT_EQ(master.troubles.size(), 1U);
  EXPECT_EQ(master.troubles.front().severity, TieSeverity::error);
  const std::string name = "node " + std::to_string(master.mesh().node_label[far.index()]) + " ";
  EXPECT_NE(master.troubles.front().why.find(name), std::string::npos)
      << master.troubles.front().why;
}

TEST_P(EveryMaster, transition_leaves_out_nodes_of_the_master) {
  Master master(GetParam(), true);
  const NodeId slave = master.add_slave(master.mesh().x[1]); // another node at the same place
  master.add_slave(NodeId(std::size_t{0}));
  master.add_slave(NodeId(std::size_t{1}));
  const std::vector<Tie> ties = master.ties();
  EXPECT_TRUE(master.troubles.empty());
  const int dim = EveryMaster::dim();
  ASSERT_EQ(ties.size(), static_cast<std::size_t>(dim));
  for (int c = 0; c < dim; ++c) { // u_slave = u_1 and nothing else
    const std::vector<FreedomTerm>& terms = ties[static_cast<std::size_t>(c)].terms;
    EXPECT_EQ(terms[0].freedom, dim * slave.value + c);
    double others = 0.0;
    for (const FreedomTerm& t : terms) {
      if (t.freedom == dim + c) {
        EXPECT_NEAR(t.coefficient, -1.0, 1e-12);
      } else if (t.freedom != terms[0].freedom) {
        others += std::abs(t.coefficient);
      }
    }
    EXPECT_LT(others, 1e-12);
  }
}

struct Cloud {
  const char* name;
  int dim;
  std::vector<Vec3> x;
  Eigen::Index freedoms; ///< of one rigid body with these nodes
};

std::vector<Cloud> clouds() {
  Random random;
  std::vector<Cloud> all;
  for (const int dim : {2, 3}) {
    const Eigen::Index full = dim == 2 ? 3 : 6;
    const Eigen::Index line = dim == 2 ? 3 : 5;
    const auto some = [&](std::size_t n) {
      std::vector<Vec3> x;
      x.reserve(n);
      for (std::size_t i = 0; i < n; ++i) {
        x.push_back(random.vec(dim));
      }
      return x;
    };
    all.push_back({"two", dim, some(2), line});
    all.push_back({"three", dim, some(3), full});
    all.push_back({"many", dim, some(25), full});
    std::vector<Vec3> straight;
    const Vec3 d = random.vec(dim);
    straight.reserve(6);
    for (int i = 0; i < 6; ++i) {
      straight.emplace_back(Vec3(0.3, -0.2, 0.0) + random.number() * d);
    }
    all.push_back({"collinear", dim, straight, line});
    std::vector<Vec3> doubled = some(4);
    doubled.insert(doubled.begin(), doubled.back());
    doubled.push_back(doubled[2]);
    all.push_back({"some coincident", dim, doubled, full});
    all.push_back({"all coincident", dim, std::vector<Vec3>(4, random.vec(dim)), dim});
    std::vector<Vec3> far = some(8);
    for (Vec3& x : far) {
      x += Vec3(40.0, -70.0, dim == 3 ? 55.0 : 0.0);
    }
    all.push_back({"far from the origin", dim, far, full});
  }
  return all;
}

model::Model rigid_model(const Cloud& cloud, double scale) {
  model::Model model;
  model.mesh.dim = cloud.dim;
  model.mesh.node_sets.emplace_back();
  for (const Vec3& x : cloud.x) {
    const auto label = static_cast<base::Label>(model.mesh.node_count());
    model.mesh.node_sets[0].nodes.push_back(
        model::add_node(model.mesh, scale * x, label, base::NetId(0)));
  }
  model.mpcs.emplace_back(model::RigidTie{base::NodeSetId(0), {}});
  return model;
}

TEST(RigidTie, LetsRigidMotionsThroughAndNothingElse) {
  for (const Cloud& cloud : clouds()) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
      SCOPED_TRACE(testing::Message() << cloud.name << ", " << cloud.dim << "D, " << scale);
      const model::Model model = rigid_model(cloud, scale);
      const model::Mesh& mesh = model.mesh;
      std::vector<TieFailure> troubles;
      const std::vector<Tie> ties = make_ties(model, mesh, troubles);
      EXPECT_TRUE(troubles.empty());
      const int dim = mesh.dim;
      const auto n = static_cast<Eigen::Index>(mesh.node_count());
      const ConstraintTransformation dependence(
          ties, std::vector<model::FreedomRole>(static_cast<std::size_t>(dim * n),
                                                model::FreedomRole::local));
      EXPECT_EQ(dim * n - static_cast<Eigen::Index>(dependence.rows().size()), cloud.freedoms);
      EXPECT_TRUE(dependence.fully_given_ties().empty());
      Random random;
      for (int trial = 0; trial < 5; ++trial) {
        const Vec3 theta = dim == 3 ? random.vec(3) : Vec3(Vec3(0.0, 0.0, random.number()));
        base::Vector u = nodal(mesh, rigid(scale * random.vec(dim), theta));
        const double size = u.lpNorm<Eigen::Infinity>();
        EXPECT_LT(residual(ties, u), 1e-12 * size);
        const base::Vector before = u;
        dependence.set_dependent_displacements(u, 1.0);
        EXPECT_LT((u - before).lpNorm<Eigen::Infinity>(), 1e-11 * size);

        // whatever the independent freedoms do, no distance changes
        u = base::Vector::NullaryExpr(dim * n, [&] { return random.number(); });
        dependence.set_dependent_displacements(u, 1.0);
        double worst = 0.0;
        for (Eigen::Index i = 0; i < n; ++i) {
          for (Eigen::Index j = 0; j < i; ++j) {
            const Vec3 d =
                mesh.x[static_cast<std::size_t>(i)] - mesh.x[static_cast<std::size_t>(j)];
            const auto du = u.segment(dim * i, dim) - u.segment(dim * j, dim);
            worst = std::max(worst, std::abs(du.dot(d.head(dim))) / scale);
          }
        }
        EXPECT_LT(worst, 1e-11 * u.lpNorm<Eigen::Infinity>());
      }
    }
  }
}

TEST(RigidTie, OfOneNodeTiesNothing) {
  std::vector<TieFailure> troubles;
  const model::Model model = rigid_model({"one", 3, {Vec3(1.0, 2.0, 3.0)}, 3}, 1.0);
  EXPECT_TRUE(make_ties(model, model.mesh, troubles).empty());
}

TEST(Equation, NamesFreedomsOfNodes) {
  model::Model model = rigid_model({"two", 3, {Vec3::Zero(), Vec3::UnitX()}, 5}, 1.0);
  model.mpcs.clear();
  model.mpcs.emplace_back(model::ConstraintEquation{
      {{2.0, NodeId(std::size_t{1}), 2}, {-1.0, NodeId(std::size_t{0}), 1}}, 0.25, {}});
  std::vector<TieFailure> troubles;
  const std::vector<Tie> ties = make_ties(model, model.mesh, troubles);
  ASSERT_EQ(ties.size(), 1U);
  EXPECT_DOUBLE_EQ(ties[0].rhs, 0.25);
  ASSERT_EQ(ties[0].terms.size(), 2U);
  EXPECT_EQ(ties[0].terms[0].freedom, 5);
  EXPECT_DOUBLE_EQ(ties[0].terms[0].coefficient, 2.0);
  EXPECT_EQ(ties[0].terms[1].freedom, 1);
  EXPECT_DOUBLE_EQ(ties[0].terms[1].coefficient, -1.0);
}

} // namespace
} // namespace spricka::fe::test_ties
