// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::fe {

/// Stresses as six components xx yy zz xy yz zx, whatever the dimension (plane strain has zz; about
/// an axis xx is radial, yy axial and zz the hoop stress).
using Stress = Eigen::Matrix<double, 6, 1>;

/// What a stress depends on: displacements [dim * node] and, where there are any, temperatures
/// [connectivity index], see thermal.hpp. Both stay with the caller.
struct DisplacementTemperatureField {
  const base::Vector& u;
  const base::Vector* temperature = nullptr;

  DisplacementTemperatureField(const base::Vector& u_)
      : u(u_) {} // NOLINT(google-explicit-constructor): a plain u
  DisplacementTemperatureField(const base::Vector& u_, const base::Vector& T)
      : u(u_), temperature(T.size() > 0 ? &T : nullptr) {}
};

} // namespace spricka::fe
