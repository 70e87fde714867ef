// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/save.hpp"

#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"
#include "model/model.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;
using grammar::Card;

std::string value_of(const Card& card, std::string_view key) {
  for (const grammar::HeaderParameter& p : card.parameters) {
    if (p.key == key && !p.values.empty()) {
      return p.values.front().text;
    }
  }
  return {};
}

/// Changes to the deck's own file, collected and made at the end.
class Edits {
public:
  explicit Edits(const ShellSession& session) : text_(session.sources().text(0)) {
    base::Diagnostics ignored; // it has been read without mistakes
    cards_ = grammar::parse_cards(session.sources(), 0, ignored);
  }
  [[nodiscard]] const std::vector<Card>& cards() const { return cards_; }
  [[nodiscard]] std::string_view text() const { return text_; }

  void replace(std::size_t begin, std::size_t end, std::string by) {
    edits_.push_back({begin, end, std::move(by)});
  }
  /// Sets a key of a header; others in its place are taken away.
  void set_key(const Card& card, std::string_view key, const std::string& value,
               std::initializer_list<std::string_view> instead = {}) {
    for (const grammar::HeaderParameter& p : card.parameters) {
      if (p.key == key || std::ranges::find(instead, p.key) != instead.end()) {
        replace(p.key_span.begin, p.span.end, "");
      }
    }
    replace(card.name_span.end, card.name_span.end, fmt::format(" {}={}", key, value));
  }
  /// The line behind a header.
  [[nodiscard]] std::size_t below(const Card& card) const {
    const char* last = text_.data() + text_.size();
    const char* end = grammar::logical_line_end(text_.data() + card.name_span.begin, last);
    return std::min(text_.size(), static_cast<std::size_t>(end - text_.data()) + 1);
  }
  [[nodiscard]] std::size_t end_card() const {
    const auto end = std::ranges::find(cards_, "END", &Card::name);
    return end == cards_.end() ? text_.size() : begin_of(*end);
  }
  /// Where the $ of a card stands.
  [[nodiscard]] std::size_t begin_of(const Card& card) const {
    std::size_t at = card.name_span.begin;
    while (at > 0 && text_[at] != '$') {
      --at;
    }
    return at;
  }
  [[nodiscard]] const Card* find(std::string_view card, const std::string& name) const {
    const auto found = std::ranges::find_if(cards_, [&](const Card& c) {
      return c.name == card && same_word(value_of(c, "NAME"), name);
    });
    return found == cards_.end() ? nullptr : &*found;
  }
  std::string make() {
    std::ranges::stable_sort(edits_, {}, &Edit::begin);
    std::string out;
    std::size_t done = 0;
    for (const Edit& edit : edits_) {
      if (edit.begin < done) {
        continue; // inside of what is gone
      }
      out += text_.substr(done, edit.begin - done);
      out += edit.by;
      done = edit.end;
    }
    out += text_.substr(done);
    return out;
  }

private:
  struct Edit {
    std::size_t begin = 0, end = 0;
    std::string by;
  };
  std::string_view text_;
  std::vector<Card> cards_;
  std::vector<Edit> edits_;
};

std::string exactly(double value) {
  return fmt::format("{}", value); // as many digits as it takes to read the same number
}

// Lines of a card as comments.
void comment_out(Edits& edits, const Card& card) {
  const std::size_t first = edits.begin_of(card);
  const std::size_t last =
      std::max<std::size_t>(edits.below(card), card.data.valid() ? card.data.end : 0);
  std::string text;
  std::string_view rest = edits.text().substr(first, last - first);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1);
    text += "! ";
    text += rest.substr(0, end + 1);
    rest.remove_prefix(end + 1);
  }
  edits.replace(first, last, text);
}

void quiet_cards(const ShellSession& session, Edits& edits) {
  const bool other = !session.user_crack_sizes().empty() || !session.user_interferences().empty() ||
                     !session.defines().empty();
  for (const Card& card : edits.cards()) {
    const bool gone = card.name == "GROW" || card.name == "SWEEP" || card.name == "RESTART" ||
                      (card.name == "CHECK" && (other || session.model().growth));
    if (gone) {
      comment_out(edits, card);
    }
  }
}

