// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/load_fields.hpp"

#include "model/loads.hpp"

#include <algorithm>

namespace spricka::crack {

std::vector<BodyForceField> body_force_fields(const TipSetting& set) {
  std::vector<BodyForceField> fields;
  for (const ActingLoad& acting : set.loads.loads) {
    if (acting.elements.empty() || acting.load->type == model::LoadType::temperature) {
      continue;
    }
    BodyForceField field{&acting, {}, {}};
    if (acting.load->elements.valid()) {
      field.shares = fe::set_shares(set.model, set.mesh, acting.load->elements);
      field.scale = fe::load_scale(set.mesh, *acting.load, field.shares.elements);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

void for_body_forces(const TipSetting& set, const std::vector<BodyForceField>& fields,
                     base::ElementId e, const PlaneVectors& X, const BodyForceVisit& visit) {
  const PlaneElement& element = plane_element(set.mesh, e);
  for (const BodyForceField& field : fields) {
    const ActingLoad& acting = *field.acting;
    if (!std::ranges::binary_search(acting.elements, e)) {
      continue;
    }
    const fe::ElementShare* share = field.shares.find_share(e);
    for (const auto& point : fe::body_load_rule<2>(element, X, *acting.load, field.scale).points) {
      base::Vec3 x = base::Vec3::Zero();
      x.head<2>() = X * element.N(point.r);
      const double factor = share == nullptr ? acting.factor : acting.factor * (*share)(x);
      visit(point.r, point.weight, base::Vec2(factor * fe::load_value(*acting.load, x).head<2>()));
    }
  }
}

} // namespace spricka::crack
