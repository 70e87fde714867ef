// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/crack_face_term.hpp"
#include "crack/front_intensity.hpp"
#include "crack/tip_intensity.hpp"
#include "mesh/boundary.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/cut/tip_mesh.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_crack_face_term {
namespace {

/// A square plate with a crack along its middle to the origin, turned by an angle, and forces of
/// uniform tractions on its faces.
struct Plate {
  model::Model model;
  mesh::CrackedMesh cracked;
  std::vector<crack::VirtualExtensionField> fields;
  std::vector<model::Face> faces;
  base::Vec2 e1;

  Plate(double angle, bool quarter, double thickness) : e1(std::cos(angle), std::sin(angle)) {
    mesh::BlockSpec spec;
    spec.type = base::ElementType::quamc8;
    spec.origin = base::Vec3(-4.0, -4.0, 0.0);
    spec.size = base::Vec3(8.0, 8.0, 1.0);
    spec.nx = spec.ny = 8;
    model.nets = {{"", {}}};
    mesh::generate_block(model.mesh, base::NetId(std::size_t{0}), "", spec);
    model.materials = {{"M", 1000.0, 0.3, 0.0, 0.0, {}}};
    model.properties = {{base::ElementSetId(std::size_t{0}),
                         base::MaterialId(std::size_t{0}),
                         model::StressState::plane_strain,
                         thickness,
                         {}}};
    model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
    mesh::CrackLine line;
    line.crack = base::CrackId(std::size_t{0});
    line.embedded = true;
    line.points = {base::Vec3(-3.0 * e1.x(), -3.0 * e1.y(), 0.0), base::Vec3::Zero()};
    mesh::TipMeshParameters tip = mesh::choose_tip_mesh(model.mesh, line, nullptr);
    tip.quarter_point = quarter;
    base::Diagnostics diagnostics;
    const std::vector<base::SourceSpan> spans(1);
    auto made = mesh::insert_cracks(model.mesh, {&line, 1}, {&tip, 1}, spans, diagnostics);
    EXPECT_TRUE(made.has_value());
    cracked = std::move(*made);
    const crack::TipNeighbourhood around(cracked.mesh);
    std::vector<int> left_out;
    fields = around.extension_fields(cracked, cracked.fronts[1], {1, 2, 4}, left_out);
    for (const auto* crack_face : {&cracked.faces[0].left, &cracked.faces[0].right}) {
      const std::vector<model::Face> own =
          mesh::boundary_faces_with_all_nodes_in(cracked.mesh, *crack_face);
      faces.insert(faces.end(), own.begin(), own.end());
    }
  }
  [[nodiscard]] double from_tip(base::NodeId n) const { return cracked.mesh.x[n.index()].norm(); }

