// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_intensity.hpp"

#include "crack/front_opening.hpp"
#include "crack/interaction_terms.hpp"
#include "crack/smooth_front.hpp"
#include "fe/heat.hpp"
#include "model/mesh_side.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::crack {

using base::Vec3;

namespace {

std::array<double, 3> modes_of(const StressIntensity& K) {
  return {K.K1, K.K2, K.K3};
}

// What loads at the front itself add to T: the stress across the faces and the free thermal strain
// (crack_space.12).
struct AtFront {
  std::vector<double> across;  ///< [point] normal stress on the crack's faces
  std::vector<double> thermal; ///< [point] free strain
};

// Where a load at the front is taken: this part of the way to the middle of the side.
constexpr double beside_front = 1e-9;

class FrontStress {
public:
  FrontStress(const FrontContext& set, const mesh::CrackFront& front,
              const FrontIntegralDomains& fields)
      : set_(set), front_(front), fields_(fields) {}

  [[nodiscard]] AtFront of(const FrontLoads& loads) const {
    AtFront at;
    at.across.assign(front_.points.size(), 0.0);
    at.thermal.assign(front_.points.size(), 0.0);
    for (const MovedFreeSide& side : fields_.sides) {
      if (side.on == UpperOrLowerFace::none) {
        continue;
      }
      const geometry::ElementSide own = model::element_side(set_.mesh, side.face);
      for (std::size_t i = 0; i < front_.points.size(); ++i) {
        add_side(side, own, i, loads, at.across[i]);
      }
    }
    add_heat(loads, at.thermal);
    return at;
  }

private:
  // Each side of the crack has one or two faces at a point: their mean, and the mean of both sides.
  void add_side(const MovedFreeSide& side, const geometry::ElementSide& own, std::size_t i,
                const FrontLoads& loads, double& sum) const {
    const base::NodeId point = front_.points[i].node;
    const auto at = std::ranges::find(own.nodes, point);
    if (at == own.nodes.end()) {
      return;
    }
    const shape::Point<2> centre = own.domain_centre();
    const shape::Point<2> r = (1.0 - beside_front) * own.node_local_coordinates(
                                                         static_cast<int>(at - own.nodes.begin())) +
                              beside_front * centre;
    const Vec3 normal = own.area_vector(centre).normalized();
    const double part = 0.5 * set_.halves / static_cast<double>(faces_at(side.on, point));
    for (const ActingLoad& acting : loads.loads) {
      if (std::ranges::find(acting.faces, side.face) != acting.faces.end()) {
        sum += part * normal.dot(load_force_on_face(acting, own.position(r), normal));
      }
    }
  }

  [[nodiscard]] std::ptrdiff_t faces_at(UpperOrLowerFace on, base::NodeId point) const {
    return std::ranges::count_if(fields_.sides, [&](const MovedFreeSide& side) {
      const std::vector<base::NodeId> nodes = model::side_nodes(set_.mesh, side.face);
      return side.on == on && std::ranges::find(nodes, point) != nodes.end();
    });
  }

  // The mean over the elements at the point, of which it is a corner.
  void add_heat(const FrontLoads& loads, std::vector<double>& thermal) const {
    if (loads.temperature.size() == 0) {
      return;
    }
    std::vector<double> sum(set_.mesh.node_count(), 0.0);
    std::vector<double> count(set_.mesh.node_count(), 0.0);
    for (const base::ElementId e : fields_.elements()) {
      const std::span<const base::NodeId> nodes = set_.mesh.element_nodes(e);
      const int corners = base::element_info(set_.mesh.type[e.index()]).corners;
      for (int c = 0; c < corners; ++c) {
        const std::size_t n = nodes[static_cast<std::size_t>(c)].index();
        sum[n] += loads.temperature[set_.mesh.first[e.index()] + c];
        count[n] += 1.0;
      }
    }
    for (std::size_t i = 0; i < thermal.size(); ++i) {
      const std::size_t n = front_.points[i].node.index();
      thermal[i] = set_.material.alpha * sum[n] / std::max(count[n], 1.0);
    }
  }

