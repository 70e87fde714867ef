// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "contact/system.hpp"
#include "results/named_arrays.hpp"

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace spricka::analysis {

/// What the contact solution of one crack length leaves for the next: compliances of bodies and
/// rows that the crack does not touch, and which rows were closed at the end of each step, where
/// the search for them begins next time.
class ContactDataForNextLength {
public:
  /// Rows whose nodes no crack touches, and what is kept of them for these bodies (indices of
  /// `bodies`, in the order of the contact system).
  contact::PersistentRowSet find_persistent_rows(const Discretisation& scene,
                                                 const std::vector<SubstructuredBody>& bodies,
                                                 const std::vector<std::size_t>& condensed);

  /// Rows [row] that a step may begin with as closed: `before` changed to what the same step ended
  /// with at the last length, row by row of its nodes. Empty: nothing is known of the step.
  [[nodiscard]] std::vector<bool> guess_closed_rows(const Discretisation& scene, std::size_t step,
                                                    const std::vector<bool>& before) const;
  /// Keeps the rows [row] that a step ended with closed, by their nodes; what was kept of that step
  /// is dropped.
  void store_closed_rows(const Discretisation& scene, std::size_t step,
                         const std::vector<bool>& closed);

  /// The closed rows as arrays "closed...", for a restart file, and back from there, of a deck with
  /// so many steps. Throws base::CorruptStoredField.
  void save_state(results::NamedArrays& arrays) const;
  /// Back from a restart file; empty without the arrays. Throws base::CorruptStoredField for a step
  /// that the deck does not have.
  static ContactDataForNextLength restore_state(const results::NamedArrays& arrays,
                                                std::size_t steps);

private:
  struct PersistentBodyCompliance {
    std::shared_ptr<const void> of; ///< what the rows are kept for: a body, or its early rows
    contact::PersistentRowCompliance rows;
  };
  using Place = std::array<std::int64_t, 3>; ///< contact, node, which of the node's rows
  std::vector<std::unique_ptr<PersistentBodyCompliance>> bodies_;
  std::vector<std::map<Place, bool>> closed_; ///< [step]

  template <class Use> static void for_rows(const Discretisation& scene, Use&& use);
};

} // namespace spricka::analysis
