// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string_view>

namespace spricka::base {

enum class DiskSync { no, yes };

/// Writes the bytes to a file without a name, or with one that nothing else has, and gives it the
/// name `file` at the end: that stands for the old bytes or for all of the new, whatever happens,
/// and no file of another's is touched. DiskSync::yes: they survive a power failure too. Throws
/// std::system_error with the file's name.
void write_atomically(const std::filesystem::path& file, std::string_view bytes,
                      DiskSync sync = DiskSync::no);

/// A name beside `file` that is free: "file.<pid>.part". Nothing is made.
std::filesystem::path unused_temporary_path(const std::filesystem::path& file);

} // namespace spricka::base
