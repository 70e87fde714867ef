// SPDX-License-Identifier: GPL-3.0-or-later
// G along fronts in space against the difference of the potential energy when nodes move.
#include "fe/heat.hpp"
#include "fe/load_rule.hpp"
#include "fe/thermal_kernel.hpp"
#include "model/mesh_side.hpp"
#include "tests/unit/crack/front_tube.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace spricka::test_front_energy {
namespace {

using base::OpCode;
using base::Vec3;
using test::Tube;

base::ExpressionInstruction number(double v) {
  return {OpCode::number, v};
}

/// c + a x + b z, as the deck would give it.
base::CompiledExpression field(double c, double a, double b) {
  return {{number(c),
           number(a),
           {OpCode::x, 0.0},
           {OpCode::multiply, 0.0},
           {OpCode::add, 0.0},
           number(b),
           {OpCode::z, 0.0},
           {OpCode::multiply, 0.0},
           {OpCode::add, 0.0}}};
}

double linear_temperature(const Vec3& x) {
  return 5.0 + 2.0 * x.x() - 3.0 * x.y() + 1.5 * x.z();
}

struct Acting {
  bool pressure = false, body = false, heat = false;
};

/// Potential energy of the solution's displacements on a mesh whose nodes have moved, with loads
/// that stand in space.
class Potential {
public:
  Potential(const Tube& tube, const Acting& acting) : tube_(tube), acting_(acting) {
    pressure_.type = model::LoadType::pressure;
    pressure_.value = {field(0.8, 0.3, 0.4)};
    body_.type = model::LoadType::body;
    body_.value = {field(2.0, -1.0, 0.7), field(-0.5, 3.0, 1.1), field(1.0, 0.2, -2.0)};
    for (std::size_t e = 0; e < tube.mesh().element_count(); ++e) {
      all_.emplace_back(e);
    }
    faces_ = tube.cracked.faces.front().left_sides;
    for (const model::Face& face : tube.cracked.faces.front().right_sides) {
      faces_.push_back(face);
    }
  }

  [[nodiscard]] crack::FrontLoads loads() const {
    crack::FrontLoads loads;
    if (acting_.pressure) {
      loads.loads.push_back({&pressure_, 1.0, {}, faces_});
    }
    if (acting_.body) {
      loads.loads.push_back({&body_, 1.0, all_, {}});
    }
    if (acting_.heat) {
      loads.temperature = base::Vector::Zero(static_cast<Eigen::Index>(tube_.mesh().nodes.size()));
      for (std::size_t i = 0; i < tube_.mesh().nodes.size(); ++i) {
        loads.temperature[static_cast<Eigen::Index>(i)] =
            linear_temperature(tube_.mesh().x[tube_.mesh().nodes[i].index()]);
      }
    }
    return loads;
  }

  [[nodiscard]] double of(const model::Mesh& mesh, const base::Vector& u) const {
    double sum = 0.0;
    for (const base::ElementId e : all_) {
      sum += element(mesh, e, u);
    }
    for (const model::Face& face : faces_) {
      const geometry::ElementSide side = model::element_side(mesh, face);
      for (const auto& point : shape::quadrature<2>(side.domain(), 9)) {
        const fe::AnyElement<2>::Values N = side.N(point.r);
        Vec3 moved = Vec3::Zero();
        for (std::size_t n = 0; n < side.nodes.size(); ++n) {
          moved += N[static_cast<Eigen::Index>(n)] *
                   u.segment<3>(3 * static_cast<Eigen::Index>(side.nodes[n].index()));
        }
        const double p = acting_.pressure ? fe::load_value(pressure_, side.X * N).x() : 0.0;
        sum += point.weight * p * side.area_vector(point.r).dot(moved);
      }
    }
    return sum;
  }

private:
  [[nodiscard]] double element(const model::Mesh& mesh, base::ElementId e,
                               const base::Vector& u) const {
    const fe::AnyElement<3>& shape = shape::reference_element<3>(mesh.type[e.index()]);
    const fe::AnyNodeVectors<3> X = fe::element_coordinates(shape, mesh, e);
    const fe::AnyNodeVectors<3> U = fe::gather_element_values(shape, mesh, e, u);
    const fe::Elasticity<3> D =
        fe::elasticity<3>(tube_.model.materials[0], model::StressState::solid);
    const double beta = fe::thermal_modulus(fe::constitutive_law(tube_.model, mesh, e));
    double sum = 0.0;
    const auto known = degree_.find(e); // that of the nodal forces, so that they are its slopes
    const int degree = known == degree_.end() ? 9 : known->second;
    for (const auto& point : shape::quadrature<3>(shape.domain, degree)) {
      const fe::Jacobian<fe::AnyElement<3>> at = fe::jacobian(shape, X, point.r);
      const crack::Tensor<3> H = U.lazyProduct(at.dNdx);
      const fe::AnyElement<3>::Values N = shape.N(point.r);
      const double T = acting_.heat ? linear_temperature(X * N) : 0.0;
      double density =
          0.5 * crack::stress_from_gradient<3>(D, H).cwiseProduct(H).sum() - beta * T * H.trace();
      if (acting_.body) {
        density -= fe::load_value(body_, X * N).dot(U * N);
      }
      sum += point.weight * at.det * density;
    }
    return sum;
  }

