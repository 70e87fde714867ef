// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/units.hpp"
#include "model/forward.hpp"
#include "report/drawing/table.hpp"
#include "results/imported_geometry.hpp"
#include "results/load_total.hpp"

#include <string>
#include <vector>

/// Tables of what the deck describes.
namespace spricka::report {

/// Nodes and elements of each net that has any.
ReportTable net_size_table(const model::Model& model);

/// Where output is in other units: what the deck and all messages are in; else empty.
std::string deck_units_note(const base::UnitSystem& units);

/// "Symmetry: only the part y >= 0 is modelled. ..": what results are of; empty: of the whole.
std::string symmetry_note(const model::Model& model);

/// Material, state and thickness of each element set that has a property.
ReportTable property_table(const model::Model& model);

/// The contact pairs as declared.
ReportTable contact_pair_table(const model::Model& model);
/// Rigid targets by shape, points and radius; bores are marked.
ReportTable rigid_target_table(const model::Model& model);

/// Total force and moment of each load case with factor 1; of plane models (dim 2) or solids.
ReportTable load_total_table(const std::vector<results::LoadTotal>& loads,
                             const base::UnitSystem& units, int dim);

/// What there is to tell of imported geometries, as tables with a blank line in front of each: the
/// constants of scripts, the solids of STEP files and the faces of those that are meshed. Empty
/// where a deck imports none.
std::string imported_geometry_section(const results::ReportedGeometry& geometry,
                                      const base::OutputUnit& length);

} // namespace spricka::report
