// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

/// The one way in which the program reads a file that a user names.
namespace spricka::base {

inline constexpr std::size_t mebibyte = std::size_t{1} << 20U;

/// Most of one deck with all of its includes [bytes].
inline constexpr std::size_t largest_deck = 1024 * mebibyte;
/// Most of a file of numbers: a spectrum, readings of a test, rates [bytes].
inline constexpr std::size_t largest_number_file = 256 * mebibyte;
/// Most of a mesh in a file that this program reads itself [bytes].
inline constexpr std::size_t largest_mesh_file = 4096 * mebibyte;

/// A file that is not read, and why, as one sentence.
class UnreadableFile : public std::system_error {
public:
  UnreadableFile(std::error_code code, std::string sentence)
      : std::system_error(code), sentence_(std::move(sentence)) {}
  [[nodiscard]] const char* what() const noexcept override { return sentence_.c_str(); }

private:
  std::string sentence_;
};

/// All of a regular file of at most `limit` bytes. Anything else is refused before a byte of it is
/// waited for: pipes, devices, sockets, folders, files that are larger or grow for ever. Throws
/// UnreadableFile.
std::string read_file(const std::filesystem::path& file, std::size_t limit);

/// The first `bytes` of a regular file, or all of a shorter one. Throws UnreadableFile.
std::string read_file_beginning(const std::filesystem::path& file, std::size_t bytes);

} // namespace spricka::base
