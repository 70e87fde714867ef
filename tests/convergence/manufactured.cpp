// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/convergence/manufactured.hpp"

#include "fe/law.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/field.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spricka::test {
namespace {

using base::ElementType;
using base::NodeId;
using model::StressState;

// Quarter ring 1 <= r <= 2 whose inner lines are bent: sides are curved, elements distorted.
Vec2 bent_ring(const Vec2& p) {
  const double bump =
      0.04 * std::sin(2.0 * std::numbers::pi * p.x()) * std::sin(2.0 * std::numbers::pi * p.y());
  const double angle = 0.5 * std::numbers::pi * (1.0 - p.x() - bump);
  return (1.0 + p.y() + bump) * Vec2(std::cos(angle), std::sin(angle));
}

bool on_rim(const Vec3& x) {
  const double r = x.norm();
  return std::min({x.x(), x.y(), r - 1.0, 2.0 - r}) < 1e-9;
}

const ExactField plane_exact{
    [](const Vec3& x) {
      return Vec3(std::sin(x.x()) * std::sin(x.y()), 2.0 * std::cos(x.x()) * std::cos(x.y()), 0.0);
    },
    [](const Vec3& x) {
      Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
      H.topLeftCorner<2, 2>() << std::cos(x.x()) * std::sin(x.y()),
          std::sin(x.x()) * std::cos(x.y()), -2.0 * std::sin(x.x()) * std::cos(x.y()),
          -2.0 * std::cos(x.x()) * std::sin(x.y());
      return H;
    }};

// In the plane the divergence is -cos x sin y and b = ((mu - lambda) sin x sin y, (lambda + 5 mu)
// cos x cos y). About an axis, where the field is smooth too, with s = sin x / x and
// q = ds/dx = (cos x - s) / x the volume change is (s - cos x) sin y and
//     b_x = -((lambda - mu) sin x + (lambda + 2 mu) q) sin y
//     b_y = ((lambda + 5 mu) cos x + (mu - lambda) s) cos y.
std::vector<base::CompiledExpression> plane_force(const fe::ConstitutiveLaw& k) {
  CardField x = CardField(k.mu - k.lambda) * sin(x_field);
  CardField y = CardField(k.lambda + 5.0 * k.mu) * cos(x_field);
  if (k.axisymmetric) {
    const CardField s = sin(x_field) / x_field;
    x = x - CardField(k.lambda + 2.0 * k.mu) * ((cos(x_field) - s) / x_field);
    y = y + CardField(k.mu - k.lambda) * s;
  }
  return {(x * sin(y_field)).code, (y * cos(y_field)).code};
}

Vec3 shell(const Vec3& p) {
  constexpr double pi = std::numbers::pi;
  const double bump = 0.05 * std::sin(pi * p.x()) * std::sin(pi * p.y()) * std::sin(pi * p.z());
  const double r = 1.0 + 0.8 * (p.x() + bump);
  const double theta = 0.9 * (p.y() + bump);
  const double phi = 0.8 * (p.z() - bump);
  return r * Vec3(std::cos(theta) * std::cos(phi), std::sin(theta) * std::cos(phi), std::sin(phi));
}

ExactField solid_exact(const Vec3& a) {
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

CardField along(int i) {
  const CardField z_field{base::OpCode::z};
  const std::array<CardField, 3> x{x_field, y_field, z_field};
  CardField e = sin(x[static_cast<std::size_t>(i)]);
  for (int j = 0; j < 3; ++j) {
    e = j == i ? e : e * cos(x[static_cast<std::size_t>(j)]);
  }
  return e;
}

model::Model solid_model(ElementType type, double nu, int n) {
  model::Model model = plane_model(1.0, nu, model::StressState::solid);
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
  model::NodeSetFreedomRole held;
  held.cls = model::FreedomRole::prescribed;
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
  base::Vector u = fe::prescribed_displacement_vector(model, mesh, load_case);
  base::Vector r = -fe::consistent_load_vector(model, mesh, load_case);
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

} // namespace

Manufactured manufactured_plane(ElementType type, StressState state, int n) {
  model::Model model = plane_model(1.0, 0.3, state);
  model.mesh = make_mesh(type, unit_grid(n, n), bent_ring);
  for (Vec3& x : model.mesh.x) { // cos(pi / 2) is not quite zero
    x.x() = std::abs(x.x()) < 1e-12 ? 0.0 : x.x();
  }
  set_freedom(model, model::FreedomRole::prescribed, on_rim, true, true);
  model::Load body;
  body.type = model::LoadType::body;
  body.elements = all_elements(model);
  body.value = plane_force(fe::constitutive_law(model.materials[0], model.properties[0], type));
  model::Load rim;
  rim.type = model::LoadType::displacement;
  rim.nodes = node_set(model, on_rim);
  rim.value = {(sin(x_field) * sin(y_field)).code, (2.0 * (cos(x_field) * cos(y_field))).code};
  base::Vector u = solve(model, {"", {body, rim}});
  return {std::move(model), std::move(u), plane_exact};
}

Manufactured manufactured_solid(ElementType type, double nu, const Vec3& a, int n) {
  model::Model model = solid_model(type, nu, n);
  const fe::ConstitutiveLaw k = fe::constitutive_law(model.materials[0], model.properties[0], type);
  model::Load body;
  body.type = model::LoadType::body;
  body.elements = all_elements(model);
  model::Load rim;
  rim.type = model::LoadType::displacement;
  rim.nodes = model.freedoms.front().nodes;
  // The volume change is (a_1 + a_2 + a_3) cos x cos y cos z, the body force
  // b_i = ((lambda + mu)(a_1 + a_2 + a_3) + 3 mu a_i) e_i.
  for (int i = 0; i < 3; ++i) {
    const double b = (k.lambda + k.mu) * a.sum() + 3.0 * k.mu * a[i];
    body.value.push_back((CardField(b) * along(i)).code);
    rim.value.push_back((CardField(a[i]) * along(i)).code);
  }
  base::Vector u = solve_by_gradients(model, {"", {body, rim}});
  return {std::move(model), std::move(u), solid_exact(a)};
}

} // namespace spricka::test
