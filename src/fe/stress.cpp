// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/stress.hpp"

#include "fe/stress_kernel.hpp"

#include <cmath>
#include <numeric>

namespace spricka::fe {

std::vector<Stress> element_node_stress(const model::Model& model, const model::Mesh& mesh,
                                        const StateField& field) {
  std::vector<Stress> stress(mesh.nodes.size(), Stress::Zero());
  std::vector<base::ElementId> elements;
  elements.reserve(mesh.element_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    elements.emplace_back(e);
  }
  for_blocks(mesh, elements, [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
    for (const base::ElementId e : block) {
      const StressElement<S> element(model, mesh, e, field);
      const auto first = static_cast<std::size_t>(mesh.first[e.index()]);
      for (int i = 0; i < S::nodes; ++i) {
        stress[first + static_cast<std::size_t>(i)] = element.at(shape::node<S>(i));
      }
    }
  });
  return stress;
}

std::vector<Stress> nodal_stress(const model::Model& /*model*/, const model::Mesh& mesh,
                                 const std::vector<Stress>& element_stress) {
  std::vector<Stress> mean(mesh.node_count(), Stress::Zero());
  std::vector<int> count(mesh.node_count(), 0);
  std::vector<base::PropertyId> property(mesh.node_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    auto k = static_cast<std::size_t>(mesh.first[e]);
    for (const base::NodeId id : mesh.nodes_of(base::ElementId(e))) {
      const std::size_t n = id.index();
      if (count[n] == 0) {
        property[n] = mesh.property[e];
      }
      if (property[n] == mesh.property[e]) {
        mean[n] += element_stress[k];
        ++count[n];
      }
      ++k;
    }
  }
  for (std::size_t n = 0; n < mean.size(); ++n) {
    mean[n] /= std::max(count[n], 1);
  }
  return mean;
}

double von_mises(const Stress& s) {
  const double a = s[0] - s[1];
  const double b = s[1] - s[2];
  const double c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * s.tail<3>().squaredNorm());
}

} // namespace spricka::fe
