// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/judge_size.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::run {

namespace {

/// How far a body reaches from its middle, and its displacements from their mean.
struct Reach {
  double size = 0.0;
  double motion = 0.0;
  double largest = 0.0; ///< displacement itself
};

Reach reach_of(const model::Mesh& mesh, const BodyNet& body, const base::Vector& u) {
  const int dim = mesh.dim;
  base::Vec3 middle = base::Vec3::Zero();
  base::Vec3 mean = base::Vec3::Zero();
  const auto motion = [&](base::NodeId n) {
    base::Vec3 v = base::Vec3::Zero();
    v.head(dim) = u.segment(static_cast<Eigen::Index>(n.index()) * dim, dim);
    return v;
  };
  const double part = 1.0 / static_cast<double>(std::max<std::size_t>(body.body.nodes.size(), 1));
  for (const base::NodeId n : body.body.nodes) {
    middle += part * mesh.x[n.index()];
    mean += part * motion(n);
  }
  Reach reach;
  for (const base::NodeId n : body.body.nodes) {
    reach.size = std::max(reach.size, (mesh.x[n.index()] - middle).norm());
    reach.motion = std::max(reach.motion, (motion(n) - mean).norm());
    reach.largest = std::max(reach.largest, motion(n).norm());
  }
  return reach;
}

} // namespace

void judge_size(const Scene& scene, const std::vector<BodyNet>& bodies, results::StepResult& out) {
  constexpr double small = 0.01;
  for (const BodyNet& body : bodies) {
    const Reach reach = reach_of(scene.cracked.mesh, body, out.u);
    if (reach.motion > small * reach.size) {
      out.notes.push_back(fmt::format(
          "warning: {} is strained or turned by {:.3g} % (largest displacement {:.3g}): linear "
          "theory holds for less than about 1 %; are moduli, loads and fits in the units meant?",
          body.name, 100.0 * reach.motion / reach.size, reach.largest));
    }
  }
}

} // namespace spricka::run
