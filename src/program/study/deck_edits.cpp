// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/deck_edits.hpp"

#include "grammar/lexeme.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckText;

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n';
}

// Without its comment and the & of a continued one; a ! in a quoted text is none.
std::string_view code_of(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first != std::string_view::npos && line[first] == '&') {
    line.remove_prefix(first + 1);
  }
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    quoted = line[i] == '\'' ? !quoted : quoted;
    if (line[i] == '!' && !quoted) {
      return line.substr(0, i);
    }
  }
  return line;
}

// The end of a line with its continuations, behind its line feed.
std::size_t end_of_line(const std::string& data, std::size_t at) {
  const char* const last = data.data() + data.size();
  const char* const end = grammar::logical_line_end(data.data() + at, last);
  return static_cast<std::size_t>(end - data.data()) + (end == last ? 0 : 1);
}

bool names_net(const std::vector<std::string>& fields, const std::set<std::string>& nets) {
  return std::ranges::any_of(fields, [&](const std::string& field) {
    const std::string_view name =
        field.starts_with('-') ? std::string_view(field).substr(1) : field;
    return nets.contains(net_prefix(name));
  });
}

// A card that is nothing without what it names there.
bool stands_on(const DeckCard& card, const std::set<std::string>& nets) {
  constexpr std::array keys{"ESET", "SLAVE", "MASTER", "FROM", "PATH", "FRONT"};
  return std::ranges::any_of(keys, [&](const char* key) {
    const std::string* value = card.find(key);
    return value != nullptr && nets.contains(net_prefix(*value));
  });
}

bool lists_sets(std::string_view card) {
  constexpr std::array names{"NSET", "ESET", "FSET", "FREEDOM"};
  return std::ranges::find(names, card) != names.end();
}

// Items of other nets stay, each in its line.
void keep_items(DeckCard& card, const std::set<std::string>& nets) {
  std::string kept;
  std::size_t at = 0;
  while (at < card.data.size()) {
    const std::size_t end = end_of_line(card.data, at);
    const std::string_view line = std::string_view(card.data).substr(at, end - at);
    const std::vector<std::string> fields = data_fields(line);
    if (!names_net(fields, nets)) {
      kept += line;
    } else {
      std::string items;
      for (const std::string& field : fields) {
        items += names_net({field}, nets) ? "" : " " + field;
      }
      kept += items.empty() ? "" : " " + items + "\n";
    }
    at = end;
  }
  card.data = std::move(kept);
}

bool has_lines(const DeckCard& card) {
  std::size_t at = 0;
  while (at < card.data.size()) {
    const std::size_t end = std::min(card.data.find('\n', at), card.data.size());
    if (!data_fields(std::string_view(card.data).substr(at, end - at)).empty()) {
      return true;
    }
    at = end + 1;
  }
  return false;
}

void erase_nets(DeckText& text, const std::set<std::string>& nets) {
  DeckText kept;
  bool inside = false;
  for (DeckCard& card : text) {
    if (card.name == "NET") {
      inside = nets.contains(card.word_value("NAME"));
    }
    const bool dropped = inside;
    if (card.name == "ENDNET") {
      inside = false;
    }
    if (!dropped) {
      kept.push_back(std::move(card));
    }
  }
  text = std::move(kept);
}

} // namespace

std::string net_prefix(std::string_view name) {
  const std::size_t point = name.find('.');
  return point == std::string_view::npos ? std::string() : grammar::to_upper(name.substr(0, point));
}

std::vector<std::string> data_fields(std::string_view line) {
  std::string code;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find('\n', at), line.size() - 1) + 1;
    code += code_of(line.substr(at, end - at));
    code += ' ';
    at = end;
  }
  std::vector<std::string> fields;
  std::string field;
  int depth = 0;
  for (const char c : code) {
    depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
    if (depth == 0 && is_separator(c)) {
      if (!field.empty()) {
        fields.push_back(std::move(field));
      }
      field.clear();
    } else {
      field += c;
    }
  }
  if (!field.empty()) {
    fields.push_back(std::move(field));
  }
  return fields;
}