  /// Nodal forces of tractions (along, across) of the left face; the right one has the opposite.
  [[nodiscard]] base::Vector forces(double along, double across) const {
    base::Vector f = base::Vector::Zero(2 * static_cast<Eigen::Index>(cracked.mesh.node_count()));
    const double thickness = model.properties[0].thickness;
    for (const double side : {1.0, -1.0}) {
      const auto& crack_face = side > 0.0 ? cracked.faces[0].left : cracked.faces[0].right;
      for (std::size_t i = 0; i + 2 < crack_face.size(); i += 2) {
        // integral of the shape functions of an edge with its middle node at a part m of it
        const double h =
            (cracked.mesh.x[crack_face[i + 2].index()] - cracked.mesh.x[crack_face[i].index()])
                .norm();
        const double m =
            (cracked.mesh.x[crack_face[i + 1].index()] - cracked.mesh.x[crack_face[i].index()])
                .norm() /
            h;
        const double first = 1.0 / 6.0 + (m - 0.5) * 2.0 / 3.0;
        const std::array<double, 3> part{first, 2.0 / 3.0, 1.0 / 3.0 - first};
        for (std::size_t k = 0; k < 3; ++k) {
          f.segment<2>(2 * static_cast<Eigen::Index>(crack_face[i + k].index())) +=
              side * thickness * h * part[k] * (along * e1 + across * base::Vec2(-e1.y(), e1.x()));
        }
      }
    }
    return f;
  }
};

// What tractions p on the last part R of a crack give its tip, q = 1 there and falling linearly to
// 0 at S: p sqrt(2/pi) integral q r^-1/2 dr, which for a step is p sqrt(8 R/pi) (Tada, Paris,
// Irwin: uniform pressure next to the tip of a semi-infinite crack).
double closed_form(double R, double S) {
  const double inner = 2.0 * std::sqrt(R);
  const auto rim = [&](double r) {
    return (2.0 * S * std::sqrt(r) - 2.0 / 3.0 * r * std::sqrt(r)) / (S - R);
  };
  return std::sqrt(2.0 / std::numbers::pi) * (inner + rim(S) - rim(R));
}

TEST(CrackFaceTerm, IsThatOfTractionsNextToTheTip) {
  for (const double angle : {0.0, 0.6, 2.0}) {
    for (const bool quarter : {true, false}) {
      const Plate plate(angle, quarter, 2.5);
      ASSERT_EQ(plate.fields.size(), 3U);
      for (const crack::VirtualExtensionField& field : plate.fields) {
        double R = 0.0;
        double S = 1e9;
        for (const base::NodeId n : plate.cracked.faces[0].left) {
          const auto q = std::ranges::find(field.motion, n, &crack::NodeMotion::node);
          if (q != field.motion.end() && q->q == 1.0) {
            R = std::max(R, plate.from_tip(n));
          } else if (q == field.motion.end()) {
            S = std::min(S, plate.from_tip(n));
          }
        }
        const base::Matrix rows = crack::face_force_tip_functionals(
            plate.model, plate.cracked, plate.cracked.fronts[1], {field},
            model::CrackTipPlaneState::automatic, plate.faces);
        const base::Vector pressed = rows.transpose() * plate.forces(0.0, 3.0);
        const base::Vector sheared = rows.transpose() * plate.forces(3.0, 0.0);
        const double K = 3.0 * closed_form(R, S);
        EXPECT_NEAR(pressed[0], K, 1e-6 * K) << angle << quarter << field.rings;
        EXPECT_NEAR(pressed[1], 0.0, 1e-6 * K);
        EXPECT_NEAR(sheared[1], K, 1e-6 * K) << angle << quarter << field.rings;
        EXPECT_NEAR(sheared[0], 0.0, 1e-6 * K);
      }
    }
  }
}

// The term of front_intensity is linear in the forces, with these rows.
TEST(CrackFaceTerm, RowsAreTheTerm) {
  const Plate plate(0.3, true, 2.0);
  const base::Vector none =
      base::Vector::Zero(2 * static_cast<Eigen::Index>(plate.cracked.mesh.node_count()));
  crack::FrontLoads loads;
  loads.crack_faces = {plate.faces, plate.forces(-0.7, 1.3)};
  crack::FrontIntensityOptions request;
  request.state = model::CrackTipPlaneState::stress;
  const crack::StressIntensity K =
      crack::front_intensity(plate.model, plate.cracked, plate.cracked.fronts[1],
                             crack::wrap_tip_domains(plate.fields), request, none, loads)
          .front();
  const base::Vector of_rows = crack::face_force_tip_functionals(
                                   plate.model, plate.cracked, plate.cracked.fronts[1],
                                   plate.fields, model::CrackTipPlaneState::stress, plate.faces)
                                   .transpose() *
                               loads.crack_faces->force;
  EXPECT_NEAR(K.K1, of_rows[0], 1e-12 * std::abs(of_rows[0]));
  EXPECT_NEAR(K.K2, of_rows[1], 1e-12 * std::abs(of_rows[1]));
  EXPECT_EQ(K.G, 0.0); // the faces do not slip
}

} // namespace
} // namespace spricka::test_crack_face_term
