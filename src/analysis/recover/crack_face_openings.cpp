// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/crack_face_openings.hpp"

#include "analysis/scene/free_faces.hpp"
#include "analysis/steps/crack_face_overlap.hpp"
#include "analysis/steps/history_program.hpp"
#include "analysis/steps/row_opening.hpp"
#include "contact/crack_face_pairing.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

namespace spricka::analysis {

CrackFaceOpenings::CrackFaceOpenings(const model::Model& model, const Discretisation& scene)
    : scene_(scene) {
  if (!scene.has_tips()) {
    return; // in space steps say where faces overlap
  }
  const bool wanted = !model.load_paths.empty() || depends_on_load_order(model);
  for (std::size_t i = 0; i < scene.cracked.faces.size() && wanted; ++i) {
    // Faces that are a pair already cannot overlap; FREE ones may.
    if (!model.cracks[i].faces_in_contact || scene.crack_face_pairs[i]) {
      continue;
    }
    contact::PairConstraints pair = contact::build_crack_face_constraints(
        model, scene.cracked.mesh, scene.cracked.faces[i], true);
    for (std::size_t r = 0; r < pair.normal.size(); ++r) {
      WatchedFaceNodePair& nodes =
          pairs_.emplace_back(WatchedFaceNodePair{i, std::move(pair.normal[r]), {}});
      if (!pair.tangent.empty()) {
        nodes.along = std::move(pair.tangent[r]);
      }
    }
  }
}

base::Matrix CrackFaceOpenings::opening_functionals(Eigen::Index first, Eigen::Index count) const {
  const auto size =
      static_cast<Eigen::Index>(scene_.cracked.mesh.node_count()) * scene_.cracked.mesh.dim;
  base::Matrix nodal = base::Matrix::Zero(size, count);
  for (Eigen::Index c = 0; c < count; ++c) {
    const WatchedFaceNodePair& nodes = pairs_[static_cast<std::size_t>((first + c) / 2)];
    const bool along = (first + c) % 2 == 1;
    if (along && !nodes.along) {
      continue;
    }
    const contact::ConstraintRow& row = along ? *nodes.along : nodes.apart;
    for (const contact::RowEntry& entry : row.entries) {
      // Over the area of the row its opening is a length.
      nodal.col(c).segment<2>(2 * static_cast<Eigen::Index>(entry.node.index())) +=
          entry.weight.head<2>() / row.area;
    }
  }
  return nodal;
}

base::Vector CrackFaceOpenings::evaluate_openings(const base::Vector& u) const {
  base::Vector values = base::Vector::Zero(count());
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const WatchedFaceNodePair& nodes = pairs_[p];
    const auto at = 2 * static_cast<Eigen::Index>(p);
    values[at] = row_opening(nodes.apart, 2, u) / nodes.apart.area;
    if (nodes.along) {
      values[at + 1] = row_opening(*nodes.along, 2, u) / nodes.along->area;
    }
  }
  return values;
}

void CrackFaceOpenings::add_overlapping_crack_lines(const base::Vector& value,
                                                    std::vector<std::size_t>& lines) const {
  for (std::size_t p = 0; p < pairs_.size();) {
    const std::size_t line = pairs_[p].line;
    std::vector<double> overlap; // along the face
    double largest = 0.0;
    for (; p < pairs_.size() && pairs_[p].line == line; ++p) {
      const base::Vec2 apart = value.segment<2>(2 * static_cast<Eigen::Index>(p));
      overlap.push_back(std::max(0.0, -apart[0]));
      largest = std::max(largest, apart.norm());
    }
    // As for a step (touching_lines): of the largest displacement of the faces against each other.
    if (find_shared_neighbour_overlap(overlap) > overlap_of_round_off * largest &&
        std::ranges::find(lines, line) == lines.end()) {
      lines.push_back(line);
    }
  }
}

} // namespace spricka::analysis
