// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/rigid_motion.hpp"

#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// "(0.600, 0.800)", as many components as the mesh has directions.
std::string components(const base::Vec3& v, int dim, int digits) {
  const double unit = std::pow(10.0, -digits);
  std::string text;
  for (int c = 0; c < dim; ++c) {
    const double rounded = std::round(v[c] / unit) * unit + 0.0; // no minus before a zero
    text += fmt::format("{}{:.{}f}", c > 0 ? ", " : "", rounded, digits);
  }
  return "(" + text + ")";
}

} // namespace

std::string describe_rigid_motion(const model::Mesh& mesh, const fe::Body& body,
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
  // About the middle of the nodes: a rotation leaves no mean there, a translation nothing but that.
  if (mean.norm() < 0.1 * rms) {
    return "rotation";
  }
  if (mean.norm() < 0.9 * rms) {
    return fmt::format("translation {} with rotation", components(mean / rms, mesh.dim, 2));
  }
  const base::Vec3 d = mean.normalized();
  for (int c = 0; c < mesh.dim; ++c) {
    if (std::abs(d[c]) > 0.999) {
      return fmt::format("direction {}", "XYZ"[c]);
    }
  }
  return "direction " + components(d, mesh.dim, 3);
}

} // namespace spricka::analysis
