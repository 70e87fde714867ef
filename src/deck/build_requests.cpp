// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/checks.hpp"
#include "deck/sets.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::Field;

// What an $OUTPUT line may ask for, and of what.
struct Request {
  std::string_view word;
  Kind kind;
};
constexpr std::array<Request, 5> requests{{{"U", Kind::any_set},
                                           {"S", Kind::any_set},
                                           {"CPRESS", Kind::contact},
                                           {"K", Kind::crack},
                                           {"REACTION", Kind::any_set}}};

void output(Context& c, const BoundCard& card) {
  model::Output output;
  output.file = card.word("FILE");
  output.format = card.is("FORMAT", "VTU")   ? model::OutputFormat::vtu
                  : card.is("FORMAT", "CSV") ? model::OutputFormat::csv
                                             : model::OutputFormat::json;
  output.every = card.is("EVERY", "STEP")        ? model::OutputEvery::step
                 : card.is("EVERY", "INCREMENT") ? model::OutputEvery::increment
                                                 : model::OutputEvery::end;
  output.span = card.span;
  for (const grammar::Row& row : card.rows) {
    const auto* const it = std::find_if(requests.begin(), requests.end(), [&](const Request& r) {
      return row.fields.front().kind == Field::Kind::name && r.word == row.fields.front().text;
    });
    if (it == requests.end()) {
      c.error(row.fields.front().span, "E115",
              fmt::format("'{}' is not a result", c.sources.text(row.fields.front().span)),
              std::string(card.spec->data_form));
      continue;
    }
    if (row.fields.size() != 2 || row.fields[1].kind != Field::Kind::name) {
      c.error(row.span, "E115",
              fmt::format("a line is {} {}", it->word, grammar::word_of(it->kind)));
      continue;
    }
    const bool set = it->kind == Kind::any_set;
    const Reference reference{row.fields[1].text, row.fields[1].span, card.net};
    if (set ? kind_of_set(c, it->kind, reference).has_value()
            : look_up(c, it->kind, reference) != nullptr) {
      const std::string own = qualify(card.net, reference.name);
      const bool inside = set && c.names.find(meanings(it->kind), own, {}) != nullptr;
      output.requests.push_back({std::string(it->word), inside ? own : reference.name, row.span});
    }
  }
  if (!card.bad) {
    c.model.outputs.push_back(std::move(output));
  }
}

void control(Context& c, const BoundCard& card) {
  c.model.control.max_iterations = card.integer("MAXITER");
  c.model.control.tolerance = card.number("TOL");
  c.model.control.threads = card.integer("THREADS");
}

void restart(Context& c, const BoundCard& card) {
  model::Restart restart;
  restart.read = card.word("READ");
  if (card.has("AT")) {
    restart.at = card.integer("AT");
  }
  restart.write = card.word("WRITE");
  restart.every = card.integer("EVERY");
  restart.span = card.span;
  for (const std::string_view key : {"READ", "WRITE"}) {
    if (card.has(key) && card.word(key).empty()) {
      c.error(card.find(key)->span, "E108", fmt::format("{}: the name of the file is empty", key));
    }
  }
  if (!card.has("READ") && !card.has("WRITE")) {
    c.error(card.span, "E106", "$RESTART needs READ or WRITE", "WRITE='file.rst' keeps states");
  }
  c.model.restart = std::move(restart);
}

// What a $TASK leaves out although cards ask for it: the chain is not cut short in this version.
void left_out(Context& c, const BoundCard& card) {
  const auto has_card = [&](std::string_view name) {
    return std::any_of(c.cards.begin(), c.cards.end(),
                       [&](const BoundCard& other) { return other.spec->name == name; });
  };
  struct Need {
    std::string_view processor, card;
  };
  for (const Need& need : {Need{"CONTACT", "CONTACT"}, Need{"VCE", "CRACK"}, Need{"GROW", "GROW"},
                           Need{"OUTPUT", "OUTPUT"}, Need{"STIFFNESS", "STEP"}}) {
    const std::vector<std::string>& tasks = c.model.tasks;
    if (has_card(need.card) &&
        std::find(tasks.begin(), tasks.end(), need.processor) == tasks.end()) {
      c.unavailable(fmt::format("$TASK without {} in a deck with ${}", need.processor, need.card),
                    card.span);
    }
  }
}

void task(Context& c, const BoundCard& card) {
  const std::vector<std::string> valid = grammar::split_words(card.spec->data_form);
  std::size_t last = 0;
  for (const grammar::Row& row : card.rows) {
    for (const Field& field : row.fields) {
      const auto it = std::find(valid.begin(), valid.end(), field.text);
      if (field.kind != Field::Kind::name || it == valid.end()) {
        c.error(field.span, "E108",
                fmt::format("'{}' is not a processor", c.sources.text(field.span)),
                base::suggest(field.text, valid));
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

void sweep(Context& c, const BoundCard& card) {
  const std::size_t columns = card.has("WITH") ? 2 : 1;
  for (const std::string_view key : {"PARAMETER", "WITH"}) {
    const std::string name(card.word(key));
    if (card.has(key) && !c.scope.values.contains(name) && !c.scope.poisoned.contains(name) &&
        !c.scope.incomplete) {
      std::vector<std::string> valid;
      for (const auto& [known, value] : c.scope.values) {
        valid.push_back(known);
      }
      c.error(card.find(key)->span, "E301", fmt::format("there is no parameter '{}'", name),
              base::suggest(name, valid));
    }
  }
  for (const grammar::Row& row : card.rows) {
    for (const Field& field : row.fields) {
      number_of(field, grammar::Quantity::number, "a value", c.scope, c.diagnostics);
    }
    if (row.fields.size() % columns != 0) {
      c.error(row.span, "E115", "WITH takes values in pairs");
    }
  }
}

} // namespace

void build_requests(Context& context) {
  for (const BoundCard& card : context.cards) {
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
}

} // namespace spricka::deck
