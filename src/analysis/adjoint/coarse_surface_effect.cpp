// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/coarse_surface_effect.hpp"

#include "contact/surface.hpp"
#include "geometry/polyline.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Edges over their distance from the tip: as inside one net (mesh/cut/cavity_check.cpp).
constexpr double longest = 2.0;
// Of hypot(K1, K2) at edges as long as their distance, and from which length on: it grows with the
// third power. Read off blocks bonded, tied or pressed to much finer ones, cracks of random length
// and distance in one of them: 0.06 % at 0.83, 0.5 % at 1.6, 4.5 % at 4.2 times the distance.
constexpr double part_of_K = 1.5e-3;
constexpr double share_that_counts = 0.5;
// The same where a front in space ends on the surface, by its depth there. Read off lugs with a
// corner crack at a pressed bush of steel: 0.2 % of K at 1.3, 2 to 8 % at 1.9, 3 to 6 % at 2.7.
constexpr double part_at_mouth = 5e-3;
// What lies further off than this many distances between tip and surface share_that_counts little.
constexpr double near = 3.0;

using base::Vec2;
using base::Vec3;

/// A piece of a surface: in the plane an edge, in space a triangle between nodes of a face.
struct AdjacentSurfacePiece {
  std::array<Vec3, 3> x; ///< end, middle, end of an edge, the middle or the mean of the ends
  double length = 0.0;   ///< in space the size of the face
  std::array<base::NodeId, 2> ends{};
};

/// Both sides of a contact or tie.
struct JoinedSurfaces {
  std::string name;
  std::vector<AdjacentSurfacePiece> sides;
  std::vector<Vec3> touching; ///< where it is closed; empty with `everywhere`: all along
  bool everywhere = true;
};

// Distance of x from the two chords of a side.
double distance_to(const AdjacentSurfacePiece& side, const Vec3& x) {
  return std::min(geometry::distance_to_segment(x, side.x[0], side.x[1]),
                  geometry::distance_to_segment(x, side.x[1], side.x[2]));
}

// Edge of the square, or of half of a square, of the same area.
double size_of(const geometry::ElementSide& face) {
  const std::size_t corners = contact::corner_hat_elements(face).size() + 2;
  return std::sqrt(face.area() * (corners == 3 ? 2.0 : 1.0));
}

void add_sides(const contact::ContactSurface& surface, std::vector<AdjacentSurfacePiece>& sides) {
  for (const contact::Edge& edge : surface.plane.edges) {
    sides.push_back(
        {{base::embed_in_space(edge.x[0]), base::embed_in_space(contact::point_on_edge(edge, 0.0)),
          base::embed_in_space(edge.x[1])},
         edge.length,
         {edge.nodes[0], edge.nodes[1]}});
  }
  for (const contact::HatElement& t : surface.elements) {
    const geometry::ElementSide& face = surface.facets[t.facet];
    if (face.is_edge()) {
      continue;
    }
    sides.push_back(
        {{face.X.col(t.node[0]), face.X.col(t.node[1]), face.X.col(t.node[2])}, size_of(face)});
  }
}

JoinedSurfaces joined_surfaces(const Discretisation& scene, const StepState& state, std::size_t c) {
  const contact::PairConstraints& pair = scene.pairs[c];
  const model::Contact& contact = scene.contacts[c];
  JoinedSurfaces found{
      "contact " + contact.name, {}, {}, contact.type == model::ContactType::bonded};
  add_sides(pair.contact, found.sides);
  add_sides(pair.target, found.sides);
  for (std::size_t r = 0; r < pair.normal.size() && !found.everywhere; ++r) {
    if (state.pair_closed[c][r]) {
      found.touching.emplace_back(scene.cracked.mesh.x[pair.normal[r].node.index()]);
    }
  }
  return found;
}

JoinedSurfaces joined_surfaces(const SolvedMeshState& set, const model::TransitionTie& transition) {
  const model::Mesh& mesh = set.scene.cracked.mesh;
  JoinedSurfaces found{"the TRANSITION", {}, {}, true};
  add_sides(contact::make_contact_surface(set.model, mesh, transition.master), found.sides);
  std::vector<bool> slave(mesh.node_count(), false);
  for (const base::NodeId n : mesh.set_with_id(transition.slave).nodes) {
    slave[n.index()] = true;
  }
  for (const estimate::QuadraticEdge& edge : set.edges->edges) {
    // Edges of the rim between nodes of the slave set, which has no faces.
    if (edge.elements == 1 && slave[edge.nodes[0].index()] && slave[edge.nodes[1].index()]) {
      const auto at = [&](std::size_t i) -> Vec3 { return mesh.x[edge.nodes[i].index()]; };
      found.sides.push_back(
          {{at(0), at(2), at(1)}, (at(1) - at(0)).norm(), {edge.nodes[0], edge.nodes[1]}});
    }
  }
  return found;
}

// The node where a tip's crack starts on a surface; invalid: inside its body, or elsewhere.
base::NodeId mouth_on(const JoinedSurfaces& joined, const mesh::CrackedMesh& cracked,
                      const mesh::CrackFront& front) {
  const mesh::CrackFaceNodes& crack_faces = cracked.faces[front.crack.index()];
  for (const std::vector<base::NodeId>* crack_face : {&crack_faces.left, &crack_faces.right}) {
    for (const AdjacentSurfacePiece& side : joined.sides) {
      if (!crack_face->empty() &&
          std::ranges::find(side.ends, crack_face->front()) != side.ends.end()) {
        return crack_face->front();
      }
    }
  }
  return {};
}

bool touches(const JoinedSurfaces& joined, const AdjacentSurfacePiece& side) {
  return joined.everywhere || std::ranges::any_of(joined.touching, [&](const Vec3& place) {
           return distance_to(side, place) <= 0.5 * side.length;
         });
}

