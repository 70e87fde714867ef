// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/space_enrichment.hpp"

#include "fe/load_points.hpp"
#include "fe/load_rule.hpp"
#include "model/model.hpp"
#include "shape/side_place.hpp"
#include "shape/topology.hpp"

#include <Eigen/LU>

namespace spricka::estimate {

using base::Vec3;

std::string solid_enrichment_obstacle(const model::Model& model, const model::Mesh& mesh) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (!SolidModes::has_modes_for_type(mesh.type[e])) {
      return base::element_info(mesh.type[e]).quadratic ? "some elements are HEXEC27"
                                                        : "some elements are linear";
    }
    if (fe::constitutive_law(model, mesh, base::ElementId(e)).projected) {
      return "a material is nearly incompressible";
    }
  }
  return {};
}

SolidEnrichment::SolidEnrichment(const model::Model& model, const model::Mesh& mesh,
                                 const std::vector<model::FreedomRole>& cls,
                                 const fe::ConstraintTransformation& ties)
    : model_(model), mesh_(mesh), operator_(model, mesh, number_solid_modes(mesh, cls, ties)) {
  std::vector<Eigen::Matrix3d> block = operator_.diagonal_blocks();
  for (std::size_t m = 0; m < block.size(); ++m) {
    // A direction that is held has no part in the block's inverse.
    for (Eigen::Index c = 0; c < 3; ++c) {
      if (free_mode_mask()[3 * static_cast<Eigen::Index>(m) + c] == 0.0) {
        const double size = block[m](c, c);
        block[m].row(c).setZero();
        block[m].col(c).setZero();
        block[m](c, c) = size;
      }
    }
    inverse_.push_back(block[m].inverse());
  }
}

base::Vector SolidEnrichment::apply_preconditioner(const base::Vector& r) const {
  // More steps gain little: what the nodes do is not in K_ee.
  constexpr int steps = 4;
  base::Vector x = base::Vector::Zero(r.size());
  base::Vector left = r;
  base::Vector s = divide_by_diagonal(left);
  base::Vector p = s;
  double size = left.dot(s);
  for (int i = 0; i < steps && size > 0.0; ++i) {
    base::Vector force = base::Vector::Zero(p.size());
    operator_.add_forces({nullptr, &p}, {nullptr, &force}, ModeStiffnessRule::reduced);
    force = force.cwiseProduct(free_mode_mask());
    const double alpha = size / p.dot(force);
    x += alpha * p;
    left -= alpha * force;
    s = divide_by_diagonal(left);
    const double next = left.dot(s);
    p = s + (next / size) * p;
    size = next;
  }
  return x;
}

base::Vector SolidEnrichment::divide_by_diagonal(const base::Vector& r) const {
  base::Vector y(r.size());
  for (std::size_t m = 0; m < inverse_.size(); ++m) {
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(m);
    y.segment<3>(at) = inverse_[m] * r.segment<3>(at);
  }
  return y.cwiseProduct(free_mode_mask());
}

base::Vector SolidEnrichment::stiffness_forces_on_modes(const base::Vector* v,
                                                        const base::Vector* x) const {
  base::Vector f = base::Vector::Zero(freedoms());
  operator_.add_forces({v, x}, {nullptr, &f});
  return f.cwiseProduct(free_mode_mask());
}

void SolidEnrichment::stiffness_product(const base::Vector& x, base::Vector& on_nodes,
                                        base::Vector& on_modes) const {
  on_nodes = base::Vector::Zero(3 * static_cast<Eigen::Index>(mesh_.node_count()));
  on_modes = base::Vector::Zero(freedoms());
  operator_.add_forces({nullptr, &x}, {&on_nodes, &on_modes});
  on_modes = on_modes.cwiseProduct(free_mode_mask());
}

void SolidEnrichment::add_inside(base::ElementId e, const Vec3& r, const Vec3& force,
                                 base::Vector& f) const {
  const base::Vector psi = SolidModes::for_type(mesh_.type[e.index()]).psi(r);
  const std::span<const std::int32_t> mode = element_modes(e);
  const std::span<const double> sign = element_mode_signs(e);
  for (std::size_t m = 0; m < mode.size(); ++m) {
    f.segment<3>(3 * static_cast<Eigen::Index>(mode[m])) +=
        sign[m] * psi[static_cast<Eigen::Index>(m)] * force;
  }
}

