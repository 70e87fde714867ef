// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

/// What stresses and forces are compared with to tell whether they are more than round-off, where
/// the loads cannot say it: of a press fit the forces of a contact balance round it, and a body
/// that expands freely has no stress.
namespace spricka::report {

/// E of the softest material times the largest displacement of the steps over the model's size
/// [stress].
double reference_elastic_stress(const model::Model& model,
                                const results::CrackLengthResult& increment);

/// The same over the thickness and the size [force].
double reference_elastic_force(const model::Model& model,
                               const results::CrackLengthResult& increment);

/// The largest von Mises stress of a step; 0 without stresses.
double largest_von_mises_stress(const results::LoadStepResult& step);

/// Whether a step has stresses that are more than round-off.
bool has_significant_stress(const model::Model& model, const results::CrackLengthResult& increment,
                            const results::LoadStepResult& step);

/// A contact pressure below which there is nothing but round-off in a run: of the largest pressure
/// of all steps, where that is round-off itself of the stiffness [stress].
double least_contact_pressure(const model::Model& model, const results::RunResult& run);
/// The same of one crack length.
double least_contact_pressure(const model::Model& model,
                              const results::CrackLengthResult& increment);

} // namespace spricka::report
