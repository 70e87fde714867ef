// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/notes.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <string_view>
#include <utility>

namespace spricka::report {
namespace {

/// The text with '#' for each number.
std::string without_numbers(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool digit = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    const bool inside = !out.empty() && out.back() == '#';
    // a point, exponent or sign between digits belongs to the number
    const bool joint = inside && i + 1 < text.size() &&
                       std::string_view(".e+-").find(text[i]) != std::string_view::npos &&
                       std::isalnum(static_cast<unsigned char>(text[i + 1])) != 0;
    if (digit) {
      out += inside ? "" : "#";
    } else if (!joint) {
      out += text[i];
    }
  }
  return out;
}

class Collector {
public:
  void add(std::string where, const results::Note& note, const std::string& group) {
    const auto [at, fresh] = seen_.try_emplace(
        group + '\n' + without_numbers(results::text_with_code(note)), notes.size());
    if (fresh) {
      notes.push_back({.where = std::move(where), .first = note, .last = {}});
    } else {
      RepeatedNote& alike = notes[at->second];
      ++alike.times;
      alike.last = std::move(where);
    }
  }

  std::vector<RepeatedNote> notes;

private:
  std::map<std::string, std::size_t> seen_;
};

} // namespace

std::vector<RepeatedNote> collect_notes(const results::RunResult& run) {
  Collector found;
  for (const results::CrackLengthResult& increment : run.increments) {
    const std::string where = fmt::format("increment {}", increment.number);
    for (const results::Note& note : increment.notes) {
      found.add(where, note, "");
    }
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::Note& note : step.notes) {
        found.add(fmt::format("{}, step {}", where, step.step), note, "");
      }
    }
  }
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadPathResult& path : increment.paths) {
      for (const results::Note& note : path.notes) {
        found.add(fmt::format("increment {}, load path {}", increment.number, path.name), note,
                  path.name);
      }
    }
  }
  for (const results::GrowthTestResult& test : run.tests) {
    for (const results::Note& note : test.notes) {
      found.add(fmt::format("test {}", test.name), note, test.name);
    }
  }
  return std::move(found.notes);
}

std::string repeated_note_text(const RepeatedNote& note) {
  std::string words = fmt::format("{}: {}", note.where, note.first.text);
  if (note.times > 1) {
    words += fmt::format(" (alike {} more time{}, last in {})", note.times - 1,
                         note.times > 2 ? "s" : "", note.last);
  }
  return words;
}

} // namespace spricka::report
