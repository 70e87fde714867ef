// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/side_stress.hpp"
#include "fe/stress_kernel.hpp"

#include <algorithm>

namespace spricka::fe {

namespace {

constexpr double place_round_off = 1e-9;

// The mean of the elements there in the material of the nearest.
Stress mean_at(const model::Model& model, const model::Mesh& mesh, const StateField& field,
               const std::vector<PointHit>& hits) {
  const auto nearest = std::ranges::min_element(
      hits, {}, [](const PointHit& h) { return std::max(h.outside, place_round_off); });
  Stress sum = Stress::Zero();
  int count = 0;
  for (const PointHit& hit : hits) {
    const bool counts =
        hit.element == nearest->element ||
        (hit.outside <= place_round_off &&
         mesh.property[hit.element.index()] == mesh.property[nearest->element.index()]);
    if (!counts) {
      continue;
    }
    shape::with_element_shape(mesh.type[hit.element.index()], [&]<shape::ElementShape S>(S) {
      sum += StressElement<S>(model, mesh, hit.element, field).at(hit.r.head<S::dim>());
    });
    ++count;
  }
  return Stress(sum / count);
}

} // namespace

std::optional<Stress> stress_at(const model::Model& model, const model::Mesh& mesh,
                                const StateField& field, const base::Vec3& point) {
  std::vector<PointHit> hits = elements_at(mesh, point);
  if (hits.empty()) {
    return std::nullopt;
  }
  // never the other body of a contact or the other face of a crack
  const PointHit nearest = *std::ranges::min_element(
      hits, {}, [](const PointHit& h) { return std::max(h.outside, place_round_off); });
  std::erase_if(hits, [&](const PointHit& h) {
    return h.element != nearest.element && !share_node(mesh, h.element, nearest.element);
  });
  return mean_at(model, mesh, field, hits);
}

Stress side_stress(const model::Model& model, const model::Mesh& mesh, const StateField& field,
                   const PointSide& side) {
  return mean_at(model, mesh, field, side);
}

} // namespace spricka::fe
