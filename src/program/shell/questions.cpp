// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"
#include "base/quantity.hpp"
#include "model/model.hpp"
#include "program/shell/actions.hpp"
#include "program/shell/k_replies.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/replies.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::vector<std::string> names_with_k(const results::StepResult& step) {
  std::vector<std::string> names;
  for (const results::FrontResult& front : step.fronts) {
    names.push_back(front.name);
  }
  return names;
}

} // namespace

base::Trouble do_k(const ShellCall& call) {
  const std::string only = call.words.size() > 1 ? name_argument(call, 1) : std::string();
  std::vector<std::string> names = names_with_k(call.session.current_result());
  if (names.empty()) {
    return invalid_input("the deck has no crack");
  }
  for (const std::string& crack : crack_names(call.session.model())) {
    if (std::ranges::find(names, crack) == names.end()) { // of two tips
      names.push_back(crack);
    }
  }
  std::size_t index = 0;
  base::Trouble trouble = only.empty() ? base::Trouble() : find_name(names, "crack", only, index);
  trouble = trouble ? trouble : solve_pending_changes(call.session, call.reply);
  trouble = trouble ? trouble : call.session.estimate_accuracy();
  if (!trouble) {
    call.reply.out = k_reply(call.session, only);
    call.reply.messages += k_notes(call.session, only);
  }
  return trouble;
}

namespace {

// The contact of that name at the present state.
base::Trouble contact_now(const ShellCall& call, const results::ContactResult** contact) {
  const std::string name = name_argument(call, 1);
  std::size_t index = 0;
  base::Trouble trouble = find_name(pair_names(call.session.model()), "contact", name, index);
  trouble = trouble ? trouble : solve_pending_changes(call.session, call.reply);
  if (trouble) {
    return trouble;
  }
  *contact = results::find_contact(call.session.current_result(), name);
  if (*contact == nullptr) {
    return base::OperationFailure{.kind = base::Outcome::check_failed,
                                  .why = fmt::format("the faces of {} touch nowhere", name)};
  }
  return {};
}

} // namespace

namespace {

// The words from one on as a point in the arguments of a quantity; empty: not as many numbers as
// there are axes.
std::string point_of(const ShellCall& call, std::size_t first) {
  const auto dim = static_cast<std::size_t>(call.session.model().mesh.dim);
  std::string point;
  for (std::size_t i = first; i < call.words.size(); ++i) {
    point += call.words[i].text + ",";
  }
  return call.words.size() == dim + first ? point : std::string();
}

} // namespace

base::Trouble do_pressure(const ShellCall& call) {
  if (call.words.size() < 2) {
    return wrong_usage(call);
  }
  if (call.words.size() == 3) {
    return answer_quantity(
        call.session,
        fmt::format("CPRESS.AT({},NOW,{})", name_argument(call, 1), call.words[2].text),
        call.reply);
  }
  if (call.words.size() > 3) {
    const std::string point = point_of(call, 2);
    return point.empty() ? wrong_usage(call)
                         : answer_quantity(
                               call.session,
                               fmt::format("CPRESS.NEAR({},{}NOW)", name_argument(call, 1), point),
                               call.reply);
  }
  const results::ContactResult* contact = nullptr;
  if (base::Trouble trouble = contact_now(call, &contact)) {
    return trouble;
  }
  call.reply.out = pressure_reply(call.session, *contact);
  if (!contact->unbounded.empty()) {
    call.reply.messages += "note: it is pressed up to an edge: there the pressure has no bound\n";
  }
  return {};
}

base::Trouble do_arc(const ShellCall& call) {
  if (call.words.size() != 2) {
    return wrong_usage(call);
  }
  const results::ContactResult* contact = nullptr;
  base::Trouble trouble = contact_now(call, &contact);
  if (!trouble) {
    call.reply.out = arc_reply(call.session, *contact);
  }
  return trouble;
}

