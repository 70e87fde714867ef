// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"
#include "program/study/ladder.hpp"

#include <string>

/// What a ladder shows: a table at the terminal, ladder.csv, ladder.html with a chart.
namespace spricka::program {

/// Tables and a closing sentence for the terminal: the variants, and what was left out.
std::string hierarchy_text(const model::Model& model, const ModelHierarchy& ladder);

/// A row for each variant and answer.
std::string hierarchy_csv(const ModelHierarchy& ladder);

/// The HTML page: sentence, chart of differences against CPU time, tables.
std::string hierarchy_page(const base::SourceTexts& sources, const model::Model& model,
                           const ModelHierarchy& ladder);

} // namespace spricka::program
