// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/checks.hpp"

#include "deck/dimension_rules.hpp"
#include "deck/sets.hpp"
#include "deck/unit_warnings.hpp"
#include "grammar/lexeme.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

bool is_unknown_word(const DeckContext& c, const grammar::ParsedExpression& e) {
  return e.terms.size() == 1 && e.terms[0].is_name() &&
         !c.scope.values.contains(grammar::to_upper(c.sources.text(e.terms[0].span)));
}

bool is_step_name(const DeckContext& c, const grammar::ParsedExpression& e) {
  return e.terms.size() == 1 && e.terms[0].is_name() &&
         c.names.find({EntityKind::step}, grammar::to_upper(c.sources.text(e.terms[0].span)), {}) !=
             nullptr;
}

// The letters for these arguments: what follows ? and the number z may be left out. A lone name
// in the place of z that is no parameter, or a step that no step follows, is the step behind it.
std::string argument_pattern(const DeckContext& c, std::string_view letters,
                             const std::vector<grammar::ParsedExpression>& arguments) {
  std::string all(letters);
  const std::size_t count = arguments.size();
  const std::size_t z = all.find('z');
  if (z != std::string::npos && z < count &&
      (is_unknown_word(c, arguments[z]) ||
       (is_step_name(c, arguments[z]) && !(z + 1 < count && is_step_name(c, arguments[z + 1]))))) {
    all.erase(z, 1);
  }
  const std::size_t mark = all.find('?');
  if (mark != std::string::npos) {
    all.erase(mark, 1);
    all.resize(std::clamp(count, mark, all.size()));
  }
  return all;
}

std::string argument_word(char letter) {
  const grammar::ResultArgument* argument = grammar::find_argument_by_letter(letter);
  return argument == nullptr ? "number"
         : letter == 'd'     ? "X|Y|Z"
         : letter == 'e'     ? "net or *"
                             : std::string(grammar::display_name(argument->kind));
}

std::string argument_usage(std::string_view letters) {
  std::string text = "(";
  bool optional = false;
  for (const char letter : letters) {
    if (letter == '?') {
      optional = true;
      continue;
    }
    text += text.size() > 1 ? ", " : "";
    text += optional || letter == 'z' ? fmt::format("[{}]", argument_word(letter))
                                      : argument_word(letter);
  }
  return text + ")";
}

/// Reads one line: QUANTITY(arguments) = value REL|ABS tolerance [SOURCE 'text'].
class CheckReader {
public:
  CheckReader(DeckContext& context, const CheckedCard& card, const grammar::DataRow& row)
      : c_(context), card_(card), row_(row) {}

  void run() {
    if (!form()) {
      return;
    }
    const bool known = arguments();
    const grammar::ResultQuantity* spec = grammar::find_result_quantity(check_.quantity);
    const auto quantity = spec == nullptr ? grammar::QuantityKind::number : spec->quantity;
    const auto value = number(1, quantity, "a value");
    const auto tolerance =
        number(3, check_.relative ? grammar::QuantityKind::number : quantity, "a tolerance");
    if (tolerance && *tolerance < 0.0) {
      c_.error(row_.fields[3].span, "E109", "a tolerance is not negative");
    }
    if (value == 0.0 && check_.relative) {
      c_.error(row_.fields[2].span, "E109", "nothing lies within REL of the value 0", "use ABS");
    }
    if (!known || !value || !tolerance) {
      return;
    }
    check_.value = *value;
    check_.tolerance = *tolerance;
    check_.is_value_in_output_unit = is_bare_number(row_.fields[1]);
    check_.is_tolerance_in_output_unit = !check_.relative && is_bare_number(row_.fields[3]);
    check_.span = row_.span;
    c_.model.checks.push_back(std::move(check_));
  }

