// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/source.hpp"
#include "model/model.hpp"

#include <optional>
#include <string>

/// Data lines typed at a prompt, read as those of their cards, for a deck that has been read.
namespace spricka::deck {

/// A data line of $STEP: LOAD, FIT, MOUNT or DISMOUNT, as the one action of a step. The line
/// becomes a text of `sources`; mistakes go to `diagnostics`, then the result is empty.
std::optional<model::Step> read_step_line(const model::Model& model, const std::string& line,
                                          base::SourceTexts& sources,
                                          base::Diagnostics& diagnostics);

/// A result that $CHECK knows, with its arguments and no value: K1(C,NOW). NOW is the present
/// state, beside the deck's steps. The line becomes a text of `sources`; mistakes go to
/// `diagnostics`, then the result is empty.
std::optional<model::ResultCheck> read_result_request_line(const model::Model& model,
                                                           const std::string& line,
                                                           base::SourceTexts& sources,
                                                           base::Diagnostics& diagnostics);

} // namespace spricka::deck
