// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/heat_field.hpp"

#include "model/loads.hpp"

#include <algorithm>

namespace spricka::fe {

namespace {

using base::ElementId;
using base::Vec3;

} // namespace

TemperatureField::TemperatureField(const PatchedMesh& patched, const model::LoadCase& load_case) {
  const model::Mesh& mesh = patched.mesh;
  for (const model::Load& load : load_case.loads) {
    if (load.type != model::LoadType::temperature) {
      continue;
    }
    if (is_new_.empty()) {
      if (mesh.dim == 2) {
        places_ = std::make_shared<HostElementFinder>(patched);
      }
      is_new_.resize(mesh.element_count());
      for (std::size_t e = 0; e < is_new_.size(); ++e) {
        is_new_[e] = patched.is_patch_element(ElementId(e));
      }
    }
    HeatedSet part{load.value.front(), std::vector<bool>(mesh.element_count(), false), false};
    for (const ElementId e : mesh.set_with_id(load.elements).elements) {
      part.member[e.index()] = true;
    }
    std::vector<bool> host(patched.host_mesh.element_count(), false);
    if (places_ != nullptr && !places_->removed_elements().empty()) {
      for (const ElementId e : patched.host_mesh.set_with_id(load.elements).elements) {
        host[e.index()] = true;
      }
      const auto in = [&](ElementId e) { return host[e.index()]; };
      // Only where the set's rim runs through what cracks took: else new elements are in it or not
      // as a whole.
      part.by_place = std::ranges::any_of(places_->removed_elements(), in) &&
                      !std::ranges::all_of(places_->removed_elements(), in);
    }
    parts_.push_back(std::move(part));
    host_member_.push_back(std::move(host));
  }
}

bool TemperatureField::may_vary_inside(ElementId e) const {
  return std::ranges::any_of(parts_, [&](const HeatedSet& part) {
    return (part.by_place && is_new_[e.index()]) ||
           (part.member[e.index()] && !part.value.is_constant());
  });
}

bool TemperatureField::acts(std::size_t part, ElementId e, const Vec3& x) const {
  if (parts_[part].by_place && is_new_[e.index()]) {
    return host_member_[part][places_->at(x.head<2>()).index()];
  }
  return parts_[part].member[e.index()];
}

double TemperatureField::operator()(ElementId e, const Vec3& x) const {
  double T = 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    T += acts(i, e, x) ? parts_[i].value(x) : 0.0;
  }
  return T;
}

} // namespace spricka::fe
