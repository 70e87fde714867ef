// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/deck_edits.hpp"

#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckCardList;

/// The data lines of a card as the grammar reads them.
struct ParsedData {
  base::SourceTexts sources;
  base::SourceSpan span;

  explicit ParsedData(const DeckCard& card) {
    span = {sources.add_text(card.name, card.data), 0,
            static_cast<std::uint32_t>(card.data.size())};
  }
  [[nodiscard]] std::vector<grammar::DataRow> rows() const {
    base::Diagnostics read_before;
    return grammar::parse_data_rows(sources, span, read_before);
  }
  [[nodiscard]] DataFields fields(const grammar::DataRow& row) const {
    DataFields fields;
    for (const grammar::CardField& field : row.fields) {
      fields.emplace_back(sources.text(field.span));
    }
    return fields;
  }
};

bool names_net(const std::string& field, const std::set<std::string>& nets) {
  return nets.contains(net_prefix(std::string_view(field).substr(field.starts_with('-') ? 1 : 0)));
}

// A card that is nothing without what it names there.
bool stands_on(const DeckCard& card, const std::set<std::string>& nets) {
  constexpr std::array keys{"ESET", "SLAVE", "MASTER", "FROM", "PATH", "FRONT"};
  return std::ranges::any_of(keys, [&](const char* key) {
    const std::string* value = card.find(key);
    return value != nullptr && nets.contains(net_prefix(*value));
  });
}

void erase_nets(DeckCardList& text, const std::set<std::string>& nets) {
  bool inside = false; // cards come in their order
  std::erase_if(text, [&](const DeckCard& card) {
    inside = card.name == "NET" ? nets.contains(card.word_value("NAME")) : inside;
    const bool dropped = inside;
    inside = inside && card.name != "ENDNET";
    return dropped;
  });
}

// Takes out lines of loads and items of lists that name the nets; false: nothing is left.
bool keep_other_nets(DeckCard& card, const std::set<std::string>& nets) {
  constexpr std::array names{"LOAD", "NSET", "ESET", "FSET", "FREEDOM"};
  if (std::ranges::find(names, card.name) == names.end() || split_data_line_fields(card).empty()) {
    return true;
  }
  rewrite_data_lines(card, [&](const DataFields& fields, std::string& line) {
    const auto own = [&](const std::string& field) { return names_net(field, nets); };
    if (card.name == "LOAD") {
      line = own(fields.front()) ? "" : line;
    } else if (std::ranges::any_of(fields, own)) {
      line.clear();
      for (const std::string& field : fields) {
        line += own(field) ? "" : " " + field;
      }
      line += line.empty() ? "" : "\n";
    }
  });
  return !split_data_line_fields(card).empty();
}

} // namespace

std::string format_twelve_digits(double value) {
  return fmt::format("{:.12g}", value);
}

std::string net_prefix(std::string_view name) {
  const std::size_t point = name.find('.');
  return point == std::string_view::npos ? std::string() : grammar::to_upper(name.substr(0, point));
}

std::vector<DataFields> split_data_line_fields(const DeckCard& card) {
  const ParsedData data(card);
  std::vector<DataFields> rows;
  for (const grammar::DataRow& row : data.rows()) {
    rows.push_back(data.fields(row));
  }
  return rows;
}

void rewrite_data_lines(DeckCard& card,
                        const std::function<void(const DataFields&, std::string& line)>& change) {
  const ParsedData data(card);
  const std::string text = card.data;
  const char* const last = text.data() + text.size();
  std::string changed;
  std::size_t at = 0; // what is in front of it is done
  for (const grammar::DataRow& row : data.rows()) {
    const std::size_t begin = text.rfind('\n', row.span.begin) + 1; // behind npos: 0
    const char* const end = grammar::logical_line_end(text.data() + row.span.begin, last);
    const std::size_t next = static_cast<std::size_t>(end - text.data()) + (end == last ? 0 : 1);
    std::string line = text.substr(begin, next - begin);
    change(data.fields(row), line);
    changed += text.substr(at, begin - at) + line;
    at = next;
  }
  card.data = changed + text.substr(at);
}

void filter_data_lines(DeckCard& card, const std::function<bool(const DataFields&)>& keep) {
  rewrite_data_lines(
      card, [&](const DataFields& fields, std::string& line) { line = keep(fields) ? line : ""; });
}

void filter_step_actions(DeckCardList& text,
                         const std::function<bool(const std::string&, const std::string&)>& keep) {
  for (DeckCard& card : cards_named(text, "STEP")) {
    filter_data_lines(card, [&](const DataFields& fields) {
      return keep(grammar::to_upper(fields.front()),
                  fields.size() < 2 ? std::string() : grammar::to_upper(fields[1]));
    });
  }
}

std::string transform_names_in_text(std::string_view text,
                                    const std::function<std::string(std::string_view)>& change) {
  std::string changed;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    std::size_t end = i + 1;
    if (grammar::is_name_char(c)) {
      while (end < text.size() && grammar::is_name_char(text[end])) {
        ++end;
      }
    } else if (c == '!') {
      end = std::min(text.find('\n', i), text.size());
    } else if (c == '\'' || c == '[') {
      end = std::min(text.find(c == '[' ? ']' : c, i + 1), text.size() - 1) + 1;
    }
    const std::string_view piece = text.substr(i, end - i);
    changed += grammar::is_letter(c) ? change(piece) : std::string(piece); // else of a number
    i = end;
  }
  return changed;
}