  /// The result with its arguments alone; empty after an error.
  std::optional<model::ResultCheck> result() {
    const CardField& first = row_.fields.front();
    if (first.kind != CardField::CardFieldKind::quantity || row_.fields.size() > 1) {
      wrong(row_.span, "one result with its arguments is expected, as K(CRACK, STEP)");
      return std::nullopt;
    }
    check_.quantity = first.text;
    check_.relative = false;
    return arguments() ? std::optional(std::move(check_)) : std::nullopt;
  }

private:
  // quantity = value word tolerance [SOURCE text]; the = belongs to the first field
  bool form() {
    const std::vector<CardField>& f = row_.fields;
    const auto word = [&](std::size_t i) { return f.size() > i && f[i].is_name(); };
    if (f[0].kind != CardField::CardFieldKind::quantity) {
      return wrong(f[0].span, "a result with its arguments is expected, as K(CRACK, STEP)");
    }
    if (f[0].separator != '=') {
      return wrong(f[0].span, "'=' and a value are expected behind the result");
    }
    if (f.size() < 3 || !word(2)) {
      const bool bare = f.size() == 3 && f[2].kind == CardField::CardFieldKind::number;
      return wrong(bare ? f[2].span : row_.span,
                   bare ? "REL or ABS is missing before the tolerance"
                        : "the tolerance is missing: REL or ABS and a number");
    }
    if (f[2].text != "REL" && f[2].text != "ABS") {
      c_.error(f[2].span, "E108",
               fmt::format("'{}' is neither REL nor ABS", c_.sources.text(f[2].span)),
               "REL: the tolerance counts from the value; ABS: it is in the value's own unit");
      arguments();
      return false;
    }
    if (f.size() < 4) {
      return wrong(f[2].span, fmt::format("{} needs a tolerance behind it", f[2].text));
    }
    if (f.size() > 4 && (!word(4) || f[4].text != "SOURCE")) {
      return wrong(f[4].span, fmt::format("unexpected {}", c_.sources.text(f[4].span)));
    }
    if (f.size() > 4 && (f.size() != 6 || f[5].kind != CardField::CardFieldKind::text)) {
      return wrong(f[f.size() > 6 ? 6 : 4].span, "SOURCE is followed by one text in quotes");
    }
    check_.quantity = f[0].text;
    check_.relative = f[2].text == "REL";
    check_.source = f.size() == 6 ? f[5].text : std::string();
    return true;
  }

  // What is read in the listing is written here. A formula is made of the deck's numbers, which are
  // in the deck's units.
  static bool is_bare_number(const CardField& field) {
    return field.kind == CardField::CardFieldKind::number &&
           !grammar::explicit_unit_span(field.expression).valid();
  }

  bool wrong(base::SourceSpan span, std::string text) {
    c_.error(span, "E115", std::move(text), std::string(card_.spec->data_form));
    return false;
  }

  std::optional<double> number(std::size_t place, grammar::QuantityKind quantity,
                               std::string_view what) {
    return c_.read_number(row_.fields[place], quantity, what);
  }

