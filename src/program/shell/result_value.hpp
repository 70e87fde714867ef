// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "model/requests.hpp"
#include "program/shell/session.hpp"

#include <string>

/// Results that $CHECK knows, asked for at the prompt.
namespace spricka::program {

/// Such a result with its arguments, as typed; NOW is the present state. Nothing is solved.
base::OptionalFailure read_result_request(const model::Model& model, const std::string& line,
                                          model::ResultCheck& check);

/// Its value at the present state for the step NOW, at the end of one of the deck's for another
/// name. What is pending is solved before.
base::OptionalFailure evaluate_result(ShellSession& session, const model::ResultCheck& check,
                                      double& value);

} // namespace spricka::program
