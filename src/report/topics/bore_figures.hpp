// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/contacts.hpp"
#include "report/topics/figures.hpp"

#include <optional>

namespace spricka::report {

/// Pressure of a contact between solids round an axis at the steps of the last length: maps of the
/// unrolled surface, curves along the axis, the line of force. Empty where it has no axis.
std::optional<Figure> bore_figure(const model::Model& model, const results::RunResult& run,
                                  const model::Contact& contact);

} // namespace spricka::report
