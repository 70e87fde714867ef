// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace spricka::solve {

/// A folder of this process for what does not fit into memory, in that for temporary files
/// (TMPDIR); made when it is first asked for, and removed at the end of the process. Folders of
/// processes that were killed are removed at the same time. Empty: none can be made.
std::string scratch_folder();

/// Removes it now: for ends of the process without destructors.
void remove_scratch_folder();

} // namespace spricka::solve
