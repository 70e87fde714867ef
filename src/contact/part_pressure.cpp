// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/part_pressure.hpp"

#include "contact/make_rows.hpp"
#include "contact/space_averages.hpp"
#include "contact/space_spot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace spricka::contact {

using base::index;

namespace {

// Shear along x, y and z [function], each averaged as the pressure is.
std::array<base::Vector, 3> averaged_shear(const PairConstraints& pair,
                                           const std::vector<base::Vec3>& shear,
                                           const std::vector<bool>& touches) {
  std::array<base::Vector, 3> all;
  for (std::size_t c = 0; c < all.size() && !pair.tangent.empty(); ++c) {
    base::Vector component = base::Vector::Zero(index(pair.functions.size()));
    for (std::size_t i = 0; i < pair.functions.size(); ++i) {
      if (const int row = pair.functions[i].row; row >= 0) {
        component[index(i)] = shear[static_cast<std::size_t>(row)][index(c)];
      }
    }
    all[c] = average_multipliers_to_corners(pair, component, touches);
  }
  return all;
}

// By how much averages change across the faces round each function.
base::Vector changes_of(const PairConstraints& pair, const base::Vector& smooth) {
  base::Vector most = base::Vector::Zero(smooth.size());
  for (const std::vector<std::size_t>& face : functions_by_facet(pair)) {
    const auto [low, high] =
        std::ranges::minmax(face, {}, [&](std::size_t i) { return smooth[index(i)]; });
    const double change = smooth[index(high)] - smooth[index(low)];
    for (const std::size_t i : face) {
      most[index(i)] = std::max(most[index(i)], change);
    }
  }
  return most;
}

// How much multipliers go up and down about their averages. Averages are linear between corners:
// where they change, toward the edge of a surface, a pressure that is curved leaves them by up to
// half the change without going up and down.
double unrest_of(const PairConstraints& pair, const base::Vector& p, const base::Vector& smooth) {
  constexpr double no_strain = 1e-9; // pressure over modulus: round-off of larger ones
  if (!pair.segments || p.size() == 0 ||
      p.cwiseAbs().maxCoeff() < no_strain * pair.contact.stiffness) {
    return 0.0;
  }
  const base::Vector change = changes_of(pair, smooth);
  double off = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < pair.functions.size(); ++i) {
    if (smooth[index(i)] != p[index(i)]) {
      const double beyond = std::abs(smooth[index(i)] - p[index(i)]) - 0.5 * change[index(i)];
      off += pair.functions[i].area * std::pow(std::max(0.0, beyond), 2);
      all += pair.functions[i].area * std::pow(p[index(i)], 2);
    }
  }
  return all > 0.0 ? std::sqrt(off / all) : 0.0;
}

// Node by node: the function's part of the surface says where it stands about an axis.
NodePressure place_of(const PairConstraints& pair, const MultiplierFunction& function,
                      const base::Vec3& x) {
  NodePressure at;
  at.node = function.node;
  at.x = x;
  if (const std::optional<AnalyticShape>& round = pair.contact.rounds[function.part]) {
    const CylindricalCoordinates place = cylindrical_coordinates(*round, x);
    at.theta = place.angle;
    at.arc = place.along;
  }
  return at;
}

// Shear tractions on the deck's slave [normal row]: of a row's functions, along their mean tangent.
std::vector<base::Vec3> shear_on_slave(const PairConstraints& pair, const base::Vector& lambda,
                                       const ContactSideNodalForces& side) {
  std::vector<base::Vec3> shear(pair.normal.size(), base::Vec3::Zero());
  for (std::size_t i = 0; i < pair.tangent.size(); ++i) {
    const ConstraintRow& row = pair.tangent[i];
    base::Vec3 force = base::Vec3::Zero();
    for (const RowEntry& entry : row.entries) {
      force += side.x.contains(entry.node) ? entry.weight : base::Vec3(base::Vec3::Zero());
    }
    shear[static_cast<std::size_t>(row.normal)] +=
        (pair.swapped ? -1.0 : 1.0) / row.area * lambda[index(pair.normal.size() + i)] * force;
  }
  return shear;
}

// Triangles on which pressures are linear, by place among the nodes, and the mean radius of a
// surface about one axis.
void add_surface(const PairConstraints& pair, PairPressure& result) {
  const FacetSurface& surface = pair.contact;
  const std::vector<std::vector<std::size_t>> faces = functions_by_facet(pair);
  for (const HatElement& t : surface.elements) {
    const std::vector<std::size_t>& at = faces[t.facet];
    const auto place = [&](int i) { return at[static_cast<std::size_t>(i)]; };
    result.triangles.push_back({place(t.node[0]), place(t.node[1]), place(t.node[2])});
  }
  if (surface.rounds.size() == 1 && surface.rounds[0] && is_cylinder_or_cone(*surface.rounds[0])) {
    for (const NodePressure& at : result.nodes) {
      const double here = surface.rounds[0]->radius + surface.rounds[0]->slope * at.arc;
      result.radius += here / static_cast<double>(result.nodes.size());
    }
  }
}

} // namespace

double recover_solid_pair_pressure(const PairConstraints& pair, const ContactRowValues& rows,
                                   const ContactSideNodalForces& force, PairPressure& result) {
  if (pair.functions.empty()) { // a pair in trouble
    return 0.0;
  }
  const auto n = index(pair.functions.size());
  base::Vector p = base::Vector::Zero(n);
  std::vector<bool> touches(pair.functions.size(), false);
  for (std::size_t i = 0; i < pair.functions.size(); ++i) {
    if (const int row = pair.functions[i].row; row >= 0) {
      p[index(i)] = rows.lambda[row];
      touches[i] = rows.closed[static_cast<std::size_t>(row)];
    }
  }
  const base::Vector smooth = average_multipliers_to_corners(pair, p, touches);
  const std::vector<base::Vec3> shear = shear_on_slave(pair, rows.lambda, force);
  const std::array<base::Vector, 3> smooth_shear = averaged_shear(pair, shear, touches);
  if (!pair.segments && n > 0) { // multipliers at nodes where no pressure acts say nothing
    result.min_pressure = smooth.minCoeff();
    result.max_pressure = smooth.maxCoeff();
  }
  for (std::size_t i = 0; i < pair.functions.size(); ++i) {
    const MultiplierFunction& function = pair.functions[i];
    NodePressure at = place_of(pair, function, force.x.at(function.node));
    at.p_consistent = p[index(i)];
    at.p_lumped = smooth[index(i)];
    if (function.row >= 0) {
      const auto row = static_cast<std::size_t>(function.row);
      rows.assign_row_to_node(pair, row, at);
      at.q_consistent = shear[row].norm();
      if (!pair.tangent.empty()) {
        at.shear = {smooth_shear[0][index(i)], smooth_shear[1][index(i)],
                    smooth_shear[2][index(i)]};
        at.q_lumped = at.shear.norm();
      }
    }
    result.nodes.push_back(at);
  }
  result.unrest = unrest_of(pair, p, smooth);
  result.across_peak = count_elements_across_peak(pair, rows.lambda, rows.closed);
  add_surface(pair, result);
  for (std::size_t r = 0; r < pair.normal.size(); ++r) {
    result.area += rows.closed[r] ? pair.normal[r].area : 0.0;
  }
  return result.area;
}

} // namespace spricka::contact
