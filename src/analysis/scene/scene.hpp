// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "contact/constraint.hpp"
#include "crack/extension.hpp"
#include "fe/dependence.hpp"
#include "mesh/cut/patch.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Processor TOPOLOGY: one crack length made ready to be solved.
namespace spricka::fe {
struct CaseHeat;
}

namespace spricka::analysis {

/// Rows of all pairs, one after another; pair p has rows first[p] .. first[p + 1] - 1, its normal
/// rows before its tangent rows.
struct RowTable {
  std::vector<const contact::ConstraintRow*> rows;
  std::vector<std::size_t> first;
  /// What the rows ask of independent freedoms: the rows themselves, or one of `reduced`.
  std::vector<const contact::ConstraintRow*> acting;
  std::vector<contact::ConstraintRow> reduced;

  /// The contact that a row belongs to.
  [[nodiscard]] std::size_t contact_of(std::size_t row) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(first, row) - first.begin() - 1);
  }
};

struct TipScene {
  std::vector<crack::ExtensionField> fields;
  std::vector<int> left_out;                   ///< domains that could not be used
  std::optional<crack::ExtensionField> beyond; ///< one ring more than the largest, if it fits
};

/// Contact between the faces of a crack, once they have been found to touch (run/lip_contact.hpp).
struct LipPair {
  std::size_t pair = 0;           ///< of the scene
  std::vector<model::Face> sides; ///< of the elements on both faces
};

struct Scene {
  mesh::CrackedMesh cracked;
  std::vector<model::FreedomClass> cls; ///< [dim * node]
  std::shared_ptr<const fe::Dependence> ties;
  std::vector<model::Contact> contacts;          ///< the deck's, then those between faces of cracks
  std::vector<contact::PairRows> pairs;          ///< [contact]
  std::vector<std::optional<LipPair>> lip_pairs; ///< [crack line] empty: its faces are open
  RowTable table;
  std::vector<TipScene> tips;     ///< [tip]
  std::vector<bool> rest_element; ///< [element] no crack of the run touches it
  std::vector<std::string> notes;
  /// By case; where ties have a right-hand side, what they ask for is a last column of its own.
  base::Matrix case_load;         ///< [dim * node, case] consistent loads
  base::Matrix case_displacement; ///< [dim * node, case] of prescribed freedoms and their followers
  base::Matrix case_temperature;  ///< [connectivity index, case]; empty: no case heats
  std::vector<std::shared_ptr<const fe::CaseHeat>> case_heat; ///< [case] the same, and the rest
};

/// What stays the same for all lengths of a run.
struct RegionPlan {
  std::vector<bool> region; ///< [host element] some length's cavity touches it
  bool split = false;       ///< worth condensing region and rest apart (several lengths)
};

/// The region of the host that the cracks of all lengths touch.
RegionPlan plan_region(const model::Model& model, const std::vector<double>& lengths,
                       base::Diagnostics& diagnostics);

/// Adds what these cracks touch.
void add_to_region(const model::Model& model, const std::vector<mesh::CrackLine>& lines,
                   RegionPlan& plan);

/// Mesh with cracks of length `a`, classes of freedoms, contact rows, virtual extension fields.
/// Mistakes that only show here (a crack that touches no element, surfaces that never face each
/// other) go to `diagnostics` at their card and give an empty result.
std::optional<Scene> make_scene(const model::Model& model, double a, const RegionPlan& plan,
                                base::Diagnostics& diagnostics);

/// The same with the cracks as given.
std::optional<Scene> make_scene(const model::Model& model,
                                const std::vector<mesh::CrackLine>& lines, const RegionPlan& plan,
                                base::Diagnostics& diagnostics);

/// Strings the rows of all pairs into the table and reduces them to independent freedoms.
void make_table(Scene& scene);

/// Loads of all cases on independent freedoms [dim * node, case], T^T (f - K g): prescribed
/// displacements g load the others by their pull.
base::Matrix loads_with_supports(const model::Model& model, const Scene& scene);

} // namespace spricka::analysis
