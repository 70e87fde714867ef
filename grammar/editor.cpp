// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/editor.hpp"

#include "grammar/catalogue.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace spricka::grammar {

namespace {

std::vector<std::string> card_names() {
  std::vector<std::string> names;
  for (const CardSpec& card : card_catalogue()) {
    names.emplace_back(card.name);
  }
  return names;
}

std::vector<std::string> key_names() {
  std::set<std::string> names;
  for (const CardSpec& card : card_catalogue()) {
    for (const KeySpec& key : card.keys) {
      names.emplace(key.name);
    }
  }
  return {names.begin(), names.end()};
}

// A number of the language as TextMate's pattern; Vim's has other escapes.
constexpr const char* k_number = R"((?<![\w.])(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?(?![\w.]))";

} // namespace

std::string vim_syntax() {
  std::string out =
      R"(" Vim syntax file for decks of spricka. Made by `spricka editor vim`; do not edit.
" Put it into ~/.vim/syntax/spricka.vim and, into ~/.vim/ftdetect/spricka.vim:
"   autocmd BufRead,BufNewFile *.deck setfiletype spricka
if exists("b:current_syntax")
  finish
endif
syntax case ignore
syntax match sprickaUnknownCard /^\s*\$\w*/
)";
  out += fmt::format("syntax match sprickaCard /^\\s*\\$\\%({}\\)\\>/\n",
                     fmt::join(card_names(), "\\|"));
  out += fmt::format("syntax match sprickaKey /\\<\\%({}\\)\\>\\ze\\s*=/\n",
                     fmt::join(key_names(), "\\|"));
  out += R"(syntax match sprickaName /\%(=\s*\)\@<=\h\w*\%(\.\w\+\)*/
syntax match sprickaNumber /\%(\w\|\.\)\@<!\%(\d\+\.\?\d*\|\.\d\+\)\%(e[+-]\?\d\+\)\?\%(\w\|\.\)\@!/
syntax match sprickaUnit /\[[^]]*\]/
syntax region sprickaString start=/'/ end=/'/ oneline
syntax match sprickaComment /!.*/
syntax match sprickaContinuation /^\s*&/
highlight default link sprickaUnknownCard Error
highlight default link sprickaCard Statement
highlight default link sprickaKey Identifier
highlight default link sprickaName Constant
highlight default link sprickaNumber Number
highlight default link sprickaUnit Type
highlight default link sprickaString String
highlight default link sprickaComment Comment
highlight default link sprickaContinuation Special
setlocal commentstring=!\ %s
let b:current_syntax = "spricka"
)";
  return out;
}

std::string textmate_grammar() {
  using Json = nlohmann::ordered_json;
  const auto pattern = [](const char* scope, const std::string& match) {
    return Json{{"name", fmt::format("{}.spricka", scope)}, {"match", match}};
  };
  Json out;
  out["$schema"] = "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json";
  out["name"] = "spricka deck";
  out["scopeName"] = "source.spricka";
  out["fileTypes"] = {"deck"};
  out["patterns"] = {
      pattern("comment.line.exclamation", "!.*$"),
      pattern("string.quoted.single", "'[^']*'"),
      pattern("keyword.control.card",
              fmt::format("(?i)^\\s*\\$({})\\b", fmt::join(card_names(), "|"))),
      pattern("invalid.illegal.card", "^\\s*\\$\\w*"),
      pattern("entity.name.tag.key",
              fmt::format("(?i)\\b({})\\b(?=\\s*=)", fmt::join(key_names(), "|"))),
      pattern("constant.numeric", k_number),
      pattern("storage.type.unit", "\\[[^\\]]*\\]"),
      pattern("variable.other.name", "[A-Za-z_]\\w*(\\.\\w+)*"),
      pattern("punctuation.separator.continuation", "^\\s*&"),
  };
  return out.dump(2) + '\n';
}

} // namespace spricka::grammar
