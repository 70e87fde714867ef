// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/replies.hpp"

#include "analysis/recover/closed_parts.hpp"
#include "model/model.hpp"
#include "program/shell/k_replies.hpp"
#include "program/shell/known_names.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/sensitivity_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr double degree = 180.0 / std::numbers::pi;
using report::ReportTable;

std::string number(double value) {
  return fmt::format("{:.7g}", value);
}

std::string place(const results::ContactResult& contact, double at, const base::UnitSystem& units) {
  return contact.round ? fmt::format("{:.1f} deg", at * degree)
                       : fmt::format("{:.5g} {}", at, units.length_name);
}

const char* word_of(const results::ContactPoint& point) {
  switch (point.state) {
  case results::ContactState::stick:
    return "sticks";
  case results::ContactState::slip:
    return "slips";
  case results::ContactState::closed:
    return "closed";
  case results::ContactState::open:
    break;
  }
  return point.closed ? "closed" : "open";
}

std::string closed_part(const results::ContactResult& contact, const base::UnitSystem& units) {
  if (!contact.mounted) {
    return "not mounted";
  }
  if (contact.closed == 0) {
    return "open";
  }
  if (contact.space) {
    return fmt::format("{}/{} closed, area {:.6g}", contact.closed, contact.rows, contact.area);
  }
  return fmt::format("{}/{} closed, {} .. {}", contact.closed, contact.rows,
                     place(contact, contact.arc_from, units),
                     place(contact, contact.arc_to, units));
}

} // namespace

std::string state_reply(const ShellSession& session) {
  std::string text = k_state(session);
  for (const results::ContactResult& contact : session.current_result().contacts) {
    text += fmt::format("{:<12} {}\n", contact.name, closed_part(contact, session.model().units));
  }
  return text;
}

std::string state_notes(ShellSession& session) {
  std::string text;
  for (const std::string& note : session.new_notes()) {
    text += note + "\n";
  }
  return text + k_concerns(session);
}

std::string pressure_reply(const ShellSession& session, const results::ContactResult& contact) {
  const base::UnitSystem& units = session.model().units;
  const auto card =
      std::ranges::find(session.model().contacts, contact.name, &model::Contact::name);
  const bool consistent = card != session.model().contacts.end() &&
                          card->recovery == model::PressureRecovery::consistent;
  ReportTable table{
      "",
      {{"x", units.length_name, false},
       {"y", units.length_name, false},
       {contact.round ? "theta" : "along", contact.round ? "deg" : units.length_name, false},
       {"p", units.stress_name(), false}},
      {}};
  const bool solid = session.model().mesh.dim == 3;
  if (solid) {
    table.columns.insert(table.columns.begin() + 2, {"z", units.length_name, false});
  }
  if (contact.sheared) {
    table.columns.push_back({"q", units.stress_name(), false});
  }
  table.columns.push_back({"gap", units.length_name, false});
  table.columns.push_back({"", "", true});
  for (const results::ContactPoint& p : contact.points) {
    std::vector<std::string> row{number(p.x.x()), number(p.x.y())};
    if (solid) {
      row.push_back(number(p.x.z()));
    }
    row.push_back(contact.round ? fmt::format("{:.3f}", p.theta * degree) : number(p.arc));
    row.push_back(number(consistent ? p.p_consistent : p.p_lumped));
    if (contact.sheared) {
      row.push_back(number(consistent ? p.q_consistent : p.q_lumped));
    }
    row.push_back(fmt::format("{:.4g}", p.gap));
    row.emplace_back(word_of(p));
    table.rows.push_back(std::move(row));
  }
  return report::to_text(table);
}

