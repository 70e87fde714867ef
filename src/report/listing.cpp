// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/printable.hpp"
#include "model/model.hpp"
#include "report/deck_name.hpp"
#include "report/report.hpp"
#include "report/topics/answer.hpp"
#include "report/topics/growth_tables.hpp"
#include "report/topics/growth_test_tables.hpp"
#include "report/topics/k_bars.hpp"
#include "report/topics/k_tables.hpp"
#include "report/topics/load_path_tables.hpp"
#include "report/topics/model_tables.hpp"
#include "report/topics/result_tables.hpp"
#include "report/topics/sensitivity_tables.hpp"
#include "report/topics/spectrum_tables.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace spricka::report {
namespace {

std::string heading(std::string_view text) {
  return fmt::format("\n{}\n{}\n\n", text, std::string(text.size(), '='));
}

/// The deck and what it includes, each line with its number, as ASKA printed them.
std::string echo(const base::SourceTexts& sources) {
  std::string out;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    out += heading("Deck " + relative_deck_file_name(sources, f));
    std::string_view text = sources.text(f);
    for (std::size_t line = 1; !text.empty(); ++line) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view shown = text.substr(0, end);
      if (shown.ends_with('\r')) {
        shown.remove_suffix(1);
      }
      out += fmt::format("{:>6} |{}{}\n", line, shown.empty() ? "" : " ", shown);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }
  return out;
}

std::string model_summary(const model::Model& model,
                          const std::vector<results::LoadTotal>& totals) {
  const base::UnitSystem& units = model.units;
  std::string out = heading("Model");
  if (!model.title.empty()) {
    out += model.title + "\n\n";
  }
  out += fmt::format("Units: length {}, force {}, stress {}, K {}\n\n", units.output_length().name,
                     units.output_force().name, units.output_stress().name,
                     units.output_stress_intensity().name);
  if (const std::string note = deck_units_note(units); !note.empty()) {
    out += note + "\n\n";
  }
  if (const std::string note = symmetry_note(model); !note.empty()) {
    out += note + "\n\n";
  }
  out += table_to_text(net_size_table(model)) + "\n" + table_to_text(property_table(model));
  out += to_text_after_blank_line(contact_pair_table(model)) +
         to_text_after_blank_line(rigid_target_table(model));
  out += to_text_after_blank_line(load_total_table(totals, units, model.mesh.dim));
  if (!model.steps.empty()) {
    out += "\nSteps:";
    for (const model::Step& step : model.steps) {
      out += fmt::format(" {}{}", step.name,
                         step.substeps > 1 ? fmt::format(" ({} substeps)", step.substeps) : "");
    }
    out += "\n";
  }
  return out;
}

std::string log_text(const results::RunResult& run) {
  return heading("Processor log") + table_to_text(without_title(run_log_table(run))) +
         fmt::format("\n  total {:.3f} s cpu, {:.3f} s wall, at most {:.0f} MB of memory\n",
                     run.cpu, run.wall, static_cast<double>(run.peak_memory) / 1e6);
}

