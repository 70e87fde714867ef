// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

/// Arrays as a page carries them: whole numbers of few bytes, as text of base64 (RFC 4648). What
/// reads them is data.js.
namespace spricka::report {

/// The bytes as text, four letters for three of them.
std::string base64_text(std::string_view bytes);

/// Text packed by zlib, as base64: DecompressionStream of a browser unpacks it. Throws
/// std::system_error without memory.
std::string packed_text(std::string_view text);

/// Numbers in 65535 even steps from their least to their largest: {"low", "high", "u16"}; what is
/// not a number stays none. Of one number alone {"value", "count"}.
nlohmann::ordered_json encode_numbers(const std::vector<double>& values);

/// Whole numbers in one, two or four bytes each, as the largest wants: {"u8"}, {"u16"}, {"u32"}.
nlohmann::ordered_json encode_counts(const std::vector<std::uint32_t>& values);

} // namespace spricka::report
