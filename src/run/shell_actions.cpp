// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/shell_actions.hpp"

#include "grammar/lexeme.hpp"
#include "report/file.hpp"
#include "run/shell_names.hpp"
#include "run/shell_plots.hpp"
#include "run/shell_replies.hpp"
#include "run/shell_save.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>

namespace spricka::run {

namespace {

using grammar::Quantity;

ShellTrouble wrong(const ShellCall& call) {
  return {exit_code::usage, fmt::format("write {}", call.usage), {}};
}

std::string name_at(const ShellCall& call, std::size_t i) {
  return grammar::to_upper(call.words[i].text);
}

// The rest of the line from a word on, an = at its beginning left out.
std::string rest_from(const ShellCall& call, std::size_t i) {
  if (i < call.words.size() && call.words[i].text == "=") {
    ++i;
  }
  return i < call.words.size()
             ? std::string(without_comment(std::string_view(call.line).substr(call.words[i].begin)))
             : std::string();
}

ShellResult number_from(const ShellCall& call, std::size_t i, Quantity quantity, double& value) {
  const std::string text = rest_from(call, i);
  return text.empty() ? wrong(call) : read_number(text, call.session.model(), quantity, value);
}

std::string unit_name(const base::UnitSystem& units, Quantity quantity) {
  switch (quantity) {
  case Quantity::length:
    return units.length_name;
  case Quantity::stress:
    return units.stress_name();
  case Quantity::angle:
    return "rad";
  case Quantity::stress_intensity:
    return units.stress_intensity_name();
  case Quantity::force:
    return units.force_name;
  case Quantity::energy_release:
    return units.force_name + "/" + units.length_name;
  case Quantity::energy:
    return units.force_name + "*" + units.length_name;
  case Quantity::number:
    break;
  }
  return {};
}

// What the last solution has to say, and with friction where it came from.
void tell_state(const ShellCall& call) {
  call.reply.out += state_reply(call.session);
  call.reply.messages += state_notes(call.session);
}

// Solves what is pending before a question; its notes are told.
ShellResult settle(ShellSession& session, ShellReply& reply) {
  if (!session.pending()) {
    return {};
  }
  const ShellResult trouble = session.solve();
  if (!trouble) {
    reply.messages +=
        session.rubs()
            ? fmt::format("note: solved from the last state on, in {} substeps\n", default_substeps)
            : std::string();
    reply.messages += state_notes(session);
  }
  return trouble;
}

ShellResult do_show(const ShellCall& call) {
  call.reply.out = show_reply(call.session);
  return {};
}

ShellResult do_step(const ShellCall& call) {
  if (call.words.size() != 2) {
    return wrong(call);
  }
  const ShellResult trouble = call.session.step(name_at(call, 1));
  if (!trouble) {
    tell_state(call);
  }
  return trouble;
}

ShellResult do_load(const ShellCall& call) {
  double factor = 0.0;
  if (call.words.size() < 3) {
    return wrong(call);
  }
  if (ShellResult trouble = number_from(call, 2, Quantity::number, factor)) {
    return trouble;
  }
  return call.session.load(name_at(call, 1), factor);
}

ShellResult do_fit(const ShellCall& call) {
  if (call.words.size() < 3) {
    return wrong(call);
  }
  const bool declares = call.words[2].text == "=";
  double value = 0.0;
  if (ShellResult trouble =
          number_from(call, 2, declares ? Quantity::length : Quantity::number, value)) {
    return trouble;
  }
  if (!declares) {
    return call.session.fit(name_at(call, 1), value);
  }
  const ShellResult trouble = call.session.interference(name_at(call, 1), value);
  if (!trouble) {
    tell_state(call);
  }
  return trouble;
}

ShellResult do_mount(const ShellCall& call) {
  return call.words.size() == 2 ? call.session.mount(name_at(call, 1), true) : wrong(call);
}

ShellResult do_dismount(const ShellCall& call) {
  return call.words.size() == 2 ? call.session.mount(name_at(call, 1), false) : wrong(call);
}

ShellResult do_length(const ShellCall& call) {
  double a = 0.0;
  if (call.words.size() < 3) {
    return wrong(call);
  }
  ShellResult trouble = number_from(call, 2, Quantity::length, a);
  trouble = trouble ? trouble : call.session.length(name_at(call, 1), a);
  if (!trouble) {
    const CondenseLog& log = call.session.condensed();
    call.reply.messages +=
        fmt::format("note: {} nets condensed, {} reused\n", log.condensed, log.reused);
    tell_state(call);
  }
  return trouble;
}

ShellResult do_set(const ShellCall& call) {
  if (call.words.size() < 4 || call.words[2].text != "=") {
    return wrong(call);
  }
  const ShellResult trouble = call.session.define(call.words[1].text, rest_from(call, 2));
  if (!trouble) {
    tell_state(call);
  }
  return trouble;
}

ShellResult do_solve(const ShellCall& call) {
  int substeps = default_substeps;
  if (call.words.size() > 1) {
    double given = 0.0;
    if (ShellResult trouble = number_from(call, 1, Quantity::number, given)) {
      return trouble;
    }
    if (!(given >= 1.0 && given <= 1e5) || given != static_cast<int>(given)) {
      return ShellTrouble{exit_code::usage, "the number of substeps is whole, from 1", {}};
    }
    substeps = static_cast<int>(given);
  }
  if (call.session.rubs() && call.session.pending()) {
    call.reply.messages += fmt::format("note: from the last state on, in {} substeps\n", substeps);
  }
  const ShellResult trouble = call.session.solve(substeps);
  if (!trouble) {
    tell_state(call);
  }
  return trouble;
}

ShellResult do_k(const ShellCall& call) {
  const std::string only = call.words.size() > 1 ? name_at(call, 1) : std::string();
  const results::StepResult& before = call.session.now();
  if (before.tips.empty()) {
    return ShellTrouble{exit_code::usage, "the deck has no crack", {}};
  }
  std::vector<std::string> names;
  for (const results::TipResult& tip : before.tips) {
    names.push_back(tip.name);
  }
  for (const std::string& crack : crack_names(call.session.model())) {
    names.push_back(crack);
  }
  std::size_t index = 0;
  ShellResult trouble = only.empty() ? ShellResult() : find_name(names, "crack", only, index);
  trouble = trouble ? trouble : settle(call.session, call.reply);
  trouble = trouble ? trouble : call.session.estimate();
  if (!trouble) {
    call.reply.out = k_reply(call.session, only);
    call.reply.messages += k_notes(call.session, only);
  }
  return trouble;
}

// The contact of that name at the present state.
ShellResult contact_now(const ShellCall& call, const results::ContactResult** contact) {
  const std::string name = name_at(call, 1);
  std::size_t index = 0;
  ShellResult trouble = find_name(pair_names(call.session.model()), "contact", name, index);
  trouble = trouble ? trouble : settle(call.session, call.reply);
  if (trouble) {
    return trouble;
  }
  *contact = results::find_contact(call.session.now(), name);
  if (*contact == nullptr) {
    return ShellTrouble{
        exit_code::check_failed, fmt::format("the faces of {} touch nowhere", name), {}};
  }
  return {};
}

ShellResult do_pressure(const ShellCall& call) {
  if (call.words.size() < 2) {
    return wrong(call);
  }
  if (call.words.size() == 3) {
    return answer_quantity(
        call.session, fmt::format("CPRESS.AT({},NOW,{})", name_at(call, 1), call.words[2].text),
        call.reply);
  }
  if (call.words.size() == 4) {
    return answer_quantity(call.session,
                           fmt::format("CPRESS.NEAR({},{},{},NOW)", name_at(call, 1),
                                       call.words[2].text, call.words[3].text),
                           call.reply);
  }
  const results::ContactResult* contact = nullptr;
  if (call.words.size() != 2) {
    return wrong(call);
  }
  if (ShellResult trouble = contact_now(call, &contact)) {
    return trouble;
  }
  call.reply.out = pressure_reply(call.session, *contact);
  if (!contact->unbounded.empty()) {
    call.reply.messages += "note: it is pressed up to an edge: there the pressure has no bound\n";
  }
  return {};
}

ShellResult do_arc(const ShellCall& call) {
  if (call.words.size() != 2) {
    return wrong(call);
  }
  const results::ContactResult* contact = nullptr;
  const ShellResult trouble = contact_now(call, &contact);
  if (!trouble) {
    call.reply.out = arc_reply(call.session, *contact);
  }
  return trouble;
}

ShellResult answer_all(const ShellCall& call, const std::vector<std::string>& quantities) {
  for (const std::string& quantity : quantities) {
    if (ShellResult trouble = answer_quantity(call.session, quantity, call.reply)) {
      return trouble;
    }
  }
  return {};
}

ShellResult do_reaction(const ShellCall& call) {
  if (call.words.size() != 2) {
    return wrong(call);
  }
  std::vector<std::string> quantities;
  for (int axis = 0; axis < call.session.model().mesh.dim; ++axis) {
    quantities.push_back(fmt::format("REACTION({},NOW,{})", call.words[1].text, "XYZ"[axis]));
  }
  return answer_all(call, quantities);
}

// The point of a command as arguments of a quantity; empty: not as many numbers as there are axes.
std::string point_of(const ShellCall& call) {
  const auto dim = static_cast<std::size_t>(call.session.model().mesh.dim);
  std::string point;
  for (std::size_t i = 1; i < call.words.size(); ++i) {
    point += call.words[i].text + ",";
  }
  return call.words.size() == dim + 1 ? point : std::string();
}

ShellResult do_displacement(const ShellCall& call) {
  const std::string point = point_of(call);
  std::vector<std::string> quantities;
  for (int axis = 0; axis < call.session.model().mesh.dim; ++axis) {
    quantities.push_back(fmt::format("U.{}.AT({}NOW)", "XYZ"[axis], point));
  }
  return point.empty() ? wrong(call) : answer_all(call, quantities);
}

ShellResult do_stress(const ShellCall& call) {
  const std::string point = point_of(call);
  std::vector<std::string> quantities;
  const bool solid = call.session.model().mesh.dim == 3;
  for (const char* component : {"XX", "YY", "ZZ", "XY", "YZ", "XZ", "P1", "MISES"}) {
    if (solid || (std::string_view(component) != "YZ" && std::string_view(component) != "XZ")) {
      quantities.push_back(fmt::format("S.{}.AT({}NOW)", component, point));
    }
  }
  return point.empty() ? wrong(call) : answer_all(call, quantities);
}

ShellResult do_map(const ShellCall& call) {
  if (call.words.size() != 2 && call.words.size() != 4) {
    return wrong(call);
  }
  ShellResult trouble = settle(call.session, call.reply);
  if (trouble) {
    return trouble;
  }
  if (call.words.size() == 2) {
    trouble = call.session.map_path(name_at(call, 1));
  } else {
    double from = 0.0;
    double to = 1.0;
    const model::Model& model = call.session.model();
    trouble = read_number(call.words[2].text, model, Quantity::number, from);
    trouble = trouble ? trouble : read_number(call.words[3].text, model, Quantity::number, to);
    trouble = trouble ? trouble : call.session.map_case(name_at(call, 1), from, to);
  }
  if (trouble) {
    return trouble;
  }
  const results::LoadPath& path = *call.session.mapped();
  call.reply.out = map_reply(call.session);
  for (const std::string& note : path.notes) {
    call.reply.messages += note.starts_with("warning: ") ? note + "\n" : "note: " + note + "\n";
  }
  return {};
}

ShellResult do_sensitivity(const ShellCall& call) {
  ShellResult trouble = settle(call.session, call.reply);
  trouble = trouble ? trouble : call.session.estimate();
  if (trouble) {
    return trouble;
  }
  if (call.session.now().tips.empty()) {
    return ShellTrouble{exit_code::usage, "the deck has no crack", {}};
  }
  call.reply.out = sensitivity_reply(call.session);
  for (const results::TipResult& tip : call.session.now().tips) {
    for (const std::string& note : tip.sensitivities.notes) {
      call.reply.messages += fmt::format("note: {}: {}\n", tip.name, note);
    }
  }
  return {};
}

ShellResult do_plot(const ShellCall& call) {
  if (call.words.size() != 3) {
    return wrong(call);
  }
  std::string kind = call.words[1].text;
  std::ranges::transform(kind, kind.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  std::string svg;
  ShellResult trouble = settle(call.session, call.reply);
  trouble = trouble ? trouble : picture(call.session, kind, svg);
  if (!trouble) {
    report::write_file(call.words[2].text, svg);
    call.reply.messages += fmt::format("note: {} written\n", call.words[2].text);
  }
  return trouble;
}

ShellResult do_save(const ShellCall& call) {
  if (call.words.size() != 2) {
    return wrong(call);
  }
  namespace fs = std::filesystem;
  const fs::path file = call.words[1].text;
  const fs::path own = call.session.sources().name(0);
  std::error_code ignored;
  if (fs::equivalent(file, own, ignored)) {
    return ShellTrouble{exit_code::usage, "the deck itself is not overwritten",
                        "take another name"};
  }
  std::string text;
  ShellResult trouble = settle(call.session, call.reply);
  trouble = trouble ? trouble : saved_deck(call.session, fs::absolute(file).parent_path(), text);
  if (!trouble) {
    report::write_file(file, text);
    call.reply.messages += fmt::format("note: {} written\n", file.string());
  }
  return trouble;
}

ShellResult do_reset(const ShellCall& call) {
  const ShellResult trouble = call.session.reset();
  if (!trouble) {
    tell_state(call);
  }
  return trouble;
}

} // namespace

ShellResult answer_quantity(ShellSession& session, const std::string& text, ShellReply& reply) {
  model::Check check;
  double value = 0.0;
  ShellResult trouble = read_quantity(text, session.model(), check);
  trouble = trouble ? trouble : settle(session, reply);
  trouble = trouble ? trouble : session.evaluate(check, value);
  if (trouble) {
    return trouble;
  }
  const std::string unit =
      unit_name(session.model().units, grammar::find_quantity(check.quantity)->quantity);
  std::string name = check.quantity + "(";
  for (std::size_t i = 0; i < check.arguments.size(); ++i) {
    name += i > 0 ? "," : "";
    name += std::holds_alternative<std::string>(check.arguments[i])
                ? std::get<std::string>(check.arguments[i])
                : fmt::format("{:.6g}", std::get<double>(check.arguments[i]));
  }
  reply.out += fmt::format("{}) = {:.10g}{}{}\n", name, value, unit.empty() ? "" : " ", unit);
  return {};
}

ShellResult carry_out(std::string_view command, const ShellCall& call) {
  using Act = ShellResult (*)(const ShellCall&);
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

} // namespace spricka::run
