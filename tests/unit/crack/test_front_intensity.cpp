// SPDX-License-Identifier: GPL-3.0-or-later
// K along fronts in space from displacements that are known exactly.
#include "crack/front_rows.hpp"
#include "crack/moving_field.hpp"
#include "mesh/boundary.hpp"
#include "model/mesh_side.hpp"
#include "tests/unit/crack/front_tube.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::test_front_intensity {
namespace {

using base::Vec3;
using test::Tube;
using test::TubeSpec;

constexpr double pi = std::numbers::pi;
constexpr double mu = 1000.0 / 2.6; // of the tubes' material
constexpr std::array<double, 3> K_given{3.0, -1.25, 2.0};

crack::FrontBody body_of(const Tube& tube) {
  const fe::LameConstants k =
      fe::lame_constants(tube.model.materials[0], model::StressState::solid);
  return {k.lambda, k.mu, tube.model.materials[0].nu, 1.0};
}

// The near-front fields along a straight front, with the stress along x of 1 that is T.
base::Vector near_front(const Tube& tube) {
  return tube.at_nodes([&](const Vec3& x, crack::UpperOrLowerFace side) -> Vec3 {
    const double r = std::hypot(x.x(), x.y());
    Vec3 u(0.91e-3 * x.x(), -0.39e-3 * x.y(), 0.0);
    const double theta = side == crack::UpperOrLowerFace::lower ? -pi : std::atan2(x.y(), x.x());
    for (std::size_t m = 1; m <= 3 && r > 1e-12; ++m) {
      u += K_given[m - 1] * crack::section_field(m, {r, theta}, body_of(tube)).w;
    }
    return u;
  });
}

// What the rest of the body does on the ends of the tube.
crack::FrontLoads end_tractions(const Tube& tube) {
  crack::FrontLoads loads;
  const crack::FrontAxes axes(*tube.front().curve);
  for (const model::Face& face : mesh::boundary_faces(tube.mesh())) {
    const geometry::ElementSide side = model::element_side(tube.mesh(), face);
    const auto off_end = [&](const shape::QuadraturePoint<2>& point) {
      return std::abs(side.area_vector(point.r).normalized().z()) < 0.99;
    };
    const auto rule = shape::quadrature<2>(side.domain(), 9);
    if (std::ranges::any_of(rule, off_end)) {
      continue;
    }
    crack::FacePointForces on{face, {}};
    for (const auto& point : rule) {
      const Vec3 area = side.area_vector(point.r);
      const crack::FrontCoordinates place = axes.locate_point(side.X * side.N(point.r));
      crack::Tensor<3> sigma = crack::Tensor<3>::Zero();
      sigma(0, 0) = 1.0;
      sigma(2, 2) = 0.3;
      for (std::size_t m = 1; m <= 3; ++m) {
        sigma += K_given[m - 1] * crack::front_auxiliary_field(m, place, body_of(tube)).sigma;
      }
      on.points.push_back({Vec3(point.r[0], point.r[1], 0.0), point.weight * (sigma * area)});
    }
    loads.contact.push_back(std::move(on));
  }
  return loads;
}

double worst_straight(const TubeSpec& spec) {
  const Tube tube(test::straight_front(1.0), spec);
  double worst = 0.0;
  for (const auto& K : tube.K(near_front(tube), end_tractions(tube))) {
    worst = std::max({worst, std::abs(K.K1 - K_given[0]), std::abs(K.K2 - K_given[1]),
                      std::abs(K.K3 - K_given[2])});
  }
  return worst / std::hypot(K_given[0], K_given[1], K_given[2]);
}

TEST(FrontIntensity, NearFrontFieldGivesItsOwnK) {
  const Tube tube(test::straight_front(1.0), {.segments = 4});
  const auto result = tube.K(near_front(tube), end_tractions(tube));
  ASSERT_EQ(result.size(), 5U);
  const double E = 1000.0 / 0.91;
  const double G = (9.0 + 1.5625) / E + 4.0 / (2.0 * mu);
  for (const crack::StressIntensity& K : result) {
    EXPECT_EQ(K.domains.size(), 2U);
    EXPECT_NEAR(K.K1, 3.0, 6e-3);
    EXPECT_NEAR(K.K2, -1.25, 6e-3);
    EXPECT_NEAR(K.K3, 2.0, 1e-2);
    EXPECT_NEAR(K.G, G, 5e-3 * G);
    EXPECT_NEAR(K.G_from_K, G, 5e-3 * G);
    EXPECT_NEAR(K.T, 1.0, 0.03);
    EXPECT_LT(K.spread, 1e-3);
    ASSERT_TRUE(K.opening.has_value());
    EXPECT_NEAR((*K.opening)[0], 3.0, 1e-2);
    EXPECT_NEAR((*K.opening)[1], -1.25, 4e-3);
    EXPECT_NEAR((*K.opening)[2], 2.0, 1e-2);
  }
}

TEST(FrontIntensity, ConvergesWithTheSectors) {
  const TubeSpec coarse{.segments = 2, .sectors = 6};
  const TubeSpec fine{.segments = 2, .sectors = 12, .radii = {0.05, 0.1, 0.15, 0.2}};
  EXPECT_LT(worst_straight(fine), worst_straight(coarse) / 6.0);
}

// Straight mid nodes do as well, only coarser.
TEST(FrontIntensity, NeedsNoQuarterPoints) {
  EXPECT_LT(worst_straight({.segments = 2, .quarter_point = false}), 0.02);
}

constexpr double hat_mean(double segment) { // of a cosine over a linear hat
  return 1.0 - segment * segment / 12.0;
}

class Penny : public testing::Test {
protected:
  static constexpr int segments = 24;
  const Tube tube{test::penny_front(1.0), {.segments = segments, .radii = {0.07, 0.14, 0.2}}};
  const base::Vector pressed =
      tube.at_nodes([](const Vec3& x, crack::UpperOrLowerFace side) -> Vec3 {
        return test::pressed_penny(x, side, mu, 0.3);
      });
  const base::Vector pulled = tube.at_nodes([](const Vec3& x,
                                               crack::UpperOrLowerFace side) -> Vec3 {
    return test::pressed_penny(x, side, mu, 0.3) + Vec3(-0.3 * x.x(), -0.3 * x.y(), x.z()) / 1000.0;
  });
  const base::Vector sheared =
      tube.at_nodes([](const Vec3& x, crack::UpperOrLowerFace side) -> Vec3 {
        return test::sheared_penny(x, side, mu, 0.3);
      });
  static constexpr double K1 = 1.1283791670955126;       // 2 / sqrt(pi)
  static constexpr double K2 = 4.0 / 1.7 * 0.5641895835; // 4 / (pi (2 - nu)) sqrt(pi)
};

// Faces free, tension: K1 the same everywhere, T = -(1 + 2 nu) / 2.
TEST_F(Penny, UnderTension) {
  for (const crack::StressIntensity& K : tube.K(pulled)) {
    EXPECT_NEAR(K.K1, K1, 2e-3 * K1);
    EXPECT_NEAR(K.K2, 0.0, 1e-4);
    EXPECT_NEAR(K.K3, 0.0, 1e-6);
    EXPECT_NEAR(K.G, 0.91e-3 * K1 * K1, 4e-3 * K.G);
    EXPECT_NEAR(K.T, -0.8, 0.015);
    EXPECT_LT(K.spread, 1e-4);
    EXPECT_NEAR((*K.opening)[0], K1, 3e-3 * K1);
    EXPECT_NEAR(K.front->smooth[0], K.K1, 1e-6);
  }
}

// The values of points are means over their hats; the smooth curve gives back what these smear.
TEST_F(Penny, UnderShear) {
  const auto result = tube.K(sheared);
  const double mean = hat_mean(2.0 * pi / segments);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const crack::StressIntensity& K = result[i];
    const Vec3& x = tube.front().points[i].x; // cos and sin of the angle from the shear
    EXPECT_NEAR(K.K1, 0.0, 1e-4);
    EXPECT_NEAR(K.K2, mean * K2 * x.x(), 1.5e-3 * K2);
    EXPECT_NEAR(K.K3, mean * 0.7 * K2 * x.y(), 1.5e-3 * K2);
    EXPECT_LT(K.spread, 1e-4);
    EXPECT_NEAR(K.front->smooth[1], K2 * x.x(), 2e-3 * K2);
    EXPECT_NEAR(K.front->smooth[2], 0.7 * K2 * x.y(), 2e-3 * K2);
  }
}

