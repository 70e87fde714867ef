// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/actions.hpp"

#include "grammar/lexeme.hpp"
#include "program/shell/plots.hpp"
#include "program/shell/replies.hpp"
#include "program/shell/save.hpp"
#include "program/shell/trouble.hpp"
#include "report/drawing/file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace spricka::program {

using grammar::Quantity;

base::OperationFailure wrong_usage(const ShellCall& call) {
  return invalid_input(fmt::format("write {}", call.usage));
}

std::string name_argument(const ShellCall& call, std::size_t i) {
  return grammar::to_upper(call.words[i].text);
}

std::string remaining_text(const ShellCall& call, std::size_t i) {
  if (i < call.words.size() && call.words[i].text == "=") {
    ++i;
  }
  return i < call.words.size()
             ? std::string(without_comment(std::string_view(call.line).substr(call.words[i].begin)))
             : std::string();
}

base::Trouble number_argument(const ShellCall& call, std::size_t i, Quantity quantity,
                              double& value) {
  const std::string text = remaining_text(call, i);
  return text.empty() ? wrong_usage(call)
                      : read_number(text, call.session.model(), quantity, value);
}

base::Trouble solve_pending_changes(ShellSession& session, ShellReply& reply) {
  if (!session.has_pending_changes()) {
    return {};
  }
  base::Trouble trouble = session.solve();
  if (!trouble) {
    reply.messages +=
        session.has_friction()
            ? fmt::format("note: solved from the last state on, in {} substeps\n", default_substeps)
            : std::string();
    reply.messages += state_notes(session);
  }
  return trouble;
}

namespace {

// What the last solution has to say, and with friction where it came from.
void tell_state(const ShellCall& call) {
  call.reply.out += state_reply(call.session);
  call.reply.messages += state_notes(call.session);
}

base::Trouble do_show(const ShellCall& call) {
  call.reply.out = settings_reply(call.session);
  return {};
}

base::Trouble do_step(const ShellCall& call) {
  if (call.words.size() != 2) {
    return wrong_usage(call);
  }
  base::Trouble trouble = call.session.go_to_step(name_argument(call, 1));
  if (!trouble) {
    tell_state(call);
  }
  return trouble;
}

base::Trouble do_load(const ShellCall& call) {
  double factor = 0.0;
  if (call.words.size() < 3) {
    return wrong_usage(call);
  }
  if (base::Trouble trouble = number_argument(call, 2, Quantity::number, factor)) {
    return trouble;
  }
  return call.session.set_load_factor(name_argument(call, 1), factor);
}

base::Trouble do_fit(const ShellCall& call) {
  if (call.words.size() < 3) {
    return wrong_usage(call);
  }
  const bool declares = call.words[2].text == "=";
  double value = 0.0;
  if (base::Trouble trouble =
          number_argument(call, 2, declares ? Quantity::length : Quantity::number, value)) {
    return trouble;
  }
  if (!declares) {
    return call.session.set_fit_factor(name_argument(call, 1), value);
  }
  base::Trouble trouble = solve_pending_changes(call.session, call.reply);
  trouble = trouble ? trouble : call.session.set_interference(name_argument(call, 1), value);
  if (!trouble) {
    call.reply.messages +=
        fmt::format("note: {} {:.6g} along the normal, on a radius; {:.6g} on a diameter\n",
                    value < 0.0 ? "gap" : "interference", std::abs(value), 2.0 * std::abs(value));
    tell_state(call);
  }
  return trouble;
}

base::Trouble do_mount(const ShellCall& call) {
  return call.words.size() == 2 ? call.session.set_mounted(name_argument(call, 1), true)
                                : wrong_usage(call);
}

base::Trouble do_dismount(const ShellCall& call) {
  return call.words.size() == 2 ? call.session.set_mounted(name_argument(call, 1), false)
                                : wrong_usage(call);
}

base::Trouble do_length(const ShellCall& call) {
  double a = 0.0;
  std::optional<double> c;
  if (call.words.size() < 3) {
    return wrong_usage(call);
  }
  const model::Model& model = call.session.model();
  base::Trouble trouble;
  // Two words behind the name of a crack in space are two axes, not an expression with a blank.
  if (model.mesh.dim == 3 && call.words.size() == 4) {
    trouble = read_number(call.words[2].text, model, Quantity::length, a);
    trouble =
        trouble ? trouble : read_number(call.words[3].text, model, Quantity::length, c.emplace());
  } else {
    trouble = number_argument(call, 2, Quantity::length, a);
  }
  trouble = trouble ? trouble : solve_pending_changes(call.session, call.reply);
  trouble = trouble ? trouble : call.session.set_crack_length(name_argument(call, 1), a, c);
  if (!trouble) {
    const analysis::CondensationFigures& log = call.session.condensation_log();
    call.reply.messages +=
        fmt::format("note: {} nets condensed, {} reused\n", log.condensed, log.reused);
    tell_state(call);
  }
  return trouble;
}

base::Trouble do_set(const ShellCall& call) {
  if (call.words.size() < 4 || call.words[2].text != "=") {
    return wrong_usage(call);
  }
  base::Trouble trouble = solve_pending_changes(call.session, call.reply);
  const std::string before = state_reply(call.session);
  trouble = trouble ? trouble
                    : call.session.define_parameter(call.words[1].text, remaining_text(call, 2));
  if (trouble) {
    return trouble;
  }
  for (const std::string& text : call.session.overridden_settings()) {
    call.reply.messages += fmt::format("note: {}\n", text);
  }
  tell_state(call);
  const bool same = !before.empty() && state_reply(call.session) == before;
  if (call.session.overridden_settings().empty() && same) {
    call.reply.messages += "note: K and the contacts are as they were before\n";
  }
  return {};
}

base::Trouble do_solve(const ShellCall& call) {
  int substeps = default_substeps;
  if (call.words.size() > 1) {
    double given = 0.0;
    if (base::Trouble trouble = number_argument(call, 1, Quantity::number, given)) {
      return trouble;
    }
    if (!(given >= 1.0 && given <= 1e5) || given != static_cast<int>(given)) {
      return invalid_input("the number of substeps is whole, from 1");
    }
    substeps = static_cast<int>(given);
  }
  if (call.session.has_friction() && call.session.has_pending_changes()) {
    call.reply.messages += fmt::format("note: from the last state on, in {} substeps\n", substeps);
  }
  base::Trouble trouble = call.session.solve(substeps);
  if (!trouble) {
    tell_state(call);
  }
  return trouble;
}

// The file that a word names. One that is there is replaced when the word behind it says so, and
// not else.
base::Trouble file_to_write(const ShellCall& call, std::size_t word, std::filesystem::path& file) {
  namespace fs = std::filesystem;
  if (call.words.size() < word + 1 || call.words.size() > word + 2) {
    return wrong_usage(call);
  }
  const bool forced = call.words.size() == word + 2;
  const std::string& name = call.words[word].text;
  if (forced && grammar::to_upper(call.words[word + 1].text) != "REPLACE") {
    return wrong_usage(call);
  }
  file = name;
  std::error_code ignored;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(call.session.sources().count()); ++f) {
    if (fs::equivalent(file, call.session.sources().file_name(f), ignored)) {
      return invalid_input("the deck itself is not overwritten", "take another name");
    }
  }
  const fs::file_status status = fs::symlink_status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    return base::OperationFailure{.kind = base::Outcome::file_trouble,
                                  .why = fmt::format("{} is not a file", name),
                                  .hint = "take another name"};
  }
  if (fs::exists(status) && !forced) {
    return base::OperationFailure{
        .kind = base::Outcome::file_trouble,
        .why = fmt::format("there is a file {} already, and it is left as it is", name),
        .hint = "take another name, or write replace behind it"};
  }
  return {};
}

