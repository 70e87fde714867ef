// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace spricka::program {

/// An option's value is a finite number above 0.
CLI::Validator positive_validator();
/// It is one of these words. Any other is refused with a suggestion; CLI11's own check would show
/// its list in every help.
CLI::Validator one_of_words_validator(std::vector<std::string> words);
/// It is a whole number from 0, of six digits at most.
CLI::Validator whole_number_validator();

/// An option that sets `value`, a finite number above 0; `unit` stands for the number in the help.
/// `value` must live as long as the command.
void add_positive_option(CLI::App& command, const std::string& name, double& value,
                         const std::string& doc, const std::string& unit);

/// An option, or a word of the command line, that sets `path`; `kind` stands for it in the help:
/// "FOLDER", "FILE", or empty. `path` must live as long as the command.
CLI::Option& add_path_option(CLI::App& command, const std::string& name,
                             std::filesystem::path& path, const std::string& doc,
                             const std::string& kind);

} // namespace spricka::program
