// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/front_functionals.hpp"

#include "analysis/scene/front_surroundings.hpp"
#include "base/parallel.hpp"
#include "contact/space_tractions.hpp"
#include "crack/front_intensity.hpp"
#include "crack/tip_intensity.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace spricka::analysis {

namespace {

/// Forces at points of sides, and how they come from the rows of the table.
struct ForcePlaces {
  std::vector<crack::FacePointForces> faces;
  std::vector<Eigen::Triplet<double>> by_row; ///< [3 * point, row]
};

ForcePlaces force_places(const Discretisation& scene, const crack::FrontIntegralDomains& fields) {
  std::set<model::Face> moved;
  for (const crack::MovedFreeSide& side : fields.sides) {
    moved.insert(side.face);
  }
  ForcePlaces places;
  Eigen::Index at = 0;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    for (const contact::UnitFaceTraction& traction : contact::solid_pair_unit_tractions(
             scene.pairs[c], [&](const model::Face& face) { return moved.contains(face); })) {
      crack::FacePointForces& on_face = places.faces.emplace_back();
      on_face.face = traction.face;
      for (const contact::FacePointRowForces& point : traction.points) {
        on_face.points.push_back({{point.r.x(), point.r.y(), 0.0}, base::Vec3::Zero()});
        for (const contact::FacePointRowForces::RowForce& one : point.rows) {
          for (Eigen::Index k = 0; k < 3; ++k) {
            places.by_row.emplace_back(
                at + k, static_cast<Eigen::Index>(scene.table.first[c] + one.row), one.force[k]);
          }
        }
        at += 3;
      }
    }
  }
  return places;
}

// Adds what rows between the faces of a plane crack do to K of its tip, which are nodal forces
// (crack.33); `point`: of the front in the layout.
void add_K_by_face_forces(const model::Model& model, const Discretisation& scene, std::size_t f,
                          std::size_t point, base::Matrix& of_row) {
  const mesh::CrackFront& front = scene.cracked.fronts[f];
  const std::optional<CrackFacePair>& crack_face = scene.crack_face_pairs[front.crack.index()];
  if (!crack_face) {
    return;
  }
  // K by a nodal force on either face [dim * node, 2]; a unit of a row puts its weights there.
  const base::Matrix weight = crack::face_force_tip_functionals(
      model, scene.cracked, front, scene.domains[f].points.front(),
      model.cracks[front.crack.index()].state, crack_face->sides);
  for (std::size_t r = scene.table.first[crack_face->pair];
       r < scene.table.first[crack_face->pair + 1]; ++r) {
    for (const contact::RowEntry& entry : scene.contact_row(r).entries) {
      const auto at = 2 * static_cast<Eigen::Index>(entry.node.index());
      scene.k_layout().segment_of_point(of_row.col(static_cast<Eigen::Index>(r)), point) +=
          weight.middleRows<2>(at).transpose() * entry.weight.head<2>();
    }
  }
}

// The same of rows that press on the sides that the domains of a front in space move
// (crack_space.9).
void add_K_by_tractions(const model::Model& model, const Discretisation& scene, std::size_t f,
                        std::size_t point, base::Matrix& of_row) {
  const ForcePlaces places = force_places(scene, scene.domains[f]);
  if (places.by_row.empty()) {
    return;
  }
  const crack::SparseLinearFunctionals rows = crack::face_force_front_functionals(
      model, scene.cracked, scene.cracked.fronts[f], scene.domains[f], places.faces);
  crack::SparseLinearFunctionals by_row(rows.rows(), of_row.cols());
  by_row.setFromTriplets(places.by_row.begin(), places.by_row.end());
  const crack::SparseLinearFunctionals product = rows.transpose() * by_row;
  of_row.middleRows(scene.k_layout().first_mode_index(point), product.rows()) += product;
}

// Columns of all fronts [size, K of a front] side by side, as in KLayout.
crack::SparseLinearFunctionals join_fronts(std::vector<crack::SparseLinearFunctionals> of_front,
                                           Eigen::Index size) {
  crack::SparseLinearFunctionals rows;
  if (of_front.size() == 1) {
    rows.swap(of_front.front()); // it has no constructor that moves
    return rows;
  }
  Eigen::Index columns = 0;
  Eigen::Index entries = 0;
  for (const crack::SparseLinearFunctionals& own : of_front) {
    columns += own.cols();
    entries += own.nonZeros();
  }
  rows.resize(size, columns);
  rows.reserve(entries);
  Eigen::Index column = 0;
  for (const crack::SparseLinearFunctionals& own : of_front) {
    for (Eigen::Index c = 0; c < own.cols(); ++c, ++column) {
      rows.startVec(column);
      for (crack::SparseLinearFunctionals::InnerIterator it(own, c); it; ++it) {
        rows.insertBack(it.row(), column) = it.value();
      }
    }
  }
  rows.finalize();
  return rows;
}

} // namespace

crack::SparseLinearFunctionals front_displacement_K_functionals(const model::Model& model,
                                                                const Discretisation& scene,
                                                                std::size_t f) {
  const mesh::CrackFront& front = scene.cracked.fronts[f];
  return crack::front_intensity_functionals(model, scene.cracked, front, scene.domains[f],
                                            model.cracks[front.crack.index()].state);
}

