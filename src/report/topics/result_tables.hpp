// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/table.hpp"
#include "results/results.hpp"

#include <vector>

/// The tables of listing and page, made from the results.
namespace spricka::report {

/// Penetration, pressures, closed rows, force, arc and iterations for each step and contact.
ReportTable contact_result_table(const model::Model& model,
                                 const results::CrackLengthResult& increment);

/// Moments on the contacts of each step, in space; no rows in the plane.
ReportTable contact_moment_table(const model::Model& model,
                                 const results::CrackLengthResult& increment);
/// What friction did, by step and contact: rows by state, tractions, slip path and work; empty
/// without friction.
ReportTable friction_table(const model::Model& model, const results::CrackLengthResult& increment);

/// Applied loads, reactions, contact forces and, where there are any, forces of ties of each body,
/// what is left of their sum, and strain energy.
ReportTable force_balance_table(const model::Model& model,
                                const results::CrackLengthResult& increment);

/// The same of each net; no rows where every net is one body.
ReportTable net_balance_table(const model::Model& model,
                              const results::CrackLengthResult& increment);

/// Estimated error of each net in the energy norm and the elements with most of it, for the steps
/// whose stresses were recovered.
ReportTable energy_error_table(const results::CrackLengthResult& increment);

/// What a reader of forces has to know of the model; may be empty.
std::string force_direction_note(const model::Model& model);

/// The step by which a growth is reported: KMAX, else the deck's last step; empty without steps.
std::string leading_step_name(const model::Model& model);

/// Every check of the deck: found, wanted, error, tolerance, source.
ReportTable checks_table(const model::Model& model, const results::RunResult& run);

/// The processors that ran, with times.
ReportTable run_log_table(const results::RunResult& run);

/// The solutions on the way to K within its tolerance; without rows where no $TIPNET has TOL.
/// `times`: with the CPU time of each, which is another in every run.
ReportTable tolerance_rounds_table(const results::RunResult& run, bool times);

} // namespace spricka::report
