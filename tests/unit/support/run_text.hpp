// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/exit_codes.hpp"
#include "program/commands/run_deck.hpp"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace spricka::test {

/// A folder of its own for each test, removed at the end.
class Folder {
public:
  Folder() {
    static std::atomic<int> count{0};
    path_ = std::filesystem::temp_directory_path() /
            ("spricka_test_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

inline std::string slurp(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Outcome {
  int exit_code = -1;
  std::string messages; ///< what went to stderr
};

/// Runs a deck given as text in a folder; the run folder is folder/out.
inline Outcome run_text(const Folder& folder, const std::string& deck, int threads = 1) {
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << deck;
  program::RunOptions options;
  options.deck = file;
  options.out = folder.path() / "out";
  options.threads = threads;
  options.quiet = true;
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.exit_code = base::exit_code(program::run_deck(options));
  outcome.messages = testing::internal::GetCapturedStderr();
  return outcome;
}

/// Column `name` of a CSV of the run folder, `#` lines left out.
inline std::vector<double> column(const std::filesystem::path& file, const std::string& name) {
  std::ifstream in(file);
  std::string line;
  std::size_t at = 0;
  bool header = true;
  std::vector<double> values;
  while (std::getline(in, line)) {
    if (line.starts_with('#')) {
      continue;
    }
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) {
      fields.push_back(field);
    }
    if (header) {
      while (at < fields.size() && fields[at] != name) {
        ++at;
      }
      header = false;
    } else {
      values.push_back(std::stod(fields.at(at)));
    }
  }
  return values;
}

} // namespace spricka::test
