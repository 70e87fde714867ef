// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "grammar/catalogue.hpp"

#include <string>
#include <vector>

/// The catalogue in words: what the help, the card reference and the schema have in common.
namespace spricka::grammar {

/// "length >0", "whole number 2..3", "STRESS|STRAIN", "name of a material".
std::string describe_key_value(const KeySpec& key);

/// "required", the default, or empty.
std::string describe_key_requirement(const KeySpec& key);

/// The clauses of a card as sentences: "SHAPE=LINE needs X0 and Y0.", "At most one of A, B and C."
/// Clauses of equal effect are one sentence.
std::vector<std::string> card_rule_sentences(const CardSpec& card);

/// What is read and checked but has no analysis in this version: "MU >0"; empty where all is there.
std::string describe_unavailable_values(const CardSpec& card);

/// How a result is written: "K1(crack[.tip], step [, a [, angle]])".
std::string result_call_syntax(const ResultQuantity& quantity);

/// What the help says of a card's data: "Data lines", or "Optional data lines" where none are
/// required.
std::string_view data_lines_heading(const CardSpec& card);

/// The groups of cards in their order.
std::vector<std::string_view> card_groups();

/// What a group of cards is for.
std::string_view card_group_purpose(std::string_view group);

} // namespace spricka::grammar
