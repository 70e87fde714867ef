// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/load.hpp"

#include "base/input_file.hpp"
#include "grammar/parse.hpp"
#include "mesh/import/recognise_mesh_file.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_deepest_include = 16;
constexpr std::size_t k_most_includes = 1000; ///< of one deck, each as often as it is included

// Lines that end with a carriage return alone, as long ago on the Macintosh, end with a line feed.
std::string with_line_feeds(std::string text) {
  if (text.find('\n') == std::string::npos) {
    std::replace(text.begin(), text.end(), '\r', '\n');
  }
  return text;
}

// Of the first byte that is part of no UTF-8 letter, or the size (RFC 3629, section 4; surrogates
// and overlong forms of three bytes and more are let pass).
std::size_t first_odd_byte(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t more = lead < 0x80                   ? 0
                             : lead >= 0xC2 && lead < 0xE0 ? 1
                             : lead >= 0xE0 && lead < 0xF0 ? 2
                             : lead >= 0xF0 && lead < 0xF5 ? 3
                                                           : text.size();
    for (std::size_t k = 1; k <= more; ++k) {
      if (i + k >= text.size() || (static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U) {
        return i;
      }
    }
    i += more + 1;
  }
  return text.size();
}

const grammar::CardField* value_of(const grammar::CardHeader& card, std::string_view key) {
  for (const grammar::HeaderParameter& p : card.parameters) {
    if (p.key == key) {
      return &p.values.front();
    }
  }
  return nullptr;
}

class Loader {
public:
  Loader(base::SourceTexts& sources, base::Diagnostics& diagnostics)
      : sources_(sources), diagnostics_(diagnostics) {}

  void file(const fs::path& path, std::string shown, const std::optional<std::string>& given = {}) {
    std::string text =
        with_line_feeds(given ? *given : base::read_file(path, base::largest_deck - bytes_));
    bytes_ += text.size();
    const std::int32_t number = sources_.add_text(std::move(shown), std::move(text));
    if (!is_text(number)) {
      deck.incomplete = true;
      return;
    }
    open_.push_back(fs::weakly_canonical(path));
    for (grammar::CardHeader& card : grammar::parse_cards(sources_, number, diagnostics_)) {
      if (card.name == "INCLUDE") {
        include(path, card);
      }
      deck.cards.push_back(std::move(card)); // an include stays, so that its keys are checked
    }
    open_.pop_back();
  }

  DeckFileCards deck;

private:
  // Not a program, a picture or UTF-16.
  bool is_text(std::int32_t file) {
    const std::string_view text = sources_.text(file);
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos) {
      say_odd_bytes(file, text);
      return true;
    }
    const bool wide = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
    const auto at = static_cast<std::uint32_t>(zero);
    diagnostics_.error({file, at, at + 1}, "E122", "a zero byte: this is not a plain text",
                       wide ? "the file is UTF-16; save it as UTF-8" : "");
    return false;
  }

  // Reports and listings show the deck's own words, and are UTF-8.
  void say_odd_bytes(std::int32_t file, std::string_view text) {
    const std::size_t odd = first_odd_byte(text);
    if (odd < text.size()) {
      const auto at = static_cast<std::uint32_t>(odd);
      diagnostics_.error({file, at, at + 1}, "E122",
                         fmt::format("byte {:02X} here is no UTF-8",
                                     static_cast<unsigned>(static_cast<unsigned char>(text[odd]))),
                         "the file seems to be in an older encoding, as Latin-1; save it as UTF-8");
    }
  }

  void include(const fs::path& from, const grammar::CardHeader& card) {
    const grammar::CardField* name = value_of(card, "FILE");
    if (name == nullptr || name->kind != grammar::CardField::CardFieldKind::text) {
      deck.incomplete = true; // the missing key is reported with the card's others
      return;
    }
    const fs::path path = from.parent_path() / name->text;
    std::error_code unknown; // no such file, a name too long ..: said when it is read
    const fs::path canonical = fs::weakly_canonical(path, unknown);
    if (!unknown && std::ranges::find(open_, canonical) != open_.end()) {
      refuse(*name, fmt::format("'{}' includes itself", name->text));
    } else if (open_.size() > k_deepest_include) {
      refuse(*name, fmt::format("includes are nested more than {} deep", k_deepest_include));
    } else if (includes_ == k_most_includes) {
      if (!too_many_) { // once: those that follow are as many again
        refuse(*name, fmt::format("more than {} files are included", k_most_includes));
      }
      too_many_ = true;
    } else {
      ++includes_;
      try {
        file(path, path.string());
      } catch (const std::system_error& trouble) {
        refuse(*name, trouble.what());
      }
    }
  }

  void refuse(const grammar::CardField& name, std::string text) {
    diagnostics_.error(name.span, "E113", std::move(text));
    deck.incomplete = true;
  }

  base::SourceTexts& sources_;
  base::Diagnostics& diagnostics_;
  std::vector<fs::path> open_;
  std::size_t bytes_ = 0;    ///< of all texts so far
  std::size_t includes_ = 0; ///< read so far
  bool too_many_ = false;
};

