// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "results/named_arrays.hpp"

#include <vector>

namespace spricka::analysis {

/// What contacts took on when they were mounted at the first length of a growth run, for the
/// lengths after it ($GROW MOUNTED=FIRST): the part stays the one that was fitted into the body
/// before its crack grew.
class MountOffsetMemory {
public:
  /// A new length begins: mountings are counted anew.
  void begin_new_length() { next_ = 0; }

  /// At the first length keeps the offsets of the rows of a contact; later replaces them by those
  /// kept for the same mounting. Slips of pairs with friction begin anew at each length. False if
  /// the contact's rows are not those of the first length.
  bool store_or_restore_offsets(const Discretisation& scene, std::size_t contact, bool rubs,
                                base::Vector& offset);

  /// As arrays "mount...", for a restart file.
  void save_state(results::NamedArrays& arrays) const;
  /// From those; what is not there has not been mounted.
  static MountOffsetMemory restore_state(const results::NamedArrays& arrays);

private:
  struct MountEvent {
    std::size_t contact = 0;
    std::vector<contact::ConstraintRow> rows;
    base::Vector offset;
  };
  std::vector<MountEvent> events_;
  std::size_t next_ = 0;
};

} // namespace spricka::analysis
