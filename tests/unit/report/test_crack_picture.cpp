// SPDX-License-Identifier: GPL-3.0-or-later
// The plane of a crack from the points of its front, and which faces are drawn as opened.
#include "report/drawing/crack_opening.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace spricka::report::test_crack_picture {
namespace {

// A part of a circle round the origin in the plane z = 0, run so that t = m x b with b = z.
results::FrontResult arc(double from, double to, int points) {
  results::FrontResult front;
  for (int i = 0; i < points; ++i) {
    const double w = to + (from - to) * i / (points - 1);
    results::FrontPointResult place;
    place.x = base::Vec3(std::cos(w), std::sin(w), 0.0);
    place.direction = place.x;
    front.points.push_back(place);
  }
  return front;
}

TEST(CrackPicture, FrameHasTheNormalOfTheUpperFace) {
  const auto frame = fit_front_plane(arc(0.0, 0.5 * std::numbers::pi, 9));
  ASSERT_TRUE(frame);
  EXPECT_LT((frame->normal - base::Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_GT(frame->growth.dot(base::Vec3(1.0, 1.0, 0.0)), 1.0); // away from the corner
}

TEST(CrackPicture, FrontsOutOfAPlaneHaveNone) {
  results::FrontResult front = arc(0.0, 3.0, 9);
  front.points[4].x.z() = 0.01;
  EXPECT_FALSE(fit_front_plane(front));
  EXPECT_FALSE(fit_front_plane(arc(0.0, 1.0, 2)));
}

// Two tetrahedra above each other that share no node, with a common face at z = 0.
TEST(CrackPicture, FacesOnEachOtherAreOpenedByWhatPartsThem) {
  results::CrackLengthResult increment;
  model::Mesh& mesh = increment.mesh;
  mesh.dim = 3;
  mesh.first = {0};
  const base::NetId net(std::size_t{0});
  const std::array<base::Vec3, 3> corner{base::Vec3(0, 0, 0), base::Vec3(1, 0, 0),
                                         base::Vec3(0, 1, 0)};
  std::array<std::vector<base::NodeId>, 2> side; // upper, lower
  for (auto& nodes : side) {
    for (const base::Vec3& x : corner) {
      nodes.push_back(
          model::add_node(mesh, x, static_cast<base::Label>(mesh.node_count() + 1), net));
    }
  }
  std::ranges::reverse(side[0]); // its outer normal points down
  increment.surface = {{base::ElementId(std::size_t{0}), side[0]},
                       {base::ElementId(std::size_t{1}), side[1]}};
  results::LoadStepResult step;
  step.u = base::Vector::Zero(18);
  for (const base::NodeId n : side[0]) {
    step.u.segment<3>(static_cast<Eigen::Index>(3 * n.index())) = base::Vec3(0.3, 0.4, 0.02);
  }
  const auto faces = crack_face_openings(increment, step, *fit_front_plane(arc(0.0, 1.5, 9)));
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_NEAR(faces[0].opening, 0.02, 1e-15);
  EXPECT_NEAR(faces[0].sliding, 0.5, 1e-15);
  EXPECT_EQ(faces[0].outline, side[0]);
}

} // namespace
} // namespace spricka::report::test_crack_picture
