// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/header_without_dollar.hpp"
#include "deck/output_units.hpp"
#include "deck/overrides.hpp"
#include "deck/unit_warnings.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::DataLineForm;
using grammar::KeyType;

/// Walks the cards in deck order: parameters come before their use, nets open and close.
class DeckBinder {
public:
  explicit DeckBinder(DeckContext& context) : c_(context) {}

  void defines(const DeckReadOptions& options) { overrides_.read(c_, options); }

  void card(const grammar::CardHeader& card) {
    const grammar::CardSpec* spec = grammar::find_card(card.name);
    if (spec == nullptr) {
      unknown(card);
      return;
    }
    bind(card, *spec);
  }

  void finish() {
    if (net_open_) {
      c_.error(c_.model.nets.back().span, "E114", "the net is not closed with $ENDNET");
    }
    if (!c_.scope.incomplete && !parameters_bad_) {
      overrides_.report_unknown_parameters(c_, defined_);
    }
  }

private:
  void bind(const grammar::CardHeader& card, const grammar::CardSpec& known) {
    const grammar::CardSpec* const spec = &known;
    CheckedCard bound = check_card_header(card, *spec, c_.scope, c_.diagnostics);
    if (spec->once && !seen_.insert(spec->name).second) {
      c_.error(card.name_span, "E119", fmt::format("${} is given twice", spec->name));
      bound.bad = true;
    }
    frame(card, bound);
    bound.net = net_;
    bound.net_id = net_id_;
    for (CheckedValue& value : bound.values) {
      for (NameReference& name : value.names) {
        name.net = net_;
      }
    }
    data(card, bound);
    if (!bound.bad) {
      note_unavailable(bound);
    }
    c_.cards.push_back(std::move(bound));
  }

  void set(const std::string& upper, const std::string& written, std::optional<double> value) {
    if (value) {
      c_.scope.values[upper] = *value;
      c_.parameters.emplace_back(written, *value);
    } else {
      c_.scope.poisoned.insert(upper);
    }
  }

  void unknown(const grammar::CardHeader& card) {
    std::vector<std::string> valid;
    for (const grammar::CardSpec& spec : grammar::card_catalogue()) {
      valid.push_back(fmt::format("${}", spec.name));
    }
    const std::string hint = base::make_spelling_hint(fmt::format("${}", card.name), valid);
    if (!card.name.empty()) {
      c_.error(card.name_span, "E104", fmt::format("there is no card ${}", card.name), hint);
    }
    const auto meant = std::ranges::find_if(
        valid, [&](const std::string& v) { return hint.ends_with("'" + v + "'?"); });
    if (meant != valid.end()) {
      misspelt(card, *grammar::find_card(meant->substr(1)));
    }
    for (const grammar::HeaderParameter& p : card.parameters) {
      for (const grammar::CardField& field : p.values) {
        if (!field.text.empty()) {
          c_.names.poison_name_ending(field.text);
        }
      }
    }
  }

  // What the misspelt card would have defined is poisoned, and a net opened or closed.
  void misspelt(const grammar::CardHeader& card, const grammar::CardSpec& spec) {
    grammar::CardHeader meant = card;
    meant.name = spec.name;
    base::Diagnostics silent;
    CheckedCard bound = check_card_header(meant, spec, c_.scope, silent);
    bound.bad = true;
    if (spec.name == "NET" || spec.name == "ENDNET") {
      frame(meant, bound);
    }
    c_.scope.incomplete = c_.scope.incomplete || spec.name == "PARAMETER";
    bound.net = net_;
    bound.net_id = net_id_;
    c_.cards.push_back(std::move(bound));
  }

  // $DECK sets the units, $NET and $ENDNET the scope.
  void frame(const grammar::CardHeader& card, const CheckedCard& bound) {
    if (card.name == "DECK") {
      if (const auto units =
              base::make_unit_system(bound.word_value("LENGTH"), bound.word_value("FORCE"))) {
        c_.scope.units = *units;
        c_.model.units = *units;
        c_.model.units.output = read_output_units(c_, bound, *units);
        warn_of_mixed_units(c_, card.name_span, *units);
      }
      c_.model.title = bound.word_value("TITLE");
    } else if (card.name == "NET") {
      open_net(bound);
    } else if (card.name == "ENDNET") {
      if (!net_open_ && unclosed_ == 0) {
        c_.error(card.name_span, "E114", "$ENDNET without an open $NET");
      }
      unclosed_ -= !net_open_ && unclosed_ > 0 ? 1 : 0;
      net_open_ = false;
      net_.clear();
      net_id_ = base::NetId(0);
    }
  }

  void open_net(const CheckedCard& bound) {
    if (net_open_) {
      c_.error(bound.span, "E114", fmt::format("net {} is still open; nets do not nest", net_),
               "close it with $ENDNET");
      ++unclosed_;
    }
    net_open_ = true;
    net_ = bound.word_value("NAME");
    if (c_.find_net(net_).index() < c_.model.nets.size() && !bound.bad) {
      c_.error(bound.find("NAME")->span, "E302", fmt::format("net {} is defined twice", net_));
      c_.property_sound = false; // which of the two a set means is not known
    }
    net_id_ = base::NetId(c_.model.nets.size());
    c_.model.nets.push_back({net_, bound.span});
  }

