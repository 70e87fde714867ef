// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/forward.hpp"

namespace spricka::sense {

/// Warns of contacts in the plane that are understood but hardly meant (W442 to W446): a declared
/// gap that the drawing contradicts, a surface with faces of its partner missing, fits that are not
/// small, friction in percent, bodies that overlap as drawn without a contact.
void warn_of_implausible_contacts(const model::Model& model, base::Diagnostics& list);

} // namespace spricka::sense