std::string arc_reply(const ShellSession& session, const results::ContactResult& contact) {
  std::string text =
      fmt::format("{:<12} {}\n", contact.name, closed_part(contact, session.model().units));
  if (contact.space) { // a part of a surface has no two ends
    return text;
  }
  const std::vector<std::array<double, 2>> parts = analysis::closed_parts(contact);
  for (std::size_t i = 0; contact.mounted && parts.size() > 1 && i < parts.size(); ++i) {
    text += fmt::format("  part {} of {}: {} .. {}\n", i + 1, parts.size(),
                        place(contact, parts[i][0], session.model().units),
                        place(contact, parts[i][1], session.model().units));
  }
  return text;
}

std::string sensitivity_reply(const ShellSession& session) {
  return report::to_text(report::untitled(report::sensitivity_table(
      session.displayed_model(), session.run_results().increments.front())));
}

namespace {

std::string action_text(const model::Model& model, const model::Action& action) {
  if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
    return fmt::format("LOAD {} {:.10g}", model.cases[load->load_case.index()].name, load->factor);
  }
  if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
    return fmt::format("FIT {} {:.10g}", model.contacts[fit->contact.index()].name, fit->factor);
  }
  if (const auto* on = std::get_if<model::MountContact>(&action)) {
    return "MOUNT " + model.contacts[on->contact.index()].name;
  }
  return "DISMOUNT " +
         model.contacts[std::get<model::DismountContact>(action).contact.index()].name;
}

std::string actions_text(const model::Model& model, const model::Step& step) {
  std::string text;
  for (const model::Action& action : step.actions) {
    text += (text.empty() ? "" : ", ") + action_text(model, action);
  }
  return text;
}

std::string gap_text(const ShellSession& session, std::size_t contact) {
  const model::Contact& card = session.model().contacts[contact];
  const std::string& unit = session.model().units.length_name;
  if (!card.gap) {
    return "gap measured";
  }
  const bool own = session.user_interferences().contains(card.name);
  return fmt::format("{} {:.6g} {}{}", *card.gap < 0.0 ? "interference" : "gap",
                     std::abs(*card.gap), unit, own ? ", set here" : "");
}

} // namespace

std::string settings_reply(const ShellSession& session) {
  const model::Model& model = session.model();
  std::string text;
  const auto line = [&](const std::string& what, const std::string& name,
                        const std::string& value) {
    text += fmt::format("{:<10} {:<14} {}\n", what, name, value);
  };
  if (!model.title.empty()) {
    line("deck", "", model.title);
  }
  line("state", session.base_step(), "the end of this step");
  for (const model::Step& step : session.applied_changes()) {
    line("then", "", actions_text(model, step));
  }
  if (session.has_pending_changes()) {
    line("pending", "", actions_text(model, session.pending_changes()));
  }
  const analysis::StepFactors& factors = session.factors();
  for (std::size_t c = 0; c < model.cases.size(); ++c) {
    line("load", model.cases[c].name,
         fmt::format("{:.10g}", factors.case_factor[static_cast<Eigen::Index>(c)]));
  }
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    std::string value = fmt::format("{:.10g} ({})", factors.fit[c], gap_text(session, c));
    value += model.contacts[c].mu > 0.0 ? fmt::format(", MU {:.6g}", model.contacts[c].mu) : "";
    value += factors.mounted[c] ? "" : ", not mounted";
    line("fit", model.contacts[c].name, value);
  }
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    const bool own = session.user_crack_sizes().contains(model.cracks[c].name);
    const CrackSize size = session.crack_size(c);
    line("length", model.cracks[c].name,
         fmt::format("{:.10g} {}{}{}", size.a, model.units.length_name,
                     size.c > 0.0 ? fmt::format(", C = {:.10g} {}", size.c, model.units.length_name)
                                  : std::string(),
                     own ? ", set here" : ""));
  }
  for (const auto& [name, expression] : session.defines()) {
    line("set", name, expression);
  }
  line("steps", "", fmt::format("{}", fmt::join(step_names(model), " ")));
  if (!model.load_paths.empty()) {
    line("paths", "", fmt::format("{}", fmt::join(path_names(model), " ")));
  }
  return text;
}

} // namespace spricka::program
