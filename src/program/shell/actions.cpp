// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/actions.hpp"

#include "base/diagnostics.hpp"
#include "base/quantity.hpp"
#include "grammar/catalogue.hpp"
#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/listing.hpp"
#include "program/shell/plots.hpp"
#include "program/shell/result_value.hpp"
#include "program/shell/save.hpp"
#include "program/shell/trouble.hpp"
#include "program/shell/typed_words.hpp"
#include "report/drawing/file.hpp"
#include "report/topics/sensitivity_tables.hpp"
#include "results/result_unit.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

namespace spricka::program {

namespace {

base::OperationFailure wrong_usage(const ShellCall& call) {
  return invalid_input(fmt::format("write {}", call.usage));
}

// Word i of a command in upper case, as names of the deck are; empty without it.
std::string name_argument(const ShellCall& call, std::size_t i) {
  return i < call.words.size() ? grammar::to_upper(call.words[i]) : std::string();
}

void tell_state(ShellSession& session, ShellReply& reply) {
  reply.out += K_and_contact_state_reply(session);
  reply.messages += warnings_and_new_notes(session);
}

// What an operation has led to.
base::OptionalFailure tell_state_after(const base::OptionalFailure& trouble,
                                       const ShellCall& call) {
  if (!trouble) {
    tell_state(call.session, call.reply);
  }
  return trouble;
}

// Solves what is pending before a question; its notes are told.
base::OptionalFailure solve_pending_changes(ShellSession& session, ShellReply& reply) {
  if (!session.has_pending_changes()) {
    return {};
  }
  base::OptionalFailure trouble = session.solve();
  if (!trouble) {
    reply.messages +=
        session.has_friction()
            ? fmt::format("note: solved from the last state on, in {} substeps\n", default_substeps)
            : std::string();
    reply.messages += warnings_and_new_notes(session);
  }
  return trouble;
}

} // namespace

base::OptionalFailure evaluate_result_line(ShellSession& session, const std::string& line,
                                           ShellReply& reply) {
  model::ResultCheck check;
  double value = 0.0;
  base::OptionalFailure trouble = read_result_request(session.model(), line, check);
  trouble = trouble ? trouble : solve_pending_changes(session, reply);
  trouble = trouble ? trouble : evaluate_result(session, check, value);
  if (!trouble && (check.quantity == "N" || check.quantity == "LIFE")) {
    reply.messages += growth_notes(session);
  }
  if (!trouble) {
    const bool is_life = check.kind == base::QuantityKind::life;
    const base::OutputUnit unit =
        results::check_unit(session.model().units, check.kind,
                            is_life ? session.growth().result() : session.run_results());
    // Lives have no unit beside them unless it is one of choice.
    const bool bare = is_life && session.model().units.output.life == base::LifeUnit::as_counted;
    reply.out += fmt::format("{} = {:.10g}{}{}\n", check_text(check), unit.from_deck(value),
                             bare || unit.name.empty() ? "" : " ", bare ? "" : unit.name);
  }
  return trouble;
}

base::OptionalFailure apply_deck_change(ShellSession& session, const std::string& line,
                                        bool is_card, ShellReply& reply) {
  base::OptionalFailure trouble = solve_pending_changes(session, reply);
  const std::string before = K_and_contact_state_reply(session);
  const InteractiveSolver* const solver = &session.solver();
  trouble =
      trouble ? trouble : (is_card ? session.change_card(line) : session.change_parameter(line));
  if (trouble) {
    return trouble;
  }
  if (&session.solver() == solver) {
    reply.messages += "note: another law of growth: K and the contacts do not depend on it\n";
    return {};
  }
  const analysis::CondensationStatistics& log = session.solver().condensation_figures();
  reply.messages += fmt::format("note: {} nets condensed, {} reused\n", log.condensed, log.reused);
  tell_state(session, reply);
  if (!before.empty() && K_and_contact_state_reply(session) == before) {
    reply.messages += "note: K and the contacts are as they were before\n";
  }
  return {};
}

base::OptionalFailure do_add_step_action(const ShellCall& call) {
  return call.session.add_step_line(std::string(strip_comment(call.line)));
}

base::OptionalFailure do_solve(const ShellCall& call) {
  int substeps = default_substeps;
  if (call.words.size() > 1) {
    const std::string& word = call.words[1];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), substeps);
    if (error != std::errc() || end != word.data() + word.size() || substeps < 1 ||
        substeps > 100'000) {
      return invalid_input("the number of substeps is whole, from 1");
    }
  }
  if (call.session.has_friction() && call.session.has_pending_changes()) {
    call.reply.messages += fmt::format("note: from the last state on, in {} substeps\n", substeps);
  }
  return tell_state_after(call.session.solve(substeps), call);
}

