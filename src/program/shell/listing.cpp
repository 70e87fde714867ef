// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/listing.hpp"

#include "base/quantity.hpp"
#include "model/model.hpp"
#include "program/shell/deck_edit.hpp"
#include "program/shell/known_names.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/growth_tables.hpp"
#include "report/topics/k_tables.hpp"
#include "report/topics/sensitivity_tables.hpp"
#include "results/result_unit.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using report::ReportTable;
using results::FrontPointResult;
using results::FrontResult;

std::string number(double value) {
  return fmt::format("{:.7g}", value);
}

/// The points with the smallest and the largest K1, those at the surface left out: K there is a
/// number of the mesh.
std::pair<const FrontPointResult*, const FrontPointResult*> extremes(const FrontResult& front) {
  const FrontPointResult* least = nullptr;
  const FrontPointResult* most = nullptr;
  for (const FrontPointResult& place : front.points) {
    if (place.at_surface && front.points.size() > 2) {
      continue;
    }
    least = least == nullptr || place.K1 < least->K1 ? &place : least;
    most = most == nullptr || place.K1 > most->K1 ? &place : most;
  }
  return {least, most};
}

std::string front_state(const FrontResult& front, const base::UnitSystem& units) {
  const auto [least, most] = extremes(front);
  if (least == nullptr) {
    return {};
  }
  const base::OutputUnit unit = units.output_stress_intensity();
  const std::string size =
      fmt::format("{:<12} a = {:<10.6g} ", front.name, units.output_length().from_deck(front.a));
  if (front.two_materials) {
    const base::OutputUnit of_G = base::output_unit(units, base::QuantityKind::energy_release);
    return fmt::format("{}G = {:.7g}\n", size, of_G.from_deck(least->G));
  }
  const auto K1 = [&](const FrontPointResult& point) { return unit.from_deck(point.K1); };
  // What `list K` estimates and takes out is still in it.
  const char* const raw = front.has_error_bar() ? "" : "raw ";
  return front.is_tip() ? fmt::format("{}{}K1 = {:<12.7g} K2 = {:<12.7g} {}\n", size, raw,
                                      K1(*least), unit.from_deck(least->K2), unit.name)
                        : fmt::format("{}{}K1 = {:.7g} .. {:.7g} {}\n", size, raw, K1(*least),
                                      K1(*most), unit.name);
}

std::string closed_part(const results::ContactResult& contact, const base::UnitSystem& units) {
  const auto place = [&](double at) {
    return contact.round ? fmt::format("{:.1f} deg", at * base::degrees_per_radian)
                         : units.output_length().text(at, 5);
  };
  if (!contact.mounted) {
    return "not mounted";
  }
  if (contact.closed == 0) {
    return "open";
  }
  const std::string rows = fmt::format("{}/{} closed", contact.closed, contact.rows);
  return contact.space
             ? fmt::format(
                   "{}, area {:.6g}", rows,
                   base::output_unit(units, base::QuantityKind::area).from_deck(contact.area))
             : fmt::format("{}, {} .. {}", rows, place(contact.arc_from), place(contact.arc_to));
}

std::string invalid_reason_note(const FrontResult& front) {
  return front.invalid_reason.empty()
             ? std::string()
             : fmt::format("warning: {}: {}\n", front.name, front.invalid_reason);
}

std::string touching_note(const FrontResult& front) {
  const auto closed = std::ranges::count_if(front.points, &FrontPointResult::closed);
  if (closed == 0) {
    return {};
  }
  return front.is_tip()
             ? fmt::format("note: {}: the crack's faces touch at the tip, K1 is 0\n", front.name)
             : fmt::format("note: {}: the crack's faces touch at {} of {} points, K1 is 0 there\n",
                           front.name, closed, front.points.size());
}

// Warnings of a state, and behind them its notes that were not given before.
std::vector<std::string> new_notes(const results::LoadStepResult& state,
                                   std::set<std::string>& reported) {
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
  for (const results::Note& note : state.notes) {
    if (results::is_warning(note)) {
      warnings.push_back(results::text_with_code(note));
    } else if (reported.insert(note.text).second) {
      notes.push_back("note: " + note.text);
    }
  }
  warnings.insert(warnings.end(), notes.begin(), notes.end());
  return warnings;
}

} // namespace

