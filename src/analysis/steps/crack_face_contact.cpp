// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/crack_face_contact.hpp"

#include "analysis/scene/scene_rows.hpp"
#include "analysis/scene/scene_ties.hpp"
#include "analysis/scene/supported_rows.hpp"
#include "analysis/steps/crack_face_overlap.hpp"
#include "analysis/steps/solid_face_contact.hpp"
#include "base/by_dimension.hpp"
#include "contact/crack_face_pairing.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::analysis {

namespace {

// Slips below this part of the largest displacement of a face are round-off.
constexpr double slip_of_round_off = 1e-9;

// The sides that make up both faces: those that are known, or all that lie within their nodes.
std::vector<model::Face> sides_of(const model::Mesh& mesh,
                                  const mesh::CrackFaceNodes& crack_faces) {
  std::vector<model::Face> sides = crack_faces.left_sides;
  sides.insert(sides.end(), crack_faces.right_sides.begin(), crack_faces.right_sides.end());
  if (!sides.empty()) {
    return sides;
  }
  for (const std::vector<base::NodeId>* crack_face : {&crack_faces.left, &crack_faces.right}) {
    if (!crack_face->empty()) {
      const std::vector<model::Face> own =
          mesh::boundary_faces_with_all_nodes_in(mesh, *crack_face);
      sides.insert(sides.end(), own.begin(), own.end());
    }
  }
  return sides;
}

const std::vector<base::NodeId>& own_crack_face(const mesh::CrackFaceNodes& crack_faces) {
  return crack_faces.meshed_face_nodes();
}

// Nodes of the crack face that carries the rows, from a tip on.
std::vector<base::NodeId> from_tip(const mesh::CrackFaceNodes& crack_faces, base::NodeId tip) {
  std::vector<base::NodeId> nodes = own_crack_face(crack_faces);
  if (nodes.back() == tip) {
    std::ranges::reverse(nodes);
  }
  // Both faces share the tip node, which has no row.
  nodes.erase(nodes.begin());
  return nodes;
}

// Of the pair's normal rows, that of a node.
std::size_t row_of(const contact::PairConstraints& pair, base::NodeId node) {
  const auto at = std::ranges::find(pair.normal, node, &contact::ConstraintRow::node);
  return static_cast<std::size_t>(at - pair.normal.begin());
}

/// How faces of cracks are looked at and paired.
struct CrackFaceRules {
  double (*overlap)(const model::Model&, const Discretisation&, std::size_t line,
                    const base::Vector& u);
  double least_overlap;
  model::PairingMethod pairing;
  contact::PairConstraints (*pair)(const model::Model&, const Discretisation&, std::size_t line,
                                   bool friction);
  /// Whose freedoms become external.
  std::vector<base::NodeId> (*nodes)(const mesh::CrackFaceNodes&, const contact::PairConstraints&);
};

constexpr base::ByDimension<CrackFaceRules> crack_face_rules{
    .plane = {.overlap =
                  [](const auto&, const auto& scene, std::size_t line, const auto& u) {
                    return measure_relative_face_overlap(scene.cracked, line, u).resolved;
                  },
              .least_overlap = overlap_of_round_off,
              .pairing = model::PairingMethod::node,
              .pair =
                  [](const auto& model, const auto& scene, std::size_t line, bool friction) {
                    return contact::build_crack_face_constraints(
                        model, scene.cracked.mesh, scene.cracked.faces[line], friction);
                  },
              .nodes =
                  [](const auto& crack_faces, const auto&) {
                    std::vector<base::NodeId> nodes = crack_faces.left;
                    nodes.insert(nodes.end(), crack_faces.right.begin(), crack_faces.right.end());
                    return nodes;
                  }},
    .space = {
        .overlap = measure_relative_solid_overlap,
        .least_overlap = overlap_of_ripple,
        .pairing = model::PairingMethod::segment,
        .pair = solid_face_pair,
        .nodes = [](const auto&, const auto& pair) { return find_nodes_in_pair_rows(pair); }}};

} // namespace

std::vector<std::size_t> find_cracks_with_face_overlap(const model::Model& model,
                                                       const Discretisation& scene,
                                                       const base::Vector& u) {
  const CrackFaceRules& rules = crack_face_rules.at(scene.cracked.mesh.dim);
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < scene.cracked.faces.size(); ++i) {
    if (!model.cracks[i].faces_in_contact || scene.crack_face_pairs[i]) {
      continue;
    }
    if (rules.overlap(model, scene, i, u) > rules.least_overlap) {
      lines.push_back(i);
    }
  }
  return lines;
}

void add_crack_face_pairs(const model::Model& model, const std::vector<std::size_t>& lines,
                          Discretisation& scene) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const auto dim = static_cast<std::size_t>(mesh.dim);
  const CrackFaceRules& rules = crack_face_rules.at(mesh.dim);
  for (const std::size_t i : lines) {
    const mesh::CrackFaceNodes& crack_faces = scene.cracked.faces[i];
    const model::CrackDefinition& crack = model.cracks[i];
    model::Contact contact;
    contact.name = crack.name + ".FACES";
    contact.mu = crack_faces.has_one_face() ? 0.0 : crack.mu; // mirrored: no slip
    contact.span = crack.span;
    scene.crack_face_pairs[i] = CrackFacePair{scene.pairs.size(), sides_of(mesh, crack_faces)};
    const bool friction = contact.mu > 0.0;
    contact.pairing = rules.pairing;
    scene.pairs.push_back(rules.pair(model, scene, i, friction));
    scene.contacts.push_back(std::move(contact));
    for (const base::NodeId n : rules.nodes(crack_faces, scene.pairs.back())) {
      for (std::size_t c = 0; c < dim; ++c) {
        make_freedom_external(dim * n.index() + c, *scene.ties, scene.cls);
      }
    }
  }
  // Rows behind those of the deck: numbers of the deck's own rows stay.
  make_row_table(scene);
}

