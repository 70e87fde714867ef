// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/session.hpp"

#include "base/messages.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/trouble.hpp"
#include "report/topics/result_tables.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Condensed nets that are kept for lengths to come back to.
constexpr std::size_t most_nets = 48;

// What an action is about; of two with the same the later one counts.
std::pair<int, std::size_t> subject(const model::Action& action) {
  if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
    return {0, load->load_case.index()};
  }
  if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
    return {1, fit->contact.index()};
  }
  const auto* on = std::get_if<model::MountContact>(&action);
  return {2, on != nullptr ? on->contact.index()
                           : std::get<model::DismountContact>(action).contact.index()};
}

void put(std::vector<model::Action>& actions, const model::Action& action) {
  std::erase_if(actions, [&](const model::Action& a) { return subject(a) == subject(action); });
  actions.push_back(action);
}

bool mounts(const model::Step& step) {
  return std::ranges::any_of(step.actions, [](const model::Action& a) {
    return std::holds_alternative<model::MountContact>(a) ||
           std::holds_alternative<model::DismountContact>(a);
  });
}

bool same_names(const model::Model& a, const model::Model& b) {
  const auto same = [](const auto& one, const auto& two) {
    return std::ranges::equal(one, two,
                              [](const auto& x, const auto& y) { return x.name == y.name; });
  };
  return same(a.cases, b.cases) && same(a.contacts, b.contacts) && same(a.steps, b.steps) &&
         same(a.cracks, b.cracks);
}

bool keeps_mounts(const model::Model& model) {
  return model.growth && model.growth->mounted == model::ContactMounting::first;
}

// Lengths of $GROW are those of its cracks: begin with the first.
void begin_growth(model::Model& model) {
  if (!model.growth || model.growth->lengths.empty()) {
    return;
  }
  if (model.mesh.dim == 3) {
    model.cracks = growth::scale_cracks(model, model.growth->lengths.front());
    return;
  }
  const std::vector<base::CrackId>& grow = model.growth->cracks;
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    if (grow.empty() || std::ranges::find(grow, base::CrackId(c)) != grow.end()) {
      model.cracks[c].a0 = model.growth->lengths.front();
    }
  }
}

} // namespace

ShellSession::ShellSession(SessionOptions options) : options_(std::move(options)) {
  changes_.name = "NOW";
  given_ = options_.defines;
}

base::Trouble ShellSession::open() {
  return read_again(options_.defines, false);
}

base::Trouble ShellSession::reset() {
  return read_again(given_, false);
}

base::Trouble ShellSession::define_parameter(const std::string& name,
                                             const std::string& expression) {
  Defines defines = options_.defines;
  std::erase_if(defines, [&](const auto& d) { return same_word(d.first, name); });
  defines.emplace_back(name, expression);
  const OriginalCards before = own_;
  if (base::Trouble trouble = read_again(defines, true)) {
    return trouble;
  }
  covered_ = covered_by(before);
  return {};
}

// All that depends on the deck is made aside and takes its place at the end.
base::Trouble ShellSession::read_again(const Defines& defines, bool keep) {
  auto deck = std::make_unique<ReadyDeck>(options_.read(defines));
  if (!deck->model) {
    return located_failure(deck->refusal.kind, {});
  }
  ShellSession next(options_);
  next.options_.defines = defines;
  next.given_ = given_;
  next.model_ = std::make_unique<model::Model>(std::move(*deck->model));
  deck->model.reset();
  next.deck_ = std::move(deck);
  next.cache_ = cache_;
  const bool same = keep && bench_ && same_names(*model_, *next.model_);
  if (same) {
    next.base_ = base_;
    next.after_ = after_;
    next.changes_ = changes_;
    next.lengths_ = lengths_;
    next.gaps_ = gaps_;
  } else {
    const std::string leading = report::leading_step(*next.model_);
    next.base_ = static_cast<std::size_t>(
        std::ranges::find(next.model_->steps, leading, &model::Step::name) -
        next.model_->steps.begin());
  }
  if (keep) { // after a reset the deck may be another one
    next.known_ = known_;
    next.reported_ = reported_;
  }
  if (base::Trouble trouble = next.open_model()) {
    return trouble;
  }
  *this = std::move(next);
  return {};
}

