// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/peers/calculix.hpp"
#include "program/study/deck_answers.hpp"

#include <vector>

namespace spricka::program {

/// What another program's displacements and stresses at the nodes of a deck's first step say of its
/// answers; between nodes by the shape functions. What is of another step, or neither, is no
/// number. [answer]
std::vector<AnswerReading> peer_answers(const model::Model& model,
                                        const std::vector<Answer>& answers,
                                        const NodalFields& fields);

} // namespace spricka::program
