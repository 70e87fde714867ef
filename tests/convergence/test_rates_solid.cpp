// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/law.hpp"
#include "mesh/generate.hpp"
#include "tests/convergence/error_norm.hpp"
#include "tests/unit/fe/field.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Rates in space on a sector of a thick spherical shell with bent lines inside. With
// e = (sin x cos y cos z, cos x sin y cos z, cos x cos y sin z) the field is u_i = a_i e_i; its
// volume change is (a_1 + a_2 + a_3) cos x cos y cos z and its body force
// b_i = ((lambda + mu)(a_1 + a_2 + a_3) + 3 mu a_i) e_i. Displacements are prescribed all round.
namespace spricka::test {
namespace {

using base::ElementType;
using base::NodeId;

Vec3 shell(const Vec3& p) {
  constexpr double pi = std::numbers::pi;
  const double bump = 0.05 * std::sin(pi * p.x()) * std::sin(pi * p.y()) * std::sin(pi * p.z());
  const double r = 1.0 + 0.8 * (p.x() + bump);
  const double theta = 0.9 * (p.y() + bump);
  const double phi = 0.8 * (p.z() - bump);
  return r * Vec3(std::cos(theta) * std::cos(phi), std::sin(theta) * std::cos(phi), std::sin(phi));
}

ExactField exact(const Vec3& a) {
  ExactField field;
  field.u = [a](const Vec3& x) {
    const Eigen::Array3d s = x.array().sin();
    const Eigen::Array3d c = x.array().cos();
    return Vec3(a.array() * s * Eigen::Array3d(c[1] * c[2], c[0] * c[2], c[0] * c[1]));
  };
  field.H = [a](const Vec3& x) {
    const Eigen::Array3d s = x.array().sin();
    const Eigen::Array3d c = x.array().cos();
    Eigen::Matrix3d H;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        H(i, j) = i == j ? a[i] * c.prod() : -a[i] * s[i] * s[j] * c[3 - i - j];
      }
    }
    return H;
  };
  return field;
}

Field along(int i) {
  const Field z_field{base::Op::z};
  const std::array<Field, 3> x{x_field, y_field, z_field};
  Field e = sin(x[static_cast<std::size_t>(i)]);
  for (int j = 0; j < 3; ++j) {
    e = j == i ? e : e * cos(x[static_cast<std::size_t>(j)]);
  }
  return e;
}

model::Model make_model(ElementType type, double nu, int n) {
  model::Model model = plane_model(1.0, nu, model::State::solid);
  model.mesh.dim = 3;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.nx = spec.ny = spec.nz = n;
  mesh::generate_solid_block(model.mesh, base::NetId(0), "", spec);
  model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(0));
  model::NodeSet rim;
  for (std::size_t k = 0; k < model.mesh.node_count(); ++k) {
    Vec3& x = model.mesh.x[k];
    if (std::min(x.minCoeff(), (1.0 - x.array()).minCoeff()) < 1e-9) {
      rim.nodes.emplace_back(k);
    }
    x = shell(x);
  }
  model.mesh.node_sets.push_back(rim);
  model::Freedom held;
  held.cls = model::FreedomClass::prescribed;
  held.dof = {true, true, true};
  held.nodes = base::NodeSetId(model.mesh.node_sets.size() - 1);
  model.freedoms.push_back(held);
  return model;
}

// By conjugate gradients: a direct solution in Eigen takes ten times as long here.
base::Vector solve_by_gradients(const model::Model& model, const model::LoadCase& load_case) {
  const model::Mesh& mesh = model.mesh;
  std::vector<NodeId> nodes;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    nodes.emplace_back(n);
  }
  const std::vector<base::ElementId> elements = every_element(mesh);
  const fe::DofMap dofs = fe::number_freedoms(mesh, nodes, fe::classify_freedoms(model, mesh));
  const base::SymmetricCsc K = fe::assemble_stiffness(model, mesh, elements, {}, dofs);
  base::Vector u = fe::prescribed_displacement(model, mesh, load_case);
  base::Vector r = -fe::nodal_load(model, mesh, load_case);
  fe::add_internal_force(model, mesh, elements, u, r);
  const Eigen::SparseMatrix<double> lower =
      Eigen::Map<const Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>>(
          K.n, K.n, static_cast<std::int64_t>(K.row.size()), K.start.data(), K.row.data(),
          K.value.data())
          .cast<double>();
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> gradients(lower);
  gradients.setTolerance(1e-10);
  gradients.setMaxIterations(20 * lower.rows());
  const base::Vector x = gradients.solve(-base::Vector(r(dofs.freedom)));
  EXPECT_EQ(gradients.info(), Eigen::Success);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    u[dofs.freedom[static_cast<std::size_t>(i)]] += x[i];
  }
  return u;
}

