// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/deck_name.hpp"
#include "report/page.hpp"
#include "report/report.hpp"
#include "report/topics/answer.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/growth_tables.hpp"
#include "report/topics/growth_test_tables.hpp"
#include "report/topics/k_section.hpp"
#include "report/topics/load_path_tables.hpp"
#include "report/topics/model_tables.hpp"
#include "report/topics/notes.hpp"
#include "report/topics/result_tables.hpp"
#include "report/topics/sensitivity_tables.hpp"
#include "report/topics/spectrum_tables.hpp"
#include "report/view/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace spricka::report {
namespace {

void add_head(HtmlPage& page, const std::string& title, const base::SourceTexts& sources,
              const model::Model& model) {
  const base::UnitSystem& units = model.units;
  page.add_html(fmt::format("<h1>{}</h1>\n", escape_xml(title)));
  page.add_html(fmt::format(
      "<p class=\"about\">Deck {}, computed by spricka {}. Units: {}, {}, {}{}.</p>\n",
      escape_xml(relative_deck_file_name(sources, 0)), SPRICKA_VERSION, units.output_length().name,
      units.output_force().name, units.output_stress().name,
      model.cracks.empty()
          ? ""
          : fmt::format("; K in {}", typeset_unit(units.output_stress_intensity().name))));
  if (const std::string note = deck_units_note(units); !note.empty()) {
    page.add_paragraph(note);
  }
}

constexpr std::size_t most_at_head = 3;      // warnings; the others stand under Notes
constexpr std::size_t longest_at_head = 220; // bytes of one

/// The beginning of a text, at the end of a word.
std::string beginning(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) {
    return text;
  }
  const std::size_t end = text.rfind(' ', longest);
  return text.substr(0, end == std::string::npos ? text.find(' ') : end) + " ..";
}

/// "W508, no answer: text".
std::string warning_item(const std::string& code, const std::string& text) {
  return fmt::format("<li><b>{}, {}:</b> {}</li>\n", code,
                     base::display_word(base::concern_of_warning_code(code)), escape_xml(text));
}

/// What puts the numbers below in doubt is said above them, the worst first.
std::string warnings_at_head(const results::RunResult& run) {
  const std::size_t count = run.warnings.size();
  if (count == 0) {
    return {};
  }
  std::string items;
  for (std::size_t i = 0; i < std::min(count, most_at_head); ++i) {
    items += warning_item(run.warnings[i].code, beginning(run.warnings[i].text, longest_at_head));
  }
  const std::string more =
      count > most_at_head ? fmt::format("; the first {}:", most_at_head) : std::string(":");
  return fmt::format("<div class=\"warnings\"><p class=\"failed\"><a href=\"#notes\">{} "
                     "warning{}</a>{}</p>\n<ul>\n{}</ul></div>\n",
                     count, count > 1 ? "s" : "", more, items);
}

/// The tables of all increments as one, with a column for the crack length in front; without
/// cracks the only one.
ReportTable
over_lengths(const model::Model& model, const results::RunResult& run,
             const std::function<ReportTable(const results::CrackLengthResult&)>& table_of) {
  const base::OutputUnit length = model.units.output_length();
  ReportTable all;
  for (const results::CrackLengthResult& increment : run.increments) {
    ReportTable table = table_of(increment);
    if (model.cracks.empty()) {
      return table;
    }
    for (std::vector<std::string>& row : table.rows) {
      row.insert(row.begin(), fmt::format("{:.6g}", length.from_deck(increment.a)));
      all.rows.push_back(std::move(row));
    }
    table.columns.insert(table.columns.begin(), {"a", length.name, false});
    all.title = table.title;
    all.columns = std::move(table.columns);
  }
  return all;
}

void add_figures(HtmlPage& page, const std::vector<Figure>& figures) {
  for (const Figure& figure : figures) {
    page.add_figure(figure);
  }
}

void add_cracks(HtmlPage& page, const model::Model& model, const results::RunResult& run) {
  const KReportSection section = make_k_report_section(model, run);
  if (section.tables.empty()) {
    return;
  }
  page.add_heading("Stress intensity factors");
  add_figures(page, section.pictures);
  for (const ReportTable& table : section.tables) {
    page.add_table(table);
  }
  for (const ReportTable& table : section.folded) {
    page.add_folded_table(table);
  }
  for (const std::string& remark : section.remarks) {
    page.add_paragraph(remark);
  }
  add_figures(page, section.curves);
  page.add_table(k_reference_table(model, run));
  if (section.pictures.empty()) { // with them it is a page of points
    add_figures(page, sensitivity_figures(model, run));
  }
}

void add_growth(HtmlPage& page, const model::Model& model, const results::RunResult& run) {
  const std::vector<Figure> figures = growth_figures(model, run);
  if (figures.empty()) {
    return;
  }
  page.add_heading("Crack growth");
  add_figures(page, figures);
  page.add_table(without_title(reported_growth_station_table(model, run)));
  page.add_table(compared_lives_table(model, run));
  for (const std::string& sentence : run.growth->interaction) {
    page.add_paragraph(sentence + ".");
  }
  if (std::string words = spectrum_summary(model, run); !words.empty()) {
    std::ranges::replace(words, '\n', ' ');
    page.add_paragraph(words);
  }
  for (const ReportTable& table : spectrum_tables(model, run)) {
    page.add_table(table);
  }
}