base::OptionalFailure do_go_to_step(const ShellCall& call) {
  return call.words.size() != 2
             ? wrong_usage(call)
             : tell_state_after(call.session.go_to_step(name_argument(call, 1)), call);
}

base::OptionalFailure do_undo(const ShellCall& call) {
  return tell_state_after(call.session.undo(), call);
}

base::OptionalFailure do_reset(const ShellCall& call) {
  return tell_state_after(call.session.open(), call);
}

namespace {

base::OptionalFailure list_k(const ShellCall& call) {
  const std::string only = name_argument(call, 2);
  std::vector<std::string> names = candidate_argument_names('c', call.session.model());
  for (const results::FrontResult& front : call.session.current_result().fronts) {
    names.push_back(front.name);
  }
  std::size_t index = 0;
  base::OptionalFailure trouble = only.empty() && !names.empty()
                                      ? base::OptionalFailure()
                                      : find_name_index(names, "crack", only, index);
  trouble = trouble ? trouble : call.session.estimate_accuracy();
  if (!trouble) {
    call.reply.out = k_reply(call.session, only);
    call.reply.messages += k_notes(call.session, only);
  }
  return trouble;
}

base::OptionalFailure list_pressure(const ShellCall& call) {
  const std::string name = name_argument(call, 2);
  std::size_t index = 0;
  if (base::OptionalFailure trouble = find_name_index(
          candidate_argument_names('p', call.session.model()), "contact", name, index)) {
    return trouble;
  }
  const results::ContactResult* contact =
      results::find_contact(call.session.current_result(), name);
  if (contact == nullptr) {
    return base::OperationFailure{.kind = base::ProgramOutcome::check_failed,
                                  .why = fmt::format("the faces of {} touch nowhere", name)};
  }
  call.reply.out = contact_reply(call.session, *contact);
  if (!contact->unbounded.empty()) {
    call.reply.messages += "note: it is pressed up to an edge: there the pressure has no bound\n";
  }
  return {};
}

base::OptionalFailure list_sensitivity(const ShellCall& call) {
  if (call.session.current_result().fronts.empty()) {
    return invalid_input("the deck has no crack");
  }
  base::OptionalFailure trouble = call.session.estimate_accuracy();
  if (!trouble) {
    call.reply.out = sensitivity_reply(call.session);
    for (const std::string& note :
         report::missing_sensitivity_reasons(call.session.solver().displayed_model(),
                                             call.session.run_results().increments.front())) {
      call.reply.messages += fmt::format("note: {}\n", note);
    }
  }
  return trouble;
}

} // namespace

std::vector<std::string> topics_of_list_command() {
  return {"K", "pressure", "sensitivity", "history"};
}

base::OptionalFailure do_list(const ShellCall& call) {
  const std::string what = name_argument(call, 1);
  if (what.empty()) {
    call.reply.out = changes_and_state_reply(call.session);
    return {};
  }
  if (what == "HISTORY") {
    for (std::size_t i = 0; i < call.history.size(); ++i) {
      call.reply.out += fmt::format("{:4}  {}\n", i + 1, call.history[i]);
    }
    return {};
  }
  base::OptionalFailure trouble = solve_pending_changes(call.session, call.reply);
  if (trouble) {
    return trouble;
  }
  if (what == "K" || what == "PRESSURE" || what == "SENSITIVITY") {
    return what == "K" ? list_k(call)
                       : (what == "PRESSURE" ? list_pressure(call) : list_sensitivity(call));
  }
  call.reply.out = cards_reply(call.session, what.starts_with('$') ? what.substr(1) : what);
  return call.reply.out.empty() ? base::OptionalFailure(invalid_input(
                                      fmt::format("there is no list or card '{}'", what),
                                      base::make_spelling_hint(what, topics_of_list_command())))
                                : base::OptionalFailure();
}

