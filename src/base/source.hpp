// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace spricka::base {

/// Whether a byte of UTF-8 begins a character: 10xxxxxx continues one and takes no column.
inline bool is_utf8_character_start(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// A stretch of bytes in one source file; `file < 0` means "no place in a deck".
struct SourceSpan {
  std::int32_t file = -1;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  [[nodiscard]] constexpr bool valid() const { return file >= 0; }
};

/// Line and column count from 1; columns count characters, not bytes.
struct SourceLocation {
  std::size_t line = 0;
  std::size_t column = 0;
};

/// The texts a run has read: the deck and its includes. Texts never move, so that string views and
/// pointers into them stay valid as long as the object lives.
class SourceTexts {
public:
  /// Takes over a text and returns its file number for spans. [bytes] at most 4 GiB.
  std::int32_t add_text(std::string name, std::string text);

  [[nodiscard]] std::size_t count() const { return files_.size(); }
  /// Name under which a text was added, by its file number.
  [[nodiscard]] const std::string& file_name(std::int32_t file) const;
  /// The whole text of a file.
  [[nodiscard]] std::string_view text(std::int32_t file) const;
  /// The text that a span covers, within its file.
  [[nodiscard]] std::string_view text(SourceSpan span) const;
  /// Line and column of an offset [bytes], both from 1; columns count characters of UTF-8. Offsets
  /// beyond the end stand for the end.
  [[nodiscard]] SourceLocation locate(std::int32_t file, std::size_t offset) const;
  /// The line that holds an offset, without its end-of-line bytes.
  [[nodiscard]] std::string_view line_at(std::int32_t file, std::size_t offset) const;

private:
  struct SourceFile {
    std::string name;
    std::string text;
  };
  std::deque<SourceFile> files_;
};

} // namespace spricka::base
