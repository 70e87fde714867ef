// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pairing.hpp"
#include "contact/recovery.hpp"
#include "contact/rigid_target.hpp"
#include "contact/singular_edges.hpp"
#include "contact/survey.hpp"
#include "model/model.hpp"
#include "two_blocks.hpp"
#include "two_rings.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

// Rigid targets: the upper block of two_blocks.hpp, lower side y = 1, against lines and arcs.
namespace spricka::test_rigid {
namespace {

using base::ElementType;
using base::Vec2;
using test::arc;
using test::block_on;
using test::line;
using test::TwoBlocks;

TwoBlocks plane(ElementType type) {
  TwoBlocks spec;
  spec.type = type;
  spec.state = model::StressState::plane_strain;
  return spec;
}

contact::PairConstraints pair_of(const model::Model& model) {
  return contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
}

// Sum and first moment of the forces of a unit pressure.
struct Resultant {
  double force = 0.0, moment = 0.0;
};
Resultant resultant(const model::Model& model, const contact::PairConstraints& pair) {
  Resultant r;
  for (const contact::ConstraintRow& row : pair.normal) {
    for (const contact::RowEntry& entry : row.entries) {
      r.force += entry.weight.y();
      r.moment += entry.weight.y() * model.mesh.x[entry.node.index()].x();
    }
  }
  return r;
}

class RigidLine : public testing::TestWithParam<ElementType> {};

TEST_P(RigidLine, EndsInsideElementsAreCutExactly) {
  for (const auto& [a, b] : {std::pair(0.37, 1.131), std::pair(0.4, 1.6), std::pair(0.61, 0.63),
                             std::pair(-1.0, 0.013), std::pair(-5.0, 5.0)}) {
    const model::Model model = block_on(plane(GetParam()), line(a, 1.0, b, 1.0));
    const contact::PairConstraints pair = pair_of(model);
    ASSERT_TRUE(pair.found);
    const double low = std::max(a, 0.0);
    const double high = std::min(b, 2.0);
    const Resultant r = resultant(model, pair);
    EXPECT_NEAR(r.force, 5.0 * (high - low), 1e-12);
    EXPECT_NEAR(r.moment, 2.5 * (high * high - low * low), 1e-12);
    double area = 0.0;
    for (const contact::ConstraintRow& row : pair.normal) {
      area += row.area;
      EXPECT_NEAR(row.gap, 0.0, 1e-14);
    }
    EXPECT_NEAR(area, 5.0 * (high - low), 1e-12);
  }
}

TEST_P(RigidLine, GapIsMeasuredExactlyOrDeclared) {
  model::Model model = block_on(plane(GetParam()), line(-3.0, 0.9, 7.0, 0.7));
  const double length = std::hypot(10.0, 0.2);
  for (const contact::ConstraintRow& row : pair_of(model).normal) {
    double arm = 0.0; // first moment of the row's function
    for (const contact::RowEntry& entry : row.entries) {
      arm += entry.weight.y() * length / 10.0 * model.mesh.x[entry.node.index()].x();
      EXPECT_NEAR(entry.weight.x() * 10.0, entry.weight.y() * 0.2, 1e-14);
    }
    // distance of (x, 1) from the line: (10 (1 - 0.9) + 0.2 (x + 3)) / length
    EXPECT_NEAR(row.gap, (1.6 * row.area + 0.2 * arm) / length, 1e-13);
  }
  model.contacts[0].gap = 0.25;
  for (const contact::ConstraintRow& row : pair_of(model).normal) {
    EXPECT_DOUBLE_EQ(row.gap, 0.25 * row.area);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, RigidLine,
                         testing::Values(ElementType::quam4, ElementType::quamc8));

TEST(RigidTarget, FacesNothingOnItsOtherSideOrBeyondItsEnds) {
  const TwoBlocks spec = plane(ElementType::quamc8);
  EXPECT_TRUE(pair_of(block_on(spec, line(0.0, 1.0, 2.0, 1.0))).found);
  EXPECT_FALSE(pair_of(block_on(spec, line(2.0, 1.0, 0.0, 1.0))).found);
  EXPECT_FALSE(pair_of(block_on(spec, line(3.0, 1.0, 4.0, 1.0))).found);
  EXPECT_FALSE(pair_of(block_on(spec, line(0.0, 0.0, 2.0, 0.0))).found); // too far off
  EXPECT_FALSE(pair_of(block_on(spec, arc(1.0, -3.0, -4.0))).found);     // a bore from outside
}

TEST(RigidTarget, NodePairsStandOnTheirFeet) {
  model::Model model = block_on(plane(ElementType::quamc8), line(-1.0, 0.9, 3.0, 0.9));
  model.contacts[0].pairing = model::PairingMethod::node;
  const contact::PairConstraints pair = pair_of(model);
  ASSERT_TRUE(pair.found && pair.trouble.empty());
  EXPECT_EQ(pair.normal.size(), 11U);
  for (const contact::ConstraintRow& row : pair.normal) {
    ASSERT_EQ(row.entries.size(), 1U);
    EXPECT_NEAR(row.gap, 0.1 * row.area, 1e-14);
  }
  EXPECT_NEAR(resultant(model, pair).force, 10.0, 1e-12);
}

TEST(RigidTarget, BondedRowsHoldBothWays) {
  model::Model model = block_on(plane(ElementType::quamc8), line(-1.0, 1.0, 3.0, 1.0));
  model.contacts[0].type = model::ContactType::bonded;
  const contact::PairConstraints pair = pair_of(model);
  ASSERT_EQ(pair.tangent.size(), pair.normal.size());
  double slip = 0.0;
  for (const contact::ConstraintRow& row : pair.tangent) {
    for (const contact::RowEntry& entry : row.entries) {
      EXPECT_EQ(entry.weight.y(), 0.0);
      slip += entry.weight.x();
    }
  }
  EXPECT_NEAR(std::abs(slip), 10.0, 1e-12);
}

// Round targets: normals point at the centre exactly, so a rotation about it opens nothing, and
// the measured gap is that of the mesh.
class RigidArc : public testing::TestWithParam<ElementType> {};

TEST_P(RigidArc, NormalsAreRadialAndGapsThoseOfTheMesh) {
  for (const bool bore : {false, true}) {
    model::Model model = test::two_rings(48, 48, GetParam());
    model.rigids = {arc(0.0, 0.0, bore ? -3.25 : 0.75)};
    model.contacts[0].slave = test::face_set(model, bore ? "OUT.OUTER" : "IN.INNER");
    model.contacts[0].master = {};
    model.contacts[0].rigid = base::RigidId(std::size_t{0});
    model.contacts[0].gap.reset();
    const contact::PairConstraints pair = pair_of(model);
    ASSERT_TRUE(pair.found);
    EXPECT_EQ(pair.normal.size(), GetParam() == ElementType::quam4 ? 48U : 96U);
    const double sagitta = GetParam() == ElementType::quam4 ? 3e-3 : 1e-5;
    for (const contact::ConstraintRow& row : pair.normal) {
      double turned = 0.0;
      for (const contact::RowEntry& entry : row.entries) {
        const base::Vec3& x = model.mesh.x[entry.node.index()];
        turned += entry.weight.dot(base::Vec3(-x.y(), x.x(), 0.0));
      }
      EXPECT_LT(std::abs(turned), 1e-12 * row.area);
      EXPECT_NEAR(row.gap / row.area, 0.25, sagitta * (bore ? 3.0 : 1.0));
    }
    const contact::GapSurvey seen = contact::survey_gaps(pair.contact, *pair.rigid);
    EXPECT_EQ(seen.facing, seen.edges);
    EXPECT_NEAR(seen.gap_mean, 0.25, sagitta * (bore ? 3.0 : 1.0));
    EXPECT_LT(seen.unpaired_fraction(), 1e-9);
    EXPECT_TRUE(contact::find_singular_edges(pair).empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Types, RigidArc, testing::Values(ElementType::quam4, ElementType::quamc8));

// Contact on a half circle that reaches the circle's end, a symmetry line say, ends there.
TEST(SurfaceInterval, ReachesTheEndOfAnOpenSurface) {
  model::Model model = test::two_rings(16, 16, ElementType::quamc8);
  model.mesh = {};
  mesh::RingSpec half;
  half.type = ElementType::quamc8;
  half.ri = 1.0;
  half.ro = 2.0;
  half.nt = 20;
  half.t0 = -0.5 * std::numbers::pi;
  half.t1 = 0.5 * std::numbers::pi;
  mesh::generate_ring(model.mesh, base::NetId(std::size_t{0}), "IN.", half);
  for (base::PropertyId& p : model.mesh.property) {
    p = base::PropertyId(std::size_t{0});
  }
  model.rigids = {arc(0.0, 0.0, -2.0)};
  model.contacts[0].slave = test::face_set(model, "IN.OUTER");
  model.contacts[0].master = {};
  model.contacts[0].rigid = base::RigidId(std::size_t{0});
  const contact::PairConstraints pair = pair_of(model);
  for (const bool upward : {false, true}) {
    const double c = 0.7; // p = sqrt(c - |theta - end|)
    base::Vector lambda = base::Vector::Zero(static_cast<Eigen::Index>(pair.normal.size()));
    std::vector<bool> closed;
    for (const contact::ConstraintRow& row : pair.normal) {
      const base::Vec3& x = model.mesh.x[row.node.index()];
      const double off = std::abs(std::atan2(x.y(), x.x()) - (upward ? half.t1 : half.t0));
      closed.push_back(off < c);
      lambda[static_cast<Eigen::Index>(closed.size()) - 1] = std::sqrt(std::max(0.0, c - off));
    }
    const contact::PairPressure p =
        contact::recover_pressure(pair, lambda, base::Vector::Zero(lambda.size()), closed);
    EXPECT_NEAR(upward ? p.arc_to : p.arc_from, upward ? half.t1 : half.t0, 1e-12);
    EXPECT_NEAR(upward ? p.arc_from : p.arc_to, upward ? half.t1 - c : half.t0 + c, 0.02);
  }
}

TEST(SingularContactEdge, IsWhereOneSurfaceEndsAndTheOtherGoesOn) {
  const auto places = [](const model::Model& model) {
    std::vector<double> x;
    for (const contact::SingularContactEdge& end : contact::find_singular_edges(pair_of(model))) {
      EXPECT_NEAR(end.x.y(), 1.0, 1e-12);
      EXPECT_FALSE(end.nodes.empty());
      x.push_back(end.x.x());
    }
    std::sort(x.begin(), x.end());
    return x;
  };
  TwoBlocks spec = plane(ElementType::quamc8);
  spec.upper = 7;
  EXPECT_TRUE(places(test::two_blocks(spec)).empty()); // both end
  EXPECT_TRUE(places(block_on(spec, line(-1.0, 1.0, 3.0, 1.0))).empty());
  const std::vector<double> punch = places(block_on(spec, line(0.37, 1.0, 1.13, 1.0)));
  ASSERT_EQ(punch.size(), 2U);
  EXPECT_NEAR(punch[0], 0.37, 1e-12);
  EXPECT_NEAR(punch[1], 1.13, 1e-12);
  spec.from = 0.55; // an elastic punch, right edges flush
  for (const int upper : {3, 20}) {
    spec.upper = upper;
    const std::vector<double> edge = places(test::two_blocks(spec));
    ASSERT_EQ(edge.size(), 1U);
    EXPECT_NEAR(edge[0], 0.55, 1e-12);
  }
}

// The mouth of a crack in either surface: a double node where a closed circle is cut open. That
// surface carries the multipliers, be it the softer or coarser one or not.
TEST(SingularContactEdge, IsAlsoTheMouthOfACrack) {
  using Case = std::tuple<bool, int, double>;
  for (const auto& [inner, outer_edges, modulus] :
       {Case{true, 20, 1.0}, Case{false, 20, 0.1}, Case{true, 20, 10.0}, Case{false, 20, 1.0},
        Case{true, 60, 1.0}, Case{false, 60, 1.0}, Case{true, 7, 1.0}, Case{false, 7, 1.0}}) {
    model::Model model = test::two_rings(16, outer_edges, ElementType::quamc8, modulus);
    model::Mesh& mesh = model.mesh;
    const model::FaceSet& set =
        mesh.set_with_id(inner ? model.contacts[0].slave : model.contacts[0].master);
    const std::size_t e = set.faces.front().element.index();
    const base::NodeId shared = [&] { // of the first face's element and the next one's, on r = 2
      for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
        const auto next = mesh.element_nodes(set.faces[1].element);
        if (std::abs(mesh.x[n.index()].norm() - 2.0) < 1e-9 &&
            std::find(next.begin(), next.end(), n) != next.end()) {
          return n;
        }
      }
      return base::NodeId();
    }();
    ASSERT_TRUE(shared.valid());
    const base::NodeId twin =
        model::add_node(mesh, mesh.x[shared.index()], 9999, mesh.node_net[shared.index()]);
    std::replace(mesh.nodes.begin() + mesh.first[e], mesh.nodes.begin() + mesh.first[e + 1], shared,
                 twin);
    const contact::PairConstraints pair = pair_of(model);
    ASSERT_TRUE(pair.found);
    EXPECT_EQ(pair.swapped, !inner);
    const std::vector<contact::SingularContactEdge> ends = contact::find_singular_edges(pair);
    ASSERT_EQ(ends.size(), 1U);
    EXPECT_LT((ends[0].x - mesh.x[shared.index()]).norm(), 1e-3);
  }
}

} // namespace
} // namespace spricka::test_rigid
