// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/scene_rows.hpp"

#include "fe/dependence.hpp"

#include <map>

namespace spricka::analysis {

namespace {

// What contact rows ask of independent freedoms; rows without dependent ones stay as they are.
void reduce_rows(Discretisation& scene) {
  const int dim = scene.cracked.mesh.dim;
  const fe::ConstraintTransformation& ties = *scene.ties;
  if (ties.rows().empty()) {
    return;
  }
  scene.table.tied.resize(scene.table.size());
  for (std::size_t r = 0; r < scene.table.size(); ++r) {
    const contact::ConstraintRow& row = scene.contact_row(r);
    // Several followers may share a master: weights of a node add up.
    std::map<std::size_t, base::Vec3> weight; // by node
    bool follows = false;
    const auto add = [&](std::size_t freedom, double w) {
      const auto at = static_cast<std::size_t>(dim);
      weight.try_emplace(freedom / at, base::Vec3::Zero())
          .first->second[static_cast<Eigen::Index>(freedom % at)] += w;
    };
    for (const contact::RowEntry& entry : row.entries) {
      for (int c = 0; c < dim; ++c) {
        const std::size_t freedom =
            static_cast<std::size_t>(dim) * entry.node.index() + static_cast<std::size_t>(c);
        const fe::ConstraintTransformation::DependentRow* tie =
            ties.find_row(static_cast<std::int32_t>(freedom));
        if (tie == nullptr) {
          add(freedom, entry.weight[c]);
          continue;
        }
        follows = true;
        for (const fe::FreedomTerm& t : tie->terms) {
          add(static_cast<std::size_t>(t.freedom), entry.weight[c] * t.coefficient);
        }
      }
    }
    if (follows) {
      scene.table.tied[r] = scene.table.reduced.size();
      contact::ConstraintRow& reduced = scene.table.reduced.emplace_back(row);
      reduced.entries.clear();
      for (const auto& [node, w] : weight) {
        reduced.entries.push_back({base::NodeId(node), w});
      }
    }
  }
}

} // namespace

void make_row_table(Discretisation& scene) {
  scene.table = {};
  for (const contact::PairConstraints& pair : scene.pairs) {
    scene.table.first.push_back(scene.table.size());
    for (std::size_t i = 0; i < pair.normal.size() + pair.tangent.size(); ++i) {
      scene.table.places.push_back({scene.table.first.size() - 1, i});
    }
  }
  scene.table.first.push_back(scene.table.size());
  reduce_rows(scene);
}

} // namespace spricka::analysis
