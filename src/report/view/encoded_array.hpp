// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <vector>

#include <nlohmann/json_fwd.hpp>

/// Arrays as a page carries them: whole numbers of few bytes, as text of base64. What reads them is
/// data.js.
namespace spricka::report {

/// Numbers in 65535 even steps from their least to their largest: {"low", "high", "u16"}; what is
/// not a number stays none. Of one number alone {"value", "count"}.
nlohmann::ordered_json encode_numbers(const std::vector<double>& values);

/// Whole numbers in one, two or four bytes each, as the largest wants: {"u8"}, {"u16"}, {"u32"}.
nlohmann::ordered_json encode_counts(const std::vector<std::uint32_t>& values);

} // namespace spricka::report
