// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

/// Files that are whole or not there: restart files and their parts.
namespace spricka::archive {

/// Trouble with a file, with the code that names it (program/commands/code_texts.cpp): the program
/// ends with ProgramOutcome::file_trouble.
class FileFailure : public std::runtime_error {
public:
  FileFailure(std::string code, const std::string& what)
      : std::runtime_error(what), code_(std::move(code)) {}
  [[nodiscard]] const std::string& code() const { return code_; }

private:
  std::string code_;
};

/// Writes beside the name, syncs, renames and syncs the folder: whatever happens, the name stands
/// for the old bytes or for all of the new. Throws FileFailure E563.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

/// What a framed file begins with: one line of text, padded to this [bytes], so that `head -1`
/// shows what it is and HDF5's own tools read what follows.
inline constexpr std::size_t frame_size = 512;

/// The bytes with a line in front that says what they are ("state", "increment"), of which version
/// of the format and program, how many, and their hash.
std::string prepend_file_header(std::string_view kind, std::string_view bytes);

/// The bytes behind the line. Throws FileFailure: E560 for a file that cannot be read, is cut off
/// or changed, E564 for a foreign one, E565 for one of another version of format or program.
std::string read_file_with_header(const std::filesystem::path& file, std::string_view kind);

/// 32 hexadecimal digits for some bytes (XXH3, 128 bit).
std::string hash_bytes(std::string_view bytes);

} // namespace spricka::archive
