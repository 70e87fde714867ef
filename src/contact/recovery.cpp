// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/recovery.hpp"

#include "base/by_dimension.hpp"
#include "base/index.hpp"
#include "contact/chain_pressure.hpp"
#include "contact/part_pressure.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace spricka::contact {

using base::index;

namespace {

ContactSideNodalForces side_force(const PairConstraints& pair, const base::Vector& lambda) {
  ContactSideNodalForces force;
  for (const geometry::ElementSide& facet : pair.contact.facets) {
    for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
      force.x[facet.nodes[i]] = facet.X.col(index(i));
    }
  }
  Eigen::Index r = 0;
  for (const std::vector<ConstraintRow>* rows : {&pair.normal, &pair.tangent}) {
    for (const ConstraintRow& row : *rows) {
      for (const RowEntry& entry : row.entries) {
        if (const auto own = force.x.find(entry.node); own != force.x.end()) {
          const base::Vec3 pushed = lambda[r] * entry.weight;
          force.node.try_emplace(entry.node, base::Vec3::Zero()).first->second += pushed;
          force.total += pushed;
          force.moment += own->second.cross(pushed);
        }
      }
      ++r;
    }
  }
  return force;
}

// What the rows say together. The sum of pressure times area.
double add_totals(const PairConstraints& pair, const ContactRowValues& rows, PairPressure& result) {
  double thrust = 0.0;
  for (std::size_t i = 0; i < pair.normal.size(); ++i) {
    const double p = rows.lambda[index(i)];
    const double area = pair.normal[i].area;
    thrust += p * area;
    result.min_pressure = i == 0 ? p : std::min(result.min_pressure, p);
    result.max_pressure = std::max(result.max_pressure, p);
    result.closed += rows.closed[i] ? 1 : 0;
    result.max_penetration = std::max(result.max_penetration, -rows.gap[index(i)] / area);
  }
  return thrust;
}

} // namespace

PairPressure recover_pressure(const PairConstraints& pair, const base::Vector& lambda,
                              const base::Vector& gap, const std::vector<bool>& closed,
                              bool may_pull) {
  const ContactRowValues rows{lambda, gap, closed, may_pull};
  const ContactSideNodalForces force = side_force(pair, lambda);
  PairPressure result;
  const double thrust = add_totals(pair, rows, result);
  const double sign = pair.swapped ? -1.0 : 1.0;
  result.force_on_slave = sign * force.total;
  result.moment_on_slave = sign * force.moment;
  constexpr base::ByDimension recover{recover_chain_pressure, recover_solid_pair_pressure};
  const double area = recover.at(pair.contact.dim)(pair, rows, force, result);
  result.mean_pressure = area > 0.0 ? thrust / area : 0.0;
  return result;
}

} // namespace spricka::contact
