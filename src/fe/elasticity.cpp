// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/elasticity.hpp"

namespace spricka::fe {

LameConstants lame_constants(const model::ElasticMaterial& material, model::StressState state) {
  const double E = material.E;
  const double nu = material.nu;
  const double mu = E / (2.0 * (1.0 + nu));
  if (state == model::StressState::plane_stress) {
    return {E * nu / (1.0 - nu * nu), mu};
  }
  return {E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), mu};
}

double effective_modulus(const model::ElasticMaterial& material, model::StressState state) {
  return state == model::StressState::plane_stress ? material.E
                                                   : material.E / (1.0 - material.nu * material.nu);
}

} // namespace spricka::fe
