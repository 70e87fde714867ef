// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/diagnostics.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace spricka::base {

namespace {

std::string upper(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return result;
}

// Edit distance with transposition of neighbours (Damerau 1964, restricted form).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    d[i][0] = i;
  }
  for (std::size_t j = 0; j <= b.size(); ++j) {
    d[0][j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t cost = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

} // namespace

void Diagnostics::error(SourceSpan span, std::string code, std::string text, std::string hint) {
  all_.push_back({Severity::error, std::move(code), span, std::move(text), std::move(hint)});
  ++errors_;
}

void Diagnostics::warning(SourceSpan span, std::string code, std::string text, std::string hint) {
  all_.push_back({Severity::warning, std::move(code), span, std::move(text), std::move(hint)});
}

void Diagnostics::note(SourceSpan span, std::string code, std::string text, std::string hint) {
  all_.push_back({Severity::note, std::move(code), span, std::move(text), std::move(hint)});
}

std::string make_spelling_hint(std::string_view word, const std::vector<std::string>& valid) {
  const std::string wanted = upper(word);
  std::size_t best = wanted.size() / 3 + 1;
  const std::string* nearest = nullptr;
  for (const std::string& candidate : valid) {
    const std::size_t distance = edit_distance(wanted, upper(candidate));
    if (distance < best) {
      best = distance;
      nearest = &candidate;
    }
  }
  if (nearest != nullptr) {
    return fmt::format("did you mean '{}'?", *nearest);
  }
  if (valid.empty() || valid.size() > 30) {
    return {};
  }
  return fmt::format("one of: {}", fmt::join(valid, ", "));
}

} // namespace spricka::base
