// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/auxiliary_field.hpp"
#include "crack/front_axes.hpp"

#include <cstddef>

/// Fields of plane strain and of antiplane shear, carried along a front by its axes.
namespace spricka::crack {

/// An isotropic body round a front, and a length to count logarithms in.
struct FrontBody {
  double lambda = 0.0, mu = 0.0; ///< Lame's constants [stress]
  double nu = 0.0;
  double unit = 1.0;

  /// Of the fields in the section: that of plane strain.
  [[nodiscard]] SectionBody plane_strain_section() const { return {mu, 3.0 - 4.0 * nu, unit}; }
  /// With the stress of a gradient; nothing is round an axis.
  [[nodiscard]] GradientStressState<3> state_from_gradient(const Tensor<3>& H,
                                                           double hoop = 0.0) const;
  /// Sets the stresses of gradients.
  void set_stress(GradientStressStates<3>& of) const;
};

/// Of auxiliary field 1 to 4 in the section across a front.
inline SectionField section_field(std::size_t auxiliary, const SectionPolarPoint& at,
                                  const FrontBody& body) {
  return section_field(auxiliary, at, body.plane_strain_section());
}

/// The axes at a place as matrices with columns m, b, t and their derivatives, and the gradients of
/// s, y and z with theirs (crack_space.2): the same for all auxiliary fields, as the place in the
/// section.
struct FrontAxesDerivatives {
  struct CoordinateGradients {
    base::Vec3 s, y, z;
  };
  Tensor<3> Q, dQ, ddQ;
  CoordinateGradients grad, by_s, by_y, by_z;
  SectionPolarPoint section;

  explicit FrontAxesDerivatives(const FrontCoordinates& at);
};

/// What the auxiliary fields 1 to 4 at a place are made of by the elasticity there.
struct FrontAuxiliaryValues {
  TensorOfFields<3> H;
  VectorOfFields<3> divergence;
};

/// The auxiliary fields, w = w1 m + w2 b + w3 t, carried along a front that turns: their gradients
/// with the turning of the axes in them, and the divergence of their stress at a place
/// (crack_space.4). All of them at once, which costs little more than one.
FrontAuxiliaryValues front_auxiliary_values(const FrontAxesDerivatives& axes,
                                            const FrontBody& body);

/// Auxiliary field 1 to 4 with its stress.
AuxiliaryField<3> front_auxiliary_field(std::size_t auxiliary, const FrontAxesDerivatives& axes,
                                        const FrontBody& body);

/// Its gradient alone.
Tensor<3> front_auxiliary_gradient(std::size_t auxiliary, const FrontAxesDerivatives& axes,
                                   const FrontBody& body);

/// The same at a point by its coordinates seen from the front.
inline AuxiliaryField<3> front_auxiliary_field(std::size_t auxiliary, const FrontCoordinates& at,
                                               const FrontBody& body) {
  return front_auxiliary_field(auxiliary, FrontAxesDerivatives(at), body);
}

/// Stress of a displacement gradient A in an isotropic body, lambda tr(A) I + mu (A + A^T)
/// [stress].
inline Tensor<3> isotropic_stress(const FrontBody& body, const Tensor<3>& A) {
  Tensor<3> sigma = body.mu * (A + A.transpose());
  sigma.diagonal().array() += body.lambda * A.trace();
  return sigma;
}

/// The fields of these values, with their stresses.
inline AuxiliaryFields<3> make_auxiliary_fields(const FrontAuxiliaryValues& values,
                                                const FrontBody& body) {
  AuxiliaryFields<3> w;
  w.H = values.H;
  w.divergence = values.divergence;
  body.set_stress(w);
  return w;
}

inline void FrontBody::set_stress(GradientStressStates<3>& of) const {
  const OfFields<3> pressure = lambda * (of.H[0][0] + of.H[1][1] + of.H[2][2]);
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      of.sigma[j][i] = of.sigma[i][j] = mu * (of.H[j][i] + of.H[i][j]);
    }
    of.sigma[j][j] = mu * (of.H[j][j] + of.H[j][j]) + pressure;
  }
}

inline GradientStressState<3> FrontBody::state_from_gradient(const Tensor<3>& H,
                                                             double hoop) const {
  return {.H = H, .hoop = hoop, .sigma = isotropic_stress(*this, H), .sigma_hoop = 0.0};
}

} // namespace spricka::crack
