// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/adjoint.hpp"

namespace spricka::estimate {

base::Vec2 adjoint_intensity(const IntensityAdjoint& adjoint, const IntensityCauses& causes) {
  return adjoint.z.transpose() * causes.load + adjoint.rows.transpose() * causes.prescribed +
         adjoint.w.transpose() * causes.gap;
}

} // namespace spricka::estimate
