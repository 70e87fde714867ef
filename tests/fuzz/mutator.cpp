// SPDX-License-Identifier: GPL-3.0-or-later
#include "mutator.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace spricka::fuzz {

namespace {

using Piece = std::pair<std::size_t, std::size_t>; ///< first byte, length

bool separates(char c) {
  return std::string_view(" \t\r\n,=()[]'").find(c) != std::string_view::npos;
}

template <class Wanted> std::vector<Piece> pieces(std::string_view text, const Wanted& wanted) {
  std::vector<Piece> found;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && !separates(text[end])) {
      ++end;
    }
    if (end > i && wanted(text.substr(i, end - i))) {
      found.emplace_back(i, end - i);
    }
    i = end + 1;
  }
  return found;
}

std::vector<Piece> lines_of(std::string_view text) {
  std::vector<Piece> found;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find('\n', i), text.size() - 1) + 1;
    found.emplace_back(i, end - i);
    i = end;
  }
  return found;
}

bool any(std::string_view /*token*/) {
  return true;
}

bool is_number(std::string_view token) {
  return std::string_view("0123456789+-.").find(token.front()) != std::string_view::npos;
}

constexpr std::array extremes{"0",
                              "-1",
                              "1e308",
                              "-1e308",
                              "1e-320",
                              "1e999",
                              "2147483647",
                              "2147483648",
                              "-2147483649",
                              "9223372036854775807",
                              "9223372036854775808",
                              "1000000000",
                              "1 : 2000000000",
                              "1 : 9223372036854775807 : 1",
                              "1 : 9223372036854775807 : 4611686018427387904",
                              "-9223372036854775808 : 9223372036854775807",
                              "9223372036854775806 : 9223372036854775807",
                              "(1e308*10)",
                              "(0/0)",
                              "(1e300)",
                              "1.0d0",
                              "1.5-3",
                              "0x1F",
                              "nan",
                              "inf",
                              "1,5",
                              "00000000007",
                              "0.1",
                              "1e9",
                              "65536",
                              "4294967296",
                              "(2^63)",
                              "(-2^63)",
                              "1[mm]",
                              "1[m^12/mm^12]",
                              "1[m^99]"};

constexpr std::array inserts{"\xC3\xA4",
                             "\xFF",
                             "\xEF\xBB\xBF",
                             "\xE2\x88\x92",
                             "\x80",
                             "\t",
                             "\r",
                             "\x01",
                             "&",
                             "!",
                             "$",
                             "'",
                             "(",
                             ")",
                             "[",
                             "]",
                             "=",
                             ",",
                             ":",
                             "\n",
                             "\n&",
                             "\n$",
                             "\n$$",
                             "$END\n",
                             "-",
                             ".",
                             "''",
                             "()",
                             "[]",
                             "\x1B[2J"};

constexpr std::array bombs{
    "\n$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=1 LY=1 NX=1000000000 NY=1000000000\n",
    "\n$MESH SHAPE=RING TYPE=TRIMC6 RI=0 RO=1 NT=1000000000\n",
    "\n$MESH SHAPE=LUG TYPE=QUAM4 RI=1 W=4 L=8 NT=2147483647 NR=2147483647\n",
    "\n$NSET NAME=BOMB\n  1 : 9223372036854775807\n",
    "\n$ESET NAME=BOMB\n  1 : 2000000000 : 3\n",
    "\n$NSET NAME=BOMB WHERE=(x^y^z^x^y^z > exp(exp(exp(x)))) ORDER=(1/x)\n",
    "\n$COOR\n  9223372036854775807 0 0 0\n  1000000000000 1 1 1\n",
    "\n$STEP NAME=BOMB SUBSTEPS=2147483647\n",
    "\n$INCLUDE FILE='/dev/zero'\n",
    "\n$INCLUDE FILE='fuzz.deck'\n"};

template <class List> auto pick(Mutator& mutator, const List& list) {
  return list[mutator.below(list.size())];
}

} // namespace

