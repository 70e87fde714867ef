// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/answer.hpp"

#include "base/quantity.hpp"
#include "base/tidy.hpp"
#include "model/model.hpp"
#include "model/property_points.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/round_off.hpp"
#include "report/topics/contact_words.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/front_places.hpp"
#include "report/topics/joint_drawing.hpp"
#include "report/topics/k_bars.hpp"
#include "results/growth_end.hpp"
#include "results/result_unit.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::report {
namespace {

constexpr double shown_beside_K1 = 5e-3; // of the largest K: a smaller K2 or K3 is not reported

/// "585.6 +- 2.1", with the bar where there is one.
std::string k_text(const model::Model& model, const results::FrontResult& front,
                   const results::FrontPointResult& point, std::size_t mode) {
  const base::OutputUnit unit = model.units.output_stress_intensity();
  const double K = unit.from_deck(point.at_surface ? point.smooth[mode] : point.K()[mode]);
  return front.has_error_bar() ? k_and_bar_text(K, unit.from_deck(point.bar[mode].size()))
                               : fmt::format("{:.5g}", K);
}

/// K1 and what else there is of a point: "K1 = 585.6 +- 2.1, K2 = 12.1 +- 0.3 MPa*mm^0.5".
std::string point_text(const model::Model& model, const results::FrontResult& front,
                       const results::FrontPointResult& point) {
  if (front.two_materials) {
    return fmt::format(
        "G = {} (between two materials there is no K)",
        base::output_unit(model.units, base::QuantityKind::energy_release).text(point.G, 5));
  }
  const std::array<double, 3> K = point.K();
  double largest = 0.0;
  for (const double mode : K) {
    largest = std::max(largest, std::abs(mode));
  }
  std::string text;
  for (std::size_t mode = 0; mode < K.size(); ++mode) {
    if (mode == 0 || std::abs(K[mode]) > shown_beside_K1 * largest) {
      text += fmt::format("{}K{} = {}", text.empty() ? "" : ", ", mode + 1,
                          k_text(model, front, point, mode));
    }
  }
  return fmt::format("{} {}{}", text, model.units.output_stress_intensity().name,
                     front.has_error_bar() ? "" : " (without error bar)");
}

/// Of a front its worst point, and K1 at its ends and in its middle.
std::string front_text(const model::Model& model, const results::CrackLengthResult& increment,
                       const results::FrontResult& front) {
  const results::FrontPointResult& worst = worst_point(front);
  std::string text = point_text(model, front, worst);
  if (front.is_tip()) {
    return text;
  }
  std::string places;
  std::string worst_name;
  for (const FrontPlace& place : front_places(front, FaceNames(increment.mesh))) {
    if (place.point == &worst) {
      worst_name = place.name == "largest" ? "" : place.name;
      continue;
    }
    places += fmt::format("{}{} {}", places.empty() ? "" : ", ", place.name,
                          k_text(model, front, *place.point, 0));
  }
  const std::size_t last = worst_name.rfind(", largest");
  worst_name = last == std::string::npos ? worst_name : worst_name.substr(0, last);
  text += fmt::format(" at its worst point, {} of {}", worst.number, front.points.size());
  if (front.has_angles) {
    text += fmt::format(" ({:.0f} deg)", worst.phi * degrees_per_radian);
  }
  if (!worst_name.empty()) {
    text += fmt::format(" ({})", worst_name);
  }
  return places.empty() ? text : text + "; K1 " + places;
}

bool is_valid(const results::FrontResult& front) {
  return front.invalid_reason.empty();
}

/// Of each front of the shown step at the last length, and of several lengths K1 at the first.
void add_fronts(std::vector<AnswerLine>& lines, const model::Model& model,
                const results::RunResult& run) {
  const results::CrackLengthResult& last = run.increments.back();
  const results::CrackLengthResult& first = run.increments.front();
  const auto shown = [&](const results::CrackLengthResult& increment) {
    return results::shown_step_result(model, run.increments, increment);
  };
  for (const results::FrontResult& front : shown(last)->fronts) {
    std::string text = is_valid(front) ? front_text(model, last, front)
                                       : "K is no answer: " + front.invalid_reason;
    const base::OutputUnit length = model.units.output_length();
    text += fmt::format("; a = {}", length.text(front.a, 4));
    const results::FrontResult* const before =
        &first == &last ? nullptr : results::find_front(*shown(first), front.name);
    if (before != nullptr && is_valid(*before) && !before->two_materials) {
      text +=
          fmt::format(" (first length: K1 = {} at a = {})",
                      k_text(model, *before, worst_point(*before), 0), length.text(before->a, 4));
    }
    lines.push_back({front.name, text, !is_valid(front)});
  }
}

/// The largest von Mises stress and its place; empty where there are no stresses but round-off.
std::string stress_text(const model::Model& model, const results::CrackLengthResult& increment,
                        const results::LoadStepResult& step) {
  const model::Mesh& mesh = increment.mesh;
  if (step.stress.empty() || !has_significant_stress(model, increment, step)) {
    return {};
  }
  double largest = 0.0;
  base::NodeId at;
  const model::FieldPointsByProperty points = model::property_points(mesh);
  for (std::size_t k = 0; k < points.of.size(); ++k) {
    const double stress = results::von_mises(step.stress[static_cast<std::size_t>(points.of[k])]);
    if (stress > largest) {
      largest = stress;
      at = mesh.nodes[k];
    }
  }
  const base::OutputUnit length = model.units.output_length();
  const std::string place =
      base::format_coordinates(mesh.x[at.index()], mesh.dim, length) + " " + length.name;
  return fmt::format(
      "largest von Mises stress {} at {}; at a sharp corner it is a number of the mesh",
      model.units.output_stress().text(largest, 4), place);
}

std::string life_text(const model::Model& model, const results::GrowthResult& growth) {
  const base::OutputUnit life = results::life_unit(model.units, growth);
  std::string text = fmt::format(
      "{}{:.6g} {}", results::growth_could_not_continue(growth) ? "more than " : "",
      life.from_deck(growth.final_cycles()),
      life.name == "pass" ? "passes of the spectrum" : results::life_unit_words(life.name));
  if (growth.final_cycles() > 0.0 && std::isfinite(growth.error)) {
    text += fmt::format(" (+- {:.2g} % by the number of solved lengths)", 100.0 * growth.error);
  }
  if (!growth.curve.empty()) {
    const base::OutputUnit length = model.units.output_length();
    std::string sizes;
    for (const std::size_t i : reported_growth_points(growth)) {
      sizes += fmt::format("{}{} {:.4g} to {:.4g}", sizes.empty() ? "" : ", ",
                           growth.point_names[i], length.from_deck(growth.curve.front().a[i]),
                           length.from_deck(growth.curve.back().a[i]));
    }
    text += fmt::format("; a of {} {}", sizes, length.name);
  }
  return text + fmt::format("; ended by {}: {}", growth.ended, growth.reason);
}

void add_checks(std::vector<AnswerLine>& lines, const results::RunResult& run) {
  const auto passed =
      static_cast<std::size_t>(std::ranges::count_if(run.checks, &results::CheckResult::passed));
  if (!run.checks.empty()) {
    lines.push_back({"Checks", fmt::format("{} of the deck's {} passed", passed, run.checks.size()),
                     passed < run.checks.size()});
  }
}

std::string cost_text(const results::RunResult& run) {
  std::size_t unknowns = 0;
  for (const results::CrackLengthResult& increment : run.increments) {
    unknowns = std::max(unknowns, increment.unknowns);
  }
  return fmt::format(
      "{:.3g} s of CPU, {:.3g} s elapsed, {:.0f} MB of memory; {} unknowns{}", run.cpu, run.wall,
      static_cast<double>(run.peak_memory) / 1e6, unknowns,
      run.increments.size() > 1 ? fmt::format(", {} crack lengths", run.increments.size()) : "");
}

/// Text of a line for HTML: units and signs as print has them.
std::string html_of(const model::Model& model, std::string text) {
  const auto put = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); !from.empty() && from != to && at != std::string::npos;
         at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
  };
  text = escape_xml(text);
  using enum base::QuantityKind;
  for (const base::QuantityKind kind : {stress_intensity, energy_release, stress, area}) {
    const std::string unit = base::output_unit(model.units, kind).name;
    put(unit, typeset_unit(unit));
  }
  put("+-", "±");
  put(" deg", "°");
  return text;
}

} // namespace

