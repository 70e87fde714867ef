// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/space_enrichment.hpp"

#include "estimate/space_numbers.hpp"
#include "fe/element.hpp"
#include "fe/load_points.hpp"
#include "model/model.hpp"
#include "shape/quadrature.hpp"
#include "shape/topology.hpp"

#include <Eigen/LU>

namespace spricka::estimate {

namespace {

using base::Vec3;

template <class S> constexpr int mode_count = 0;
template <> constexpr int mode_count<shape::Tet10> = 10;
template <> constexpr int mode_count<shape::Pentac15> = 25;
template <> constexpr int mode_count<shape::Hexec20> = 40;

// Of straight tetrahedra exact; quarter points make rational functions of the others.
template <class S> constexpr int mode_degree = 7;
template <> constexpr int mode_degree<shape::Tet10> = 5;

/// Slopes of an element's functions at the points of its rule, in reference coordinates.
template <shape::ElementShape S> struct PointTable {
  struct At {
    double weight = 0.0;
    Eigen::Matrix<double, S::nodes, 3> dN;
    Eigen::Matrix<double, mode_count<S>, 3> dpsi;
  };
  std::vector<At> points;

  static const PointTable& get() {
    static const PointTable table;
    return table;
  }

private:
  PointTable() {
    for (const auto& point : shape::quadrature<S>(mode_degree<S>)) {
      points.push_back({point.weight, S::dN(point.r), SpaceModes::of(S::type).dpsi(point.r)});
    }
  }
};

template <class F> void with_modes(base::ElementType type, F&& f) {
  switch (type) {
  case base::ElementType::tet10:
    f(shape::Tet10{});
    return;
  case base::ElementType::pentac15:
    f(shape::Pentac15{});
    return;
  default:
    f(shape::Hexec20{});
  }
}

Eigen::Matrix3d stress_of(const fe::Law& law, const Eigen::Matrix3d& H) {
  return law.lambda * H.trace() * Eigen::Matrix3d::Identity() + law.mu * (H + H.transpose());
}

template <shape::ElementShape S> using ModeVectors = Eigen::Matrix<double, 3, mode_count<S>>;

/// Forces of one element on its nodes and its modes.
template <shape::ElementShape S> struct BothForces {
  fe::NodeVectors<S> nodal = fe::NodeVectors<S>::Zero();
  ModeVectors<S> modes = ModeVectors<S>::Zero();

  BothForces(const fe::NodeVectors<S>& X, const fe::Law& law, const fe::NodeVectors<S>* U,
             const ModeVectors<S>* A, bool on_nodes) {
    for (const auto& at : PointTable<S>::get().points) {
      const Eigen::Matrix3d J = X * at.dN;
      const Eigen::Matrix3d inverse = J.inverse();
      Eigen::Matrix3d G = Eigen::Matrix3d::Zero();
      if (U != nullptr) {
        G += *U * at.dN;
      }
      if (A != nullptr) {
        G += *A * at.dpsi;
      }
      const Eigen::Matrix3d F =
          at.weight * J.determinant() * stress_of(law, G * inverse) * inverse.transpose();
      modes.noalias() += F * at.dpsi.transpose();
      if (on_nodes) {
        nodal.noalias() += F * at.dN.transpose();
      }
    }
  }
};

template <shape::ElementShape S>
fe::NodeVectors<S> gathered(std::span<const base::NodeId> nodes, const base::Vector& v) {
  fe::NodeVectors<S> U;
  for (int n = 0; n < S::nodes; ++n) {
    U.col(n) =
        v.segment<3>(3 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(n)].index()));
  }
  return U;
}

} // namespace

std::string not_enriched_in_space(const model::Model& model, const model::Mesh& mesh) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (!SpaceModes::has(mesh.type[e])) {
      return base::info(mesh.type[e]).quadratic ? "some elements are HEXEC27"
                                                : "some elements are linear";
    }
    if (fe::law_of(model, mesh, base::ElementId(e)).projected) {
      return "a material is nearly incompressible";
    }
  }
  return {};
}