std::string K_and_contact_state_reply(const ShellSession& session) {
  const base::UnitSystem& units = session.model().units;
  std::string text;
  for (const FrontResult& front : session.current_result().fronts) {
    text += front_state(front, units);
  }
  for (const results::ContactResult& contact : session.current_result().contacts) {
    text += fmt::format("{:<12} {}\n", contact.name, closed_part(contact, units));
  }
  return text;
}

std::string warnings_and_new_notes(ShellSession& session) {
  std::string text;
  for (const std::string& note : new_notes(session.current_result(), session.reported_notes())) {
    text += note + "\n";
  }
  for (const FrontResult& front : session.current_result().fronts) {
    text += invalid_reason_note(front);
  }
  return text;
}

results::CrackLengthResult present_state_of_crack(const ShellSession& session,
                                                  const std::string& only) {
  results::CrackLengthResult alone;
  results::LoadStepResult& step = alone.steps.emplace_back();
  step.step = "NOW";
  for (const FrontResult& front : session.current_result().fronts) {
    if (is_tip_of_crack(front.name, only)) {
      step.fronts.push_back(front);
    }
  }
  return alone;
}

std::string k_reply(const ShellSession& session, const std::string& only) {
  const results::CrackLengthResult fronts = present_state_of_crack(session, only);
  std::vector<ReportTable> tables =
      report::front_tables(session.solver().displayed_model(), fronts);
  if (tables.empty()) {
    tables.push_back(report::without_title(report::tip_k_table(
        session.solver().displayed_model(), fronts, report::KTableExtent::full)));
  }
  std::string text;
  for (const ReportTable& table : tables) {
    text += report::table_to_text(table);
  }
  return text;
}

std::string k_notes(const ShellSession& session, const std::string& only) {
  std::string text;
  const results::CrackLengthResult now = present_state_of_crack(session, only);
  for (const FrontResult& front : now.steps.front().fronts) {
    text += invalid_reason_note(front) + touching_note(front);
    if (!front.has_error_bar()) {
      text += fmt::format("note: {}: no error bar: {}\n", front.name, front.missing_bar_reason);
    }
  }
  return text;
}

std::string sensitivity_reply(const ShellSession& session) {
  return report::table_to_text(report::without_title(report::sensitivity_table(
      session.solver().displayed_model(), session.run_results().increments.front())));
}

std::string contact_reply(const ShellSession& session, const results::ContactResult& contact) {
  const int dim = session.model().mesh.dim;
  std::vector<const results::ContactPointQuantity*> columns;
  for (const results::ContactPointQuantity& q : results::point_quantities) {
    const std::string_view name = q.name;
    const bool of_place = name == "theta" ? contact.round : name == "arc" && !contact.round;
    const bool other_place = name == "theta" || name == "arc";
    const bool shown = q.least_dim <= dim && (!q.friction || contact.sheared || q.is_word());
    if (of_place || (shown && !other_place)) {
      columns.push_back(&q);
    }
  }
  ReportTable table;
  for (const results::ContactPointQuantity* q : columns) {
    table.columns.push_back(
        {q->name, base::output_unit(session.model().units, q->kind).name, q->is_word()});
  }
  for (const results::ContactPoint& point : contact.points) {
    std::vector<std::string> row;
    for (const results::ContactPointQuantity* q : columns) {
      const base::OutputUnit unit = base::output_unit(session.model().units, q->kind);
      row.push_back(q->is_word() ? results::display_word(point.*(q->state))
                                 : number(unit.from_deck(q->extract_value(point))));
    }
    table.rows.push_back(std::move(row));
  }
  return report::table_to_text(table);
}

namespace {

/// A point of a front whose K is shown along a map.
struct MappedFrontPoint {
  std::string name; ///< of a tip, or of a front and number of the point
  const results::LoadPathFrontPoint* point = nullptr;
  bool is_tip = false;
};

// The tips; in space of each front the points inside with the largest and the smallest K1 at the
// end of the path.
std::vector<MappedFrontPoint> mapped_points(const results::LoadPathResult& path) {
  std::vector<MappedFrontPoint> out;
  for (const results::LoadPathFront& front : path.fronts) {
    const FrontResult at_end = front.at(path.t.back());
    const auto [least, most] = extremes(at_end);
    for (const results::LoadPathFrontPoint& point : front.points) {
      const auto is = [&](const FrontPointResult* one) {
        return one != nullptr && one->number == point.point_at_start.number;
      };
      if (is(least) || is(most)) {
        const std::string name = at_end.is_tip()
                                     ? front.front_without_points.name
                                     : fmt::format("{} point {}", front.front_without_points.name,
                                                   point.point_at_start.number);
        out.push_back({name, &point, at_end.is_tip()});
      }
    }
  }
  return out;
}

} // namespace