  const Tube& tube_;
  Acting acting_;
  model::Load pressure_, body_;
  std::vector<base::ElementId> all_;
  std::vector<model::Face> faces_;
  std::map<base::ElementId, int> degree_ = tube_.fields().degree;
};

model::Mesh moved(const Tube& tube, const crack::VirtualExtensionField& field, double way) {
  model::Mesh mesh = tube.mesh();
  for (const crack::NodeMotion& motion : field.motion) {
    mesh.x[motion.node.index()] += way * motion.q * motion.along;
  }
  return mesh;
}

// Of each point's widest domain.
void expect_released(const Tube& tube, const Acting& acting, double tolerance) {
  const base::Vector u = tube.rough();
  const Potential potential(tube, acting);
  const crack::FrontIntegralDomains fields = tube.fields();
  const auto K = tube.K(u, potential.loads());
  const double h = 1e-6 * tube.front().radius;
  for (std::size_t i = 0; i < K.size(); ++i) {
    ASSERT_EQ(K[i].domains.size(), 2U);
    const crack::VirtualExtensionField& domain = fields.points[i].back();
    const double slope =
        (potential.of(moved(tube, domain, h), u) - potential.of(moved(tube, domain, -h), u)) /
        (2.0 * h);
    const double G = K[i].domains.back().G * tube.front().points[i].weight;
    EXPECT_NEAR(G, -slope, tolerance * std::abs(G)) << "point " << i;
  }
}

class FrontEnergy : public testing::TestWithParam<Acting> {};

TEST_P(FrontEnergy, IsReleasedAsNodesMove) {
  const Tube tube(test::straight_front(1.0), {.segments = 3, .sectors = 4});
  expect_released(tube, GetParam(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Loads, FrontEnergy,
                         testing::Values(Acting{}, Acting{.pressure = true}, Acting{.body = true},
                                         Acting{.heat = true}));

TEST(FrontEnergyOfCurvedFronts, IsReleasedAsNodesMove) {
  const Tube ellipse(test::ellipse_front(2.0, 1.2, 0.25), {.segments = 4, .sectors = 4});
  expect_released(ellipse, {}, 1e-6);
  const Tube penny(test::penny_front(2.0), {.segments = 8, .sectors = 4});
  expect_released(penny, {}, 1e-6);
}

// A front that leaves the body off its normal: nodes of the end keep to it.
TEST(FrontEnergyOfObliqueEnds, IsReleasedAsNodesMove) {
  const Tube tube(test::straight_front(1.0), {.segments = 3, .sectors = 4, .shear = 0.4});
  expect_released(tube, {.pressure = true}, 1e-6);
  const crack::FrontIntegralDomains fields = tube.fields();
  for (const crack::NodeMotion& motion : fields.points.front().back().motion) {
    const Vec3& x = tube.mesh().x[motion.node.index()];
    const Vec3 n = Vec3(0.4, 0.0, -1.0).normalized(); // of the end
    if (std::abs(x.dot(n)) < 1e-9) {
      EXPECT_NEAR(motion.along.dot(n), 0.0, 1e-9);
      EXPECT_NEAR(motion.along.x(), 1.0, 1e-9);
    } else {
      EXPECT_NEAR((motion.along - Vec3::UnitX()).norm(), 0.0, 1e-9);
    }
  }
}

} // namespace
} // namespace spricka::test_front_energy
