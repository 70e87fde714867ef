// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "results/preview.hpp"

#include <string>

namespace spricka::report {

/// What `check` found, as tables for reading.
std::string deck_preview_listing(const results::DeckPreview& preview);

/// The same as one JSON object; memory in bytes, angles in degrees, lengths in deck units.
std::string deck_preview_json(const results::DeckPreview& preview, base::ProgramOutcome outcome);

/// What there is to tell of the geometries of a deck, as tables for reading.
std::string imported_geometry_listing(const results::ReportedGeometry& geometry,
                                      const base::OutputUnit& length);

} // namespace spricka::report
