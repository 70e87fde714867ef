// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/solid_face_contact.hpp"

#include "analysis/scene/supported_rows.hpp"
#include "contact/solid_crack_pairing.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::analysis {

namespace {

// Slips below this part of the largest displacement beside them are round-off.
constexpr double slip_of_solid_round_off = 1e-9;

base::Vec3 at_node(const base::Vector& u, base::NodeId n) {
  return u.segment<3>(3 * static_cast<Eigen::Index>(n.index()));
}

// A row's weights times u, and what it would be if all of u counted.
struct FaceRowJump {
  double jump = 0.0;
  double size = 0.0;
};

FaceRowJump motion_of(const contact::ConstraintRow& row, const base::Vector& u) {
  FaceRowJump motion;
  for (const contact::RowEntry& entry : row.entries) {
    const base::Vec3 own = at_node(u, entry.node);
    motion.jump += entry.weight.dot(own);
    motion.size = std::max(motion.size, row.area * own.norm());
  }
  return motion;
}

} // namespace

contact::PairConstraints solid_face_pair(const model::Model& model, const Discretisation& scene,
                                         std::size_t line, bool friction) {
  contact::PairConstraints pair = contact::build_solid_crack_constraints(
      model, scene.cracked.mesh, scene.cracked.faces[line], friction);
  apply_supports_to_rows(pair, scene.cls);
  return pair;
}

double measure_relative_solid_overlap(const model::Model& model, const Discretisation& scene,
                                      std::size_t line, const base::Vector& u) {
  double largest = 0.0;
  for (const auto& [upper, lower] : scene.cracked.faces[line].coincident_node_pairs()) {
    largest = std::max(largest, (at_node(u, upper) - at_node(u, lower)).norm());
  }
  if (!(largest > slip_of_solid_round_off * u.lpNorm<Eigen::Infinity>())) {
    return 0.0; // nothing loads the crack
  }
  double deepest = 0.0;
  for (const contact::ConstraintRow& row : solid_face_pair(model, scene, line, false).normal) {
    deepest = std::max(deepest, -motion_of(row, u).jump / row.area);
  }
  return deepest / largest;
}

std::vector<std::optional<std::size_t>>
find_solid_face_row_by_front_point(const Discretisation& scene, const mesh::CrackFront& front) {
  const std::optional<CrackFacePair>& crack_face = scene.crack_face_pairs[front.crack.index()];
  if (!crack_face) {
    return {};
  }
  const contact::PairConstraints& pair = scene.pairs[crack_face->pair];
  std::vector<std::optional<std::size_t>> rows;
  for (const mesh::FrontPoint& point : front.points) {
    std::optional<std::size_t>& row = rows.emplace_back();
    const auto function =
        std::ranges::find(pair.functions, point.node, &contact::MultiplierFunction::node);
    if (function != pair.functions.end() && function->row >= 0) {
      row = static_cast<std::size_t>(function->row);
    }
  }
  return rows;
}

std::vector<FrontFaceContact> front_face_contact(const Discretisation& scene,
                                                 const mesh::CrackFront& front,
                                                 const StepState& state) {
  const std::optional<CrackFacePair>& crack_face = scene.crack_face_pairs[front.crack.index()];
  if (!crack_face) {
    return {};
  }
  const contact::PairConstraints& pair = scene.pairs[crack_face->pair];
  const std::vector<bool>& closed = state.pair_closed[crack_face->pair];
  std::vector<bool> slipped(pair.normal.size(), pair.tangent.empty());
  for (const contact::ConstraintRow& row : pair.tangent) {
    const FaceRowJump slip = motion_of(row, state.u);
    const auto at = static_cast<std::size_t>(row.normal);
    slipped[at] = slipped[at] || std::abs(slip.jump) > slip_of_solid_round_off * slip.size;
  }
  std::vector<FrontFaceContact> all;
  for (const std::optional<std::size_t>& row : find_solid_face_row_by_front_point(scene, front)) {
    FrontFaceContact& faces = all.emplace_back();
    if (!row) {
      continue;
    }
    faces.closed = *row < closed.size() && closed[*row];
    faces.held = faces.closed && !slipped[*row];
    faces.pressure = state.pair_lambda[crack_face->pair][static_cast<Eigen::Index>(*row)];
  }
  return all;
}

} // namespace spricka::analysis
