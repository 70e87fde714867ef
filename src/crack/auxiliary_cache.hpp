// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <mutex>

namespace spricka::crack {

class AuxiliaryFieldTable;

/// Keeps the table of the auxiliary fields in a front's domains from one call to the next
/// (partner_table). It changes how long K takes, not what it is.
struct AuxiliaryFieldCache {
  std::mutex mutex;
  std::shared_ptr<const AuxiliaryFieldTable> table;
};

} // namespace spricka::crack
