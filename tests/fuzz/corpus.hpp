// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/messages.hpp"
#include "deck/read_deck.hpp"
#include "model/model.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The decks of this house in a folder of their own, where changed copies of them are read.
namespace spricka::fuzz {

struct Deck {
  std::string name;
  std::string text;
  bool sound = false;   ///< accepted as it is
  bool imports = false; ///< goes through gmsh, so it is read seldom
};

/// What reading a text gave.
struct Outcome {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  std::optional<model::Model> model;

  [[nodiscard]] std::string messages() const { return base::format_messages(sources, diagnostics); }
};

/// Reads texts as decks. A reading that takes more than five seconds of processor time ends the
/// program; the text that did it, or that crashed it, stays behind as `deck()`.
class Reader {
public:
  Reader();
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// `largest_mesh` as in deck::DeckReadOptions.
  Outcome read(const std::string& text, std::size_t largest_mesh = 40'000) const;
  [[nodiscard]] std::filesystem::path deck() const { return folder_ / "fuzz.deck"; }

private:
  std::filesystem::path folder_;
};

/// All decks of decks/, tests/diagnostics and this folder, by name. Those of decks/ that import a
/// mesh do not find it here, which is one more mistake to live with.
const std::vector<Deck>& corpus();

} // namespace spricka::fuzz
