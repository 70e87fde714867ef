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

// Data lines, each with its continuations, as `change` makes them of the line and its fields.
template <class Change> void change_lines(DeckCard& card, const Change& change) {
  std::string changed;
  for (std::size_t at = 0; at < card.data.size();) {
    const std::size_t end = end_of_line(card.data, at);
    const std::string line = card.data.substr(at, end - at);
    changed += change(line, data_fields(line));
    at = end;
  }
  card.data = std::move(changed);
}

// Items of other nets stay, each in its line.
void keep_items(DeckCard& card, const std::set<std::string>& nets) {
  change_lines(card, [&](const std::string& line, const std::vector<std::string>& fields) {
    if (!names_net(fields, nets)) {
      return line;
    }
    std::string items;
    for (const std::string& field : fields) {
      items += names_net({field}, nets) ? "" : " " + field;
    }
    return items.empty() ? items : " " + items + "\n";
  });
}

void erase_nets(DeckText& text, const std::set<std::string>& nets) {
  bool inside = false; // cards come in their order
  std::erase_if(text, [&](const DeckCard& card) {
    inside = card.name == "NET" ? nets.contains(card.word_value("NAME")) : inside;
    const bool dropped = inside;
    inside = inside && card.name != "ENDNET";
    return dropped;
  });
}

} // namespace

std::string twelve_digits(double value) {
  return fmt::format("{:.12g}", value);
}

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
  change_lines(card, [&](const std::string& line, const std::vector<std::string>& fields) {
    return fields.empty() || keep(fields) ? line : std::string();
  });
}

void filter_actions(DeckCard& step,
                    const std::function<bool(const std::string&, const std::string&)>& keep) {
  filter_lines(step, [&](const std::vector<std::string>& fields) {
    return keep(grammar::to_upper(fields.front()),
                fields.size() < 2 ? std::string() : grammar::to_upper(fields[1]));
  });
}

void drop_mounts(DeckText& text) {
  for (DeckCard& card : cards_named(text, "STEP")) {
    filter_actions(card, [](const std::string& action, const std::string&) {
      return action != "MOUNT" && action != "DISMOUNT";
    });
  }
  for (DeckCard& card : cards_named(text, "GROW")) {
    card.erase("MOUNTED");
  }
}

void drop_fits(DeckText& text, const std::set<std::string>& contacts) {
  for (DeckCard& card : cards_named(text, "STEP")) {
    filter_actions(card, [&](const std::string& action, const std::string& contact) {
      return action != "FIT" || !contacts.contains(contact);
    });
  }
}

std::set<std::string> remove_nets(DeckText& text, const std::set<std::string>& nets) {
  erase_nets(text, nets);
  std::set<std::string> contacts;
  for (const DeckCard& card : cards_named(text, "CONTACT")) {
    if (stands_on(card, nets)) {
      contacts.insert(card.word_value("NAME"));
    }
  }
  std::erase_if(text, [&](const DeckCard& card) { return stands_on(card, nets); });
  for (DeckCard& card : text) {
    const bool had_lines = !data_fields(card.data).empty();
    if (card.name == "LOAD") {
      filter_lines(card, [&](const auto& fields) { return !names_net({fields.front()}, nets); });
    } else if (lists_sets(card.name)) {
      keep_items(card, nets);
    } else {
      continue;
    }
    card.name = had_lines && data_fields(card.data).empty() ? "" : card.name; // nothing is left
  }
  std::erase_if(text, [](const DeckCard& card) { return card.name.empty(); });
  for (DeckCard& card : cards_named(text, "STEP")) {
    filter_actions(card, [&](const std::string& action, const std::string& contact) {
      return action == "LOAD" || !contacts.contains(contact);
    });
  }
  return contacts;
}

void drop_undefined_loads(DeckText& text) {
  std::set<std::string> cases;
  for (const DeckCard& card : cards_named(text, "LOAD")) {
    cases.insert(card.word_value("CASE"));
  }
  for (DeckCard& card : cards_named(text, "STEP")) {
    filter_actions(card, [&](const std::string& action, const std::string& load_case) {
      return action != "LOAD" || load_case.empty() || cases.contains(load_case);
    });
  }
}

void apply_defines(DeckText& text,
                   const std::vector<std::pair<std::string, std::string>>& defines) {
  for (DeckCard& card : cards_named(text, "PARAMETER")) {
    change_lines(card, [&](const std::string& line, const std::vector<std::string>&) {
      const std::vector<std::string> left =
          data_fields(line.substr(0, std::min(line.find('='), line.size())));
      const auto own = std::ranges::find_if(defines, [&](const auto& define) {
        return left.size() == 1 && grammar::to_upper(define.first) == grammar::to_upper(left[0]);
      });
      return own == defines.end() ? line : fmt::format("  {} = {}\n", left[0], own->second);
    });
  }
}

void drop_requests(DeckText& text) {
  std::erase_if(text, [](const DeckCard& card) {
    constexpr std::array names{"CHECK", "OUTPUT", "RESTART", "SWEEP", "TEST"};
    return std::ranges::find(names, card.name) != names.end();
  });
}

DeckCard rigid_line(const std::string& name, const base::Vec3& first, const base::Vec3& second) {
  return deck::make_card("RIGID", {{"NAME", name},
                                   {"SHAPE", "LINE"},
                                   {"X0", twelve_digits(first.x())},
                                   {"Y0", twelve_digits(first.y())},
                                   {"X1", twelve_digits(second.x())},
                                   {"Y1", twelve_digits(second.y())}});
}

DeckCard rigid_circle(const std::string& name, const base::Vec3& centre, double radius) {
  return deck::make_card("RIGID", {{"NAME", name},
                                   {"SHAPE", "ARC"},
                                   {"X0", twelve_digits(centre.x())},
                                   {"Y0", twelve_digits(centre.y())},
                                   {"R", twelve_digits(radius)}});
}

} // namespace spricka::program