  bool arguments() {
    const CardField& quantity = row_.fields[0];
    const grammar::ResultQuantity* spec = grammar::find_result_quantity(quantity.text);
    if (spec == nullptr) {
      unknown(quantity);
      return false;
    }
    check_.kind = spec->quantity;
    if ((spec->name == "N" || spec->name == "LIFE") && !counts_cycles()) {
      c_.error(quantity.span, "E315",
               fmt::format("{} counts cycles, but the deck has no $GROW with a law of growth",
                           quantity.text));
      return false;
    }
    if (!is_of_this_dimension(*spec, quantity)) {
      return false;
    }
    const std::string pattern = argument_pattern(c_, spec->arguments, quantity.arguments);
    if (pattern.size() != quantity.arguments.size()) {
      c_.error(quantity.span, "E315",
               fmt::format("{} takes {}", quantity.text, argument_usage(spec->arguments)),
               row_.fields.size() == 1 ? "the step may be NOW, the present state" : "");
      return false;
    }
    bool ok = true;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      ok = argument(pattern[i], quantity.arguments[i]) && ok;
    }
    return ok;
  }

  // Contacts in the plane have arcs and places along them, those between solids areas and moments.
  bool is_of_this_dimension(const grammar::ResultQuantity& spec, const CardField& quantity) {
    if (!c_.mesh_sound) {
      return true;
    }
    const DimensionRules& other = other_dimension_rules(c_.model.mesh.dim);
    if (!is_of_these_cracks(spec.name, quantity)) {
      return false;
    }
    if (std::ranges::find(other.contact_only, spec.name) != other.contact_only.end()) {
      c_.error(quantity.span, "E313",
               fmt::format("{} is of contacts {}", spec.name, other.contacts),
               std::string(dimension_rules.at(c_.model.mesh.dim).contact_results));
      return false;
    }
    return true;
  }

  // K of a tip in the plane is one number, along a front in space a place belongs to it.
  bool is_of_these_cracks(std::string_view name, const CardField& quantity) {
    const std::size_t point = name.rfind('.');
    const std::string_view where =
        point == std::string_view::npos ? std::string_view() : name.substr(point + 1);
    static constexpr std::array along{"AT", "PHI", "MIN", "MAX"};
    const bool front = std::ranges::find(along, where) != along.end();
    const std::string_view of = front ? name.substr(0, point) : name;
    // Paths have openings and knots as well, which are of contacts.
    static constexpr std::array tips{"K",      "K1",     "K2",      "K3",      "G",
                                     "T",      "K1.BAR", "K2.BAR",  "K3.BAR",  "K1.RAW",
                                     "K2.RAW", "K3.RAW", "PATH.K1", "PATH.K2", "PATH.K3"};
    const bool of_crack = std::ranges::find(tips, of) != tips.end() || of.starts_with("DK1.") ||
                          of.starts_with("DK2.") || of.starts_with("DK3.");
    const DimensionRules& rules = dimension_rules.at(c_.model.mesh.dim);
    if (!of_crack || rules.ends_in_fronts == front) {
      return true;
    }
    c_.error(
        quantity.span, "E313",
        fmt::format("{} is of a crack in {}", name, other_dimension_rules(c_.model.mesh.dim).where),
        fmt::format(fmt::runtime(rules.crack_results), of == "K" ? rules.mode_one : of));
    return false;
  }

  // By a law of $GROW, or perhaps by one that is refused already.
  [[nodiscard]] bool counts_cycles() const {
    return c_.has_bad_card("GROW") ||
           (c_.model.growth && c_.model.growth->law != model::CrackGrowthLaw::increment);
  }

  // Names that go on where this one stops come first: S.XX is S.XX.MIN, S.XX.MAX or S.XX.AT.
  void unknown(const CardField& quantity) {
    std::vector<std::string> valid;
    std::vector<std::string> longer;
    for (const grammar::ResultQuantity& q : grammar::result_quantities()) {
      valid.emplace_back(q.name);
      if (q.name.starts_with(quantity.text + ".")) {
        longer.emplace_back(q.name);
      }
    }
    base::SourceSpan name = quantity.span;
    name.end = name.begin + static_cast<std::uint32_t>(quantity.text.size());
    std::string hint = longer.empty() ? base::make_spelling_hint(quantity.text, valid)
                                      : fmt::format("one of: {}", fmt::join(longer, ", "));
    c_.error(name, "E314", fmt::format("'{}' is not a result", quantity.text),
             hint.empty()
                 ? "K1 K2 G T, CPRESS.MAX, ARC.FROM, SUM, U.X.MAX, S.XX.AT, REACTION, ENERGY .."
                 : std::move(hint));
  }

  bool argument(char letter, const grammar::ParsedExpression& expression) {
    if (letter == 'a' || letter == 'z') {
      const auto value = grammar::evaluate_constant(expression, c_.scope, c_.diagnostics);
      check_.arguments.emplace_back(value.value_or(0.0));
      if (value && check_.quantity.ends_with(".PHI")) {
        warn_of_whole_radians(c_, expression.span, check_.quantity, *value);
      }
      return value.has_value();
    }
    if (expression.terms.size() != 1 || !expression.terms[0].is_name()) {
      c_.error(expression.span, "E315",
               fmt::format("expected {}, not '{}'", argument_word(letter),
                           c_.sources.text(expression.span)));
      return false;
    }
    std::string name = grammar::to_upper(c_.sources.text(expression.terms[0].span));
    const bool ok = known(letter, name, expression.terms[0].span);
    check_.arguments.emplace_back(std::move(name));
    return ok;
  }

  // Names of sets become qualified.
  bool known(char letter, std::string& name, base::SourceSpan span) {
    const NameReference reference{name, span, card_.net};
    switch (letter) {
    case 'c': {
      const std::size_t dot = name.find('.');
      if (dot != std::string::npos && name.substr(dot) != ".1" && name.substr(dot) != ".2") {
        c_.error(span, "E315", "the tips of a crack are NAME.1 and NAME.2");
        return false;
      }
      return find_referenced_definition(c_, EntityKind::crack, {name.substr(0, dot), span, {}}) !=
             nullptr;
    }
    case 'p':
      return check_contact_or_crack_faces(c_, reference);
    case 'e':
      return name == "*" ||
             find_referenced_definition(c_, EntityKind::net, {name, span, {}}) != nullptr;
    case 'n': {
      const std::string own = qualified_name(card_.net, name);
      const bool ok = resolve_set_kind(c_, EntityKind::any_set, reference).has_value();
      name = c_.names.find(accepted_kinds(EntityKind::any_set), own, {}) != nullptr ? own : name;
      return ok;
    }
    case 'd':
      if (name == "X" || name == "Y" || name == "Z") {
        return true;
      }
      c_.error(span, "E315", fmt::format("expected X, Y or Z, not '{}'", name));
      return false;
    default: // steps, cases, materials, paths and tests
      return find_referenced_definition(c_, grammar::find_argument_by_letter(letter)->kind,
                                        reference) != nullptr;
    }
  }

  DeckContext& c_;
  const CheckedCard& card_;
  const grammar::DataRow& row_;
  model::ResultCheck check_;
};

} // namespace

void read_checks(DeckContext& context, const CheckedCard& card) {
  for (const grammar::DataRow& row : card.rows) {
    CheckReader(context, card, row).run();
  }
}

std::optional<model::ResultCheck> read_result_request(DeckContext& context, const CheckedCard& card,
                                                      const grammar::DataRow& row) {
  return CheckReader(context, card, row).result();
}

} // namespace spricka::deck
