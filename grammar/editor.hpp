// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

/// Syntax files for editors, made of the catalogue: cards, keys, numbers, comments, texts, names.
namespace spricka::grammar {

/// A Vim syntax file for decks, syntax/spricka.vim, as text.
std::string vim_syntax();

/// A TextMate grammar as JSON, as VS Code reads it.
std::string textmate_grammar();

} // namespace spricka::grammar
