// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/opening.hpp"
#include "crack/williams.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_opening {
namespace {

constexpr double K1 = 3.0;
constexpr double K2 = -1.25;
/// An opening that is linear behind the tip, as the stress along the crack and rotations add it.
constexpr double linear = 0.02;

/// The faces of a crack on x < 0 at the two nodes behind the tip, moved by the near-tip field.
struct Faces {
  model::Model model;
  mesh::CrackedMesh cracked;
  mesh::CrackFront front;
  base::Vector u = base::Vector::Zero(10);

  explicit Faces(model::StressState state, bool tip_first) {
    model.materials = {{"M", 1000.0, 0.3, 0.0, 0.0, {}}};
    model.properties = {
        {base::ElementSetId(std::size_t{0}), base::MaterialId(std::size_t{0}), state, 1.0, {}}};
    cracked.mesh.x = {base::Vec3::Zero(),
                      {-0.25, 0.0, 0.0},
                      {-1.0, 0.0, 0.0},
                      {-0.25, 0.0, 0.0},
                      {-1.0, 0.0, 0.0}};
    const auto node = [](std::size_t n) { return base::NodeId(n); };
    mesh::CrackFaceNodes faces;
    faces.left = {node(2), node(1), node(0)};
    faces.right = {node(4), node(3), node(0)};
    if (tip_first) { // seen from the other end left is right
      std::swap(faces.left, faces.right);
      std::reverse(faces.left.begin(), faces.left.end());
      std::reverse(faces.right.begin(), faces.right.end());
    }
    cracked.faces = {faces};
    front.crack = base::CrackId(std::size_t{0});
    front.tip_point().node = node(0);
    front.tip_point().growth = base::Vec3::UnitX();
    for (const std::size_t n : {1U, 2U, 3U, 4U}) {
      const bool upper = n < 3;
      const crack::PolarCoordinates at{-cracked.mesh.x[n].x(),
                                       upper ? std::numbers::pi : -std::numbers::pi};
      base::Vec2 moved = K1 * crack::near_tip_displacement(
                                  {}, at, 1, crack::make_section_body(model.materials[0], state)) +
                         K2 * crack::near_tip_displacement(
                                  {}, at, 2, crack::make_section_body(model.materials[0], state));
      moved.y() += (upper ? linear : -linear) * at.r;
      u.segment<2>(2 * static_cast<Eigen::Index>(n)) = moved;
    }
  }

  [[nodiscard]] std::optional<std::array<double, 3>> intensity() const {
    const crack::FrontLoads loads;
    const crack::TipContext set{.model = model,
                                .mesh = cracked.mesh,
                                .material = model.materials[0],
                                .property = model.properties[0],
                                .tip = {},
                                .tip_node = front.tip_point().node,
                                .crack_faces = cracked.faces.data(),
                                .loads = loads};
    return crack::tip_K_from_face_opening(set, cracked, front, u);
  }
};

TEST(OpeningIntensity, OfTheNearTipFieldIsItsOwnK) {
  for (const model::StressState state :
       {model::StressState::plane_stress, model::StressState::plane_strain}) {
    for (const bool tip_first : {false, true}) {
      const std::optional<std::array<double, 3>> K = Faces(state, tip_first).intensity();
      ASSERT_TRUE(K.has_value());
      EXPECT_NEAR((*K)[0], K1, 1e-12);
      EXPECT_NEAR((*K)[1], K2, 1e-12);
    }
  }
}

// Of a half on a line of symmetry the other face is the mirror image.
TEST(OpeningIntensity, OfASymmetricHalfCountsBothFaces) {
  Faces half(model::StressState::plane_strain, false);
  half.cracked.faces[0].right.clear();
  half.front.symmetric_half = true;
  const std::optional<std::array<double, 3>> K = half.intensity();
  ASSERT_TRUE(K.has_value());
  EXPECT_NEAR((*K)[0], K1, 1e-12);
  EXPECT_EQ((*K)[1], 0.0);
}

} // namespace
} // namespace spricka::test_opening
