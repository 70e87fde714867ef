// SPDX-License-Identifier: GPL-3.0-or-later
#include "words.hpp"

#include "grammar/catalogue.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace spricka::fuzz {

namespace {

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

// Comments and texts as blanks, so that places stay.
std::string without_texts(std::string_view text) {
  std::string result(text);
  char inside = 0;
  for (char& c : result) {
    const bool ends = (inside == '!' && c == '\n') || (inside == '\'' && (c == '\'' || c == '\n'));
    if (inside == 0 && (c == '!' || c == '\'')) {
      inside = c;
      c = c == '\'' ? '"' : ' ';
    } else if (ends) {
      inside = 0;
      c = c == '\n' ? '\n' : '"';
    } else if (inside != 0 && c != '\n') {
      c = ' ';
    }
  }
  return result;
}

bool letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}
bool blank(char c) {
  return c == ' ' || c == '\t' || c == '&';
}

class Finder {
public:
  explicit Finder(std::string text) : text_(std::move(text)) {}

  std::vector<Word> run() {
    std::vector<std::size_t> starts; // of the names of cards
    for (std::size_t line = 0; line < text_.size(); line = next_line(line)) {
      const std::size_t first = skip(line);
      if (first < text_.size() && text_[first] == '$') {
        starts.push_back(first + 1);
      }
    }
    starts.push_back(text_.size());
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
      card(starts[i], starts[i + 1]);
    }
    return std::move(words_);
  }

private:
  [[nodiscard]] std::size_t next_line(std::size_t at) const {
    return std::min(text_.find('\n', at), text_.size() - 1) + 1;
  }
  [[nodiscard]] std::size_t skip(std::size_t at) const {
    while (at < text_.size() && blank(text_[at])) {
      ++at;
    }
    return at;
  }
  [[nodiscard]] std::size_t word_end(std::size_t at) const {
    while (at < text_.size() && in_word(text_[at])) {
      ++at;
    }
    return at;
  }
  [[nodiscard]] std::string word(std::size_t begin) const {
    return upper(std::string_view(text_).substr(begin, word_end(begin) - begin));
  }
  void keep(std::size_t begin) { words_.push_back({begin, word_end(begin) - begin}); }

  void card(std::size_t begin, std::size_t end) {
    const std::string name = word(begin);
    const grammar::CardSpec* spec = grammar::find_card(name);
    if (spec == nullptr) {
      return;
    }
    keep(begin);
    std::size_t header_end = next_line(begin);
    while (header_end < end &&
           text_[std::min(text_.find_first_not_of(" \t", header_end), text_.size() - 1)] == '&') {
      header_end = next_line(header_end);
    }
    keys(*spec, word_end(begin), header_end);
    rows(name, header_end, end);
  }

  void keys(const grammar::CardSpec& spec, std::size_t begin, std::size_t end) {
    int depth = 0;
    for (std::size_t i = begin; i < end; ++i) {
      depth += text_[i] == '(' ? 1 : text_[i] == ')' ? -1 : 0;
      if (depth > 0 || !letter(text_[i])) {
        continue;
      }
      const std::size_t equal = skip(word_end(i));
      const grammar::KeySpec* key =
          equal < end && text_[equal] == '=' ? spec.find(word(i)) : nullptr;
      if (key != nullptr) {
        keep(i);
        if (key->type == grammar::KeyType::word) {
          keep(skip(equal + 1));
        }
      }
      i = word_end(i) - 1;
    }
  }

  // Words in data lines: actions of $STEP, results, processors, REL, ABS and SOURCE.
  void rows(const std::string& card, std::size_t begin, std::size_t end) {
    const bool first_counts = card == "STEP" || card == "CHECK" || card == "OUTPUT";
    for (std::size_t line = begin; line < end; line = next_line(line)) {
      bool first = first_counts;
      for (std::size_t i = skip(line); i < std::min(next_line(line), end); ++i) {
        if (!letter(text_[i])) {
          first = false;
          continue;
        }
        const std::string found = word(i);
        const bool fixed =
            card == "CHECK" && (found == "REL" || found == "ABS" || found == "SOURCE");
        if (first || fixed || card == "TASK") {
          keep(i);
        }
        first = false;
        i = word_end(i) - 1;
      }
    }
  }

  std::string text_;
  std::vector<Word> words_;
};

} // namespace

std::vector<Word> words_of(std::string_view text) {
  return Finder(without_texts(text)).run();
}

std::string misspelt(std::string_view word) {
  std::string result(word); // no word of the language holds QJ
  result.insert(word.size() / 2 + 1 > word.size() ? word.size() : word.size() / 2 + 1, "QJ");
  return result;
}

} // namespace spricka::fuzz