void add_tests(HtmlPage& page, const model::Model& model, const results::RunResult& run) {
  if (run.tests.empty()) {
    return;
  }
  page.add_heading("Crack growth tests");
  page.add_table(without_title(growth_test_summary_table(model, run)));
  add_figures(page, growth_test_figures(model, run));
  for (const results::GrowthTestResult& test : run.tests) {
    page.add_table(test_points_table(model, test));
  }
}

void add_paths(HtmlPage& page, const model::Model& model, const results::RunResult& run) {
  if (model.load_paths.empty() || run.increments.empty()) {
    return;
  }
  page.add_heading("Load paths");
  add_figures(page, load_path_figures(model, run));
  const auto paths = [&](const results::CrackLengthResult& i) { return load_path_table(model, i); };
  page.add_table(over_lengths(model, run, paths));
  const auto openings = [&](const results::CrackLengthResult& i) {
    return contact_opening_onset_table(model, i);
  };
  page.add_table(over_lengths(model, run, openings));
}

void add_contacts(HtmlPage& page, const model::Model& model, const results::RunResult& run) {
  const bool any =
      std::ranges::any_of(run.increments, [](const results::CrackLengthResult& increment) {
        return std::ranges::any_of(increment.steps, [](const results::LoadStepResult& step) {
          return !step.contacts.empty();
        });
      });
  if (!any) {
    return;
  }
  page.add_heading("Contact");
  add_figures(page, pressure_figures(model, run));
  const auto contacts = [&](const results::CrackLengthResult& i) {
    return contact_result_table(model, i);
  };
  const auto friction = [&](const results::CrackLengthResult& i) {
    return friction_table(model, i);
  };
  const auto moments = [&](const results::CrackLengthResult& i) {
    return contact_moment_table(model, i);
  };
  page.add_table(over_lengths(model, run, contacts));
  page.add_table(over_lengths(model, run, moments));
  page.add_table(over_lengths(model, run, friction));
}

void add_notes(HtmlPage& page, const results::RunResult& run) {
  std::string items;
  for (const results::Warning& warning : run.warnings) {
    items += warning_item(warning.code, warning.text);
  }
  for (const RepeatedNote& note : collect_notes(run)) {
    if (!results::is_warning(note.first)) {
      items += fmt::format("<li>{}</li>\n", escape_xml(repeated_note_text(note)));
    }
  }
  if (!items.empty()) {
    page.add_heading("Notes", "notes");
    page.add_html("<ul>\n" + items + "</ul>\n");
  }
}

/// "a = 3.6 mm", of cracks of different lengths each.
std::string lengths_of(const model::Model& model, const results::CrackLengthResult& increment) {
  const base::OutputUnit length = model.units.output_length();
  std::string each;
  bool same = true;
  for (const results::FrontResult& front : increment.steps.empty()
                                               ? std::vector<results::FrontResult>()
                                               : increment.steps.back().fronts) {
    if (front.is_tip()) {
      same = same && std::abs(front.a - increment.a) < 1e-9 * increment.a;
      each += fmt::format("{}{}: a = {}", each.empty() ? "" : ", ", front.name,
                          length.text(front.a, 6));
    }
  }
  return same ? fmt::format("a = {}", length.text(increment.a, 6)) : each;
}

void add_deck(HtmlPage& page, const base::SourceTexts& sources) {
  page.add_html("<section class=\"screen\">\n"); // folded, so of no use on paper
  page.add_heading("Deck");
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    page.add_html(fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n",
                              escape_xml(relative_deck_file_name(sources, f)),
                              escape_xml(sources.text(f))));
  }
  page.add_html("</section>\n");
}

} // namespace

std::string html_report(const base::SourceTexts& sources, const model::Model& model,
                        const results::RunResult& run,
                        const std::vector<results::LoadTotal>& loads) {
  HtmlPage page;
  const std::string title = model.title.empty() ? "spricka report" : model.title;
  add_head(page, title, sources, model);
  page.add_html(answer_html(model, run, warnings_at_head(run)));
  page.add_html(view_section(model, run));
  add_cracks(page, model, run);
  add_growth(page, model, run);
  add_tests(page, model, run);
  add_paths(page, model, run);
  page.add_heading("Model");
  if (const std::string note = symmetry_note(model); !note.empty()) {
    page.add_paragraph(note);
  }
  page.add_table(net_size_table(model));
  page.add_table(property_table(model));
  page.add_table(contact_pair_table(model));
  page.add_table(load_total_table(loads, model.units, model.mesh.dim));
  page.add_table(rigid_target_table(model));
  add_figures(page, mesh_figures(model, run));
  add_contacts(page, model, run);
  if (!run.increments.empty()) {
    page.add_heading("Force balance");
    if (const results::CrackLengthResult& last = run.increments.back(); last.a > 0.0) {
      page.add_paragraph(fmt::format("At {}{}.",
                                     run.increments.size() > 1 ? "the last length, " : "",
                                     lengths_of(model, last)));
    }
    if (const std::string note = force_direction_note(model); !note.empty()) {
      page.add_html(fmt::format("<p>Here {}.</p>\n", note));
    }
    page.add_table(without_title(force_balance_table(model, run.increments.back())));
    page.add_table(net_balance_table(model, run.increments.back()));
    page.add_table(energy_error_table(run.increments.back()));
  }
  if (const ReportTable rounds = tolerance_rounds_table(run, false); !rounds.rows.empty()) {
    page.add_heading("K to a tolerance");
    page.add_table(without_title(rounds));
  }
  if (!run.checks.empty()) {
    page.add_heading("Checks");
    page.add_table(without_title(checks_table(model, run)));
  }
  add_notes(page, run);
  add_deck(page, sources);
  return page.finish_page(title);
}

} // namespace spricka::report