base::Trouble set_lengths(const ShellSession& session, Edits& edits) {
  std::map<std::string, CrackSize> lengths = session.user_crack_sizes();
  if (session.model().growth) { // its lengths are gone with its card
    for (std::size_t c = 0; c < session.model().cracks.size(); ++c) {
      const model::CrackDefinition& crack = session.model().cracks[c];
      if (crack.a0 || crack.kind == model::CrackDefinitionKind::ellipse) {
        lengths.emplace(crack.name, crack.a0 ? CrackSize{*crack.a0, 0.0} : session.crack_size(c));
      }
    }
  }
  for (const auto& [name, size] : lengths) {
    const Card* card = edits.find("CRACK", name);
    if (card == nullptr) {
      return invalid_input(
          fmt::format("crack {} is described in an included file, which save does not "
                      "change",
                      name));
    }
    if (size.c > 0.0) {
      edits.set_key(*card, "A", exactly(size.a));
      edits.set_key(*card, "C", exactly(size.c));
    } else {
      edits.set_key(*card, "A0", exactly(size.a));
    }
  }
  return {};
}

base::Trouble set_interferences(const ShellSession& session, Edits& edits) {
  for (const auto& [name, value] : session.user_interferences()) {
    const Card* card = edits.find("CONTACT", name);
    if (card == nullptr) {
      return invalid_input(
          fmt::format("contact {} is described in an included file, which save does not "
                      "change",
                      name));
    }
    edits.set_key(*card, value < 0.0 ? "GAP" : "INTERFERENCE", exactly(std::abs(value)),
                  {"GAP", "INTERFERENCE", "DIAMETRAL"});
  }
  return {};
}

// NAME = value of one line of $PARAMETER by NAME = expression.
bool set_parameter(Edits& edits, const std::string& name, const std::string& expression) {
  const std::string_view text = edits.text();
  for (const Card& card : edits.cards()) {
    if (card.name != "PARAMETER" || !card.data.valid()) {
      continue;
    }
    for (std::size_t at = card.data.begin; at < card.data.end;) {
      const std::size_t end = std::min<std::size_t>(text.find('\n', at), card.data.end);
      const std::string_view line = text.substr(at, end - at);
      const std::size_t first = line.find_first_not_of(" \t");
      const std::size_t equal = line.find('=');
      if (first != std::string_view::npos && equal != std::string_view::npos && first < equal) {
        const std::size_t last = line.find_last_not_of(" \t", equal - 1);
        if (same_word(line.substr(first, last - first + 1), name)) {
          const std::size_t stop = std::min(line.find('!'), line.size());
          edits.replace(at + equal + 1, at + stop,
                        fmt::format(" {}{}", expression, stop < line.size() ? "  " : ""));
          return true;
        }
      }
      at = end + 1;
    }
  }
  return false;
}

base::Trouble set_parameters(const ShellSession& session, Edits& edits) {
  for (const auto& [name, expression] : session.defines()) {
    if (!set_parameter(edits, name, expression)) {
      return invalid_input(
          fmt::format("parameter {} is defined in an included file, which save does not "
                      "change",
                      name),
          fmt::format("save without it and run with -D '{}={}'", name, expression));
    }
  }
  return {};
}

// Paths of files are those seen from the deck's folder.
void move_files(const ShellSession& session, const fs::path& folder, Edits& edits) {
  const fs::path own = fs::absolute(session.sources().file_name(0)).parent_path();
  if (fs::weakly_canonical(folder) == fs::weakly_canonical(own)) {
    return;
  }
  for (const Card& card : edits.cards()) {
    for (const grammar::HeaderParameter& p : card.parameters) {
      const bool read = card.name == "INCLUDE" || card.name == "IMPORT";
      if (read && p.key == "FILE" && !p.values.empty() &&
          fs::path(p.values.front().text).is_relative()) {
        const fs::path file = fs::proximate(fs::weakly_canonical(own / p.values.front().text),
                                            fs::weakly_canonical(folder));
        edits.replace(p.span.begin, p.span.end, fmt::format("'{}'", file.generic_string()));
      }
    }
  }
}

std::string row_of(const model::Model& model, const model::Action& action) {
  if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
    return fmt::format("  LOAD {} {}\n", model.cases[load->load_case.index()].name,
                       exactly(load->factor));
  }
  if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
    return fmt::format("  FIT {} {}\n", model.contacts[fit->contact.index()].name,
                       exactly(fit->factor));
  }
  if (const auto* on = std::get_if<model::MountContact>(&action)) {
    return fmt::format("  MOUNT {}\n", model.contacts[on->contact.index()].name);
  }
  return fmt::format("  DISMOUNT {}\n",
                     model.contacts[std::get<model::DismountContact>(action).contact.index()].name);
}