namespace {

base::Trouble answer_all(const ShellCall& call, const std::vector<std::string>& quantities) {
  for (const std::string& quantity : quantities) {
    if (base::Trouble trouble = answer_quantity(call.session, quantity, call.reply)) {
      return trouble;
    }
  }
  return {};
}

} // namespace

base::Trouble do_reaction(const ShellCall& call) {
  if (call.words.size() != 2) {
    return wrong_usage(call);
  }
  std::vector<std::string> quantities;
  quantities.reserve(3);
  for (int axis = 0; axis < call.session.model().mesh.dim; ++axis) {
    quantities.push_back(fmt::format("REACTION({},NOW,{})", call.words[1].text, "XYZ"[axis]));
  }
  return answer_all(call, quantities);
}

base::Trouble do_displacement(const ShellCall& call) {
  const std::string point = point_of(call, 1);
  std::vector<std::string> quantities;
  quantities.reserve(3);
  for (int axis = 0; axis < call.session.model().mesh.dim; ++axis) {
    quantities.push_back(fmt::format("U.{}.AT({}NOW)", "XYZ"[axis], point));
  }
  return point.empty() ? wrong_usage(call) : answer_all(call, quantities);
}

base::Trouble do_stress(const ShellCall& call) {
  const std::string point = point_of(call, 1);
  std::vector<std::string> quantities;
  const bool solid = call.session.model().mesh.dim == 3;
  for (const char* component : {"XX", "YY", "ZZ", "XY", "YZ", "XZ", "P1", "MISES"}) {
    if (solid || (std::string_view(component) != "YZ" && std::string_view(component) != "XZ")) {
      quantities.push_back(fmt::format("S.{}.AT({}NOW)", component, point));
    }
  }
  return point.empty() ? wrong_usage(call) : answer_all(call, quantities);
}

base::Trouble do_map(const ShellCall& call) {
  if (call.words.size() != 2 && call.words.size() != 4) {
    return wrong_usage(call);
  }
  base::Trouble trouble = solve_pending_changes(call.session, call.reply);
  if (trouble) {
    return trouble;
  }
  if (call.words.size() == 2) {
    trouble = call.session.map_path(name_argument(call, 1));
  } else {
    double from = 0.0;
    double to = 1.0;
    const model::Model& model = call.session.model();
    trouble = read_number(call.words[2].text, model, base::Quantity::number, from);
    trouble =
        trouble ? trouble : read_number(call.words[3].text, model, base::Quantity::number, to);
    trouble = trouble ? trouble : call.session.map_case(name_argument(call, 1), from, to);
  }
  if (trouble) {
    return trouble;
  }
  const results::LoadPathResult& path = *call.session.last_mapped_path();
  call.reply.out = map_reply(call.session);
  for (const results::Note& note : path.notes) {
    call.reply.messages += fmt::format(
        "{}{}\n", results::is_warning(note) ? "" : "note: ", results::text_with_code(note));
  }
  return {};
}

base::Trouble do_sensitivity(const ShellCall& call) {
  base::Trouble trouble = solve_pending_changes(call.session, call.reply);
  trouble = trouble ? trouble : call.session.estimate_accuracy();
  if (trouble) {
    return trouble;
  }
  if (names_with_k(call.session.current_result()).empty()) {
    return invalid_input("the deck has no crack");
  }
  call.reply.out = sensitivity_reply(call.session);
  for (const results::FrontResult& front : call.session.current_result().fronts) {
    for (const std::string& note : front.sensitivities.notes) {
      call.reply.messages += fmt::format("note: {}: {}\n", front.name, note);
    }
  }
  return {};
}

base::Trouble answer_quantity(ShellSession& session, const std::string& text, ShellReply& reply) {
  model::ResultCheck check;
  double value = 0.0;
  base::Trouble trouble = read_quantity(text, session.model(), check);
  trouble = trouble ? trouble : solve_pending_changes(session, reply);
  trouble = trouble ? trouble : session.evaluate(check, value);
  if (trouble) {
    return trouble;
  }
  const std::string unit =
      base::unit_name(session.model().units, grammar::find_quantity(check.quantity)->quantity);
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

} // namespace spricka::program
