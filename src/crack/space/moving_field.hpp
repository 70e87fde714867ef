// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/energy_momentum.hpp"
#include "crack/space/front_axes.hpp"

#include <cstddef>

/// Fields of plane strain and of antiplane shear, carried along a front by its axes.
namespace spricka::crack {

/// Partners of the solution along a front: itself (G), the near-front fields of K1, K2, K3 = 1 and
/// the field of a unit force per length along m (T).
inline constexpr std::size_t front_auxiliary_field_count = 5;
inline constexpr std::size_t line_force_auxiliary = 4;

/// An isotropic body round a front, and a length to count logarithms in.
struct FrontBody {
  double lambda = 0.0, mu = 0.0; ///< Lame's constants [stress]
  double nu = 0.0;
  double unit = 1.0;
};

/// A point off the front in the section across it, with what the fields of all auxiliary fields
/// share.
struct SectionPolarPoint {
  double r = 0.0, theta = 0.0;
  double c1 = 0.0, s1 = 0.0; ///< cosine and sine of theta/2
  double C = 0.0, S = 0.0;   ///< of theta
  double c3 = 0.0, s3 = 0.0; ///< of 3 theta/2

  SectionPolarPoint(double radius, double angle);
};

/// Displacements along m, b, t as a function of y and z, with derivatives.
struct SectionField {
  base::Vec3 w, w_y, w_z, w_yy, w_yz, w_zz;
};
/// Of auxiliary field 1 to 4 (manual, crack_space.3).
SectionField section_field(std::size_t auxiliary, const SectionPolarPoint& at,
                           const FrontBody& body);

/// The axes at a place as matrices with columns m, b, t and their derivatives, and the gradients of
/// s, y and z with theirs (crack_space.2): the same for all auxiliary fields, as the place in the
/// section.
struct TurningAxes {
  struct CoordinateGradients {
    base::Vec3 s, y, z;
  };
  Tensor<3> Q, dQ, ddQ;
  CoordinateGradients grad, by_s, by_y, by_z;
  SectionPolarPoint section;

  explicit TurningAxes(const FrontCoordinates& at);
};

/// The field w = w1 m + w2 b + w3 t of a auxiliary field (crack_space.4) at a place.
struct FrontAuxiliaryField {
  Tensor<3> H = Tensor<3>::Zero();            ///< dw_i/dx_j, the turning of the axes in it
  Tensor<3> sigma = Tensor<3>::Zero();        ///< its stress
  base::Vec3 divergence = base::Vec3::Zero(); ///< of that, not zero where the front turns
};
/// An auxiliary field 1 to 4, carried along a front that turns: gradient, stress and its divergence
/// at a place.
FrontAuxiliaryField front_auxiliary_field(std::size_t auxiliary, const TurningAxes& axes,
                                          const FrontBody& body);

/// The same at a point by its coordinates seen from the front.
inline FrontAuxiliaryField front_auxiliary_field(std::size_t auxiliary, const FrontCoordinates& at,
                                                 const FrontBody& body) {
  return front_auxiliary_field(auxiliary, TurningAxes(at), body);
}

/// Stress of a displacement gradient A in an isotropic body, lambda tr(A) I + mu (A + A^T)
/// [stress].
inline Tensor<3> isotropic_stress(const FrontBody& body, const Tensor<3>& A) {
  Tensor<3> sigma = body.mu * (A + A.transpose());
  sigma.diagonal().array() += body.lambda * A.trace();
  return sigma;
}

} // namespace spricka::crack
