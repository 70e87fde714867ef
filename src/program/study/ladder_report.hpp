// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"
#include "program/study/ladder.hpp"

#include <string>

/// What a ladder shows: a table at the terminal, ladder.csv, ladder.html with a chart.
namespace spricka::program {

std::string ladder_text(const model::Model& model, const Ladder& ladder);

/// A row for each rung and answer.
std::string ladder_csv(const Ladder& ladder);

std::string ladder_page(const base::SourceTexts& sources, const model::Model& model,
                        const Ladder& ladder);

} // namespace spricka::program
