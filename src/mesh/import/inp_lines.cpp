// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_lines.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace spricka::mesh {

void InpKeywordReader::complain_or_leave_out(std::string_view what, std::string words) const {
  if (shared_.lenient) {
    shared_.leave_out(fmt::format("{} {}", key_.shown, what), key_.place);
  } else {
    complain(key_.place, std::move(words));
  }
}

bool InpKeywordReader::only(std::initializer_list<std::string_view> known) const {
  bool ok = true;
  for (const auto& [name, value] : key_.parameters) {
    const bool says_where = name == "SYSTEM" || name == "INPUT"; // of nodes, or another file
    if (std::find(known.begin(), known.end(), name) != known.end()) {
      continue;
    }
    if (shared_.lenient && !says_where) {
      shared_.leave_out(fmt::format("{} {}", key_.shown, name), key_.place);
    } else {
      complain(key_.place, fmt::format("*{}: {} is not understood", key_.shown, name));
      ok = false;
    }
  }
  return ok;
}

bool InpKeywordReader::needs(std::string_view key, std::string& value) const {
  const std::string* given = key_.find(key);
  if (given == nullptr || given->empty()) {
    complain(key_.place, fmt::format("*{} needs {}=", key_.shown, key));
    return false;
  }
  value = *given;
  return true;
}

InpLabelSet* InpKeywordReader::set_named_by(std::string_view key, std::vector<InpLabelSet>& sets,
                                            std::map<std::string, std::size_t>& index) const {
  const std::string* name = key_.find(key);
  return name == nullptr ? nullptr : &sets[set_of(sets, index, *name)];
}

std::size_t InpKeywordReader::set_of(std::vector<InpLabelSet>& sets,
                                     std::map<std::string, std::size_t>& index,
                                     const std::string& name) const {
  const auto [at, fresh] = index.try_emplace(upper_case(plain(name)), sets.size());
  if (fresh) {
    sets.push_back({plain(name), {}, {}, key_.place});
  }
  return at->second;
}

std::string InpKeywordReader::plain(std::string_view name) const {
  const std::string prefix = upper_case(shared_.instance) + ".";
  const bool own = !shared_.instance.empty() && upper_case(name).starts_with(prefix);
  return std::string(own ? name.substr(prefix.size()) : name);
}

} // namespace spricka::mesh
