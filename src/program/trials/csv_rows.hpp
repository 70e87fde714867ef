// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace spricka::program {

/// A text as a field of a table: with commas or quotes it stands in quotes (RFC 4180), line ends
/// become blanks, and one that a spreadsheet would take for a formula begins with an apostrophe.
std::string csv_field(std::string_view text);

/// The rows of such a table, the names of its columns first; lines that begin with # are left out.
std::vector<std::vector<std::string>> csv_rows(std::string_view text);

} // namespace spricka::program
