// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"
#include "program/study/ladder.hpp"

#include <string>

/// What a ladder shows: a table at the terminal, ladder.csv, ladder.html with a chart.
namespace spricka::program {

std::string hierarchy_text(const model::Model& model, const ModelHierarchy& ladder);

/// A row for each variant and answer.
std::string hierarchy_csv(const ModelHierarchy& ladder);

std::string hierarchy_page(const base::SourceTexts& sources, const model::Model& model,
                           const ModelHierarchy& ladder);

} // namespace spricka::program