double distance_to_front(const AdjacentSurfacePiece& side, const mesh::CrackFront& front) {
  double distance = std::numeric_limits<double>::infinity();
  for (const mesh::FrontPoint& point : front.points) {
    distance = std::min(distance, distance_to(side, point.x));
  }
  return distance;
}

std::string coarse_at_tip(const std::string& name, const AdjacentSurfacePiece& worst,
                          double ratio) {
  return fmt::format(
      "edges of {} near ({:.6g}, {:.6g}) are {:.3g} long, {:.2g} times their distance from the "
      "tip: no error estimate covers how stiffly the body beyond them supports the crack; refine "
      "both sides there, to twice that distance at most",
      name, worst.x[1].x(), worst.x[1].y(), worst.length, ratio);
}

std::string coarse_along_front(const std::string& name, const AdjacentSurfacePiece& worst,
                               double ratio, double part) {
  return fmt::format(
      "elements of {} near ({:.6g}, {:.6g}, {:.6g}) are {:.3g} large, {:.2g} times the size "
      "of the crack: the body there follows the crack too stiffly, K may be off by {:.2g} %; "
      "refine both sides there, to that size at most",
      name, worst.x[0].x(), worst.x[0].y(), worst.x[0].z(), worst.length, ratio, 100.0 * part);
}

CoarseNeighbourEffect effect_of(const JoinedSurfaces& joined, const mesh::CrackedMesh& cracked,
                                const mesh::CrackFront& front) {
  constexpr double ends_on = 0.1; // of its depth: where the first or last domain of a front ends
  constexpr double worth_a_word = 0.02;
  const bool tip = front.is_tip();
  double closest = std::numeric_limits<double>::infinity();
  double depth = 0.0;
  for (const mesh::FrontPoint& point : front.points) {
    double distance = std::numeric_limits<double>::infinity();
    for (const AdjacentSurfacePiece& side : joined.sides) {
      distance = std::min(distance, distance_to(side, point.x));
    }
    closest = std::min(closest, distance);
    depth = std::max(depth, distance);
  }
  if (const base::NodeId start = tip ? mouth_on(joined, cracked, front) : base::NodeId();
      start.valid() &&
      (cracked.mesh.x[start.index()] - front.tip_point().x).norm() <= near * closest) {
    return {};
  }
  const bool mouth = !tip && closest <= ends_on * depth;
  const double size = mouth ? depth : closest;
  // The side that is longest against its own distance from the tip, or the size of the front.
  const AdjacentSurfacePiece* worst = nullptr;
  double ratio = share_that_counts;
  for (const AdjacentSurfacePiece& side : joined.sides) {
    const double distance = distance_to_front(side, front);
    const double against = tip ? distance : size;
    if (distance <= (tip ? near * closest : size) && side.length > ratio * against &&
        touches(joined, side)) {
      ratio = side.length / against;
      worst = &side;
    }
  }
  if (worst == nullptr) {
    return {};
  }
  CoarseNeighbourEffect effect;
  effect.part = (mouth ? part_at_mouth : part_of_K) * ratio * ratio * ratio;
  if (tip && ratio > longest) {
    effect.why_not = coarse_at_tip(joined.name, *worst, ratio);
  } else if (!tip && effect.part > worth_a_word) {
    effect.why_not = coarse_along_front(joined.name, *worst, ratio, effect.part);
  }
  return effect;
}

} // namespace

CoarseNeighbourEffect estimate_coarse_neighbour_effect(const SolvedMeshState& set,
                                                       const mesh::CrackFront& front) {
  CoarseNeighbourEffect all;
  const auto add = [&](const JoinedSurfaces& joined) {
    const CoarseNeighbourEffect one = effect_of(joined, set.scene.cracked, front);
    all.part += one.part;
    all.why_not = all.why_not.empty() ? one.why_not : all.why_not;
  };
  for (std::size_t c = 0; c < set.scene.pairs.size(); ++c) {
    const contact::PairConstraints& pair = set.scene.pairs[c];
    if (set.state.mounted[c] && !pair.faces && !pair.rigid) {
      add(joined_surfaces(set.scene, set.state, c));
    }
  }
  for (const model::Mpc& mpc : set.model.mpcs) {
    const auto* transition = std::get_if<model::TransitionTie>(&mpc);
    if (transition != nullptr && set.edges != nullptr) {
      add(joined_surfaces(set, *transition));
    }
  }
  return all;
}

std::vector<bool> nodes_held_by_other_bodies(const SolvedMeshState& set) {
  std::vector<bool> tied(set.scene.cracked.mesh.node_count(), false);
  for (std::size_t c = 0; c < set.scene.pairs.size(); ++c) {
    if (!set.state.mounted[c] || set.scene.contacts[c].type != model::ContactType::bonded) {
      continue;
    }
    for (const contact::ConstraintRow& row : set.scene.pairs[c].normal) {
      for (const contact::RowEntry& entry : row.entries) {
        tied[entry.node.index()] = true;
      }
    }
  }
  for (const fe::ConstraintTransformation::DependentRow& row : set.scene.ties->rows()) {
    // Rims of patches and equations of the deck tie no other body to a side.
    if (row.mpc >= set.model.mpcs.size() ||
        std::holds_alternative<model::ConstraintEquation>(set.model.mpcs[row.mpc])) {
      continue;
    }
    tied[static_cast<std::size_t>(row.freedom) / 2] = true;
    for (const fe::FreedomTerm& term : row.terms) {
      tied[static_cast<std::size_t>(term.freedom) / 2] = true;
    }
  }
  return tied;
}

} // namespace spricka::analysis