crack::SparseLinearFunctionals displacement_K_functionals(const model::Model& model,
                                                          const Discretisation& scene) {
  std::vector<crack::SparseLinearFunctionals> of_front(scene.cracked.fronts.size());
  base::parallel_for_ranges(of_front.size(), 1, [&](std::size_t f, std::size_t) {
    of_front[f] = front_displacement_K_functionals(model, scene, f);
  });
  return join_fronts(std::move(of_front),
                     static_cast<Eigen::Index>(scene.cracked.mesh.node_count()) *
                         scene.cracked.mesh.dim);
}

crack::IntensityFunctionals
supplemented_K_functionals(const model::Model& model, const Discretisation& scene,
                           const crack::SupplementaryFunctions& others) {
  std::vector<crack::SparseLinearFunctionals> of_nodes(scene.cracked.fronts.size());
  std::vector<crack::SparseLinearFunctionals> of_others(scene.cracked.fronts.size());
  base::parallel_for_ranges(of_nodes.size(), 1, [&](std::size_t f, std::size_t) {
    crack::IntensityFunctionals own = crack::supplemented_intensity_functionals(
        model, scene.cracked, scene.cracked.fronts[f], scene.domains[f], others);
    of_nodes[f].swap(own.of_nodes);
    of_others[f].swap(own.of_others);
  });
  return {join_fronts(std::move(of_nodes),
                      3 * static_cast<Eigen::Index>(scene.cracked.mesh.node_count())),
          join_fronts(std::move(of_others), 3 * others.count)};
}

base::Matrix contact_force_K_functionals(const model::Model& model, const Discretisation& scene) {
  base::Matrix of_row =
      base::Matrix::Zero(scene.k_layout().count(), static_cast<Eigen::Index>(scene.table.size()));
  std::size_t first = 0;
  for (std::size_t f = 0; f < scene.cracked.fronts.size(); ++f) {
    if (scene.cracked.fronts[f].is_tip()) {
      add_K_by_face_forces(model, scene, f, first, of_row);
    } else {
      add_K_by_tractions(model, scene, f, first, of_row);
    }
    first += scene.cracked.fronts[f].points.size();
  }
  return of_row;
}

base::Vector evaluate_K_values(const model::Model& model, const Discretisation& scene,
                               const base::Vector& u, const base::Vector& case_factor) {
  const crack::KLayout layout = scene.k_layout();
  base::Vector values = base::Vector::Zero(layout.count());
  std::size_t first = 0;
  for (std::size_t f = 0; f < scene.cracked.fronts.size(); ++f) {
    const mesh::CrackFront& front = scene.cracked.fronts[f];
    const crack::FrontIntegralDomains& domains = scene.domains[f];
    crack::FrontIntensityOptions request; // without SHIFT: linear in u
    request.state = model.cracks[front.crack.index()].state;
    for (const crack::StressIntensity& K :
         crack::front_intensity(model, scene.cracked, front, domains, request, u,
                                collect_front_loads(model, scene, domains, case_factor))) {
      layout.segment_of_point(values, first++) =
          base::Vec3(K.K1, K.K2, K.K3).head(layout.mode_count());
    }
  }
  return values;
}

base::Vector K_added_by_loads(const model::Model& model, const Discretisation& scene,
                              const base::Vector& case_factor) {
  const auto size =
      static_cast<Eigen::Index>(scene.cracked.mesh.node_count()) * scene.cracked.mesh.dim;
  return loads_act_on_domains(model, scene, case_factor)
             ? evaluate_K_values(model, scene, base::Vector::Zero(size), case_factor)
             : base::Vector::Zero(scene.k_layout().count());
}

base::Matrix K_added_by_load_cases(const model::Model& model, const Discretisation& scene) {
  const auto cases = static_cast<Eigen::Index>(model.cases.size());
  // That of ties, too.
  const Eigen::Index columns =
      std::max({cases, scene.case_load.cols(), scene.case_temperature.cols()});
  base::Matrix K(scene.k_layout().count(), cases);
  for (Eigen::Index c = 0; c < cases; ++c) {
    K.col(c) = K_added_by_loads(model, scene, base::Vector::Unit(columns, c));
  }
  return K;
}

bool loads_act_on_domains(const model::Model& model, const Discretisation& scene,
                          const base::Vector& case_factor) {
  const auto acts = [](const crack::FrontLoads& loads) {
    return loads.temperature.size() > 0 ||
           std::ranges::any_of(loads.loads, [](const crack::ActingLoad& acting) {
             return !acting.elements.empty() || !acting.faces.empty();
           });
  };
  return std::ranges::any_of(scene.domains, [&](const crack::FrontIntegralDomains& domains) {
    return acts(collect_front_loads(model, scene, domains, case_factor));
  });
}

std::vector<std::array<double, 3>> smooth_K_along_front(const mesh::CrackFront& front,
                                                        const crack::FrontIntegralDomains& domains,
                                                        const base::Vector& K, Eigen::Index first) {
  std::vector<crack::StressIntensity> points(front.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Index k = first + 3 * static_cast<Eigen::Index>(i);
    points[i].K1 = K[k];
    points[i].K2 = K[k + 1];
    points[i].K3 = K[k + 2];
    points[i].front = crack::SmoothedFrontIntensity();
    points[i].domains.resize(domains.points[i].size());
  }
  crack::smooth_intensity_along_front(front, domains, points);
  std::vector<std::array<double, 3>> smooth;
  smooth.reserve(points.size());
  for (const crack::StressIntensity& point : points) {
    smooth.push_back(point.front->from_inside.value_or(point.front->smooth));
  }
  return smooth;
}

} // namespace spricka::analysis