// What a file that is no deck begins with; empty for bytes that are no text.
std::string first_printable_line(const fs::path& file) {
  const std::string text = base::read_file_beginning(file, 80);
  const std::string line = text.substr(0, text.find_first_of("\r\n"));
  return std::ranges::all_of(line, [](char c) { return c >= ' ' && c <= '~'; }) ? line : "";
}

base::SourceSpan end_of_text(const base::SourceTexts& sources, std::int32_t file) {
  const std::string_view text = sources.text(file);
  std::size_t end = text.size();
  while (end > 0 && (text[end - 1] == '\n' || text[end - 1] == '\r' || text[end - 1] == ' ')) {
    --end;
  }
  const auto at = static_cast<std::uint32_t>(end);
  return {file, at, at};
}

// $DECK is the first card and $END the last one of the deck's own file.
void check_frame(std::vector<grammar::CardHeader>& cards, std::int32_t file,
                 const base::SourceTexts& sources, base::Diagnostics& diagnostics) {
  if (cards.empty() || cards.front().name != "DECK") {
    const base::SourceSpan at =
        cards.empty() ? base::SourceSpan{file, 0, 0} : cards.front().name_span;
    diagnostics.error(at, "E111", "the first card is $DECK", "$DECK VERSION=1 LENGTH=mm FORCE=N");
  }
  const auto end =
      std::ranges::find_if(cards, [](const grammar::CardHeader& c) { return c.name == "END"; });
  if (end == cards.end() || end->name_span.file != file) {
    diagnostics.error(end == cards.end() ? end_of_text(sources, file) : end->name_span, "E112",
                      end == cards.end() ? "the deck does not end with $END: is it truncated?"
                                         : "$END stands in an included file");
  } else if (end + 1 != cards.end()) {
    diagnostics.error((end + 1)->name_span, "E118", "a card behind $END");
    cards.erase(end + 1, cards.end());
  }
}

} // namespace

DeckFileCards read_deck_and_includes(const std::filesystem::path& deck, base::SourceTexts& sources,
                                     base::Diagnostics& diagnostics,
                                     const std::optional<std::string>& text) {
  Loader loader(sources, diagnostics);
  const auto file = static_cast<std::int32_t>(sources.count());
  if (const mesh::MeshFileKind* kind = text ? nullptr : mesh::recognise_mesh_file(deck)) {
    sources.add_text(deck.string(), first_printable_line(deck));
    diagnostics.error({file, 0, 0}, "E337", fmt::format("this is {}, and no deck", kind->name),
                      kind->format.empty()
                          ? mesh::mesh_file_remedy(*kind, deck)
                          : fmt::format("a deck takes it in: $IMPORT FILE='{}' FORMAT={}",
                                        deck.filename().string(), kind->format));
    loader.deck.incomplete = true;
    return std::move(loader.deck);
  }
  loader.file(deck, deck.string(), text);
  if (!loader.deck.cards.empty() || !loader.deck.incomplete) {
    check_frame(loader.deck.cards, file, sources, diagnostics);
  }
  return std::move(loader.deck);
}

} // namespace spricka::deck
