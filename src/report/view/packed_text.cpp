// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/packed_text.hpp"

#include <algorithm>
#include <cstdint>

namespace spricka::report {

std::string base64_text(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = (word << 8U) | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? letters[(word >> (18U - 6U * k)) & 63U] : '=';
    }
  }
  return text;
}

std::string packed_text(std::string_view text, base::RepetitionSearch search) {
  return base64_text(base::Deflater(search, text.size()).pack(text));
}

} // namespace spricka::report
