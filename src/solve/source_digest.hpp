// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::solve {

/// Sixteen digits that tell whether two programs are made of the same sources, as
/// cmake/source_digest prints them.
const char* source_digest();

} // namespace spricka::solve