  void data(const grammar::CardHeader& card, CheckedCard& bound) {
    const std::size_t before = c_.diagnostics.error_count();
    switch (bound.spec->data) {
    case DataLineForm::assignments:
      parameters(card);
      break;
    case DataLineForm::rows:
      bound.rows = grammar::parse_data_rows(c_.sources, card.data, c_.diagnostics);
      break;
    case DataLineForm::none:
      no_data(card);
      break;
    case DataLineForm::table: // read when the mesh is built
      break;
    }
    bound.rows_bad = c_.diagnostics.error_count() > before;
    drop_header_without_dollar(c_, bound);
    const bool empty = !first_token(card).valid();
    if (bound.spec->data_required && empty) {
      c_.error(card.name_span, "E115", fmt::format("${} needs data lines", bound.spec->name),
               std::string(bound.spec->data_form));
    }
  }

  // The first token behind the header; invalid if there is none.
  [[nodiscard]] base::SourceSpan first_token(const grammar::CardHeader& card) const {
    const std::string_view text = c_.sources.text(card.data);
    const char* p = text.data();
    const char* const last = p + text.size();
    for (p = grammar::skip_blanks_and_comments(p, last); p < last && *p == '\n';) {
      p = grammar::skip_blanks_and_comments(p + 1, last);
    }
    if (p >= last) {
      return {};
    }
    const auto begin = card.data.begin + static_cast<std::uint32_t>(p - text.data());
    const char* const end = std::max(grammar::scan_token(p, last), p + 1);
    return {card.data.file, begin, begin + static_cast<std::uint32_t>(end - p)};
  }

  void no_data(const grammar::CardHeader& card) {
    if (const base::SourceSpan token = first_token(card); token.valid()) {
      const bool continues = c_.sources.text(token).starts_with('&');
      c_.error(token, "E115", fmt::format("${} takes no data lines", card.name),
               continues ? "a continued line follows at once"
                         : card_name_hint(c_.sources.text(token)));
    }
  }

  void parameters(const grammar::CardHeader& card) {
    const std::size_t before = c_.diagnostics.error_count();
    for (const grammar::ParameterAssignment& a :
         grammar::parse_parameter_assignments(c_.sources, card.data, c_.diagnostics)) {
      if (grammar::is_reserved_name(a.name)) {
        c_.error(a.name_span, "E208", fmt::format("'{}' is a word of the language", a.written),
                 "choose another name");
      } else if (!defined_.insert(a.name).second) {
        c_.error(a.name_span, "E207", fmt::format("parameter '{}' is defined twice", a.written));
      } else {
        const auto value = a.value.terms.empty()
                               ? std::nullopt
                               : grammar::evaluate_constant(a.value, c_.scope, c_.diagnostics);
        const bool overridden = overrides_.contains(a.name);
        set(a.name, a.written, overridden ? overrides_.value(c_, a.name) : value);
        if (overridden && value) {
          overrides_.warn_of_missing_unit(c_, a);
        }
        const base::SourceSpan unit =
            overridden ? overrides_.unit_span(a.name)
                       : grammar::explicit_or_parameter_unit_span(a.value, c_.scope);
        if (unit.valid()) {
          c_.scope.units_of[a.name] = unit;
        } else if (overridden ? overrides_.has_unit(c_, a) : grammar::has_unit(a.value, c_.scope)) {
          c_.scope.made_of_units.insert(a.name);
        }
      }
    }
    parameters_bad_ = parameters_bad_ || c_.diagnostics.error_count() > before;
  }

  // What is understood, but has no analysis in this version.
  void note_unavailable(const CheckedCard& bound) {
    for (const CheckedValue& value : bound.values) {
      const std::string_view later = value.key->later;
      if (later.empty() || !value.given) {
        continue;
      }
      const std::vector<std::string> words = grammar::split_words(later);
      const bool hit = later == "*" || (later == ">0" && value.number > 0.0) ||
                       std::ranges::find(words, value.text) != words.end();
      if (hit) {
        c_.record_unavailable_analysis(fmt::format("${} {}{}{}", bound.spec->name, value.key->name,
                                                   value.text.empty() || later == "*" ? "" : "=",
                                                   later == "*" ? "" : value.text),
                                       value.span);
      }
    }
  }

  DeckContext& c_;
  std::string net_;
  base::NetId net_id_{std::size_t{0}};
  bool net_open_ = false;
  int unclosed_ = 0; ///< nets that were open when another was opened: their $ENDNET may follow
  std::set<std::string_view> seen_;
  std::set<std::string> defined_;
  ParameterOverrides overrides_;
  bool parameters_bad_ = false;
};

