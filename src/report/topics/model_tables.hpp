// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/table.hpp"

/// Tables of what the deck describes.
namespace spricka::report {

/// Nodes and elements of each net that has any.
ReportTable net_table(const model::Model& model);

/// "Symmetry: only the part y >= 0 is modelled. ..": what results are of; empty: of the whole.
std::string symmetry_note(const model::Model& model);

/// Material, state and thickness of each element set that has a property.
ReportTable property_table(const model::Model& model);

/// The contact pairs as declared.
ReportTable contact_pair_table(const model::Model& model);
/// Rigid targets by shape, points and radius; bores are marked.
ReportTable rigid_table(const model::Model& model);

} // namespace spricka::report
