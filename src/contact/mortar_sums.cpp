// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar_sums.hpp"

#include "base/index.hpp"
#include "contact/space_dual.hpp"

namespace spricka::contact {

using base::index;

namespace {

void set_zero(HatMotionIntegrals::OfHats& of_hats, std::size_t nodes) {
  for (geometry::SidePositions& of_hat : of_hats) {
    of_hat.setZero(3, index(nodes));
  }
}

} // namespace

MortarSums::MortarSums(const PairConstraints& pair, const MortarRowOptions& options)
    : own_(pair.contact), other_(pair.target), options_(options), frames_(own_),
      directions_(options.tangents ? frames_.count() : 1) {
  for (const SmoothPartNode& key : smooth_part_nodes(own_)) {
    place_.emplace(key, place_.size());
  }
  functions_.resize(place_.size());
}

std::vector<std::size_t> MortarSums::functions_of(const HatElement& element) const {
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < element.node_count(); ++i) {
    at.push_back(place_.at(own_.part_node(element, i)));
  }
  return at;
}

HatIntegrals MortarSums::integrate(const HatElement& element,
                                   const OppositePointsOfElement& projection) const {
  HatIntegrals sum;
  const geometry::ElementSide& facet = own_.facets[element.facet];
  for (std::size_t k = 0; k < directions_; ++k) {
    set_zero(sum.motion[k].own, facet.nodes.size());
  }
  const bool rigid = other_.facets.empty();
  for (const PairPoint& p : projection.points) {
    if (!rigid && (sum.targets.empty() || sum.targets.back() != p.target)) {
      sum.targets.push_back(p.target);
      for (std::size_t k = 0; k < directions_; ++k) {
        set_zero(sum.motion[k].target.emplace_back(), other_.facets[p.target].nodes.size());
      }
    }
    const geometry::SideValues N = facet.N(p.r);
    const geometry::SideValues M = rigid ? geometry::SideValues() : other_.facets[p.target].N(p.s);
    const std::array<Vec3, 3> along = frames_.at(own_.part[element.facet], p.normal);
    const Eigen::Vector3d w = p.weight * p.hat;
    sum.moment += w * p.hat.transpose();
    sum.gap += options_.declared_gap.value_or(p.gap) * w;
    sum.round_gap += options_.declared_gap.value_or(p.round_gap) * w;
    for (std::size_t k = 0; k < directions_; ++k) {
      HatMotionIntegrals& motion = sum.motion[k];
      for (std::size_t h = 0; h < element.node_count(); ++h) {
        const Vec3 push = w[index(h)] * along[k];
        motion.own[h] -= push * N.transpose();
        if (!rigid) {
          motion.target.back()[h] += push * M.transpose();
        }
      }
    }
  }
  return sum;
}

ElementContribution MortarSums::contribution(const HatElement& element,
                                             const ElementProjector& project) const {
  ElementContribution own;
  own.projection = project(element);
  if (own.projection.trouble.empty() && !own.projection.points.empty()) {
    own.sum = integrate(element, own.projection);
    own.weights = element.node_count() == 3 ? dual_hat_weights(own.sum.moment)
                                            : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  }
  return own;
}

void MortarSums::add(const HatElement& element, const ElementContribution& own) {
  const OppositePointsOfElement& projection = own.projection;
  const std::vector<std::size_t> at = functions_of(element);
  for (std::size_t a = 0; a < at.size(); ++a) {
    functions_[at[a]].whole += projection.whole[index(a)];
  }
  if (projection.points.empty()) {
    return;
  }
  const HatIntegrals& sum = own.sum;
  for (std::size_t a = 0; a < at.size(); ++a) {
    const Eigen::RowVector3d weight = own.weights.row(index(a));
    FunctionSums& function = functions_[at[a]];
    // (contact.2), and along the tangents (contact.21).
    function.row[0].gap += weight * sum.gap;
    function.row[0].round_gap += weight * sum.round_gap;
    const double area = weight * sum.moment.rowwise().sum();
    for (std::size_t k = 0; k < directions_; ++k) {
      function.row[k].area += area;
      add_motion(element, sum, k, weight, function.row[k]);
    }
    for (const std::size_t b : at) {
      if (b != at[a]) {
        function.beside.push_back(b);
      }
    }
  }
}

void MortarSums::add_motion(const HatElement& element, const HatIntegrals& sum, std::size_t k,
                            const Eigen::RowVector3d& weight, ConstraintRowBuilder& row) const {
  const auto add_nodes = [&](const std::vector<base::NodeId>& nodes, const auto& of_hat) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Vec3 motion = weight[0] * of_hat[0].col(index(i)) + weight[1] * of_hat[1].col(index(i));
      if (element.node_count() == 3) {
        motion += weight[2] * of_hat[2].col(index(i));
      }
      row.add_contribution(nodes[i], motion);
    }
  };
  add_nodes(own_.facets[element.facet].nodes, sum.motion[k].own);
  for (std::size_t t = 0; t < sum.targets.size(); ++t) {
    add_nodes(other_.facets[sum.targets[t]].nodes, sum.motion[k].target[t]);
  }
}

} // namespace spricka::contact
