// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/verify/comparison.hpp"
#include "program/verify/deck_list.hpp"
#include "program/verify/verification.hpp"
#include "report/drawing/table.hpp"

#include <vector>

/// The tables of verification.html and of the chapter of the manual.
namespace spricka::program {

/// "le1: NAFEMS LE1, elliptic membrane, beta = 0.78".
std::string deck_heading(const VerifiedDeck& deck, const VerifiedPoint& point);
/// "1240 freedoms, 0.31 s CPU, 45 MB"; of a sweep time and memory are those of all its points.
std::string deck_cost_text(const VerifiedDeck& deck, const VerifiedPoint& point);

/// The checks of a point: check, reference, result, error, allowed, bar, source.
report::ReportTable checks_table(const VerifiedPoint& point);

/// Every deck, and every point of a sweep: how many checks, how many passed, the largest error over
/// what is allowed, costs of the deck.
report::ReportTable verified_deck_table(const Verification& verification);

/// Problems of the open collections: which decks and tests stand for each, and how they ended.
report::ReportTable benchmark_problem_table(const Verification& verification,
                                            const std::vector<BenchmarkProblem>& problems);
/// Those that are not covered, with the reason.
report::ReportTable uncovered_problem_table(const std::vector<BenchmarkProblem>& problems);

/// Decks that have not ended with 0, and why.
report::ReportTable failed_deck_table(const Verification& verification);

/// What has changed since the last verification; without rows: nothing.
report::ReportTable verification_change_table(const VerificationComparison& comparison);

} // namespace spricka::program
