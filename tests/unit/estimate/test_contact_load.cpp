// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/contact_load.hpp"

#include "../contact/two_blocks.hpp"
#include "contact/pairing.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

// Pressures of a pair's hats on the cubic modes of the other body's edges.
namespace spricka::test_contact_load {
namespace {

// A pressure that is linear along the surface, which the hats hold exactly: the integral of x times
// the mode -t (1 - t^2) / 4 over an edge of length L is L^2 / 60, by the way the edge runs.
TEST(ContactLoad, ALinearPressureWorksOnTheModesAsInTheIntegral) {
  for (const auto& [lower, upper] : {std::pair{4, 5}, std::pair{7, 8}, std::pair{3, 4}}) {
    test::TwoBlocks spec;
    spec.state = model::StressState::plane_stress;
    spec.lower = lower;
    spec.upper = upper;
    const model::Model model = test::two_blocks(spec);
    const contact::PairConstraints pair =
        contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
    ASSERT_FALSE(pair.swapped);
    const estimate::EdgeTable table = estimate::make_edge_table(model.mesh);
    std::map<std::size_t, double> force; // by freedom
    for (const estimate::ContactModeWeight& w : estimate::target_mode_weights(table, pair)) {
      force[w.freedom] += w.weight * model.mesh.x[pair.normal[w.row].node.index()].x();
    }
    int seen = 0;
    for (const estimate::ContactEdge& edge : estimate::contact_edges_of_pair(table, pair)) {
      if (!edge.target_side) {
        EXPECT_FALSE(force.contains(2 * edge.edge)); // its own side has its rows
        continue;
      }
      const double L = edge.shape->length;
      const double way = edge.shape->x[1].x() > edge.shape->x[0].x() ? -1.0 : 1.0;
      const double sign = estimate::side_mode_sign(edge.shape->nodes[0], edge.shape->nodes[1]);
      // the pressure pushes against the outer normal; the blocks are 5 thick
      EXPECT_NEAR(force[2 * edge.edge], -5.0 * sign * way * L * L / 60.0, 1e-14);
      ++seen;
    }
    EXPECT_EQ(seen, lower);
  }
}

} // namespace
} // namespace spricka::test_contact_load
