// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/stress.hpp"

#include "base/parallel.hpp"
#include "fe/stress_kernel.hpp"
#include "model/property_points.hpp"

#include <algorithm>

namespace spricka::fe {

std::vector<Stress> element_node_stress(const model::Model& model, const model::Mesh& mesh,
                                        const DisplacementTemperatureField& field) {
  std::vector<Stress> stress(mesh.nodes.size(), Stress::Zero());
  for_shape_blocks(mesh, model::all_elements(mesh),
                   [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                     base::for_each_element(block.size(), [&](std::size_t k) {
                       const base::ElementId e = block[k];
                       const ElementStressEvaluator<S> element(model, mesh, e, field);
                       const auto first = static_cast<std::size_t>(mesh.first[e.index()]);
                       for (int i = 0; i < S::nodes; ++i) {
                         stress[first + static_cast<std::size_t>(i)] =
                             element.at(shape::node_local_coordinates<S>(i));
                       }
                     });
                   });
  return stress;
}

std::vector<Stress> nodal_stress(const model::Model& /*model*/, const model::Mesh& mesh,
                                 const std::vector<Stress>& element_stress) {
  // A point for each property at a node: stresses jump between materials, their mean is none.
  const model::FieldPointsByProperty points = model::property_points(mesh);
  std::vector<Stress> mean(points.node.size(), Stress::Zero());
  std::vector<int> count(points.node.size(), 0);
  for (std::size_t k = 0; k < points.of.size(); ++k) {
    const auto point = static_cast<std::size_t>(points.of[k]);
    mean[point] += element_stress[k];
    ++count[point];
  }
  for (std::size_t n = 0; n < mean.size(); ++n) {
    mean[n] /= std::max(count[n], 1);
  }
  return mean;
}

std::vector<Stress> element_mean_stress(const model::Model& model, const model::Mesh& mesh,
                                        const DisplacementTemperatureField& field) {
  std::vector<Stress> mean(mesh.element_count(), Stress::Zero());
  for_shape_blocks(mesh, model::all_elements(mesh),
                   [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                     base::for_each_element(block.size(), [&](std::size_t k) {
                       const base::ElementId e = block[k];
                       const ElementStressEvaluator<S> element(model, mesh, e, field);
                       double volume = 0.0;
                       for (const auto& point : stiffness_rule<S>(element.law)) {
                         const Jacobian<S> at = jacobian<S>(element.X, point.r);
                         const double x = element.X.row(0) * S::N(point.r);
                         const double w = point.weight * at.det * element.law.depth(x);
                         mean[e.index()] += w * element.stress_from_map(at, point.r);
                         volume += w;
                       }
                       mean[e.index()] /= volume;
                     });
                   });
  return mean;
}

} // namespace spricka::fe
