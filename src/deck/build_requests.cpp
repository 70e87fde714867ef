// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/checks.hpp"
#include "deck/sets.hpp"
#include "deck/unit_warnings.hpp"
#include "grammar/lexeme.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

// What an $OUTPUT line may ask for, and of what.
struct Request {
  std::string_view word;
  EntityKind kind;
};
constexpr std::array<Request, 5> requests{{{"U", EntityKind::any_set},
                                           {"S", EntityKind::any_set},
                                           {"CPRESS", EntityKind::contact},
                                           {"K", EntityKind::crack},
                                           {"REACTION", EntityKind::any_set}}};

// Files of every run folder or sweep; none is given away.
constexpr std::array<std::string_view, 17> own_files{
    "k.csv",       "sensitivity.csv", "pressure.csv",
    "listing.txt", "load_path.csv",   "load_path_fronts.csv",
    "life.csv",    "life_curve.csv",  "spectrum.csv",
    "beta.csv",    "report.html",     "results.pvd",
    "results.h5",  "test.csv",        "sweep.csv",
    "sweep.html",  "point.json"};

// Why a file in the run folder cannot have this name, which is that of FILE without its folders;
// empty: it can.
std::string why_not(const DeckContext& c, const model::OutputFileRequest& output,
                    const std::string& name) {
  const std::string named = name == output.file ? fmt::format("'{}'", name)
                                                : fmt::format("'{}' ('{}')", name, output.file);
  const bool control = std::ranges::any_of(
      name, [](char letter) { return static_cast<unsigned char>(letter) < 0x20U; });
  if (name.empty() || name == "." || name == ".." || control || name.size() > 200) {
    return fmt::format("'{}' is not the name of a file", output.file);
  }
  if (std::ranges::find(own_files, name) != own_files.end() || name.starts_with(".spricka")) {
    return fmt::format("{} is a file that every run writes", named);
  }
  if (output.format == model::OutputFormat::vtu) {
    return {};
  }
  if (name.ends_with(".vtu") || name.ends_with(".pvd") || name.ends_with(".part")) {
    return fmt::format("{} is the name of a picture or of a file that is being written", named);
  }
  const bool twice =
      std::ranges::any_of(c.model.outputs, [&](const model::OutputFileRequest& other) {
        return other.format == output.format &&
               std::filesystem::path(other.file).filename() == name;
      });
  return twice ? fmt::format("{} is written by another $OUTPUT already", named) : std::string();
}

void output(DeckContext& c, const CheckedCard& card) {
  model::OutputFileRequest output;
  output.file = card.word_value("FILE");
  output.format = card.key_has_word("FORMAT", "VTU")   ? model::OutputFormat::vtu
                  : card.key_has_word("FORMAT", "CSV") ? model::OutputFormat::csv
                                                       : model::OutputFormat::json;
  const std::string name =
      std::filesystem::path(output.file).lexically_normal().filename().string();
  const std::string why = card.bad ? std::string() : why_not(c, output, name);
  if (!why.empty()) {
    c.error(card.find("FILE")->span, "E322", "FILE: " + why,
            "another name; it counts without its folders, as all files lie in the run folder");
  } else {
    output.file = name;
  }
  output.every = card.key_has_word("EVERY", "STEP")        ? model::OutputFrequency::step
                 : card.key_has_word("EVERY", "INCREMENT") ? model::OutputFrequency::increment
                                                           : model::OutputFrequency::end;
  output.span = card.span;
  for (const grammar::DataRow& row : card.rows) {
    const auto* const it = std::ranges::find_if(requests, [&](const Request& r) {
      return row.fields.front().is_name() && r.word == row.fields.front().text;
    });
    if (it == requests.end()) {
      c.error(row.fields.front().span, "E115",
              fmt::format("'{}' is not a result", c.sources.text(row.fields.front().span)),
              std::string(card.spec->data_form));
      continue;
    }
    if (row.fields.size() != 2 || !row.fields[1].is_name()) {
      c.error(row.span, "E115",
              fmt::format("a line is {} {}", it->word, grammar::display_name(it->kind)));
      continue;
    }
    const bool set = it->kind == EntityKind::any_set;
    const NameReference reference{row.fields[1].text, row.fields[1].span, card.net};
    if (set ? resolve_set_kind(c, it->kind, reference).has_value()
        : it->kind == EntityKind::contact
            ? check_contact_or_crack_faces(c, reference)
            : find_referenced_definition(c, it->kind, reference) != nullptr) {
      const std::string own = qualified_name(card.net, reference.name);
      const bool inside = set && c.names.find(accepted_kinds(it->kind), own, {}) != nullptr;
      output.requests.push_back({std::string(it->word), inside ? own : reference.name, row.span});
    }
  }
  if (!card.bad) {
    c.model.outputs.push_back(std::move(output));
  }
}