base::Trouble ShellSession::open_model() {
  own_ = {model_->cracks, model_->contacts, model_->steps};
  begin_growth(*model_);
  for (const auto& [name, value] : gaps_) {
    std::ranges::find(model_->contacts, name, &model::Contact::name)->gap = -value;
  }
  base::Diagnostics diagnostics;
  plan_ = analysis::plan_region(*model_, growth::crack_lengths(*model_), diagnostics);
  if (diagnostics.has_errors()) {
    return located_failure(base::Outcome::deck_error,
                           base::format_messages(deck_->sources, diagnostics));
  }
  if (keeps_mounts(*model_)) { // what is mounted at the first length, by all steps
    memory_ = std::make_unique<analysis::MountOffsetMemory>();
    std::unique_ptr<InteractiveSolver> first;
    base::Trouble trouble = make_bench(true, first);
    trouble = trouble ? trouble : first->solve_from_unloaded(model_->steps);
    if (trouble) {
      return trouble;
    }
  }
  set_lengths_on(*model_);
  if (!lengths_.empty()) {
    plan_ = plan_lengths();
  }
  return rebuild();
}

base::Trouble ShellSession::make_bench(bool first, std::unique_ptr<InteractiveSolver>& bench) {
  base::Diagnostics diagnostics;
  base::Trouble trouble;
  bench = InteractiveSolver::make({.model = *model_,
                                   .cache = *cache_,
                                   .contact = *contact_,
                                   .memory = memory_.get(),
                                   .fills_memory = first,
                                   .threads = options_.threads ? options_.threads(*model_) : 1,
                                   .stopped = options_.stopped},
                                  plan_, diagnostics, trouble);
  if (diagnostics.has_errors()) {
    return located_failure(base::Outcome::deck_error,
                           base::format_messages(deck_->sources, diagnostics));
  }
  return trouble;
}

base::Trouble ShellSession::rebuild() {
  std::unique_ptr<InteractiveSolver> bench;
  if (base::Trouble trouble = make_bench(false, bench)) {
    return trouble;
  }
  if (base::Trouble trouble = bench->solve_from_unloaded(way())) {
    return trouble;
  }
  bench_ = std::move(bench);
  if (cache_->nets.size() > most_nets) {
    std::erase_if(cache_->nets, [](const auto& entry) { return entry.second.use_count() == 1; });
    std::erase_if(cache_->bodies, [](const auto& entry) { return entry.second.use_count() == 1; });
  }
  mapped_.clear();
  remember();
  return {};
}

base::Trouble ShellSession::restore_after_failure() {
  return bench_->ready() ? base::Trouble() : rebuild();
}

std::vector<model::Step> ShellSession::way_to(std::size_t step) const {
  return {model_->steps.begin(), model_->steps.begin() + static_cast<std::ptrdiff_t>(step) + 1};
}

std::vector<model::Step> ShellSession::way() const {
  std::vector<model::Step> steps = way_to(base_);
  steps.insert(steps.end(), after_.begin(), after_.end());
  return steps;
}

base::Trouble ShellSession::go_to_step(const std::string& name) {
  std::size_t index = 0;
  if (base::Trouble trouble = find_name(step_names(*model_), "step", name, index)) {
    return trouble;
  }
  if (base::Trouble trouble = bench_->solve_from_unloaded(way_to(index))) {
    return trouble;
  }
  base_ = index;
  after_.clear();
  changes_.actions.clear();
  mapped_.clear();
  remember();
  return {};
}

void ShellSession::change(const model::Action& action) {
  put(changes_.actions, action);
}

base::Trouble ShellSession::set_load_factor(const std::string& load_case, double factor) {
  std::size_t index = 0;
  if (base::Trouble trouble = find_name(load_case_names(*model_), "load case", load_case, index)) {
    return trouble;
  }
  change(model::ApplyLoad{base::CaseId(index), factor});
  return {};
}