Vec3 place_on_element(base::ElementType type, int side, const base::Vec2& r) {
  Vec3 place = Vec3::Zero();
  const std::span<const int> local = shape::side_nodes(type, side);
  const auto at = [&](std::size_t k) -> Vec3 {
    const auto node = static_cast<std::size_t>(local[k]);
    Vec3 x = Vec3::Zero();
    shape::with_shape(type, [&]<shape::ElementShape S>(S) {
      if constexpr (S::dim == 3) {
        x = Eigen::Map<const Vec3>(S::coordinates[node].data());
      }
    });
    return x;
  };
  // Sides are flat in the reference coordinates: their corners are enough.
  if (shape::side_corners(type, side) == 3) {
    const Eigen::Vector3d N = shape::Trim3::N(r);
    for (std::size_t k = 0; k < 3; ++k) {
      place += N[static_cast<Eigen::Index>(k)] * at(k);
    }
  } else {
    const Eigen::Vector4d N = shape::Quam4::N(r);
    for (std::size_t k = 0; k < 4; ++k) {
      place += N[static_cast<Eigen::Index>(k)] * at(k);
    }
  }
  return place;
}

SpaceEnrichment::SpaceEnrichment(const model::Model& model, const model::Mesh& mesh,
                                 const std::vector<model::FreedomClass>& cls,
                                 const fe::Dependence& ties)
    : model_(model), mesh_(mesh) {
  SpaceNumbers numbers = number_modes(mesh, cls, ties);
  first_ = std::move(numbers.first);
  mode_ = std::move(numbers.mode);
  sign_ = std::move(numbers.sign);
  free_ = std::move(numbers.free);
  freedoms_ = free_.size();
  sum_diagonal();
}

void SpaceEnrichment::sum_diagonal() {
  std::vector<Eigen::Matrix3d> block(static_cast<std::size_t>(freedoms_ / 3),
                                     Eigen::Matrix3d::Zero());
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const base::ElementId id(e);
    const fe::Law law = fe::law_of(model_, mesh_, id);
    with_modes(mesh_.type[e], [&]<shape::ElementShape S>(S) {
      const fe::NodeVectors<S> X = fe::coordinates<S>(mesh_, id);
      const std::span<const std::int32_t> mode = of_element(id);
      for (const auto& at : PointTable<S>::get().points) {
        const Eigen::Matrix3d J = X * at.dN;
        const double w = at.weight * J.determinant();
        const Eigen::Matrix<double, mode_count<S>, 3> d = at.dpsi * J.inverse();
        for (std::size_t m = 0; m < mode.size(); ++m) {
          const Vec3 slope = d.row(static_cast<Eigen::Index>(m)).transpose();
          block[static_cast<std::size_t>(mode[m])] +=
              w * ((law.lambda + law.mu) * slope * slope.transpose() +
                   law.mu * slope.squaredNorm() * Eigen::Matrix3d::Identity());
        }
      }
    });
  }
  for (std::size_t m = 0; m < block.size(); ++m) {
    // A direction that is held has no part in the block's inverse.
    for (Eigen::Index c = 0; c < 3; ++c) {
      if (free_[3 * static_cast<Eigen::Index>(m) + c] == 0.0) {
        const double size = block[m](c, c);
        block[m].row(c).setZero();
        block[m].col(c).setZero();
        block[m](c, c) = size;
      }
    }
    inverse_.push_back(block[m].inverse());
  }
}

base::Vector SpaceEnrichment::precondition(const base::Vector& r) const {
  base::Vector y(r.size());
  for (std::size_t m = 0; m < inverse_.size(); ++m) {
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(m);
    y.segment<3>(at) = inverse_[m] * r.segment<3>(at);
  }
  return y.cwiseProduct(free_);
}