void control(DeckContext& c, const CheckedCard& card) {
  c.model.control.max_iterations = card.integer_value("MAXITER");
  c.model.control.tolerance = card.number_value("TOL");
  c.model.control.threads = card.integer_value("THREADS");
  c.model.control.engine =
      base::equation_engine_of_word(card.word_value("ENGINE")).value_or(c.model.control.engine);
  if (card.has_key("SHOW")) {
    if (const NameDefinition* const step =
            find_referenced_definition(c, EntityKind::step, card.name_reference("SHOW"))) {
      c.model.control.shown_step = base::StepId(step->index);
    }
  }
}

void restart(DeckContext& c, const CheckedCard& card) {
  model::RestartFiles restart;
  restart.read = card.word_value("READ");
  if (card.has_key("AT")) {
    restart.at = card.integer_value("AT");
  }
  restart.write = card.word_value("WRITE");
  restart.every = card.integer_value("EVERY");
  restart.span = card.span;
  for (const std::string_view key : {"READ", "WRITE"}) {
    if (card.has_key(key) && card.word_value(key).empty()) {
      c.error(card.find(key)->span, "E108", fmt::format("{}: the name of the file is empty", key));
    }
  }
  if (!card.has_key("READ") && !card.has_key("WRITE")) {
    c.error(card.span, "E106", "$RESTART needs READ or WRITE", "WRITE='file.rst' keeps states");
  }
  if (c.find_first_card("SWEEP") != nullptr && card.has_key("READ")) {
    c.error(card.find("READ")->span, "E110", "READ and $SWEEP exclude each other",
            "each point keeps its own state; run --restart goes on with it");
  }
  c.model.restart = std::move(restart);
}

// What a $TASK leaves out although cards ask for it: the chain is not cut short in this version.
void left_out(DeckContext& c, const CheckedCard& card) {
  struct Need {
    std::string_view processor, card;
  };
  for (const Need& need : {Need{"CONTACT", "CONTACT"}, Need{"VCE", "CRACK"}, Need{"GROW", "GROW"},
                           Need{"OUTPUT", "OUTPUT"}, Need{"STIFFNESS", "STEP"}}) {
    const std::vector<std::string>& tasks = c.model.tasks;
    if (c.find_first_card(need.card) != nullptr &&
        std::ranges::find(tasks, need.processor) == tasks.end()) {
      c.record_unavailable_analysis(
          fmt::format("$TASK without {} in a deck with ${}", need.processor, need.card), card.span);
    }
  }
}

void task(DeckContext& c, const CheckedCard& card) {
  const std::vector<std::string> valid = grammar::split_words(card.spec->data_form);
  std::size_t last = 0;
  for (const grammar::DataRow& row : card.rows) {
    for (const CardField& field : row.fields) {
      const auto it = std::ranges::find(valid, field.text);
      if (!field.is_name() || it == valid.end()) {
        c.error(field.span, "E108",
                fmt::format("'{}' is not a processor", c.sources.text(field.span)),
                base::make_spelling_hint(field.text, valid));
        continue;
      }
      const auto place = static_cast<std::size_t>(it - valid.begin()) + 1;
      if (place <= last) {
        c.error(field.span, "E108", fmt::format("{} is out of order", field.text),
                std::string(card.spec->data_form));
      }
      last = std::max(last, place);
      c.model.tasks.push_back(field.text);
    }
  }
  left_out(c, card);
}

