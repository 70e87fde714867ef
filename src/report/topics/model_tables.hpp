// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
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

/// "Symmetry: only the part y >= 0 is modelled. ..": what results are of; empty: of the whole.
std::string symmetry_note(const model::Model& model);

/// Material, state and thickness of each element set that has a property.
ReportTable property_table(const model::Model& model);

/// The contact pairs as declared.
ReportTable contact_pair_table(const model::Model& model);
/// Rigid targets by shape, points and radius; bores are marked.
ReportTable rigid_target_table(const model::Model& model);

/// Units and form of a model, as far as totals of loads need them.
struct LoadTableUnits {
  std::string length_unit, force_unit;
  int dim = 2;
};

/// Total force and moment of each load case with factor 1.
ReportTable load_total_table(const std::vector<results::LoadTotal>& loads,
                             const LoadTableUnits& form);

/// What there is to tell of imported geometries, as tables with a blank line in front of each: the
/// constants of scripts, the solids of STEP files and the faces of those that are meshed. Empty
/// where a deck imports none.
std::string imported_geometry_section(const results::ReportedGeometry& geometry,
                                      const std::string& length_unit);

} // namespace spricka::report