std::string increment_text(const model::Model& model, const results::CrackLengthResult& increment) {
  std::string out = model.cracks.empty()
                        ? heading("Results")
                        : heading(fmt::format("Increment {}: a = {}", increment.number,
                                              model.units.output_length().text(increment.a, 6)));
  out += fmt::format("Mesh: {} nodes, {} elements\n",
                     std::ranges::count(model::mark_nodes_in_use(increment.mesh), true),
                     increment.mesh.element_count());
  if (const std::string note = force_direction_note(model); !note.empty()) {
    out += "note: " + note + "\n";
  }
  for (const results::Note& note : increment.notes) {
    out += "note: " + results::text_with_code(note) + "\n";
  }
  for (const results::LoadStepResult& step : increment.steps) {
    for (const results::Note& note : step.notes) {
      out += fmt::format("note: step {}: {}\n", step.step, results::text_with_code(note));
    }
  }
  for (const results::LoadPathResult& path : increment.paths) {
    for (const results::Note& note : path.notes) {
      out += fmt::format("note: load path {}: {}\n", path.name, results::text_with_code(note));
    }
  }
  for (const std::string& note : missing_sensitivity_reasons(model, increment)) {
    out += fmt::format("note: sensitivities: {}\n", note);
  }
  for (const ReportTable& table :
       {force_balance_table(model, increment), net_balance_table(model, increment),
        energy_error_table(increment), contact_result_table(model, increment),
        contact_moment_table(model, increment), friction_table(model, increment),
        tip_k_table(model, increment, KTableExtent::full), sensitivity_table(model, increment),
        load_path_table(model, increment), contact_opening_onset_table(model, increment)}) {
    out += to_text_after_blank_line(table);
  }
  for (const ReportTable& table : front_tables(model, increment)) {
    (out += '\n') += table_to_text(table);
  }
  if (const std::string bars = k_error_bar_lines(increment, model.units.output_stress_intensity());
      !bars.empty()) {
    out += "\nStress intensity factors with the error of the mesh (not that of the model)\n" + bars;
  }
  return out;
}

std::string tests_text(const model::Model& model, const results::RunResult& run) {
  if (run.tests.empty()) {
    return {};
  }
  std::string out = heading("Crack growth tests") +
                    table_to_text(without_title(growth_test_summary_table(model, run)));
  for (const results::GrowthTestResult& test : run.tests) {
    for (const results::Note& note : test.notes) {
      out += fmt::format("note: test {}: {}\n", test.name, results::text_with_code(note));
    }
    (out += '\n') += table_to_text(test_points_table(model, test));
  }
  return out;
}

std::string check_text(const model::Model& model, const results::RunResult& run) {
  if (run.checks.empty()) {
    return {};
  }
  std::size_t failed = 0;
  std::size_t recorded = 0;
  for (const results::CheckResult& check : run.checks) {
    failed += check.passed ? 0 : 1;
    recorded += check.source == "RECORDED" ? 1 : 0;
  }
  return heading("Checks of the deck") + table_to_text(without_title(checks_table(model, run))) +
         fmt::format("\n  {} of {} passed; {} compare with a recorded value\n",
                     run.checks.size() - failed, run.checks.size(), recorded);
}

} // namespace

std::string listing_text(const base::SourceTexts& sources, const model::Model& model,
                         const results::RunResult& run,
                         const std::vector<results::LoadTotal>& loads) {
  std::string out = "spricka " SPRICKA_VERSION "\n";
  out += echo(sources) + model_summary(model, loads) + log_text(run);
  if (const ReportTable rounds = tolerance_rounds_table(run, true); !rounds.rows.empty()) {
    out += heading("K to a tolerance") + table_to_text(without_title(rounds));
  }
  for (const results::CrackLengthResult& increment : run.increments) {
    out += increment_text(model, increment);
  }
  if (run.increments.size() > 1) {
    const ReportTable table = tip_k_table_over_increments(
        model, run, results::shown_step_name(model, run.increments), KTableExtent::full);
    if (!table.rows.empty()) {
      out += heading("Crack growth") + table_to_text(table);
    }
  }
  if (run.growth) {
    out += heading("GROWTH") + life_summary(model, run) + "\n" +
           table_to_text(without_title(growth_station_table(model, run)));
    if (const ReportTable lives = compared_lives_table(model, run); !lives.rows.empty()) {
      out += "\n" + table_to_text(lives);
    }
    for (const ReportTable& table : spectrum_tables(model, run)) {
      out += "\n" + table_to_text(table);
    }
  }
  out += tests_text(model, run);
  out += check_text(model, run);
  out += heading("Answer") + answer_text(model, run);
  if (!run.warnings.empty()) {
    out += heading("Warnings");
    for (const results::Warning& warning : run.warnings) {
      out += "  " + results::text_with_code(warning) + "\n";
    }
  }
  return base::make_lines_printable(out);
}

} // namespace spricka::report
