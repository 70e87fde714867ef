// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "fe/bearing.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// The pin load in space, on a ring extruded along z (and then turned in space): its resultant, its
// arms, and its forces against those of the plane on the ring's cross-section.
namespace spricka::fe::test_bearing_solid {
namespace {

using base::CompiledExpression;
using base::ElementType;
using base::Vec3;
using base::Vector;

constexpr double bore = 36.0;
constexpr double depth = 14.0;
constexpr int sectors = 24;
const Vec3 centre(12.0, -7.0, 3.0);

struct Case {
  ElementType solid;
  ElementType plane;
};

// x 0..1 from bore outwards, y 0..1 round it from `start`; a seam at 0 has its nodes twice.
Vec3 onto_ring(const Vec3& p, double start) {
  const double r = bore + 8.0 * p.x();
  const double angle = start + 2.0 * std::numbers::pi * p.y();
  return centre + Vec3(r * std::cos(angle), r * std::sin(angle), p.z());
}

class SolidBearing : public testing::TestWithParam<Case> {
protected:
  static constexpr double start = 0.1;

  SolidBearing() {
    solid = test::plane_model(72e3, 0.3, model::StressState::solid);
    solid.mesh.dim = 3;
    fill(solid, GetParam().solid, mesh::generate_solid_block);
    plane = test::plane_model(72e3, 0.3, model::StressState::plane_stress, depth);
    fill(plane, GetParam().plane, mesh::generate_block);
    load.type = model::LoadType::bearing;
  }

  static void fill(model::Model& model, ElementType type,
                   void (*generate)(model::Mesh&, base::NetId, const std::string&,
                                    const mesh::BlockSpec&)) {
    mesh::BlockSpec spec;
    spec.type = type;
    spec.nx = 1;
    spec.ny = sectors;
    spec.nz = 2;
    spec.size = {1.0, 1.0, depth};
    generate(model.mesh, base::NetId(0), "", spec);
    model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(0));
    for (Vec3& x : model.mesh.x) {
      x = onto_ring(x, start);
      x.z() -= model.mesh.dim == 2 ? centre.z() : 0.0;
    }
  }

  // The faces XMIN of the block are the bore.
  static base::FaceSetId bore_of(const model::Model& model) {
    for (std::size_t s = 0; s < model.mesh.face_sets.size(); ++s) {
      if (model.mesh.face_sets[s].name == "XMIN") {
        return base::FaceSetId(s);
      }
    }
    ADD_FAILURE() << "no bore";
    return {};
  }

  Vector apply(const model::Model& model, const Vec3& F) {
    load.faces = bore_of(model);
    load.value.clear();
    for (int c = 0; c < model.mesh.dim; ++c) {
      load.value.push_back(CompiledExpression::make_constant(F[c]));
    }
    return consistent_load_vector(model, model.mesh, {"", {load}});
  }

  static Vec3 at(const Vector& f, std::size_t n, int dim) {
    Vec3 v = Vec3::Zero();
    v.head(dim) = f.segment(static_cast<Eigen::Index>(n) * dim, dim);
    return v;
  }

  model::Model solid;
  model::Model plane;
  model::Load load;
};

INSTANTIATE_TEST_SUITE_P(load, SolidBearing,
                         testing::Values(Case{ElementType::hexe8, ElementType::quam4},
                                         Case{ElementType::penta6, ElementType::trim3},
                                         Case{ElementType::hexec20, ElementType::quamc8},
                                         Case{ElementType::hexec27, ElementType::quamc9},
                                         Case{ElementType::pentac15, ElementType::trimc6},
                                         Case{ElementType::tet10, ElementType::trimc6}),
                         [](const auto& c) {
                           return std::string(base::element_info(c.param.solid).name);
                         });

// In any direction in space: the ring is turned along with the load.
TEST_P(SolidBearing, resultant_is_exact_and_without_moment) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  for (Vec3& x : solid.mesh.x) {
    x = turn * x;
  }
  const Vec3 middle = turn * (centre + Vec3(0.0, 0.0, 0.5 * depth));
  for (const auto shape : {model::BearingShape::cosine, model::BearingShape::uniform}) {
    load.shape = shape;
    for (const double angle : {0.0, 0.37, 1.0, 2.0, 4.5}) {
      const Vec3 F = 97100.0 * (turn * Vec3(std::cos(angle), std::sin(angle), 0.0));
      const Vector f = apply(solid, F);
      Vec3 sum = Vec3::Zero();
      Vec3 moment = Vec3::Zero();
      for (std::size_t n = 0; n < solid.mesh.node_count(); ++n) {
        sum += at(f, n, 3);
        moment += (solid.mesh.x[n] - middle).cross(at(f, n, 3));
      }
      EXPECT_LT((sum - F).norm(), 1e-12 * F.norm()) << angle;
      // Radial at every point: no moment about the axis; even along it: none across, but for what
      // the ends of the pressure inside faces and unlike triangles leave.
      EXPECT_LT(std::abs(moment.dot(turn.col(2))), 1e-10 * F.norm() * bore) << angle;
      EXPECT_LT(moment.norm(), 2e-3 * F.norm() * depth) << angle;
    }
  }
}