  const FrontContext& set_;
  const mesh::CrackFront& front_;
  const FrontIntegralDomains& fields_;
};

bool acts_nothing(const FrontLoads& loads) {
  return loads.loads.empty() &&
         std::ranges::all_of(loads.contact, [](const FacePointForces& on_face) {
           return std::ranges::all_of(on_face.points,
                                      [](const auto& point) { return point.force.isZero(0.0); });
         });
}

InteractionConfigurationalForces<3> all_forces(const FrontContext& set,
                                               const FrontIntegralDomains& extensions,
                                               const base::Vector& u, const FrontLoads& loads) {
  InteractionConfigurationalForces<3> forces(set.mesh.node_count());
  if (u.isZero(0.0) && acts_nothing(loads)) {
    return forces; // as at the end of many a load cycle
  }
  const FrontAuxiliaryFields fields(set, extensions);
  add_front_element_terms(fields, loads, u, forces);
  add_face_load_terms(fields, load_forces_on_faces(set.mesh, loads), u, forces);
  add_face_load_terms(fields, loads.contact, u, forces);
  add_auxiliary_tractions(fields, u, forces);
  return forces;
}

FrontStations stations_of(const mesh::CrackFront& front, const FrontIntegralDomains& fields,
                          const std::vector<StressIntensity>& K) {
  FrontStations at;
  at.s = fields.station;
  at.local.assign(K.size(), false);
  at.closed = fields.closed;
  at.length = front.curve->length();
  for (std::size_t i = 0; i < K.size(); ++i) {
    // Values at the surface are no values of the front's.
    const bool counts = !K[i].domains.empty() && !front.points[i].at_surface;
    at.weight.push_back(counts ? front.points[i].weight : 0.0);
  }
  return at;
}

} // namespace

void smooth_intensity_along_front(const mesh::CrackFront& front, const FrontIntegralDomains& fields,
                                  std::vector<StressIntensity>& result) {
  FrontStations at = stations_of(front, fields, result);
  base::Matrix values(static_cast<Eigen::Index>(result.size()), 3);
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    const std::array<double, 3> K = modes_of(result[static_cast<std::size_t>(i)]);
    values.row(i) << K[0], K[1], K[2];
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    const mesh::FrontPoint& point = front.points[i];
    if (!point.at_surface) {
      continue;
    }
    const auto inside = extrapolate_front_value(at, values, {at.s[i], 4.0 * point.radius});
    if (inside) {
      result[i].front->from_inside = std::array{(*inside)[0], (*inside)[1], (*inside)[2]};
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (const auto& inside = result[i].front->from_inside) {
      values.row(static_cast<Eigen::Index>(i)) << (*inside)[0], (*inside)[1], (*inside)[2];
      at.weight[i] = front.points[i].weight;
      at.local[i] = true;
    }
  }
  const base::Matrix fitted = smooth_values_along_front(at, values);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    result[i].front->smooth = {fitted(row, 0), fitted(row, 1), fitted(row, 2)};
  }
}

std::vector<StressIntensity> front_intensity(const model::Model& model,
                                             const mesh::CrackedMesh& cracked,
                                             const mesh::CrackFront& front,
                                             const FrontIntegralDomains& domains,
                                             const FrontIntensityOptions& request,
                                             const base::Vector& u, const FrontLoads& loads) {
  std::vector<StressIntensity> result(front.points.size());
  if (domains.empty()) {
    return result;
  }
  if (front.is_tip()) {
    result.front() =
        tip_intensity(model, cracked, front, domains.points.front(), request, u, loads);
    return result;
  }
  const FrontContext set = make_front_context(model, cracked, front, domains);
  const InteractionConfigurationalForces<3> forces = all_forces(set, domains, u, loads);
  const AtFront at_front = FrontStress(set, front, domains).of(loads);
  const auto strain = strain_along_front_weights(front, cracked.mesh, domains);
  for (std::size_t i = 0; i < result.size(); ++i) {
    StressIntensity& K = result[i];
    K.E_effective = set.E_effective();
    K.front = SmoothedFrontIntensity();
    double e_tt = 0.0;
    for (const NodeWeight& entry : strain[i]) {
      e_tt += entry.weight.dot(u.segment<3>(3 * static_cast<Eigen::Index>(entry.node.index())));
    }
    const double nu = set.body.nu;
    const double sigma = at_front.across[i] + (loads.across.empty() ? 0.0 : loads.across[i]);
    const double free = at_front.thermal[i];
    for (const VirtualExtensionField& field : domains.points[i]) {
      std::array<double, auxiliary_field_count<3>> sum = forces.released_energies(field);
      for (std::size_t k = 0; k < sum.size(); ++k) {
        sum[k] *= set.intensity_conversion_factor(k) / front.points[i].weight;
      }
      const bool half = front.symmetric_half;
      K.domains.push_back(
          {.rings = field.rings,
           .K1 = sum[1],
           .K2 = half ? 0.0 : sum[2],
           .K3 = half ? 0.0 : sum[3],
           .G = sum[0],
           .T = sum[4] + set.E_effective() * (nu * e_tt - (1.0 + nu) * free) + sigma});
    }
    if (K.domains.empty()) {
      continue;
    }
    summarise_domain_intensities(set.body.mu, 3, K); // (crack_space.14)
    if (request.opening) {
      K.opening = front_K_from_face_opening(set, cracked.faces[front.crack.index()],
                                            front.points[i], K.G, u);
    }
  }
  smooth_intensity_along_front(front, domains, result);
  return result;
}

} // namespace spricka::crack
