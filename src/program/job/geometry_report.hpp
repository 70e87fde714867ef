// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/imported_step.hpp"
#include "results/imported_geometry.hpp"

namespace spricka::program {

/// The constants of a deck's geometry scripts and the solids of its STEP files, for listing and
/// check. A solid stands once, with all sets that it became.
results::ReportedGeometry report_imported_geometry(const deck::ImportedGeometry& imported);

} // namespace spricka::program
