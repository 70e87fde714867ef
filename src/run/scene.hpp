// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "contact/constraint.hpp"
#include "crack/extension.hpp"
#include "mesh/patch.hpp"
#include "model/model.hpp"

#include <optional>
#include <string>
#include <vector>

/// Processor TOPOLOGY: one crack length made ready to be solved.
namespace spricka::run {

/// Rows of all pairs, one after another; pair p has rows first[p] .. first[p + 1] - 1, its normal
/// rows before its tangent rows.
struct RowTable {
  std::vector<const contact::ConstraintRow*> rows;
  std::vector<std::size_t> first;
};

struct TipScene {
  std::vector<crack::ExtensionField> fields;
  std::vector<int> left_out; ///< domains that could not be used
};

struct Scene {
  mesh::CrackedMesh cracked;
  std::vector<model::FreedomClass> cls; ///< [dim * node]
  std::vector<contact::PairRows> pairs; ///< [contact]
  RowTable table;
  std::vector<TipScene> tips;     ///< [tip]
  std::vector<bool> rest_element; ///< [element] no crack of the run touches it
  std::vector<std::string> notes;
  base::Matrix case_load;         ///< [dim * node, case] consistent loads
  base::Matrix case_displacement; ///< [dim * node, case] prescribed values
};

/// What stays the same for all lengths of a run.
struct RegionPlan {
  std::vector<bool> region; ///< [host element] some length's cavity touches it
  bool split = false;       ///< worth condensing region and rest apart (several lengths)
};

/// The region of the host that the cracks of all lengths touch.
RegionPlan plan_region(const model::Model& model, const std::vector<double>& lengths,
                       base::Diagnostics& diagnostics);

/// Mesh with cracks of length `a`, classes of freedoms, contact rows, virtual extension fields.
/// Mistakes that only show here (a crack that touches no element, surfaces that never face each
/// other) go to `diagnostics` at their card and give an empty result.
std::optional<Scene> make_scene(const model::Model& model, double a, const RegionPlan& plan,
                                base::Diagnostics& diagnostics);

/// Loads of all cases [dim * node, case] with the pull of prescribed displacements: they load the
/// free freedoms by -K u.
base::Matrix loads_with_supports(const model::Model& model, const Scene& scene);

} // namespace spricka::run