bool is_set(EntityKind kind) {
  return kind == EntityKind::node_set || kind == EntityKind::element_set ||
         kind == EntityKind::face_set;
}

// The names that a bad card would have defined.
void poison_names(DeckContext& c, const CheckedCard& card) {
  for (const grammar::KeySpec& key : card.spec->keys) {
    if (key.type != KeyType::name) {
      continue;
    }
    const CheckedValue* value = card.find(key.name);
    if (value != nullptr && value->sound) {
      c.names.poison(key.kind,
                     is_set(key.kind) ? qualified_name(card.net, value->text) : value->text);
    } else if (value != nullptr || key.required) {
      c.names.poison_kind(key.kind);
    }
  }
  for (const std::string& word : card.stray) {
    c.names.poison_name_ending(word);
  }
  if (card.spec->name == "MESH" || card.spec->name == "IMPORT") {
    c.names.poison_net(card.net);
    c.mesh_sound = false;
  } else if (card.spec->name == "COOR" || card.spec->name == "ELEMENT") {
    c.mesh_sound = false;
  } else if (card.spec->name == "PROPERTY") {
    c.property_sound = false;
  } else if (card.spec->name == "INCLUDE" || card.spec->name == "NET") {
    c.names.poison_everything();
    c.scope.incomplete = true;
    c.mesh_sound = false;
    c.property_sound = false;
  }
}

// Entities are numbered in deck order, one for each card of their kind.
void declare_names(DeckContext& c) {
  std::map<EntityKind, std::size_t> count;
  for (std::size_t i = 0; i < c.cards.size(); ++i) {
    CheckedCard& card = c.cards[i];
    const CheckedValue* name = card.find("NAME");
    if (card.bad) {
      poison_names(c, card);
      continue;
    }
    if (name == nullptr || name->key->type != KeyType::name) {
      continue;
    }
    NameDefinition definition;
    definition.kind = name->key->kind;
    definition.span = name->span;
    if (is_set(definition.kind)) {
      definition.card = i;
    } else {
      definition.index = count[definition.kind];
    }
    const std::string full =
        is_set(definition.kind) ? qualified_name(card.net, name->text) : name->text;
    const NameDefinition* before = c.names.define(full, definition);
    if (before != nullptr && !before->poisoned && definition.kind != EntityKind::net) {
      // Not built, so it takes no number: those behind it would mean the wrong entities.
      card.bad = true;
      c.report_duplicate_name(definition, name->text, *before);
    } else if (!is_set(definition.kind)) {
      ++count[definition.kind];
    }
  }
}

} // namespace

const NameDefinition* find_referenced_definition(DeckContext& context, EntityKind kind,
                                                 const NameReference& reference) {
  const std::vector<EntityKind> kinds = accepted_kinds(kind);
  const NameDefinition* found = context.names.find(kinds, reference.name, reference.net);
  if (found != nullptr) {
    return found->poisoned ? nullptr : found;
  }
  if (!reference.name.empty() && !context.names.is_poisoned(kinds, reference.name, reference.net)) {
    context.error(reference.span, "E301",
                  fmt::format("there is no {} '{}'", grammar::display_name(kind), reference.name),
                  base::is_below_hint_error_limit(context.diagnostics)
                      ? context.names.similar_name_hint(kinds, reference.name)
                      : "");
  }
  return nullptr;
}

bool check_contact_or_crack_faces(DeckContext& context, const NameReference& reference) {
  constexpr std::string_view faces = ".FACES";
  if (!reference.name.ends_with(faces)) {
    return find_referenced_definition(context, EntityKind::contact, reference) != nullptr;
  }
  NameReference crack = reference;
  crack.name.resize(crack.name.size() - faces.size());
  return find_referenced_definition(context, EntityKind::crack, crack) != nullptr;
}

void check_references_of_bad_cards(DeckContext& context) {
  for (const CheckedCard& card : context.cards) {
    for (const CheckedValue& value : card.values) {
      const bool refers =
          value.key->type == KeyType::reference || value.key->type == KeyType::references;
      if (!card.bad || !value.sound || !refers || value.key->kind == EntityKind::parameter ||
          value.key->kind == EntityKind::solid || value.key->kind == EntityKind::law) {
        continue;
      }
      for (const NameReference& name : value.names) {
        if (!is_no_interaction(value.key->kind, name)) {
          find_referenced_definition(context, value.key->kind, name);
        }
      }
    }
  }
}

void check_cards_and_define_names(DeckContext& context,
                                  const std::vector<grammar::CardHeader>& cards,
                                  const DeckReadOptions& options) {
  context.scope.sources = &context.sources;
  context.model.nets.push_back({}); // what stands outside every $NET
  DeckBinder binder(context);
  // $DECK comes first, so that units of definitions on the command line are known
  bool defined = false;
  for (const grammar::CardHeader& card : cards) {
    binder.card(card);
    if (!defined) {
      binder.defines(options);
      defined = true;
    }
  }
  binder.finish();
  context.model.parameters = context.parameters;
  declare_names(context);
}

} // namespace spricka::deck