class PressedPenny : public Penny {
protected:
  // Pressure on both faces, at points.
  [[nodiscard]] std::vector<crack::FacePointForces> pressure() const {
    std::vector<crack::FacePointForces> forces;
    const mesh::CrackFaceNodes& faces = tube.cracked.faces.front();
    for (const auto* sides : {&faces.left_sides, &faces.right_sides}) {
      for (const model::Face& face : *sides) {
        const geometry::ElementSide side = model::element_side(tube.mesh(), face);
        crack::FacePointForces on{face, {}};
        for (const auto& point : shape::quadrature<2>(side.domain(), 9)) {
          on.points.push_back(
              {Vec3(point.r[0], point.r[1], 0.0), -point.weight * side.area_vector(point.r)});
        }
        forces.push_back(std::move(on));
      }
    }
    return forces;
  }
};

TEST_F(PressedPenny, TakesPressureBetweenItsFaces) {
  EXPECT_GT(std::abs(tube.K(pressed).front().K1 - K1), 0.05); // without it K is another
  crack::FrontLoads contact;
  contact.contact = pressure();
  model::Load load;
  load.type = model::LoadType::pressure;
  load.value = {{{base::ExpressionInstruction{base::OpCode::number, 1.0}}}};
  crack::FrontLoads given;
  crack::ActingLoad acting{&load, 1.0, {}, tube.cracked.faces.front().left_sides};
  for (const model::Face& face : tube.cracked.faces.front().right_sides) {
    acting.faces.push_back(face);
  }
  given.loads = {acting};
  const auto by_contact = tube.K(pressed, contact);
  const auto by_load = tube.K(pressed, given);
  for (std::size_t i = 0; i < by_load.size(); ++i) {
    EXPECT_NEAR(by_load[i].K1, K1, 4e-3 * K1); // the edges on the front are parabolas
    EXPECT_NEAR(by_load[i].T, -0.8, 0.015);    // with the pressure at the front itself
    EXPECT_NEAR(by_contact[i].K1, by_load[i].K1, 1e-9);
    EXPECT_NEAR(by_contact[i].G, by_load[i].G, 1e-9 * by_load[i].G);
    EXPECT_NEAR(by_load[i].G, 0.91e-3 * K1 * K1, 8e-3 * by_load[i].G);
  }
}