void SpaceEnrichment::apply(const base::Vector* v, const base::Vector* x, base::Vector* on_nodes,
                            base::Vector& on_modes) const {
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const base::ElementId id(e);
    const fe::Law law = fe::law_of(model_, mesh_, id);
    with_modes(mesh_.type[e], [&]<shape::ElementShape S>(S) {
      const std::span<const std::int32_t> mode = of_element(id);
      const std::span<const double> sign = signs(id);
      const std::span<const base::NodeId> nodes = mesh_.nodes_of(id);
      fe::NodeVectors<S> U;
      if (v != nullptr) {
        U = gathered<S>(nodes, *v);
      }
      ModeVectors<S> A;
      for (std::size_t m = 0; m < mode.size() && x != nullptr; ++m) {
        A.col(static_cast<Eigen::Index>(m)) =
            sign[m] * x->segment<3>(3 * static_cast<Eigen::Index>(mode[m]));
      }
      const BothForces<S> force(fe::coordinates<S>(mesh_, id), law, v != nullptr ? &U : nullptr,
                                x != nullptr ? &A : nullptr, on_nodes != nullptr);
      for (std::size_t m = 0; m < mode.size(); ++m) {
        on_modes.segment<3>(3 * static_cast<Eigen::Index>(mode[m])) +=
            sign[m] * force.modes.col(static_cast<Eigen::Index>(m));
      }
      for (int n = 0; n < S::nodes && on_nodes != nullptr; ++n) {
        on_nodes->segment<3>(
            3 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(n)].index())) +=
            force.nodal.col(n);
      }
    });
  }
  on_modes = on_modes.cwiseProduct(free_);
}

base::Vector SpaceEnrichment::on_modes(const base::Vector* v, const base::Vector* x) const {
  base::Vector f = base::Vector::Zero(freedoms_);
  apply(v, x, nullptr, f);
  return f;
}

void SpaceEnrichment::product(const base::Vector& x, base::Vector& on_nodes,
                              base::Vector& on_modes) const {
  on_nodes = base::Vector::Zero(3 * static_cast<Eigen::Index>(mesh_.node_count()));
  on_modes = base::Vector::Zero(freedoms_);
  apply(nullptr, &x, &on_nodes, on_modes);
}

void SpaceEnrichment::add_inside(base::ElementId e, const Vec3& r, const Vec3& force,
                                 base::Vector& f) const {
  const base::Vector psi = SpaceModes::of(mesh_.type[e.index()]).psi(r);
  const std::span<const std::int32_t> mode = of_element(e);
  const std::span<const double> sign = signs(e);
  for (std::size_t m = 0; m < mode.size(); ++m) {
    f.segment<3>(3 * static_cast<Eigen::Index>(mode[m])) +=
        sign[m] * psi[static_cast<Eigen::Index>(m)] * force;
  }
}

void SpaceEnrichment::add_on_side(const model::Face& face, const base::Vec2& r, const Vec3& force,
                                  base::Vector& f) const {
  add_inside(face.element, place_on_element(mesh_.type[face.element.index()], face.side, r), force,
             f);
}

base::Vector SpaceEnrichment::load(const model::LoadCase& load_case) const {
  base::Vector f = base::Vector::Zero(freedoms_);
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
    fe::for_load_points(model_, mesh_, load, {on_side, inside});
  }
  return f.cwiseProduct(free_);
}

void SpaceEnrichment::add_tractions(const std::vector<contact::FaceTraction>& tractions,
                                    base::Vector& f) const {
  base::Vector own = base::Vector::Zero(freedoms_);
  for (const contact::FaceTraction& traction : tractions) {
    for (const contact::TractionPoint& p : traction.points) {
      add_on_side(traction.face, p.r, p.force, own);
    }
  }
  f += own.cwiseProduct(free_);
}

} // namespace spricka::estimate
