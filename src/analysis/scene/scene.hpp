// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "contact/constraint.hpp"
#include "crack/front_extension.hpp"
#include "crack/k_layout.hpp"
#include "fe/dependence.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/contacts.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spricka::fe {
struct CaseTemperature;
}

namespace spricka::analysis {

/// Rows of all pairs, one after another; pair p has rows first[p] .. first[p + 1] - 1, its normal
/// rows before its tangent rows.
struct ContactRowTable {
  struct ContactRowLocation {
    std::size_t pair = 0;
    std::size_t index = 0; ///< among the pair's normal rows, then its tangent rows
  };
  std::vector<ContactRowLocation> places;       ///< [row]
  std::vector<std::size_t> first;               ///< [pair + 1]
  std::vector<contact::ConstraintRow> reduced;  ///< of rows with dependent freedoms
  std::vector<std::optional<std::size_t>> tied; ///< [row] its place in `reduced`; empty: none is

  [[nodiscard]] std::size_t size() const { return places.size(); }
  /// The contact that a row belongs to.
  [[nodiscard]] std::size_t contact_index(std::size_t row) const { return places[row].pair; }
};

/// Contact between the faces of a crack, once they have been found to touch
/// (analysis/steps/crack_face_contact.hpp).
struct CrackFacePair {
  std::size_t pair = 0;           ///< of the scene
  std::vector<model::Face> sides; ///< of the elements on both faces
};

/// One crack length made ready to be solved: what processor TOPOLOGY leaves (make_scene.hpp).
struct Discretisation {
  mesh::CrackedMesh cracked;
  std::vector<model::FreedomRole> cls; ///< [dim * node]
  std::shared_ptr<const fe::ConstraintTransformation> ties;
  std::vector<model::Contact> contacts;        ///< the deck's, then those between faces of cracks
  std::vector<contact::PairConstraints> pairs; ///< [contact]
  std::vector<std::optional<CrackFacePair>>
      crack_face_pairs; ///< [crack line] empty: its faces are open
  ContactRowTable table;
  std::vector<crack::FrontIntegralDomains> domains; ///< [front of `cracked`]
  std::vector<bool> rest_element;                   ///< [element] no crack of the run touches it
  std::vector<std::string> notes;
  /// By case; where ties have a right-hand side, what they ask for is a last column of its own.
  base::Matrix case_load;         ///< [dim * node, case] consistent loads
  base::Matrix case_displacement; ///< [dim * node, case] of prescribed freedoms and their followers
  base::Matrix case_temperature;  ///< [connectivity index, case]; empty: no case heats
  std::vector<std::shared_ptr<const fe::CaseTemperature>>
      case_heat; ///< [case] the same, and the rest

  /// Whether there are cracks in the plane, whose fronts are tips.
  [[nodiscard]] bool has_tips() const {
    return !cracked.fronts.empty() && cracked.fronts.front().is_tip();
  }
  /// Where K of which point of a front, in the plane of which tip, stands among functionals.
  [[nodiscard]] crack::KLayout k_layout() const {
    std::size_t points = 0;
    for (const mesh::CrackFront& front : cracked.fronts) {
      points += front.points.size();
    }
    return {points, cracked.mesh.dim};
  }
  /// Row r of the table, as its pair has it.
  [[nodiscard]] const contact::ConstraintRow& contact_row(std::size_t r) const {
    const ContactRowTable::ContactRowLocation at = table.places[r];
    const contact::PairConstraints& pair = pairs[at.pair];
    return at.index < pair.normal.size() ? pair.normal[at.index]
                                         : pair.tangent[at.index - pair.normal.size()];
  }
  /// What row r asks of independent freedoms: the row itself where none of its freedoms follows.
  [[nodiscard]] const contact::ConstraintRow& reduced_contact_row(std::size_t r) const {
    return !table.tied.empty() && table.tied[r] ? table.reduced[*table.tied[r]] : contact_row(r);
  }
  /// All acting rows, for as long as the scene does not change.
  [[nodiscard]] std::vector<const contact::ConstraintRow*> reduced_contact_rows() const {
    std::vector<const contact::ConstraintRow*> rows;
    for (std::size_t r = 0; r < table.size(); ++r) {
      rows.push_back(&reduced_contact_row(r));
    }
    return rows;
  }
};

} // namespace spricka::analysis