base::Trouble ShellSession::set_fit_factor(const std::string& contact, double factor) {
  std::size_t index = 0;
  if (base::Trouble trouble = find_name(contact_names(*model_), "contact", contact, index)) {
    return trouble;
  }
  if (!model_->contacts[index].gap) {
    return invalid_input(
        fmt::format("contact {} has no declared fit that a factor could scale", contact),
        fmt::format("fit {} = 0.05 declares an interference", contact));
  }
  change(model::ApplyFit{base::ContactId(index), factor});
  return {};
}

base::Trouble ShellSession::set_mounted(const std::string& contact, bool on) {
  std::size_t index = 0;
  if (base::Trouble trouble = find_name(contact_names(*model_), "contact", contact, index)) {
    return trouble;
  }
  if (keeps_mounts(*model_)) {
    return invalid_input(
        "with $GROW MOUNTED=FIRST a contact keeps what it took on at the first length: "
        "nothing is mounted or dismounted here");
  }
  const base::ContactId id(index);
  const model::Action action =
      on ? model::Action(model::MountContact{id}) : model::Action(model::DismountContact{id});
  if (factors().mounted[index] != on) {
    change(action);
    return {};
  }
  // What is in force would count its fit a second time, from bodies that have it already.
  if (std::erase_if(changes_.actions,
                    [&](const model::Action& a) { return subject(a) == subject(action); }) == 0) {
    return invalid_input(
        fmt::format("contact {} is {} already", contact, on ? "mounted" : "absent"),
        on ? "dismount it first: mounted anew, its fit counts from the bodies as they are "
             "then"
           : "mount puts it in");
  }
  return {}; // a change that was pending is taken back
}

base::Trouble ShellSession::set_interference(const std::string& contact, double value) {
  std::size_t index = 0;
  if (base::Trouble trouble = find_name(contact_names(*model_), "contact", contact, index)) {
    return trouble;
  }
  if (keeps_mounts(*model_)) {
    return invalid_input(
        "with $GROW MOUNTED=FIRST a contact keeps what it took on at the first length",
        "make the interference a parameter of the deck and use set");
  }
  if (model_->contacts[index].rigid.valid() && !model_->contacts[index].gap) {
    return invalid_input(
        fmt::format("contact {} meets a rigid target and has no declared gap", contact));
  }
  const std::optional<double> before = model_->contacts[index].gap;
  const std::vector<model::Step> after = after_;
  model_->contacts[index].gap = -value;
  if (factors().fit[index] != 1.0) { // the value itself is meant, not a part of it
    model::Step& whole = after_.emplace_back();
    whole.name = "NOW";
    whole.substeps = has_friction() ? default_substeps : 1;
    whole.actions.emplace_back(model::ApplyFit{base::ContactId(index), 1.0});
  }
  if (base::Trouble trouble = rebuild()) {
    model_->contacts[index].gap = before;
    after_ = after;
    return trouble;
  }
  gaps_[contact] = value;
  return {};
}

base::Trouble ShellSession::solve(int substeps) {
  if (!has_pending_changes()) {
    return {};
  }
  model::Step next = changes_;
  next.substeps = has_friction() ? substeps : 1;
  const std::vector<model::Step> before = after_;
  if (!after_.empty() && !has_friction() && !mounts(next) && !mounts(after_.back())) {
    for (const model::Action& action : next.actions) {
      put(after_.back().actions, action);
    }
  } else {
    after_.push_back(next);
  }
  if (base::Trouble trouble = bench_->solve_further_step(next, way())) {
    after_ = before;
    return trouble;
  }
  changes_.actions.clear();
  mapped_.clear();
  remember();
  return {};
}

base::Trouble ShellSession::estimate_accuracy() {
  if (base::Trouble trouble = solve()) {
    return trouble;
  }
  return bench_->estimate_accuracy();
}

bool ShellSession::has_friction() const {
  return std::ranges::any_of(model_->contacts, [](const auto& c) { return c.mu > 0.0; }) ||
         std::ranges::any_of(model_->cracks,
                             [](const auto& c) { return c.faces_in_contact && c.mu > 0.0; });
}

} // namespace spricka::program