TEST_F(PressedPenny, RowsGiveTheSameK) {
  const crack::FrontIntegralDomains fields = tube.fields();
  const base::Vector u = pressed + sheared + 1e-3 * tube.rough();
  crack::FrontLoads loads;
  loads.contact = pressure();
  const crack::KLayout layout(tube.front().points.size(), 3);
  const auto rows =
      crack::front_intensity_functionals(tube.model, tube.cracked, tube.front(), fields);
  const auto force_rows = crack::face_force_front_functionals(tube.model, tube.cracked,
                                                              tube.front(), fields, loads.contact);
  std::vector<double> f;
  for (const crack::FacePointForces& on : loads.contact) {
    for (const fe::LoadPoint& point : on.points) {
      f.insert(f.end(), point.force.data(), point.force.data() + 3);
    }
  }
  const base::Vector force = Eigen::Map<const base::Vector>(f.data(), force_rows.rows());
  const auto still = tube.K(base::Vector::Zero(u.size()), loads);
  const base::Vector of_u = rows.transpose() * u;
  const base::Vector of_f = force_rows.transpose() * force;
  for (std::size_t i = 0; i < still.size(); ++i) {
    EXPECT_NEAR(of_f[layout.at(i, 1)], still[i].K1, 1e-12 * of_f.norm());
    EXPECT_NEAR(of_f[layout.at(i, 2)], still[i].K2, 1e-12 * of_f.norm());
    EXPECT_NEAR(of_f[layout.at(i, 3)], still[i].K3, 1e-12 * of_f.norm());
  }
  const auto result = tube.K(u, loads);
  for (std::size_t i = 0; i < result.size(); ++i) {
    EXPECT_NEAR(of_u[layout.at(i, 1)] + of_f[layout.at(i, 1)], result[i].K1, 1e-11);
    EXPECT_NEAR(of_u[layout.at(i, 2)] + of_f[layout.at(i, 2)], result[i].K2, 1e-11);
    EXPECT_NEAR(of_u[layout.at(i, 3)] + of_f[layout.at(i, 3)], result[i].K3, 1e-11);
  }
}

