// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/format.hpp"
#include "report/file.hpp"
#include "run/commands.hpp"
#include "run/exit_codes.hpp"
#include "run/log.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::run {

namespace {

namespace fs = std::filesystem;

std::string read_stream(std::FILE* file, const std::string& name) {
  std::string text;
  std::array<char, 65536> chunk{};
  while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), file)) {
    text.append(chunk.data(), got);
  }
  if (std::ferror(file) != 0) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  return text;
}

std::string read_text(const fs::path& path) {
  if (path == "-") {
    return read_stream(stdin, "standard input");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) {
    throw std::system_error(errno, std::generic_category(), path.string());
  }
  return read_stream(file.get(), path.string());
}

// A link stays a link: what it points to is replaced, and keeps its permissions.
void replace(const fs::path& path, const std::string& text) {
  const fs::path file = fs::canonical(path);
  const fs::perms permissions = fs::status(file).permissions();
  report::write_file(file, text);
  fs::permissions(file, permissions);
}

int format(const FormatOptions& options, const Log& log) {
  base::Sources sources;
  base::Diagnostics diagnostics;
  const bool standard_input = options.deck == "-";
  const std::int32_t file =
      sources.add(standard_input ? "<stdin>" : options.deck.string(), read_text(options.deck));
  const auto formatted = grammar::format_deck(sources, file, diagnostics);
  log.diagnostics(sources, diagnostics);
  if (!formatted) {
    return exit_code::deck_error;
  }
  const bool same = *formatted == sources.text(file);
  if (options.check) {
    if (!same) {
      fmt::print(stderr, "{}: the layout would change\n", options.deck.string());
    }
    return same ? exit_code::done : exit_code::check_failed;
  }
  if (options.in_place && !standard_input) {
    if (!same) {
      replace(options.deck, *formatted);
    }
  } else {
    fmt::print("{}", *formatted);
  }
  return exit_code::done;
}

} // namespace

int format_command(const FormatOptions& options) {
  const Log log(LogFormat::text);
  try {
    return format(options, log);
  } catch (const std::system_error& trouble) {
    log.message(base::Severity::error, "E530", trouble.what());
    return exit_code::file_trouble;
  }
}

} // namespace spricka::run