void remove_mount_actions(DeckCardList& text) {
  filter_step_actions(text, [](const std::string& action, const std::string&) {
    return action != "MOUNT" && action != "DISMOUNT";
  });
  for (DeckCard& card : cards_named(text, "GROW")) {
    card.erase("MOUNTED");
  }
}

std::set<std::string> remove_nets_with_dependents(DeckCardList& text,
                                                  const std::set<std::string>& nets) {
  erase_nets(text, nets);
  std::set<std::string> contacts;
  for (const DeckCard& card : cards_named(text, "CONTACT")) {
    if (stands_on(card, nets)) {
      contacts.insert(card.word_value("NAME"));
    }
  }
  DeckCardList kept;
  for (DeckCard& card : text) {
    if (!stands_on(card, nets) && keep_other_nets(card, nets)) {
      kept.push_back(std::move(card));
    }
  }
  text = std::move(kept);
  filter_step_actions(text, [&](const std::string& action, const std::string& contact) {
    return action == "LOAD" || !contacts.contains(contact);
  });
  return contacts;
}

void drop_undefined_loads(DeckCardList& text) {
  std::set<std::string> cases;
  for (const DeckCard& card : cards_named(text, "LOAD")) {
    cases.insert(card.word_value("CASE"));
  }
  filter_step_actions(text, [&](const std::string& action, const std::string& load_case) {
    return action != "LOAD" || load_case.empty() || cases.contains(load_case);
  });
}

void remove_checks_and_requests(DeckCardList& text) {
  std::erase_if(text, [](const DeckCard& card) {
    constexpr std::array names{"CHECK", "OUTPUT", "RESTART", "SWEEP", "TEST"};
    return std::ranges::find(names, card.name) != names.end();
  });
}

DeckCard make_rigid_line_card(const std::string& name, const base::Vec3& first,
                              const base::Vec3& second) {
  return deck::make_card("RIGID", {{"NAME", name},
                                   {"SHAPE", "LINE"},
                                   {"X0", format_twelve_digits(first.x())},
                                   {"Y0", format_twelve_digits(first.y())},
                                   {"X1", format_twelve_digits(second.x())},
                                   {"Y1", format_twelve_digits(second.y())}});
}

DeckCard make_rigid_circle_card(const std::string& name, const base::Vec3& centre, double radius) {
  return deck::make_card("RIGID", {{"NAME", name},
                                   {"SHAPE", "ARC"},
                                   {"X0", format_twelve_digits(centre.x())},
                                   {"Y0", format_twelve_digits(centre.y())},
                                   {"R", format_twelve_digits(radius)}});
}

namespace {

/// Factors of fits and load cases, by {"LOAD", name}.
using ActionFactors = std::map<std::pair<std::string, std::string>, double>;

// Those at the end of a step.
ActionFactors factors_after(const model::Model& model, std::size_t step) {
  ActionFactors factors;
  for (std::size_t s = 0; s <= step; ++s) {
    for (const model::StepAction& action : model.steps[s].actions) {
      if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
        factors[{"LOAD", model.cases[load->load_case.index()].name}] = load->factor;
      } else if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
        factors[{"FIT", model.contacts[fit->contact.index()].name}] = fit->factor;
      }
    }
  }
  return factors;
}

// LOAD SHAFTLOAD 0.3, for each of what either end has.
std::string lines_at(const ActionFactors& from, const ActionFactors& to, double t) {
  ActionFactors between;
  for (const auto& [action, factor] : from) {
    between[action] = (1.0 - t) * factor;
  }
  for (const auto& [action, factor] : to) {
    between[action] += t * factor;
  }
  std::string lines;
  for (const auto& [action, factor] : between) {
    lines += fmt::format("  {} {} {:.12g}\n", action.first, action.second, factor);
  }
  return lines;
}

// Without lines of $CHECK that name a path.
void drop_path_checks(DeckCardList& text) {
  for (DeckCard& card : cards_named(text, "CHECK")) {
    filter_data_lines(card, [](const DataFields& fields) {
      return std::ranges::none_of(fields, [](const std::string& field) {
        return grammar::to_upper(field).find("PATH.") != std::string::npos;
      });
    });
  }
  std::erase_if(text, [](const DeckCard& card) {
    return card.name == "CHECK" && split_data_line_fields(card).empty();
  });
}

} // namespace

std::string import_format(const DeckCard& card) {
  if (card.name != "IMPORT" || card.has_key("FORMAT")) {
    return card.name == "IMPORT" ? card.word_value("FORMAT") : std::string();
  }
  const std::string ending = std::filesystem::path(card.word_value("FILE")).extension().string();
  return ending.empty() ? ending : ending.substr(1);
}

bool replace_load_paths_by_steps(DeckCardList& text, const model::Model& model) {
  if (model.load_paths.empty() || !model.spectra.empty()) {
    return false;
  }
  std::erase_if(text, [](const DeckCard& card) { return card.name == "LOADPATH"; });
  drop_path_checks(text);
  constexpr int steps = 10;
  for (const model::LoadPathDefinition& path : model.load_paths) {
    const ActionFactors from = factors_after(model, path.from.index());
    const ActionFactors to = factors_after(model, path.to.index());
    for (int i = 1; i <= steps; ++i) {
      const double t = path.beyond * i / steps;
      append_card(text, deck::make_card("STEP", {{"NAME", fmt::format("{}_{}", path.name, i)}},
                                        lines_at(from, to, t)));
    }
  }
  return true;
}

} // namespace spricka::program
