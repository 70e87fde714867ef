// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/safe_file.hpp"

#include "base/hasher.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <system_error>
#include <vector>

#include <fmt/format.h>

namespace spricka::archive {

namespace {

namespace fs = std::filesystem;

constexpr int safe_format = 2;
constexpr std::size_t largest_framed = std::size_t{16} * 1024 * base::mebibyte; ///< [bytes]

[[noreturn]] void unusable(const fs::path& file, const std::string& why,
                           const char* code = "E560") {
  throw FileFailure(code, fmt::format("{}: {}", file.string(), why));
}

// `read` with what it throws as trouble with a restart file.
template <class Read> std::string bytes_of(const fs::path& file, Read read) {
  std::error_code unknown;
  if (!fs::exists(file, unknown)) {
    unusable(file, "there is no such file");
  }
  try {
    return read();
  } catch (const base::UnreadableFile& trouble) {
    throw FileFailure("E560", trouble.what());
  }
}

std::vector<std::string> words(std::string_view line) {
  std::vector<std::string> list;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    list.emplace_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return list;
}

// spricka state 2 of 0.1.0, 12345 bytes, xxh3 0123...
constexpr std::size_t line_words = 9;

} // namespace

void write_file_atomically(const fs::path& file, std::string_view bytes) {
  try {
    base::write_atomically(file, bytes, base::DiskSync::yes);
  } catch (const std::system_error& trouble) {
    throw FileFailure("E563",
                      fmt::format("{}: {}", file.string(), std::strerror(trouble.code().value())));
  }
}

std::string hash_bytes(std::string_view bytes) {
  base::Hasher hash;
  hash.add_bytes(bytes.data(), bytes.size());
  const auto [high, low] = hash.digest();
  return fmt::format("{:016x}{:016x}", high, low);
}

std::string prepend_file_header(std::string_view kind, std::string_view bytes) {
  std::string out = fmt::format("spricka {} {} of {} , {} bytes {}", kind, safe_format,
                                SPRICKA_VERSION, bytes.size(), hash_bytes(bytes));
  // The head has a fixed size, so that it can be read before the rest is.
  out.resize(frame_size - 1, ' ');
  out += '\n';
  out += bytes;
  return out;
}

std::string read_file_with_header(const fs::path& file, std::string_view kind) {
  const std::string head =
      bytes_of(file, [&] { return base::read_file_beginning(file, frame_size); });
  const std::string start = fmt::format("spricka {} ", kind);
  if (head.size() < frame_size && (head.starts_with(start) || start.starts_with(head))) {
    unusable(file, "cut off in its first line");
  }
  if (!head.starts_with(start)) {
    unusable(file, fmt::format("not a {} of spricka", kind), "E564");
  }
  const std::vector<std::string> line = words(std::string_view(head).substr(0, frame_size - 1));
  if (line.size() < line_words || line[2] != std::to_string(safe_format) ||
      line[4] != SPRICKA_VERSION) {
    unusable(file,
             fmt::format("written by spricka {} in format {}; this is {} with format {}",
                         line.size() > 4 ? line[4] : "?", line.size() > 2 ? line[2] : "?",
                         SPRICKA_VERSION, safe_format),
             "E565");
  }
  std::size_t size = 0;
  std::from_chars(line[6].data(), line[6].data() + line[6].size(), size);
  std::error_code unknown;
  if (fs::file_size(file, unknown) > frame_size + size && !unknown) {
    unusable(file, "its content was changed"); // whatever follows is not ours, and may be long
  }
  const std::string bytes = bytes_of(file, [&] { return base::read_file(file, largest_framed); });
  const std::string_view body = std::string_view(bytes).substr(std::min(frame_size, bytes.size()));
  if (body.size() < size) {
    unusable(file, fmt::format("cut off: {} of {} bytes are there", body.size(), size));
  }
  if (body.size() > size || hash_bytes(body) != line[8]) {
    unusable(file, "its content was changed");
  }
  return std::string(body);
}

} // namespace spricka::archive
