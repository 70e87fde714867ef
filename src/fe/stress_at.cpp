// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/side_stress.hpp"
#include "fe/stress_kernel.hpp"

#include <algorithm>

namespace spricka::fe {

namespace {

constexpr double place_round_off = 1e-9;

// The mean of the elements there in the material of the nearest.
Stress mean_at(const model::Model& model, const model::Mesh& mesh,
               const DisplacementTemperatureField& field, const std::vector<ElementHit>& hits) {
  const auto nearest = std::ranges::min_element(
      hits, {}, [](const ElementHit& h) { return std::max(h.outside, place_round_off); });
  Stress sum = Stress::Zero();
  int count = 0;
  for (const ElementHit& hit : hits) {
    const bool counts =
        hit.element == nearest->element ||
        (hit.outside <= place_round_off &&
         mesh.property[hit.element.index()] == mesh.property[nearest->element.index()]);
    if (!counts) {
      continue;
    }
    shape::with_element_shape(mesh.type[hit.element.index()], [&]<shape::ElementShape S>(S) {
      sum += ElementStressEvaluator<S>(model, mesh, hit.element, field).at(hit.r.head<S::dim>());
    });
    ++count;
  }
  return Stress(sum / count);
}

} // namespace

std::optional<Stress> stress_at_body_point(const model::Model& model, const model::Mesh& mesh,
                                           const DisplacementTemperatureField& field,
                                           const base::Vec3& point) {
  std::vector<ElementHit> hits = elements_at_point(mesh, point);
  if (hits.empty()) {
    return std::nullopt;
  }
  // never the other body of a contact or the other face of a crack
  const ElementHit nearest = *std::ranges::min_element(
      hits, {}, [](const ElementHit& h) { return std::max(h.outside, place_round_off); });
  std::erase_if(hits, [&](const ElementHit& h) {
    return h.element != nearest.element && !have_common_node(mesh, h.element, nearest.element);
  });
  return mean_at(model, mesh, field, hits);
}

Stress stress_of_element_group(const model::Model& model, const model::Mesh& mesh,
                               const DisplacementTemperatureField& field,
                               const PointElementGroup& side) {
  return mean_at(model, mesh, field, side);
}

} // namespace spricka::fe
