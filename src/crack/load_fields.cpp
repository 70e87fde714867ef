// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/load_fields.hpp"

#include "model/loads.hpp"

namespace spricka::crack {

std::vector<BodyField> body_fields(const TipSetting& set) {
  std::vector<BodyField> fields;
  for (const ActingLoad& acting : set.loads.loads) {
    if (acting.elements.empty() || acting.load->type == model::LoadType::temperature) {
      continue;
    }
    BodyField field{&acting, {}, {}};
    if (acting.load->elements.valid()) {
      field.shares = fe::set_shares(set.model, set.mesh, acting.load->elements);
      field.scale = fe::load_scale(set.mesh, *acting.load, field.shares.elements);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

} // namespace spricka::crack
