// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/input_file.hpp"
#include "base/printable.hpp"
#include "grammar/format.hpp"
#include "program/commands/commands.hpp"
#include "program/job/log.hpp"
#include "program/job/standard_streams.hpp"
#include "report/drawing/file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

std::string read_standard_input() {
  std::string text;
  std::array<char, 65536> chunk{};
  while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), stdin)) {
    text.append(chunk.data(), got);
    if (text.size() > base::largest_deck) { // a device may go on for ever
      throw std::system_error(EFBIG, std::generic_category(), "standard input");
    }
  }
  if (std::ferror(stdin) != 0) {
    throw std::system_error(errno, std::generic_category(), "standard input");
  }
  return text;
}

std::string read_text(const fs::path& path) {
  return path == "-" ? read_standard_input() : base::read_file(path, base::largest_deck);
}

// A link stays a link: what it points to is replaced, and keeps its permissions.
void replace(const fs::path& path, const std::string& text) {
  const fs::path file = fs::canonical(path);
  const fs::perms permissions = fs::status(file).permissions();
  report::write_file(file, text);
  fs::permissions(file, permissions);
}

base::ProgramOutcome format(const FormatOptions& options, const Log& log) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const bool standard_input = options.deck == "-";
  const std::int32_t file =
      sources.add_text(standard_input ? "<stdin>" : options.deck.string(), read_text(options.deck));
  const auto formatted = grammar::format_deck(sources, file, diagnostics);
  log.report_diagnostics(sources, diagnostics);
  if (!formatted) {
    return base::ProgramOutcome::deck_error;
  }
  const bool same = *formatted == sources.text(file);
  if (options.check) {
    if (!same) {
      write_to_stderr(fmt::format("{}: the layout would change\n",
                                  base::make_printable(options.deck.string())));
    }
    return same ? base::ProgramOutcome::done : base::ProgramOutcome::check_failed;
  }
  if (options.in_place && !standard_input) {
    if (!same) {
      replace(options.deck, *formatted);
    }
  } else {
    write_to_stdout(*formatted);
  }
  return base::ProgramOutcome::done;
}

} // namespace

base::ProgramOutcome format_command(const FormatOptions& options) {
  const Log log(LogFormat::text);
  try {
    return format(options, log);
  } catch (const std::system_error& trouble) {
    log.report_message(base::Severity::error, "E530", trouble.what());
    return base::ProgramOutcome::file_trouble;
  }
}

} // namespace spricka::program