TipFaceContact tip_face_contact(const Discretisation& scene, const mesh::CrackFront& front,
                                const StepState& state) {
  TipFaceContact faces;
  const std::optional<CrackFacePair>& crack_face = scene.crack_face_pairs[front.crack.index()];
  if (!crack_face) {
    return faces;
  }
  faces.in_contact = true;
  const contact::PairConstraints& pair = scene.pairs[crack_face->pair];
  const std::vector<bool>& closed = state.pair_closed[crack_face->pair];
  if (!pair.normal.empty()) {
    faces.pressure = state.pair_lambda[crack_face->pair]
                         .head(static_cast<Eigen::Index>(pair.normal.size()))
                         .maxCoeff();
  }
  bool met = false;
  std::vector<bool> along; // closed, from the tip on
  for (const base::NodeId n :
       from_tip(scene.cracked.faces[front.crack.index()], front.tip_point().node)) {
    const std::size_t row = row_of(pair, n);
    along.push_back(row < closed.size() && closed[row]);
    met = met || along.back();
    faces.open_nodes += met ? 0 : 1;
  }
  for (std::size_t i = 2; i + 3 < along.size(); ++i) {
    faces.lone = faces.lone || (along[i] && !along[i - 1] && !along[i + 1]);
  }
  faces.closed = met && faces.open_nodes == 0;
  // Without a closed pair anywhere there is no open part that ends.
  faces.open_nodes = met ? faces.open_nodes : 0;
  if (faces.closed && !pair.tangent.empty()) {
    const base::NodeId next =
        from_tip(scene.cracked.faces[front.crack.index()], front.tip_point().node).front();
    const contact::ConstraintRow& slip = pair.tangent[row_of(pair, next)];
    double size = 0.0;
    double jump = 0.0;
    for (const contact::RowEntry& entry : slip.entries) {
      const base::Vec2 u = state.u.segment<2>(2 * static_cast<Eigen::Index>(entry.node.index()));
      size = std::max(size, slip.area * u.norm());
      jump += entry.weight.head<2>().dot(u);
    }
    // Weights are areas, so that both sides are areas times lengths.
    faces.held = std::abs(jump) <= slip_of_round_off * size;
  }
  return faces;
}

std::optional<std::size_t> contact_row_at_tip(const Discretisation& scene,
                                              const mesh::CrackFront& front) {
  const std::optional<CrackFacePair>& crack_face = scene.crack_face_pairs[front.crack.index()];
  if (!crack_face) {
    return std::nullopt;
  }
  return scene.table.first[crack_face->pair] +
         row_of(scene.pairs[crack_face->pair],
                from_tip(scene.cracked.faces[front.crack.index()], front.tip_point().node).front());
}

std::vector<std::optional<std::size_t>>
find_face_row_by_front_point(const Discretisation& scene, const mesh::CrackFront& front) {
  if (front.is_tip()) {
    const std::optional<std::size_t> row = contact_row_at_tip(scene, front);
    return row ? std::vector{row} : std::vector<std::optional<std::size_t>>();
  }
  std::vector<std::optional<std::size_t>> rows = find_solid_face_row_by_front_point(scene, front);
  for (std::optional<std::size_t>& row : rows) {
    if (row) {
      *row += scene.table.first[scene.crack_face_pairs[front.crack.index()]->pair];
    }
  }
  return rows;
}

std::optional<crack::ForcesBetweenCrackFaces> crack_face_forces(const Discretisation& scene,
                                                                const mesh::CrackFront& front,
                                                                const StepState& state) {
  const std::optional<CrackFacePair>& crack_face = scene.crack_face_pairs[front.crack.index()];
  if (!crack_face) {
    return std::nullopt;
  }
  crack::ForcesBetweenCrackFaces forces{crack_face->sides, base::Vector::Zero(state.u.size()), 0.0};
  const std::size_t first = scene.table.first[crack_face->pair];
  const std::size_t next = *contact_row_at_tip(scene, front) - first;
  // Tension is positive; a plain minus would make -0 of a pair that does not press.
  forces.at_tip = 0.0 - state.pair_lambda[crack_face->pair][static_cast<Eigen::Index>(next)];
  for (std::size_t r = first; r < scene.table.first[crack_face->pair + 1]; ++r) {
    const double value = state.pair_lambda[crack_face->pair][static_cast<Eigen::Index>(r - first)];
    for (const contact::RowEntry& entry : scene.contact_row(r).entries) {
      forces.force.segment<2>(2 * static_cast<Eigen::Index>(entry.node.index())) +=
          value * entry.weight.head<2>();
    }
  }
  return forces;
}

} // namespace spricka::analysis
