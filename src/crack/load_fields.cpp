// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/load_fields.hpp"

#include "model/loads.hpp"

#include <algorithm>

namespace spricka::crack {

std::vector<BodyForceField> body_force_fields(const model::Model& model, const model::Mesh& mesh,
                                              const FrontLoads& loads, LoadScaleScope scale) {
  std::vector<BodyForceField> fields;
  for (const ActingLoad& acting : loads.loads) {
    if (acting.elements.empty() || acting.load->type == model::LoadType::temperature) {
      continue;
    }
    BodyForceField field{&acting, {}, {}};
    if (acting.load->elements.valid()) {
      field.shares = fe::find_set_coverage(model, mesh, acting.load->elements);
      field.scale = fe::load_scale(mesh, *acting.load,
                                   scale == LoadScaleScope::whole_set ? field.shares.elements
                                                                      : acting.elements);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

template <int dim>
void visit_body_force_points(const model::Mesh& mesh, const std::vector<BodyForceField>& fields,
                             base::ElementId e, const fe::AnyNodeVectors<dim>& X,
                             const BodyForceVisit<dim>& visit) {
  const fe::AnyElement<dim>& element = shape::reference_element<dim>(mesh.type[e.index()]);
  for (const BodyForceField& field : fields) {
    const ActingLoad& acting = *field.acting;
    if (!std::ranges::binary_search(acting.elements, e)) {
      continue;
    }
    const fe::CutElementShareFunction* share = field.shares.find_cut_share_function(e);
    for (const auto& point :
         fe::body_load_rule<dim>(element, X, *acting.load, field.scale).points) {
      base::Vec3 x = base::Vec3::Zero();
      x.head<dim>() = X * element.N(point.r);
      const double factor = share == nullptr ? acting.factor : acting.factor * (*share)(x);
      visit(point.r, point.weight,
            shape::Point<dim>(factor * fe::load_value(*acting.load, x).template head<dim>()));
    }
  }
}

template void visit_body_force_points<2>(const model::Mesh&, const std::vector<BodyForceField>&,
                                         base::ElementId, const fe::AnyNodeVectors<2>&,
                                         const BodyForceVisit<2>&);
template void visit_body_force_points<3>(const model::Mesh&, const std::vector<BodyForceField>&,
                                         base::ElementId, const fe::AnyNodeVectors<3>&,
                                         const BodyForceVisit<3>&);

} // namespace spricka::crack