std::vector<AnswerLine> answer_lines(const model::Model& model, const results::RunResult& run) {
  std::vector<AnswerLine> lines;
  const results::LoadStepResult* const step =
      run.increments.empty()
          ? nullptr
          : results::shown_step_result(model, run.increments, run.increments.back());
  if (step != nullptr) {
    add_fronts(lines, model, run);
    if (std::string words =
            step->fronts.empty() ? stress_text(model, run.increments.back(), *step) : std::string();
        !words.empty()) {
      lines.push_back({"Stress", std::move(words)});
    }
    for (const model::Contact& contact : shown_contacts(model, run)) {
      if (std::string words = contact_words(model, run, contact); !words.empty()) {
        lines.push_back({contact.name, std::move(words)});
      }
    }
  }
  if (run.growth) {
    lines.push_back(
        {"Life", life_text(model, *run.growth), results::growth_could_not_continue(*run.growth)});
  }
  add_checks(lines, run);
  lines.push_back({"Cost", cost_text(run)});
  return lines;
}

std::string answer_place(const model::Model& model, const results::RunResult& run) {
  const std::string step = results::shown_step_name(model, run.increments);
  if (run.increments.empty() || step.empty()) {
    return {};
  }
  return run.increments.size() > 1
             ? fmt::format("At the end of step {}, at the last of {} crack lengths.", step,
                           run.increments.size())
             : fmt::format("At the end of step {}.", step);
}

std::string answer_text(const model::Model& model, const results::RunResult& run) {
  const std::vector<AnswerLine> lines = answer_lines(model, run);
  std::size_t width = 0;
  for (const AnswerLine& line : lines) {
    width = std::max(width, line.subject.size());
  }
  const std::string place = answer_place(model, run);
  std::string text = place.empty() ? std::string() : "  " + place + "\n";
  for (const AnswerLine& line : lines) {
    text += fmt::format("  {:<{}}  {}\n", line.subject, width, line.text);
  }
  return text;
}

std::string answer_html(const model::Model& model, const results::RunResult& run,
                        const std::string& warnings) {
  constexpr double picture_width = 460.0;
  constexpr double picture_height = 420.0;
  std::string html = "<section class=\"answer\">\n";
  if (const std::string joint = draw_whole_joint(model, run, picture_width, picture_height);
      !joint.empty()) {
    html += "<div class=\"joint\">\n" + joint + "</div>\n";
  }
  html += "<div class=\"words\">\n";
  if (const std::string place = answer_place(model, run); !place.empty()) {
    html += fmt::format("<p class=\"about\">{}</p>\n", escape_xml(place));
  }
  html += "<dl>\n";
  for (const AnswerLine& line : answer_lines(model, run)) {
    html += fmt::format("<dt>{}</dt><dd{}>{}</dd>\n", escape_xml(line.subject),
                        line.is_failure ? " class=\"failed\"" : "", html_of(model, line.text));
  }
  return html + "</dl>\n" + warnings + "</div>\n</section>\n";
}

} // namespace spricka::report
