// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/deflater.hpp"

#include <string>
#include <string_view>

/// Bytes as a page carries them: text of base64 (RFC 4648).
namespace spricka::report {

/// The bytes as text, four letters for three of them.
std::string base64_text(std::string_view bytes);

/// Text packed by zlib, as base64: DecompressionStream of a browser unpacks it. Throws
/// std::system_error without memory.
std::string packed_text(std::string_view text, base::RepetitionSearch search);

} // namespace spricka::report
