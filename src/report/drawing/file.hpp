// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string_view>

namespace spricka::report {

/// Writes the bytes under a temporary name beside `file` and renames it, so that nobody ever reads
/// half a file. Throws std::system_error, with the file's name, when the system refuses.
void write_file(const std::filesystem::path& file, std::string_view bytes);

} // namespace spricka::report
