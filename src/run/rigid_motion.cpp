// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/rigid_motion.hpp"

#include <cmath>

#include <fmt/format.h>

namespace spricka::run {

std::string describe_motion(const model::Mesh& mesh, const fe::Body& body,
                            const base::Vector& motion) {
  base::Vec3 mean = base::Vec3::Zero();
  double square = 0.0;
  for (const base::NodeId n : body.nodes) {
    for (int c = 0; c < mesh.dim; ++c) {
      const double v = motion[static_cast<Eigen::Index>(n.index()) * mesh.dim + c];
      mean[c] += v;
      square += v * v;
    }
  }
  const auto count = static_cast<double>(body.nodes.size());
  mean /= count;
  const double rms = std::sqrt(square / count);
  if (mean.norm() < 0.1 * rms) {
    return "rotation";
  }
  if (mean.norm() < 0.9 * rms) {
    return fmt::format("translation ({:.2f}, {:.2f}) with rotation", mean.x() / rms,
                       mean.y() / rms);
  }
  const base::Vec3 d = mean.normalized();
  for (int c = 0; c < mesh.dim; ++c) {
    if (std::abs(d[c]) > 0.999) {
      return fmt::format("direction {}", "XYZ"[c]);
    }
  }
  return fmt::format("direction ({:.3f}, {:.3f})", d.x(), d.y());
}

} // namespace spricka::run