// The parameter's name as the deck defines it. Empty after an error.
std::string swept_parameter(DeckContext& c, const CheckedCard& card, std::string_view key) {
  const std::string name(card.word_value(key));
  const base::SourceSpan span = card.find(key)->span;
  const auto known = std::ranges::find_if(
      c.parameters, [&](const auto& p) { return grammar::to_upper(p.first) == name; });
  if (known == c.parameters.end()) {
    if (!c.scope.poisoned.contains(name) && !c.scope.incomplete) {
      std::vector<std::string> valid;
      for (const auto& [other, value] : c.scope.values) {
        valid.push_back(other);
      }
      c.error(span, "E301", fmt::format("there is no parameter '{}'", name),
              base::make_spelling_hint(name, valid));
    }
    return {};
  }
  if (c.overridden.contains(name)) {
    c.error(span, "E390", fmt::format("parameter {} is swept and given with -D", known->first),
            "leave -D out, or the card");
  }
  const auto swept = [&](const std::vector<std::string>& names) {
    return std::ranges::find(names, known->first) != names.end();
  };
  const bool before = std::ranges::any_of(
      c.model.sweeps, [&](const model::ParameterSweep& s) { return swept(s.parameters); });
  const bool with_itself = key == "WITH" && card.word_value("PARAMETER") == name;
  if (before || with_itself) {
    c.error(span, "E391", fmt::format("parameter {} is swept twice", known->first));
  }
  return known->first;
}

// A parameter's value may have any unit.
std::optional<double> sweep_value(DeckContext& c, const CardField& field, const std::string& name) {
  if (!field.is_number_or_expression()) {
    return c.read_number(field, grammar::QuantityKind::number, "a value");
  }
  const std::optional<double> value =
      grammar::evaluate_constant(field.expression, c.scope, c.diagnostics);
  const auto unit = c.scope.units_of.find(grammar::to_upper(name));
  if (value && unit != c.scope.units_of.end() && !grammar::has_unit(field.expression, c.scope) &&
      is_foreign_unit(c, unit->second)) {
    warn_of_missing_unit(c, field.span, name, *value, unit->second);
  }
  return value;
}

void sweep(DeckContext& c, const CheckedCard& card) {
  model::ParameterSweep sweep;
  sweep.span = card.span;
  for (const std::string_view key : {"PARAMETER", "WITH"}) {
    if (card.has_key(key)) {
      sweep.parameters.push_back(swept_parameter(c, card, key));
    }
  }
  const std::size_t columns = sweep.parameters.size();
  for (const grammar::DataRow& row : card.rows) {
    if (row.fields.size() % columns != 0) {
      c.error(row.span, "E115", "WITH takes values in pairs");
      continue;
    }
    std::vector<double> point;
    for (const CardField& field : row.fields) {
      point.push_back(sweep_value(c, field, sweep.parameters[point.size()]).value_or(0.0));
      if (point.size() == columns) {
        sweep.values.push_back(std::move(point));
        point.clear();
      }
    }
  }
  c.model.sweeps.push_back(std::move(sweep));
}

// Several cards multiply: said before the points are put together.
void limit_sweeps(DeckContext& c) {
  constexpr double most = 1e5;
  double points = 1.0;
  for (const model::ParameterSweep& sweep : c.model.sweeps) {
    points *= static_cast<double>(sweep.values.size());
  }
  if (points > most) {
    c.error(c.model.sweeps.back().span, "E353",
            fmt::format("the $SWEEP cards of this deck make {:.6g} points, the values of each "
                        "times those of the others; at most {:.0f} are taken",
                        points, most),
            "WITH varies two parameters together; fewer values, or several decks");
  }
}

} // namespace

void build_requests(DeckContext& context) {
  for (const CheckedCard& card : context.cards) {
    if (card.spec->name == "OUTPUT") {
      output(context, card);
    } else if (card.bad) {
      continue;
    } else if (card.spec->name == "CHECK") {
      read_checks(context, card);
    } else if (card.spec->name == "CONTROL") {
      control(context, card);
    } else if (card.spec->name == "RESTART") {
      restart(context, card);
    } else if (card.spec->name == "TASK") {
      task(context, card);
    } else if (card.spec->name == "SWEEP") {
      sweep(context, card);
    }
  }
  limit_sweeps(context);
}

} // namespace spricka::deck
