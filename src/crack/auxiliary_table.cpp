// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/auxiliary_table.hpp"

#include <algorithm>
#include <numbers>

namespace spricka::crack {

namespace {

// Where all nodes of an element are, as a sum in which no two of them count alike: a node that
// moves changes it.
base::Vec3 places_of(const model::Mesh& mesh, base::ElementId e) {
  base::Vec3 sum = base::Vec3::Zero();
  double weight = 1.0;
  for (const base::NodeId n : mesh.element_nodes(e)) {
    sum += weight * mesh.x[n.index()];
    weight += std::numbers::phi;
  }
  return sum;
}

} // namespace

AuxiliaryFieldTable::AuxiliaryFieldTable(const FrontContext& set,
                                         const FrontIntegralDomains& fields,
                                         AuxiliaryFieldReading reading)
    : body_(set.body), elements_(fields.elements()) {
  if (elements_.empty()) {
    return;
  }
  first_ = elements_.front().index();
  slot_.assign(elements_.back().index() - first_ + 1, 0);
  std::size_t points = 0;
  for (const base::ElementId e : elements_) {
    slot_[e.index() - first_] = start_.size();
    start_.push_back(points);
    degree_.push_back(fields.degree.at(e));
    places_.push_back(places_of(set.mesh, e));
    const fe::AnyElement<3>& element = shape::reference_element<3>(set.mesh.type[e.index()]);
    functions_.push_back(shape::shape_functions_at_quadrature_points<3>(element, degree_.back()));
    points += functions_.back().size();
  }
  if (reading == AuxiliaryFieldReading::once) {
    return;
  }
  fields_.reserve(points);
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const base::ElementId e = elements_[i];
    const fe::AnyElement<3>& element = shape::reference_element<3>(set.mesh.type[e.index()]);
    const fe::AnyNodeVectors<3> X = fe::element_coordinates(element, set.mesh, e);
    for (const shape::ShapeFunctionValues<3>& functions : functions_[i]) {
      fields_.push_back(auxiliary_values_at(set, X * functions.N));
    }
  }
}

bool AuxiliaryFieldTable::is_valid_for(const FrontContext& set) const {
  const bool same_body = body_.lambda == set.body.lambda && body_.mu == set.body.mu &&
                         body_.nu == set.body.nu && body_.unit == set.body.unit;
  return same_body && elements_.back().index() < set.mesh.element_count() &&
         std::ranges::all_of(elements_, [&](base::ElementId e) {
           return places_[slot_[e.index() - first_]] == places_of(set.mesh, e);
         });
}

std::shared_ptr<const AuxiliaryFieldTable>
cached_auxiliary_table(const FrontContext& set, const FrontIntegralDomains& fields) {
  if (!fields.auxiliary_cache) {
    return std::make_shared<const AuxiliaryFieldTable>(set, fields, AuxiliaryFieldReading::once);
  }
  const std::lock_guard<std::mutex> guard(fields.auxiliary_cache->mutex);
  std::shared_ptr<const AuxiliaryFieldTable>& table = fields.auxiliary_cache->table;
  if (!table || !table->is_valid_for(set)) {
    table =
        std::make_shared<const AuxiliaryFieldTable>(set, fields, AuxiliaryFieldReading::repeatedly);
  }
  return table;
}

} // namespace spricka::crack
