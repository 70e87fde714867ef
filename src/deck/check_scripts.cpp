// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "grammar/lexeme.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

/// Where a name stands in the deck: first where it is defined.
struct NameOccurrences {
  base::SourceSpan first;
  std::size_t count = 0;
};

bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// The words of all files of the deck, upper case, without comments, texts in quotes and the names
// that $SWEEP varies.
std::map<std::string, NameOccurrences> words_of(const base::SourceTexts& sources) {
  std::map<std::string, NameOccurrences> words;
  for (std::size_t f = 0; f < sources.count(); ++f) {
    const auto file = static_cast<std::int32_t>(f);
    const std::string_view text = sources.text(file);
    for (std::size_t i = 0; i < text.size();) {
      if (text[i] == '!') {
        i = std::min(text.find('\n', i), text.size());
      } else if (text[i] == '\'') {
        i = std::min(text.find_first_of("'\n", i + 1), text.size() - 1) + 1;
      } else if (!in_word(text[i])) {
        ++i;
      } else {
        std::size_t end = i;
        while (end < text.size() && in_word(text[end])) {
          ++end;
        }
        const std::string word = grammar::to_upper(std::string(text.substr(i, end - i)));
        const bool swept =
            (word == "PARAMETER" || word == "WITH") && end < text.size() && text[end] == '=';
        NameOccurrences& places = words[word];
        if (places.count++ == 0) {
          places.first = {file, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end)};
        }
        i = end;
        while (swept && i < text.size() && (text[i] == '=' || text[i] == ' ' || in_word(text[i]))) {
          ++i;
        }
      }
    }
  }
  return words;
}

std::string name_of(const ImportedScript& script) {
  return std::filesystem::path(script.file).filename().string();
}

/// The plots of results look for these by their names.
bool belongs_to_the_report(const std::string& name) {
  return name == "R" || name == "SIGMA";
}

// The number stands in the deck for nothing: it was meant for a script.
void unused(DeckContext& c, const std::string& name, const base::SourceSpan& span) {
  std::vector<std::string> unset;
  for (const ImportedScript& script : c.scripts) {
    for (const mesh::GeometryScriptConstant& constant : script.constants) {
      if (constant.defined && !constant.from_deck) {
        unset.push_back(constant.name);
      }
    }
  }
  const std::string scripts =
      c.scripts.size() == 1 ? name_of(c.scripts.front()) : std::string("the imported scripts");
  const std::string hint = base::make_spelling_hint(name, unset);
  if (hint.starts_with("did you mean")) {
    c.error(span, "E486",
            fmt::format("{} has no constant {}, and nothing else uses it", scripts, name), hint);
  } else {
    c.warning(
        span, "W480",
        fmt::format("nothing uses the parameter {}: no expression, and {} no such constant", name,
                    c.scripts.size() == 1 ? scripts + " has" : scripts + " have"),
        "take it away, or use it; a constant of a script is DefineConstant[ name = value ]; there");
  }
}

bool reaches_a_script(const DeckContext& c, const std::string& upper) {
  return std::ranges::any_of(c.scripts, [&](const ImportedScript& script) {
    return std::ranges::any_of(script.constants, [&](const mesh::GeometryScriptConstant& constant) {
      return constant.from_deck && grammar::to_upper(constant.name) == upper;
    });
  });
}

// Points that differ in nothing but the value of a name.
void idle_sweeps(DeckContext& c, const std::map<std::string, NameOccurrences>& words) {
  for (const CheckedCard& card : c.cards) {
    for (const std::string_view key : {"PARAMETER", "WITH"}) {
      if (card.spec->name != "SWEEP" || card.bad || !card.has_key(key)) {
        continue;
      }
      const std::string name(card.word_value(key));
      const auto at = words.find(name);
      if (at != words.end() && at->second.count < 2 && !reaches_a_script(c, name) &&
          !belongs_to_the_report(name)) {
        c.warning(card.find(key)->span, "W361",
                  fmt::format("nothing uses the parameter {}: all points of this "
                              "$SWEEP are alike",
                              name),
                  "a parameter works where an expression has it: THICK=(h)");
      }
    }
  }
}

} // namespace

void warn_of_unused_script_parameters(DeckContext& c) {
  const bool swept = c.find_first_card("SWEEP") != nullptr;
  if ((c.scripts.empty() && !swept) || c.scope.incomplete || c.diagnostics.has_errors()) {
    return;
  }
  const std::map<std::string, NameOccurrences> words = words_of(c.sources);
  idle_sweeps(c, words);
  if (c.scripts.empty()) {
    return;
  }
  for (const auto& [written, value] : c.parameters) {
    const std::string upper = grammar::to_upper(written);
    const auto at = words.find(upper);
    const NameOccurrences places = at == words.end() ? NameOccurrences{} : at->second;
    const bool arrives = reaches_a_script(c, upper);
    bool reported = arrives; // where it arrives in one script, another may have a name of its own
    for (const ImportedScript& script : c.scripts) {
      for (const mesh::GeometryScriptConstant& constant : script.constants) {
        if (!reported && !constant.defined && constant.name == written && constant.value &&
            *constant.value != value) {
          c.warning(places.first, "W481",
                    fmt::format("{} = {:.6g} does not reach {}, which sets {} to {:.6g} itself",
                                written, value, name_of(script), written, *constant.value),
                    fmt::format("write DefineConstant[ {} = {:.6g} ]; there, or another name here",
                                written, *constant.value));
          reported = true;
        }
      }
    }
    if (!reported && places.count < 2 && !belongs_to_the_report(upper)) {
      unused(c, written, places.first);
    }
  }
}

} // namespace spricka::deck
