// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/messages.hpp"
#include "deck/read_deck.hpp"
#include "model/model.hpp"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <unistd.h>

namespace spricka::deck {

/// A folder of its own for the files of one test, removed at the end.
class Folder {
public:
  Folder() {
    static std::atomic<int> count{0};
    path = std::filesystem::temp_directory_path() /
           ("spricka-deck-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path / name).parent_path());
    std::ofstream(path / name, std::ios::binary) << text;
  }
  std::filesystem::path path;
};

/// Reads a deck given as text; keeps what it said.
struct Reading {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  std::optional<model::Model> model;

  Reading(const Folder& folder, const std::string& text, const DeckReadOptions& options = {}) {
    folder.write("test.deck", text);
    model = read_deck(folder.path / "test.deck", options, sources, diagnostics);
  }
  [[nodiscard]] std::string messages() const { return base::format_messages(sources, diagnostics); }
  /// Codes of all errors in order of place, separated by blanks.
  [[nodiscard]] std::string codes() const {
    std::string all;
    const std::string text = messages();
    for (std::size_t at = text.find(" error E"); at != std::string::npos;
         at = text.find(" error E", at + 1)) {
      all += (all.empty() ? "" : " ") + text.substr(at + 7, 4);
    }
    return all;
  }
};

/// Four nodes of a unit square and one element PLATE.
inline const std::string k_square = "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
                                    "$COOR DIM=2\n 1 0 0\n 2 1 0\n 3 1 1\n 4 0 1\n"
                                    "$ELEMENT TYPE=QUAM4 ESET=PLATE\n 1 1 2 3 4\n"
                                    "$MATERIAL NAME=STEEL E=210[GPa] NU=0.3\n"
                                    "$PROPERTY ESET=PLATE MATERIAL=STEEL STATE=STRESS\n";

} // namespace spricka::deck
