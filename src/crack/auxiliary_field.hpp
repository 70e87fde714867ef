// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/energy_momentum.hpp"
#include "crack/williams.hpp"

#include <array>
#include <cstddef>

/// Displacements at a point of a body, and those that the solution is combined with.
namespace spricka::crack {

/// Partners of the solution at a front: itself (G), the near-tip fields of K1, K2 and in space K3
/// = 1, and the field of a unit force along the crack at the front (T).
template <int dim> inline constexpr std::size_t auxiliary_field_count = dim + 2;
/// Number of the last one.
template <int dim> inline constexpr std::size_t force_auxiliary = dim + 1;
/// Number of a partner among the fields of a section (section_field).
template <int dim> [[nodiscard]] constexpr std::size_t section_field_number(std::size_t auxiliary) {
  return auxiliary == force_auxiliary<dim> ? line_force_auxiliary : auxiliary;
}

/// A displacement at a point: gradient and stress, and about an axis those round it (both 0 in
/// other bodies, where nothing works on them).
template <int dim> struct GradientStressState {
  Tensor<dim> H = Tensor<dim>::Zero(); ///< du_i/dx_j
  double hoop = 0.0;                   ///< u_x / x
  Tensor<dim> sigma = Tensor<dim>::Zero();
  double sigma_hoop = 0.0;

  /// Volume change, the part round the axis included.
  [[nodiscard]] double dilatation() const { return H.trace() + hoop; }
};

/// An auxiliary field at a point off the front. About an axis it is carried round with the section,
/// in space along the front: a displacement of the body, but none of a body at rest.
template <int dim> struct AuxiliaryField : GradientStressState<dim> {
  /// Of its stress [stress/length] (crack.38, crack_space.5).
  shape::Point<dim> divergence = shape::Point<dim>::Zero();
};

/// A number of each auxiliary field, 1 and on, worked on at once, and vectors and tensors of them:
/// by component and by column.
template <int dim> using OfFields = Eigen::Array<double, auxiliary_field_count<dim> - 1, 1>;
template <int dim> using VectorOfFields = std::array<OfFields<dim>, dim>;
template <int dim> using TensorOfFields = std::array<VectorOfFields<dim>, dim>;

/// Gradients and stresses at a point, one of each auxiliary field, as in GradientStressState.
template <int dim> struct GradientStressStates {
  TensorOfFields<dim> H, sigma;
  OfFields<dim> hoop = OfFields<dim>::Zero();
  OfFields<dim> sigma_hoop = OfFields<dim>::Zero();
};

/// All auxiliary fields at a point off the front.
template <int dim> struct AuxiliaryFields : GradientStressStates<dim> {
  VectorOfFields<dim> divergence; ///< as in AuxiliaryField

  /// Puts in one of them, 1 and on.
  void set(std::size_t auxiliary, const AuxiliaryField<dim>& v) {
    const auto k = static_cast<Eigen::Index>(auxiliary - 1);
    for (std::size_t i = 0; i < dim; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      divergence[i][k] = v.divergence[row];
      for (std::size_t j = 0; j < dim; ++j) {
        const auto column = static_cast<Eigen::Index>(j);
        this->H[j][i][k] = v.H(row, column);
        this->sigma[j][i][k] = v.sigma(row, column);
      }
    }
    this->hoop[k] = v.hoop;
    this->sigma_hoop[k] = v.sigma_hoop;
  }
};

/// Work density of the stress of a displacement on the strains of the auxiliary fields, the part
/// round the axis included [stress].
template <int dim>
OfFields<dim> work_densities(const GradientStressState<dim>& u,
                             const GradientStressStates<dim>& fields) {
  OfFields<dim> work = u.sigma_hoop * fields.hoop;
  for (std::size_t j = 0; j < dim; ++j) {
    for (std::size_t i = 0; i < dim; ++i) {
      work += u.sigma(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * fields.H[j][i];
    }
  }
  return work;
}

/// Energy-momentum of the work of a displacement and each auxiliary field on each other, H_v^T
/// sigma_u + H_u^T sigma_v - `work` I [stress] (crack.10); `work`: work_densities of both.
template <int dim>
TensorOfFields<dim> interaction_energy_momentum(const GradientStressState<dim>& u,
                                                const GradientStressStates<dim>& fields,
                                                const OfFields<dim>& work) {
  TensorOfFields<dim> T;
  for (std::size_t j = 0; j < dim; ++j) {
    for (std::size_t i = 0; i < dim; ++i) {
      T[j][i] = OfFields<dim>::Zero();
      for (std::size_t m = 0; m < dim; ++m) {
        const auto row = static_cast<Eigen::Index>(m);
        T[j][i] += u.sigma(row, static_cast<Eigen::Index>(j)) * fields.H[i][m] +
                   u.H(row, static_cast<Eigen::Index>(i)) * fields.sigma[j][m];
      }
    }
    T[j][j] -= work;
  }
  return T;
}

} // namespace spricka::crack
