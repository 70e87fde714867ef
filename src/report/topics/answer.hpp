// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

/// What a run says in a few sentences: the head of the report and the end of the listing.
namespace spricka::report {

/// "C1" and what is found of it. Texts have "+-" and units as base::UnitSystem writes them.
struct AnswerLine {
  std::string subject;
  std::string text;
  bool is_failure = false; ///< a check has failed, or there is no answer
};

/// K of each front at the end of the shown step with its bar, of the first and the last length;
/// what each contact does there; the life and how it ended; the checks; what the run cost.
std::vector<AnswerLine> answer_lines(const model::Model& model, const results::RunResult& run);

/// The step, and of several crack lengths which, in words: "At the end of step LOAD, a = 6 mm."
std::string answer_place(const model::Model& model, const results::RunResult& run);

/// The lines as text with the subjects in a column, each ended by a newline.
std::string answer_text(const model::Model& model, const results::RunResult& run);

/// The lines beside a picture of the joint, as HTML; `warnings`: what follows the lines, as HTML.
std::string answer_html(const model::Model& model, const results::RunResult& run,
                        const std::string& warnings);

} // namespace spricka::report