void Mutator::bytes(std::string& text) {
  const std::size_t at = below(text.size());
  switch (below(5)) {
  case 0:
    text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << below(8)));
    break;
  case 1:
    text[at] = static_cast<char>(below(256));
    break;
  case 2:
    text.erase(at, 1 + below(below(4) == 0 ? 200 : 3));
    break;
  case 3:
    text.resize(at);
    break;
  default:
    text.insert(at, pick(*this, inserts));
  }
}

void Mutator::lines(std::string& text, std::string_view other) {
  const auto own = lines_of(text);
  const auto [first, length] = pick(*this, own);
  const auto foreign = lines_of(other);
  switch (below(5)) {
  case 0:
    text.erase(first, length);
    break;
  case 1:
    text.insert(first, text.substr(first, length));
    break;
  case 2: { // a line moves
    const std::string line = text.substr(first, length);
    text.erase(first, length);
    const auto rest = lines_of(text);
    text.insert(rest.empty() ? 0 : pick(*this, rest).first, line);
    break;
  }
  case 3:
    if (!foreign.empty()) { // a block of another deck
      const auto from = pick(*this, foreign).first;
      const std::size_t most = 1 + below(400);
      text.insert(first, other.substr(from, most));
    }
    break;
  default: // the head of one deck, the tail of another
    text.resize(first);
    text += foreign.empty() ? std::string_view() : other.substr(pick(*this, foreign).first);
  }
}

void Mutator::tokens(std::string& text, std::string_view other) {
  const auto own = pieces(text, any);
  if (own.empty()) {
    return;
  }
  const auto [first, length] = pick(*this, own);
  const auto [second, size] = pick(*this, own);
  const auto foreign = pieces(other, any);
  switch (below(4)) {
  case 0:
    text.erase(first, length);
    break;
  case 1:
    text.insert(first, text.substr(second, size) + " ");
    break;
  case 2:
    text.replace(first, length, text.substr(second, size));
    break;
  default:
    if (!foreign.empty()) {
      const auto from = pick(*this, foreign);
      text.replace(first, length, other.substr(from.first, from.second));
    }
  }
}

void Mutator::numbers(std::string& text) {
  const auto own = pieces(text, is_number);
  if (own.empty()) {
    return;
  }
  const auto [first, length] = pick(*this, own);
  text.replace(first, length, pick(*this, extremes));
}

void Mutator::nesting(std::string& text) {
  if (below(2) == 0) {
    const auto own = lines_of(text);
    text.insert(pick(*this, own).first, pick(*this, bombs));
    return;
  }
  const auto own = pieces(text, is_number);
  const std::size_t depth = std::array<std::size_t, 4>{3, 90, 110, 100000}[below(4)];
  const std::size_t at = own.empty() ? below(text.size()) : pick(*this, own).first;
  const char* const open = std::array{"(", "((-", "sqrt(", "[", "1^"}[below(5)];
  std::string deep;
  for (std::size_t i = 0; i < depth; ++i) {
    deep += open;
  }
  text.insert(at, deep + "1" + std::string(below(2) == 0 ? depth : 0, ')'));
}

void Mutator::once(std::string& text, std::string_view other) {
  if (text.empty()) {
    text = "$";
  }
  switch (below(10)) {
  case 0:
  case 1:
    bytes(text);
    break;
  case 2:
  case 3:
    lines(text, other);
    break;
  case 4:
  case 5:
  case 6:
    tokens(text, other);
    break;
  case 7:
  case 8:
    numbers(text);
    break;
  default:
    nesting(text);
  }
}

std::string Mutator::mutate(std::string text, std::string_view other) {
  for (std::size_t i = 1 + below(4); i > 0; --i) {
    once(text, other);
  }
  constexpr std::size_t longest = 300'000;
  text.resize(std::min(text.size(), longest));
  return text;
}

} // namespace spricka::fuzz
