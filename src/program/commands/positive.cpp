// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/positive.hpp"

#include "base/diagnostics.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

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

CLI::Validator one_of_words_validator(std::vector<std::string> words) {
  return {[words = std::move(words)](const std::string& given) {
            const bool known = std::find(words.begin(), words.end(), given) != words.end();
            const std::string hint = base::make_spelling_hint(given, words);
            return known ? std::string() : fmt::format("not '{}'; {}", given, hint);
          },
          ""};
}

CLI::Validator whole_number_validator() {
  return {[](const std::string& given) {
            const bool digits = !given.empty() && given.size() < 7 &&
                                given.find_first_not_of("0123456789") == std::string::npos;
            return digits ? std::string() : fmt::format("a whole number from 0, not '{}'", given);
          },
          ""};
}

void add_positive_option(CLI::App& command, const std::string& name, double& value,
                         const std::string& doc, const std::string& unit) {
  command.add_option(name, value, doc)->check(positive_validator())->type_name(unit);
}

CLI::Option& add_path_option(CLI::App& command, const std::string& name,
                             std::filesystem::path& path, const std::string& doc,
                             const std::string& kind) {
  return *command.add_option(name, path, doc)->type_name(kind);
}

} // namespace spricka::program