void filter_lines(DeckCard& card,
                  const std::function<bool(const std::vector<std::string>&)>& keep) {
  std::string kept;
  std::size_t at = 0;
  while (at < card.data.size()) {
    const std::size_t end = end_of_line(card.data, at);
    const std::vector<std::string> fields =
        data_fields(std::string_view(card.data).substr(at, end - at));
    if (fields.empty() || keep(fields)) {
      kept += card.data.substr(at, end - at);
    }
    at = end;
  }
  card.data = std::move(kept);
}

void drop_mounts(DeckText& text) {
  for (DeckCard& card : text) {
    if (card.name == "STEP") {
      filter_lines(card, [](const std::vector<std::string>& fields) {
        const std::string word = grammar::to_upper(fields.front());
        return word != "MOUNT" && word != "DISMOUNT";
      });
    } else if (card.name == "GROW") {
      card.erase("MOUNTED");
    }
  }
}

void drop_fits(DeckText& text, const std::set<std::string>& contacts) {
  for (DeckCard& card : text) {
    if (card.name == "STEP") {
      filter_lines(card, [&](const std::vector<std::string>& fields) {
        return grammar::to_upper(fields.front()) != "FIT" || fields.size() < 2 ||
               !contacts.contains(grammar::to_upper(fields[1]));
      });
    }
  }
}

std::set<std::string> remove_nets(DeckText& text, const std::set<std::string>& nets) {
  erase_nets(text, nets);
  std::set<std::string> contacts;
  for (const DeckCard& card : text) {
    if (card.name == "CONTACT" && stands_on(card, nets)) {
      contacts.insert(card.word_value("NAME"));
    }
  }
  std::erase_if(text, [&](const DeckCard& card) { return stands_on(card, nets); });
  for (DeckCard& card : text) {
    const bool load = card.name == "LOAD";
    if (load || lists_sets(card.name)) {
      const bool had = has_lines(card);
      if (load) {
        filter_lines(card, [&](const auto& fields) { return !names_net({fields.front()}, nets); });
      } else {
        keep_items(card, nets);
      }
      card.name = had && !has_lines(card) ? "" : card.name; // nothing is left of it
    } else if (card.name == "STEP") {
      filter_lines(card, [&](const std::vector<std::string>& fields) {
        return fields.size() < 2 || grammar::to_upper(fields.front()) == "LOAD" ||
               !contacts.contains(grammar::to_upper(fields[1]));
      });
    }
  }
  std::erase_if(text, [](const DeckCard& card) { return card.name.empty(); });
  return contacts;
}

void drop_undefined_loads(DeckText& text) {
  std::set<std::string> cases;
  for (const DeckCard& card : text) {
    if (card.name == "LOAD") {
      cases.insert(card.word_value("CASE"));
    }
  }
  for (DeckCard& card : text) {
    if (card.name == "STEP") {
      filter_lines(card, [&](const std::vector<std::string>& fields) {
        return fields.size() < 2 || grammar::to_upper(fields.front()) != "LOAD" ||
               cases.contains(grammar::to_upper(fields[1]));
      });
    }
  }
}

void apply_defines(DeckText& text,
                   const std::vector<std::pair<std::string, std::string>>& defines) {
  for (DeckCard& card : text) {
    if (card.name != "PARAMETER") {
      continue;
    }
    std::string lines;
    std::size_t at = 0;
    while (at < card.data.size()) {
      const std::size_t end = end_of_line(card.data, at);
      const std::string line = card.data.substr(at, end - at);
      const std::size_t equal = code_of(line).find('=');
      const std::vector<std::string> left =
          data_fields(line.substr(0, equal == std::string::npos ? 0 : equal));
      const auto own = std::ranges::find_if(defines, [&](const auto& define) {
        return left.size() == 1 && grammar::to_upper(define.first) == grammar::to_upper(left[0]);
      });
      lines += own == defines.end() ? line : fmt::format("  {} = {}\n", left[0], own->second);
      at = end;
    }
    card.data = std::move(lines);
  }
}

void drop_requests(DeckText& text) {
  std::erase_if(text, [](const DeckCard& card) {
    constexpr std::array names{"CHECK", "OUTPUT", "RESTART", "SWEEP", "TEST"};
    return std::ranges::find(names, card.name) != names.end();
  });
}

} // namespace spricka::program
