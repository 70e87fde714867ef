// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/verify/verification.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace spricka::program {

/// verification.csv: a row for each check, or for a deck that has none; manual/verify.md names the
/// columns.
std::string verification_csv(const Verification& verification);

/// What such a file says, as far as a comparison needs it: texts of checks, errors, what is
/// allowed, costs. Empty if it is not there, or no such table. Throws std::system_error.
std::optional<Verification> read_verification_csv(const std::filesystem::path& file);

} // namespace spricka::program