// Functions beside those of nodes that are the same as these have the same rows.
TEST_F(PressedPenny, RowsOfOtherFunctionsAreThoseOfNodes) {
  const model::Mesh& mesh = tube.cracked.mesh;
  std::vector<std::int32_t> numbers; // of the node of an element, from mesh.first on
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
      numbers.push_back(static_cast<std::int32_t>(n.index()));
    }
  }
  const std::vector<double> signs(shape::most_nodes<3>, -1.0);
  crack::SupplementaryFunctions others;
  others.count = static_cast<Eigen::Index>(mesh.node_count());
  others.of_element = [&](base::ElementId e) {
    return std::span<const std::int32_t>(numbers.data() + mesh.first[e.index()],
                                         mesh.element_nodes(e).size());
  };
  others.signs = [&](base::ElementId e) {
    return std::span<const double>(signs.data(), mesh.element_nodes(e).size());
  };
  others.slopes = [](base::ElementType type, const Vec3& r) -> Eigen::MatrixX3d {
    return -shape::reference_element<3>(type).dN(r);
  };
  const crack::FrontIntegralDomains fields = tube.fields();
  const crack::IntensityFunctionals both = crack::supplemented_intensity_functionals(
      tube.model, tube.cracked, tube.front(), fields, others);
  const auto rows =
      crack::front_intensity_functionals(tube.model, tube.cracked, tube.front(), fields);
  EXPECT_EQ((both.of_nodes - rows).norm(), 0.0);
  EXPECT_GT(rows.norm(), 0.0);
  EXPECT_LT((both.of_others - rows).norm(), 1e-12 * rows.norm());
}

TEST(FrontInvariance, OfRotationAndUnits) {
  const double p = 2.0;
  const TubeSpec spec{.segments = 6, .radii = {0.1, 0.2, 0.3}};
  const Tube tube(test::ellipse_front(p, 1.5, 0.25), spec);
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.7, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const double scale = 1000.0;
  std::vector<Vec3> x;
  for (const Vec3& point : tube.front().curve->points()) {
    x.push_back(scale * (R * point));
  }
  const mesh::FrontCurve turned_curve(x, std::vector<Vec3>(x.size(), R.col(2)), false);
  const Tube turned(turned_curve, {.segments = 6, .radii = {100.0, 200.0, 300.0}});
  const base::Vector u = tube.rough();
  base::Vector v = u;
  for (Eigen::Index n = 0; n < u.size() / 3; ++n) {
    v.segment<3>(3 * n) = scale * (R * u.segment<3>(3 * n));
  }
  const auto one = tube.K(u);
  const auto other = turned.K(v);
  const double root = std::sqrt(scale);
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double size = std::abs(one[i].K1) + std::abs(one[i].K2) + std::abs(one[i].K3);
    EXPECT_NEAR(other[i].K1, root * one[i].K1, 1e-6 * root * size);
    EXPECT_NEAR(other[i].K2, root * one[i].K2, 1e-6 * root * size);
    EXPECT_NEAR(other[i].K3, root * one[i].K3, 1e-6 * root * size);
    EXPECT_NEAR(other[i].G, scale * one[i].G, 1e-6 * scale * std::abs(one[i].G));
    EXPECT_NEAR(other[i].T, one[i].T, 1e-5 * size);
  }
}

// Seen in a mirror across the front the faces slide along it the other way.
TEST(FrontInvariance, OfAMirror) {
  const Tube tube(test::straight_front(1.0), {.segments = 4});
  const auto field = [](const Vec3& x, crack::UpperOrLowerFace) {
    return Vec3(std::sin(3.0 * x.x() + x.z()), std::cos(2.0 * x.y() - x.z() * x.x()),
                x.z() * x.z() + std::sin(5.0 * x.y()));
  };
  const auto one = tube.K(tube.at_nodes(field));
  const auto other = tube.K(tube.at_nodes([&](const Vec3& x, crack::UpperOrLowerFace side) -> Vec3 {
    const Vec3 u = field({x.x(), x.y(), 1.0 - x.z()}, side);
    return {u.x(), u.y(), -u.z()};
  }));
  for (std::size_t i = 0; i < one.size(); ++i) {
    const crack::StressIntensity& K = other[one.size() - 1 - i];
    const double size = std::abs(K.K1) + std::abs(K.K2) + std::abs(K.K3);
    EXPECT_NEAR(K.K1, one[i].K1, 2e-6 * size);
    EXPECT_NEAR(K.K2, one[i].K2, 2e-6 * size);
    EXPECT_NEAR(K.K3, -one[i].K3, 2e-6 * size);
    EXPECT_NEAR(K.G, one[i].G, 1e-9 * std::abs(K.G));
  }
}

} // namespace
} // namespace spricka::test_front_intensity
