// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/law.hpp"

namespace spricka::fe {

Law law_of(const model::Material& material, const model::Property& property) {
  const Lame k = lame(material, property.state);
  Law law;
  law.lambda = k.lambda;
  law.mu = k.mu;
  law.plane_stress = property.state == model::State::plane_stress;
  law.axisymmetric = property.state == model::State::axisymmetric;
  const bool plane = law.plane_stress || property.state == model::State::plane_strain;
  law.thickness = plane ? property.thickness : 1.0;
  // A body held all round carries -(3 lambda + 2 mu) alpha T; in plane stress, with the reduced
  // lambda, two directions are held.
  law.thermal = material.alpha * ((law.plane_stress ? 2.0 : 3.0) * k.lambda + 2.0 * k.mu);
  law.projected = !law.plane_stress && material.nu > nearly_incompressible;
  return law;
}

} // namespace spricka::fe
