// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/positive.hpp"

#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace spricka::program {

CLI::Validator positive_validator() {
  return {[](const std::string& given) {
            double value = 0.0;
            const char* const end = given.data() + given.size();
            const auto read = std::from_chars(given.data(), end, value);
            const bool good =
                read.ec == std::errc() && read.ptr == end && value > 0.0 && std::isfinite(value);
            return good ? std::string() : fmt::format("a number above 0, not '{}'", given);
          },
          ""};
}

} // namespace spricka::program