base::Trouble do_plot(const ShellCall& call) {
  if (call.words.size() < 3) {
    return wrong_usage(call);
  }
  std::string kind = call.words[1].text;
  std::ranges::transform(kind, kind.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  std::string svg;
  std::filesystem::path file;
  base::Trouble trouble = file_to_write(call, 2, file);
  trouble = trouble ? trouble : solve_pending_changes(call.session, call.reply);
  trouble = trouble ? trouble : draw_picture(call.session, kind, svg);
  if (!trouble) {
    report::write_file(file, svg);
    call.reply.messages += fmt::format("note: {} written\n", file.string());
  }
  return trouble;
}

base::Trouble do_save(const ShellCall& call) {
  namespace fs = std::filesystem;
  fs::path file;
  std::string text;
  base::Trouble trouble = file_to_write(call, 1, file);
  trouble = trouble ? trouble : solve_pending_changes(call.session, call.reply);
  trouble = trouble ? trouble : saved_deck(call.session, fs::absolute(file).parent_path(), text);
  if (!trouble) {
    report::write_file(file, text);
    call.reply.messages += fmt::format("note: {} written\n", file.string());
  }
  return trouble;
}

base::Trouble do_reset(const ShellCall& call) {
  base::Trouble trouble = call.session.reset();
  if (!trouble) {
    tell_state(call);
  }
  return trouble;
}

} // namespace

base::Trouble run_shell_command(std::string_view command, const ShellCall& call) {
  using Act = base::Trouble (*)(const ShellCall&);
  static const std::map<std::string_view, Act> acts{
      {"show", do_show},
      {"step", do_step},
      {"load", do_load},
      {"fit", do_fit},
      {"mount", do_mount},
      {"dismount", do_dismount},
      {"length", do_length},
      {"set", do_set},
      {"solve", do_solve},
      {"K", do_k},
      {"pressure", do_pressure},
      {"arc", do_arc},
      {"reaction", do_reaction},
      {"displacement", do_displacement},
      {"stress", do_stress},
      {"map", do_map},
      {"sensitivity", do_sensitivity},
      {"plot", do_plot},
      {"save", do_save},
      {"reset", do_reset},
  };
  return acts.at(command)(call);
}

} // namespace spricka::program