base::OptionalFailure do_follow_load_path(const ShellCall& call) {
  if (call.words.size() != 2 && call.words.size() != 4) {
    return wrong_usage(call);
  }
  base::OptionalFailure trouble = solve_pending_changes(call.session, call.reply);
  if (!trouble && call.words.size() == 2) {
    trouble = call.session.follow_deck_load_path(name_argument(call, 1));
  } else if (!trouble) {
    trouble =
        call.session.follow_load_case_range(name_argument(call, 1), call.words[2], call.words[3]);
  }
  if (trouble) {
    return trouble;
  }
  call.reply.out = K_along_load_path_reply(call.session);
  for (const results::Note& note : call.session.last_followed_path()->notes) {
    call.reply.messages += fmt::format(
        "{}{}\n", results::is_warning(note) ? "" : "note: ", results::text_with_code(note));
  }
  return {};
}

base::OptionalFailure do_grow(const ShellCall& call) {
  const bool anew = call.words.size() == 2 && name_argument(call, 1) == "ANEW";
  if (call.words.size() > 2 || (call.words.size() == 2 && !anew)) {
    return wrong_usage(call);
  }
  base::OptionalFailure trouble = call.session.grow(anew);
  if (!trouble) {
    call.reply.out = growth_reply(call.session);
    call.reply.messages += growth_notes(call.session);
  }
  return trouble;
}

namespace {

// The file that a word names. One that is there is replaced when the word behind it says so, and
// not else.
base::OptionalFailure file_to_write(const ShellCall& call, std::size_t word,
                                    std::filesystem::path& file) {
  namespace fs = std::filesystem;
  if (call.words.size() < word + 1 || call.words.size() > word + 2) {
    return wrong_usage(call);
  }
  const bool forced = call.words.size() == word + 2;
  const std::string& name = call.words[word];
  if (forced && name_argument(call, word + 1) != "REPLACE") {
    return wrong_usage(call);
  }
  file = name;
  std::error_code ignored;
  for (const fs::path& own : call.session.files()) {
    if (fs::equivalent(file, own, ignored)) {
      return invalid_input("the deck itself is not overwritten", "take another name");
    }
  }
  const fs::file_status status = fs::symlink_status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    return base::OperationFailure{.kind = base::ProgramOutcome::file_trouble,
                                  .why = fmt::format("{} is not a file", name),
                                  .hint = "take another name"};
  }
  if (fs::exists(status) && !forced) {
    return base::OperationFailure{
        .kind = base::ProgramOutcome::file_trouble,
        .why = fmt::format("there is a file {} already, and it is left as it is", name),
        .hint = "take another name, or write replace behind it"};
  }
  return {};
}

// What a command makes of the state goes into the file that its word names.
template <class Make>
base::OptionalFailure write_made(const ShellCall& call, std::size_t word, const Make& make) {
  std::string text;
  std::filesystem::path file;
  base::OptionalFailure trouble = file_to_write(call, word, file);
  trouble = trouble ? trouble : solve_pending_changes(call.session, call.reply);
  trouble = trouble ? trouble : make(file, text);
  if (!trouble) {
    report::write_file(file, text);
    call.reply.messages += fmt::format("note: {} written\n", file.string());
  }
  return trouble;
}

} // namespace

base::OptionalFailure do_plot(const ShellCall& call) {
  return write_made(call, 2, [&](const std::filesystem::path& /*file*/, std::string& svg) {
    return draw_picture(call.session, call.words[1], svg);
  });
}

base::OptionalFailure do_save(const ShellCall& call) {
  return write_made(call, 1, [&](const std::filesystem::path& file, std::string& text) {
    return make_saved_deck_text(call.session, std::filesystem::absolute(file).parent_path(), text);
  });
}

} // namespace spricka::program
