// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/closing_motion.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Eigenvalues>

namespace spricka::analysis {

namespace {

// Of contacts that bond or friction holds.
std::set<base::NodeId> nodes_that_resist_sliding(const Discretisation& scene) {
  std::set<base::NodeId> nodes;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const model::Contact& contact = scene.contacts[c];
    if (contact.type != model::ContactType::bonded && !(contact.mu > 0.0)) {
      continue;
    }
    for (const contact::ContactSurface* side : {&scene.pairs[c].contact, &scene.pairs[c].target}) {
      for (const geometry::ElementSide& facet : side->facets) {
        nodes.insert(facet.nodes.begin(), facet.nodes.end());
      }
    }
  }
  return nodes;
}

// Columns that mix the motions so that each moves the surfaces past each other by a mean square of
// one and independently of the others, by thrust; motions of bodies together are none of them.
base::Matrix independent_motions(std::span<const contact::DisplacedContactPoint> points) {
  constexpr double round_off = 1e-12; // of the largest mean square
  const Eigen::Index count = points.front().relative_motions.cols();
  base::Matrix mean_square = base::Matrix::Zero(count, count);
  double thrust = 0.0;
  for (const contact::DisplacedContactPoint& point : points) {
    mean_square += point.thrust * point.relative_motions.transpose() * point.relative_motions;
    thrust += point.thrust;
  }
  const Eigen::SelfAdjointEigenSolver<base::Matrix> eigen(mean_square / thrust);
  const base::Vector& squares = eigen.eigenvalues(); // ascending
  const Eigen::Index kept = (squares.array() > round_off * squares[count - 1]).count();
  return eigen.eigenvectors().rightCols(kept) *
         squares.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

} // namespace

std::vector<const base::Matrix*>
unresisted_rigid_motions(const Discretisation& scene,
                         const std::vector<SubstructuredBody>& bodies) {
  const std::set<base::NodeId> held = nodes_that_resist_sliding(scene);
  std::vector<const base::Matrix*> motions;
  for (const SubstructuredBody& body : bodies) {
    if (std::ranges::none_of(body.body.nodes,
                             [&](base::NodeId node) { return held.contains(node); })) {
      motions.push_back(&body.free_rigid_modes);
    }
  }
  return motions;
}

base::Vector fit_gap_closing_motion(std::span<const contact::DisplacedContactPoint> points,
                                    double largest_slide) {
  const Eigen::Index count = points.empty() ? 0 : points.front().relative_motions.cols();
  base::Vector closing = base::Vector::Zero(count);
  if (count == 0) {
    return closing;
  }
  const base::Matrix motions = independent_motions(points);
  base::Matrix opening = base::Matrix::Zero(motions.cols(), motions.cols());
  base::Vector gap = base::Vector::Zero(motions.cols());
  double thrust = 0.0;
  for (const contact::DisplacedContactPoint& point : points) {
    thrust += point.thrust;
    if (point.unseen) {
      const base::Vector one =
          motions.transpose() * point.relative_motions.transpose() * point.normal;
      opening += point.thrust * one * one.transpose();
      gap += point.thrust * *point.unseen * one;
    }
  }
  const Eigen::SelfAdjointEigenSolver<base::Matrix> eigen(opening / thrust);
  for (Eigen::Index i = 0; i < motions.cols(); ++i) {
    const auto direction = eigen.eigenvectors().col(i);
    const double size = -direction.dot(gap) / thrust / eigen.eigenvalues()[i];
    if (std::abs(size) <= largest_slide) { // not infinite, nor a quotient of zeros
      closing += size * (motions * direction);
    }
  }
  return closing;
}

} // namespace spricka::analysis