bool mounts(const std::vector<model::Step>& steps) {
  return std::ranges::any_of(steps, [](const model::Step& step) {
    return std::ranges::any_of(step.actions, [](const model::Action& a) {
      return std::holds_alternative<model::MountContact>(a) ||
             std::holds_alternative<model::DismountContact>(a);
    });
  });
}

std::string free_name(const model::Model& model, std::size_t number) {
  const std::vector<std::string> taken = step_names(model);
  std::string name = number == 0 ? "NOW" : fmt::format("NOW_{}", number);
  while (std::ranges::find(taken, name) != taken.end()) {
    name += "_";
  }
  return name;
}

// Where the order does not count, one step with every factor as it is.
model::Step all_factors(const ShellSession& session) {
  model::Step step;
  const model::Model& model = session.model();
  const analysis::StepFactors& now = session.factors();
  for (std::size_t c = 0; c < model.cases.size(); ++c) {
    step.actions.emplace_back(
        model::ApplyLoad{base::CaseId(c), now.case_factor[static_cast<Eigen::Index>(c)]});
  }
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    if (model.contacts[c].gap &&
        (now.fit[c] != 1.0 || analysis::step_sets_fit(model, base::ContactId(c)))) {
      step.actions.emplace_back(model::ApplyFit{base::ContactId(c), now.fit[c]});
    }
  }
  return step;
}

template <class ActionType>
bool acts_on(const std::vector<model::Step>& steps, base::ContactId contact) {
  return std::ranges::any_of(steps, [&](const model::Step& step) {
    return std::ranges::any_of(step.actions, [&](const model::Action& action) {
      const auto* a = std::get_if<ActionType>(&action);
      return a != nullptr && a->contact == contact;
    });
  });
}

// A contact that no step of the deck mounts, and a fit that none names, are in force from the
// beginning: naming them now would change that, so that the first step names them, too.
base::Trouble keep_beginning(const ShellSession& session, const std::vector<model::Step>& added,
                             Edits& edits) {
  const model::Model& model = session.model();
  const std::vector<model::Step> beginning{model.steps.front()};
  std::string rows;
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const base::ContactId id(c);
    if (acts_on<model::ApplyFit>(added, id) && !analysis::step_sets_fit(model, id)) {
      rows += row_of(model, model::ApplyFit{id, 1.0});
    }
    if (acts_on<model::MountContact>(added, id) && !analysis::step_mounts(model, id) &&
        !acts_on<model::DismountContact>(beginning, id)) {
      rows += row_of(model, model::MountContact{id});
    }
  }
  if (rows.empty()) {
    return {};
  }
  const Card* first = edits.find("STEP", model.steps.front().name);
  if (first == nullptr) {
    return invalid_input("the first step is in an included file, which save does not change");
  }
  edits.replace(edits.below(*first), edits.below(*first), rows);
  return {};
}

base::Trouble add_steps(const ShellSession& session, Edits& edits) {
  const model::Model& model = session.model();
  const bool last = session.base_step() == model.steps.back().name;
  const bool ordered =
      session.has_friction() || mounts(session.applied_changes()) || mounts(model.steps);
  std::vector<model::Step> steps = session.applied_changes();
  if (steps.empty() && last) {
    return {}; // the deck's last step is the state
  }
  if (!ordered) {
    steps = {all_factors(session)};
  } else if (!last) {
    return invalid_input(
        fmt::format("the state goes on from step {}, but the deck has steps behind it, "
                    "and with friction or mounted contacts the order counts",
                    session.base_step()),
        fmt::format("step {} and the changes again", model.steps.back().name));
  }
  if (base::Trouble trouble = keep_beginning(session, steps, edits)) {
    return trouble;
  }
  std::string text;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    text +=
        fmt::format("$STEP NAME={}{}\n", free_name(model, steps.size() - 1 - s),
                    steps[s].substeps > 1 ? fmt::format(" SUBSTEPS={}", steps[s].substeps) : "");
    for (const model::Action& action : steps[s].actions) {
      text += row_of(model, action);
    }
  }
  edits.replace(edits.end_card(), edits.end_card(), text);
  return {};
}

} // namespace

base::Trouble saved_deck(const ShellSession& session, const fs::path& folder, std::string& text) {
  Edits edits(session);
  quiet_cards(session, edits);
  move_files(session, folder, edits);
  base::Trouble trouble = set_parameters(session, edits);
  trouble = trouble ? trouble : set_lengths(session, edits);
  trouble = trouble ? trouble : set_interferences(session, edits);
  trouble = trouble ? trouble : add_steps(session, edits);
  if (!trouble) {
    text = edits.make();
  }
  return trouble;
}

} // namespace spricka::program
