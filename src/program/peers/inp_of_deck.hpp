// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/forward.hpp"

#include <string>

namespace spricka::program {

/// A model and its first step as an Abaqus or CalculiX input: supports, loads of every kind as
/// nodal forces, temperatures at nodes. Without a step the model alone. What such an input cannot
/// say (contact, cracks, ties) goes to `refusals` (E540), each with its place, and the text is
/// empty.
std::string abaqus_input_text(const model::Model& model, base::Diagnostics& refusals);

} // namespace spricka::program
