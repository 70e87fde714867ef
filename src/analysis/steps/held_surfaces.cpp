// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/held_surfaces.hpp"

#include "analysis/steps/row_opening.hpp"
#include "model/freedoms.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double round_off = 1e-9; // of the extent of a surface

bool is_held(const Discretisation& scene, const contact::ConstraintRow& row) {
  const int dim = scene.cracked.mesh.dim;
  return std::ranges::all_of(row.entries, [&](const contact::RowEntry& entry) {
    for (int c = 0; c < dim; ++c) {
      const auto freedom = static_cast<std::size_t>(dim) * entry.node.index() + std::size_t(c);
      const model::FreedomRole k = scene.cls[freedom];
      const bool moves = k != model::FreedomRole::suppressed && k != model::FreedomRole::prescribed;
      if (moves && std::abs(entry.weight[c]) > round_off * row.area) {
        return false;
      }
    }
    return true;
  });
}

/// What supports and prescribed displacements do to the rows of one contact that nothing else
/// moves.
struct FullySupportedContact {
  double overlap = 0.0; // largest [length]
  double slip = 0.0;    // largest [length]
  base::NodeId node;    // where they overlap most
};

} // namespace

void warn_of_immovable_rows(const Discretisation& scene,
                            const contact::ContactSystem::IncrementProblem& problem,
                            const StepContactsAndMotion& motion,
                            std::vector<results::Note>& notes) {
  std::vector<FullySupportedContact> found(scene.contacts.size());
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const std::size_t r = problem.rows[i];
    const auto c = scene.table.contact_index(r);
    const contact::ConstraintRow& row = scene.reduced_contact_row(r);
    const bool bonded = scene.contacts[c].type == model::ContactType::bonded;
    if (bonded || row.area <= 0.0 || !is_held(scene, row)) {
      continue;
    }
    // Nothing but supports moves this row: its gap is the given one.
    const double g = problem.gap[static_cast<Eigen::Index>(i)] / row.area;
    if (row.tangential) {
      found[c].slip =
          std::max(found[c].slip,
                   std::abs(row_opening(row, scene.cracked.mesh.dim, motion.moved)) / row.area);
    } else if (-g > found[c].overlap) {
      found[c].overlap = -g;
      found[c].node = row.node;
    }
  }
  for (std::size_t c = 0; c < found.size(); ++c) {
    const double least = round_off * scene.pairs[c].contact.extent;
    const std::string& name = scene.contacts[c].name;
    if (found[c].overlap > least) {
      const base::Vec3& x = scene.cracked.mesh.x[found[c].node.index()];
      notes.push_back(results::invalid_result_note(fmt::format(
          "contact {}: both sides are held or prescribed where they overlap by up to "
          "{:.3g}, at ({:.5g}, {:.5g}): contact cannot press there; free one of them along the "
          "normal",
          name, found[c].overlap, x.x(), x.y())));
    }
    if (found[c].slip > least && motion.pressed[c]) {
      notes.push_back(results::less_exact_note(fmt::format(
          "contact {}: both sides are held or prescribed where they slide by up to "
          "{:.3g}: what friction does there is in no reaction, shear or work; free one of them "
          "along the surface",
          name, found[c].slip)));
    }
  }
}

} // namespace spricka::analysis
