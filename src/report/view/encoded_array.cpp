// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/encoded_array.hpp"

#include "report/view/packed_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace spricka::report {
namespace {

constexpr std::uint32_t no_number = 65535;

/// Of so many bytes each, the lowest first on any machine.
std::string bytes_of(const std::vector<std::uint32_t>& values, unsigned width) {
  std::string bytes;
  bytes.reserve(width * values.size());
  for (const std::uint32_t value : values) {
    for (unsigned i = 0; i < width; ++i) {
      bytes += static_cast<char>((value >> (8U * i)) & 0xFFU);
    }
  }
  return bytes;
}

} // namespace

nlohmann::ordered_json encode_numbers(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  bool complete = true;
  for (const double value : values) {
    const bool finite = std::isfinite(value);
    complete = complete && finite;
    low = finite ? std::min(low, value) : low;
    high = finite ? std::max(high, value) : high;
  }
  if (!(high >= low)) {
    low = high = 0.0;
  }
  if (complete && !(high > low)) {
    return {{"value", low}, {"count", values.size()}};
  }
  const double scale = high > low ? (no_number - 1) / (high - low) : 0.0;
  std::vector<std::uint32_t> steps;
  steps.reserve(values.size());
  for (const double value : values) {
    steps.push_back(std::isfinite(value)
                        ? static_cast<std::uint32_t>(std::lround(scale * (value - low)))
                        : no_number);
  }
  return {{"low", low}, {"high", high}, {"u16", base64_text(bytes_of(steps, 2))}};
}

nlohmann::ordered_json encode_counts(const std::vector<std::uint32_t>& values) {
  const std::uint32_t largest = values.empty() ? 0 : std::ranges::max(values);
  if (largest < 256) {
    return {{"u8", base64_text(bytes_of(values, 1))}};
  }
  return largest < 65536 ? nlohmann::ordered_json{{"u16", base64_text(bytes_of(values, 2))}}
                         : nlohmann::ordered_json{{"u32", base64_text(bytes_of(values, 4))}};
}

} // namespace spricka::report