ErrorNorms run(ElementType type, double nu, const Vec3& a, int n) {
  model::Model model = make_model(type, nu, n);
  const fe::Law k = fe::law_of(model.materials[0], model.properties[0], type);
  model::Load body;
  body.type = model::LoadType::body;
  body.elements = all_elements(model);
  model::Load rim;
  rim.type = model::LoadType::displacement;
  rim.nodes = model.freedoms.front().nodes;
  for (int i = 0; i < 3; ++i) {
    const double b = (k.lambda + k.mu) * a.sum() + 3.0 * k.mu * a[i];
    body.value.push_back((Field(b) * along(i)).code);
    rim.value.push_back((Field(a[i]) * along(i)).code);
  }
  return error_norms(model, solve_by_gradients(model, {"", {body, rim}}), exact(a));
}

class SolidRates : public testing::TestWithParam<ElementType> {};

INSTANTIATE_TEST_SUITE_P(convergence, SolidRates,
                         testing::Values(ElementType::tet4, ElementType::tet10, ElementType::penta6,
                                         ElementType::pentac15, ElementType::hexe8,
                                         ElementType::hexec20, ElementType::hexec27),
                         [](const auto& c) { return std::string(base::info(c.param).name); });

TEST_P(SolidRates, are_those_of_the_theory) {
  const ElementType type = GetParam();
  const double p = base::info(type).quadratic ? 2.0 : 1.0;
  const std::vector<int> sizes =
      base::info(type).quadratic ? std::vector<int>{3, 4, 6} : std::vector<int>{6, 9, 14};
  std::vector<double> L2;
  std::vector<double> energy;
  for (const int n : sizes) {
    const ErrorNorms error = run(type, 0.3, Vec3(1.0, -2.0, 0.5), n);
    L2.push_back(error.L2);
    energy.push_back(error.energy);
  }
  RecordProperty("L2", std::to_string(slope(sizes, L2)));
  RecordProperty("energy", std::to_string(slope(sizes, energy)));
  EXPECT_NEAR(slope(sizes, L2), p + 1.0, 0.1);
  EXPECT_NEAR(slope(sizes, energy), p, 0.1);
}

// A field without change of volume at nu = 0.4999, with the projected dilatation. TET4 and PENTA6
// are left out: one dilatation in each of them is too many for the freedoms that they share.
class NearlyIncompressible : public testing::TestWithParam<ElementType> {};

INSTANTIATE_TEST_SUITE_P(convergence, NearlyIncompressible,
                         testing::Values(ElementType::tet10, ElementType::pentac15,
                                         ElementType::hexe8, ElementType::hexec20,
                                         ElementType::hexec27),
                         [](const auto& c) { return std::string(base::info(c.param).name); });

TEST_P(NearlyIncompressible, does_not_lock) {
  const ElementType type = GetParam();
  const double p = base::info(type).quadratic ? 2.0 : 1.0;
  const std::vector<int> sizes =
      base::info(type).quadratic ? std::vector<int>{3, 4, 6} : std::vector<int>{6, 9};
  std::vector<double> L2;
  double soft = 0.0;
  for (const int n : sizes) {
    soft = run(type, 0.3, Vec3(1.0, -2.0, 1.0), n).L2;
    L2.push_back(run(type, 0.4999, Vec3(1.0, -2.0, 1.0), n).L2);
  }
  EXPECT_GT(slope(sizes, L2), p + 0.9);
  EXPECT_LT(L2.back(), 1.25 * soft);
}

} // namespace
} // namespace spricka::test
