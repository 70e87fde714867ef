// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"
#include "program/study/verdict.hpp"

#include <string>

/// What a study shows: a table at the terminal, study.csv, study.html with charts.
namespace spricka::program {

/// Settings with their cost and errors, series with slopes and plateaus, references of the deck
/// that are not used, the cheapest settings.
std::string study_text(const Study& study);

/// A row for each setting and answer.
std::string study_csv(const Study& study);

/// One page: error of each group of answers against CPU time and against freedoms, then the tables.
std::string study_page(const base::SourceTexts& sources, const model::Model& model,
                       const Study& study);

} // namespace spricka::program