std::string K_along_load_path_reply(const ShellSession& session) {
  const results::LoadPathResult& path = *session.last_followed_path();
  const PathParameterRange& range = session.path_parameter_range();
  const base::OutputUnit K = session.model().units.output_stress_intensity();
  ReportTable table{"", {{range.what, "", false}}, {}};
  const std::vector<MappedFrontPoint> points =
      path.t.empty() ? std::vector<MappedFrontPoint>() : mapped_points(path);
  for (const MappedFrontPoint& mapped : points) {
    const bool alone = mapped.is_tip && points.size() == 1;
    const std::string of = alone ? std::string() : " " + mapped.name;
    table.columns.push_back({"K1" + of, K.name, false});
    table.columns.push_back({fmt::format("dK1/d{}{}", range.what, of), K.name, false});
    if (mapped.is_tip) {
      table.columns.push_back({"K2" + of, K.name, false});
    }
  }
  for (const results::LoadPathContact& contact : path.contacts) {
    table.columns.push_back({contact.name, "closed", false});
  }
  const double width = range.to - range.from;
  for (std::size_t k = 0; k < path.t.size(); ++k) {
    std::vector<std::string> row{number(range.from + width * path.t[k])};
    for (const MappedFrontPoint& mapped : points) {
      const auto& [K1, K2, K3] = mapped.point->K;
      row.push_back(number(K.from_deck(K1.value_at_knot(k))));
      row.push_back(number(K.from_deck(K1.slope_after(k) / width)));
      if (mapped.is_tip) {
        row.push_back(number(K.from_deck(K2.value_at_knot(k))));
      }
    }
    for (const results::LoadPathContact& contact : path.contacts) {
      row.push_back(fmt::format("{}/{}", contact.closed[k], contact.rows));
    }
    table.rows.push_back(std::move(row));
  }
  return report::table_to_text(table);
}

std::string growth_reply(const ShellSession& session) {
  const results::RunResult& run = session.growth().result();
  return report::table_to_text(
             report::without_title(report::growth_station_table(session.model(), run))) +
         report::life_summary(session.model(), run);
}

std::string growth_notes(const ShellSession& session) {
  const ShellGrowth& growth = session.growth();
  std::string text = fmt::format("note: {} of {} fronts solved", growth.solved_count(),
                                 growth.result().increments.size());
  text += growth.why_solved_anew().empty()
              ? "\n"
              : fmt::format(", earlier ones did not serve: {}\n", growth.why_solved_anew());
  for (const std::string& warning : results::text_with_code(growth.result().warnings)) {
    text += warning + "\n";
  }
  return text;
}

namespace {

std::string actions_text(const model::Model& model, const model::Step& step) {
  std::vector<std::string> texts;
  for (const model::StepAction& action : step.actions) {
    texts.push_back(step_action_text(model, action));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

} // namespace

std::string changes_and_state_reply(const ShellSession& session) {
  const model::Model& model = session.model();
  std::string text = fmt::format("state    the end of step {}\n", session.base_step_name());
  for (const model::Step& step : session.changes().applied) {
    text += fmt::format("then     {}\n", actions_text(model, step));
  }
  if (session.has_pending_changes()) {
    text += fmt::format("pending  {}\n", actions_text(model, session.changes().pending));
  }
  for (const std::string& typed : session.changes().lines) {
    text += fmt::format("changed  {}\n", typed);
  }
  return text + K_and_contact_state_reply(session);
}

std::string cards_reply(const ShellSession& session, const std::string& name) {
  deck::DeckCardList text = *session.changes().text;
  append_steps(session.model(), session.changes().applied, text);
  std::erase_if(text, [&](const deck::DeckCard& card) { return card.name != name; });
  return deck::format_deck_card_list(std::move(text), ".");
}

} // namespace spricka::program
