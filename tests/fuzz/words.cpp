// SPDX-License-Identifier: GPL-3.0-or-later
#include "words.hpp"

#include "grammar/catalogue.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

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

class Finder {
public:
  explicit Finder(std::string text) : text_(std::move(text)) {}

  std::vector<Word> run() {
    static const std::regex any_card(R"(^[ \t]*\$([A-Za-z]+))", std::regex::multiline);
    std::vector<std::size_t> starts;
    for (std::sregex_iterator it(text_.begin(), text_.end(), any_card), end; it != end; ++it) {
      starts.push_back(static_cast<std::size_t>(it->position(1)));
    }
    starts.push_back(text_.size());
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
      card(starts[i], starts[i + 1]);
    }
    return std::move(words_);
  }

private:
  void card(std::size_t begin, std::size_t end) {
    std::size_t name_end = begin;
    while (name_end < end && std::isalpha(static_cast<unsigned char>(text_[name_end])) != 0) {
      ++name_end;
    }
    const std::string name = upper(text_.substr(begin, name_end - begin));
    const grammar::CardSpec* spec = grammar::find_card(name);
    if (spec == nullptr) {
      return;
    }
    words_.push_back({begin, name_end - begin});
    std::size_t header_end = std::min(text_.find('\n', name_end), end);
    while (header_end < end && continues(header_end)) {
      header_end = std::min(text_.find('\n', header_end + 1), end);
    }
    keys(*spec, name_end, header_end);
    rows(name, header_end, end);
  }

  [[nodiscard]] bool continues(std::size_t newline) const {
    const std::size_t next = text_.find_first_not_of(" \t", newline + 1);
    return next != std::string::npos && text_[next] == '&';
  }

  void keys(const grammar::CardSpec& spec, std::size_t begin, std::size_t end) {
    static const std::regex form(R"(([A-Za-z][A-Za-z0-9]*)[ \t]*=(?!=)[ \t]*([A-Za-z0-9]*))");
    const auto first = text_.cbegin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = text_.cbegin() + static_cast<std::ptrdiff_t>(end);
    for (std::sregex_iterator it(first, last, form), none; it != none; ++it) {
      const grammar::KeySpec* key = spec.find(upper(it->str(1)));
      if (key == nullptr) {
        continue;
      }
      words_.push_back({begin + static_cast<std::size_t>(it->position(1)),
                        static_cast<std::size_t>(it->length(1))});
      if (key->type == grammar::KeyType::word) {
        words_.push_back({begin + static_cast<std::size_t>(it->position(2)),
                          static_cast<std::size_t>(it->length(2))});
      }
    }
  }

  // Words in data lines: actions of $STEP, results, processors, REL and ABS.
  void rows(const std::string& card, std::size_t begin, std::size_t end) {
    static const std::regex first_word(R"(^[ \t]*([A-Za-z][A-Za-z0-9.]*))", std::regex::multiline);
    static const std::regex each_word(R"(([A-Za-z]+))");
    static const std::regex tolerance(R"(\b(REL|ABS|SOURCE)\b)", std::regex::icase);
    if (card == "STEP" || card == "CHECK" || card == "OUTPUT") {
      collect(first_word, begin, end);
    }
    if (card == "TASK") {
      collect(each_word, begin, end);
    }
    if (card == "CHECK") {
      collect(tolerance, begin, end);
    }
  }

  void collect(const std::regex& form, std::size_t begin, std::size_t end) {
    const auto first = text_.cbegin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = text_.cbegin() + static_cast<std::ptrdiff_t>(end);
    for (std::sregex_iterator it(first, last, form), none; it != none; ++it) {
      words_.push_back({begin + static_cast<std::size_t>(it->position(1)),
                        static_cast<std::size_t>(it->length(1))});
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