void SolidEnrichment::add_on_side(const model::Face& face, const base::Vec2& r, const Vec3& force,
                                  base::Vector& f) const {
  const base::ElementType type = mesh_.type[face.element.index()];
  add_inside(face.element, shape::side_to_solid_point(type, face.side, r), force, f);
}

// A temperature presses on the volume change of the modes.
void SolidEnrichment::add_thermal(base::ElementId e, const fe::CaseTemperature& heat,
                                  base::Vector& f) const {
  const fe::AnyElement<3>& element = shape::reference_element<3>(mesh_.type[e.index()]);
  const fe::CornerValues<3> T = fe::gather_corner_temperatures(element, mesh_, e, heat.temperature);
  const bool varies = heat.field.may_vary_inside(e);
  if ((T.array() == 0.0).all() && !varies) {
    return;
  }
  const fe::AnyNodeVectors<3> X = fe::element_coordinates(element, mesh_, e);
  const fe::ConstitutiveLaw law = fe::constitutive_law(model_, mesh_, e);
  const fe::ThermalStress<3> thermal(element, X, law, T);
  const SolidModes& modes = SolidModes::for_type(mesh_.type[e.index()]);
  base::Matrix F = base::Matrix::Zero(static_cast<Eigen::Index>(modes.modes().size()), 3);
  const double beta = fe::thermal_modulus(law);
  const int degree = varies ? fe::load_degree : element.degree;
  for (const auto& point : shape::quadrature<3>(element.domain, degree)) {
    const Eigen::Matrix3d J = X.lazyProduct(element.dN(point.r));
    const Eigen::Matrix3d inverse = J.inverse();
    const double pressure =
        varies ? beta * heat.field(e, Vec3(X * element.N(point.r))) : thermal.at(point.r);
    const double w = point.weight * J.determinant() * pressure;
    F += w * modes.dpsi(point.r).lazyProduct(inverse);
  }
  const std::span<const std::int32_t> mode = element_modes(e);
  const std::span<const double> sign = element_mode_signs(e);
  for (std::size_t m = 0; m < mode.size(); ++m) {
    f.segment<3>(3 * static_cast<Eigen::Index>(mode[m])) +=
        sign[m] * F.row(static_cast<Eigen::Index>(m)).transpose();
  }
}

base::Vector SolidEnrichment::distributed_load(const model::LoadCase& load_case,
                                               const fe::CaseTemperature& heat) const {
  base::Vector f = base::Vector::Zero(freedoms());
  const auto on_side = [&](const model::Face& face, std::span<const fe::LoadPoint> points) {
    for (const fe::LoadPoint& p : points) {
      add_on_side(face, p.r.head<2>(), p.force, f);
    }
  };
  const auto inside = [&](base::ElementId e, std::span<const fe::LoadPoint> points) {
    for (const fe::LoadPoint& p : points) {
      add_inside(e, p.r, p.force, f);
    }
  };
  for (const model::Load& load : load_case.loads) {
    if (load.type == model::LoadType::bearing) {
      continue; // its nodal forces stand for it
    }
    fe::for_load_points(model_, mesh_, load, {on_side, inside});
  }
  for (std::size_t e = 0; e < mesh_.element_count() && heat.temperature.size() > 0; ++e) {
    add_thermal(base::ElementId(e), heat, f);
  }
  return f.cwiseProduct(free_mode_mask());
}

void SolidEnrichment::add_tractions(const std::vector<contact::FaceTraction>& tractions,
                                    base::Vector& f) const {
  base::Vector own = base::Vector::Zero(freedoms());
  for (const contact::FaceTraction& traction : tractions) {
    for (const contact::FacePointForce& p : traction.points) {
      add_on_side(traction.face, p.r, p.force, own);
    }
  }
  f += own.cwiseProduct(free_mode_mask());
}

} // namespace spricka::estimate
