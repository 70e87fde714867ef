// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/figures.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <vector>

/// What the run folder shows of crack growth tests.
namespace spricka::report {

/// test.csv: test,tip,N,a,rate,rate_low,rate_high,R,K_exp,K_low,K_high,K_computed,ratio,covered;
/// one row for each length with a rate; cells of what there is not are empty. Nothing without
/// tests.
void write_growth_test_csv(const std::filesystem::path& file, const model::Model& model,
                           const results::RunResult& run);

/// One row for each test: how it was read and how far K is from the computed one.
ReportTable growth_test_summary_table(const model::Model& model, const results::RunResult& run);
/// The points of one test: cycles, length, rate, ratio, measured K with its band, computed K.
ReportTable test_points_table(const model::Model& model, const results::GrowthTestResult& test);

/// The readings, and K of the test with its band over the crack length beside the computed K and
/// what the deck compares K with; over sigma sqrt(pi a) and a/R where the deck names R and SIGMA.
std::vector<Figure> growth_test_figures(const model::Model& model, const results::RunResult& run);

} // namespace spricka::report
