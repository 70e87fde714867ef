// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_heat.hpp"

#include <cmath>

#include <Eigen/QR>

namespace spricka::crack {

std::optional<LinearTemperature>
exact_linear_temperature(const model::Mesh& mesh, const std::vector<base::ElementId>& elements,
                         const base::Vector& temperature) {
  constexpr double round_off = 1e-9; // of the largest temperature
  if (temperature.size() == 0 || elements.empty()) {
    return std::nullopt;
  }
  const base::Vec3 origin = mesh.x[mesh.element_nodes(elements.front()).front().index()];
  const auto for_corners = [&](auto&& visit) {
    for (const base::ElementId e : elements) {
      const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
      for (int c = 0; c < base::element_info(mesh.type[e.index()]).corners; ++c) {
        visit(base::Vec3(mesh.x[nodes[static_cast<std::size_t>(c)].index()] - origin),
              temperature[mesh.first[e.index()] + c]);
      }
    }
  };
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  double largest = 0.0;
  for_corners([&](const base::Vec3& x, double T) {
    const Eigen::Vector4d row(1.0, x.x(), x.y(), x.z());
    normal += row * row.transpose();
    right += T * row;
    largest = std::max(largest, std::abs(T));
  });
  const Eigen::Vector4d fit = normal.completeOrthogonalDecomposition().solve(right);
  double miss = 0.0;
  for_corners([&](const base::Vec3& x, double T) {
    miss = std::max(miss, std::abs(fit[0] + fit.tail<3>().dot(x) - T));
  });
  if (miss > round_off * largest) {
    return std::nullopt;
  }
  const base::Vec3 slope = fit.tail<3>();
  return LinearTemperature{fit[0] - slope.dot(origin), slope};
}

} // namespace spricka::crack