// Where the loaded half ends at corners, each pillar of nodes along z carries what the node of the
// plane carries; but for the integration of pressures that are no polynomials.
TEST_P(SolidBearing, pillars_carry_the_forces_of_the_plane) {
  const double step = 2.0 * std::numbers::pi / sectors;
  for (const auto shape : {model::BearingShape::cosine, model::BearingShape::uniform}) {
    load.shape = shape;
    for (const int k : {0, 5, 13}) {
      const double angle = start + k * step;
      const Vec3 F = 1000.0 * Vec3(std::cos(angle), std::sin(angle), 0.0);
      const Vector f = apply(solid, F);
      const Vector g = apply(plane, F);
      for (std::size_t n = 0; n < plane.mesh.node_count(); ++n) {
        // The seam has its nodes twice: what is at one place counts together.
        Vec3 wanted = Vec3::Zero();
        Vec3 pillar = Vec3::Zero();
        const auto same = [&](const Vec3& x) {
          return (x - plane.mesh.x[n]).head<2>().norm() < 1e-9;
        };
        for (std::size_t m = 0; m < plane.mesh.node_count(); ++m) {
          wanted += same(plane.mesh.x[m]) ? at(g, m, 2) : Vec3(Vec3::Zero());
        }
        for (std::size_t m = 0; m < solid.mesh.node_count(); ++m) {
          pillar += same(solid.mesh.x[m]) ? at(f, m, 3) : Vec3(Vec3::Zero());
        }
        EXPECT_LT((pillar - wanted).norm(), 2e-5 * F.norm()) << k << " " << n;
      }
    }
  }
}

TEST_P(SolidBearing, nothing_is_pushed_along_the_axis) {
  load.faces = bore_of(solid);
  const auto visit = [](const auto& /*face*/, const auto& /*points*/) { ADD_FAILURE(); };
  for (const Vec3& F : {Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 1e-3), Vec3(-1.0, 2.0, -1.0)}) {
    load.value = {CompiledExpression::make_constant(F.x()),
                  CompiledExpression::make_constant(F.y()),
                  CompiledExpression::make_constant(F.z())};
    EXPECT_FALSE(for_bearing_points(solid, solid.mesh, load, visit)) << F.transpose();
  }
}

// Half a bore takes a pin that pushes into it, and none that pushes away.
TEST_P(SolidBearing, meets_the_loaded_half_only) {
  auto& faces = solid.mesh.face_sets[bore_of(solid).index()].faces;
  std::erase_if(faces, [&](const model::Face& face) {
    Vec3 mean = Vec3::Zero();
    const auto nodes = solid.mesh.element_nodes(face.element);
    for (const base::NodeId n : nodes) {
      mean += solid.mesh.x[n.index()] / static_cast<double>(nodes.size());
    }
    return mean.y() < centre.y() - 0.2 * bore;
  });
  const Vec3 up(0.0, 1000.0, 0.0);
  Vec3 sum = Vec3::Zero();
  const Vector f = apply(solid, up);
  for (std::size_t n = 0; n < solid.mesh.node_count(); ++n) {
    sum += at(f, n, 3);
  }
  EXPECT_LT((sum - up).norm(), 1e-10 * up.norm());
  std::erase_if(faces, [&](const model::Face& face) { // the sides alone are left: too little
    Vec3 mean = Vec3::Zero();
    const auto nodes = solid.mesh.element_nodes(face.element);
    for (const base::NodeId n : nodes) {
      mean += solid.mesh.x[n.index()] / static_cast<double>(nodes.size());
    }
    return mean.y() < centre.y() + 0.2 * bore;
  });
  load.value[1] = CompiledExpression::make_constant(-1000.0);
  const auto visit = [](const auto& /*face*/, const auto& /*points*/) { ADD_FAILURE(); };
  EXPECT_FALSE(for_bearing_points(solid, solid.mesh, load, visit));
}

} // namespace
} // namespace spricka::fe::test_bearing_solid
