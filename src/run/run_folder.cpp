// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_folder.hpp"

#include "base/clock.hpp"
#include "report/growth_tables.hpp"
#include "report/growth_tests.hpp"
#include "report/load_paths.hpp"
#include "report/report.hpp"
#include "report/sensitivity.hpp"
#include "run/load_totals.hpp"
#include "run/results_file.hpp"

#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::run {

namespace fs = std::filesystem;

namespace {

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) {
    throw std::system_error(std::make_error_code(std::errc::io_error), file.string());
  }
}

// Names of the pictures: those of the first VTU output of the deck, else "results".
std::string picture_stem(const model::Model& model) {
  for (const model::Output& output : model.outputs) {
    if (output.format == model::OutputFormat::vtu) {
      return fs::path(output.file).stem().string();
    }
  }
  return "results";
}

void write_pictures(const fs::path& folder, const model::Model& model, const results::Run& run) {
  const std::string stem = picture_stem(model);
  std::vector<std::pair<double, std::string>> entries;
  double time = 0.0;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      time += 1.0;
      if (step.stress.empty()) {
        continue;
      }
      const std::string name = fmt::format("{}_{:03}_{}.vtu", stem, increment.number, step.step);
      report::write_vtu(folder / name, model, increment, step);
      entries.emplace_back(time, name);
    }
  }
  report::write_pvd(folder / (stem + ".pvd"), entries);
}

void write_requested(const fs::path& folder, const model::Model& model, const results::Run& run) {
  for (const model::Output& output : model.outputs) {
    if (output.format == model::OutputFormat::csv) {
      report::write_requested_csv(folder / fs::path(output.file).filename(), model, output, run);
    }
  }
}

} // namespace

RunFolder::RunFolder(fs::path folder) : folder_(std::move(folder)) {
  part_ = folder_;
  part_ += ".part";
  if (fs::exists(folder_)) {
    if (fs::exists(folder_ / sweep_table_name)) {
      throw std::system_error(std::make_error_code(std::errc::file_exists),
                              folder_.string() + " holds a sweep; name another folder with --out");
    }
    const bool ours =
        fs::is_directory(folder_) && (fs::is_empty(folder_) || fs::exists(folder_ / listing_name));
    if (!ours) {
      throw std::system_error(std::make_error_code(std::errc::file_exists),
                              folder_.string() + " is not a run folder of spricka");
    }
    fs::remove_all(folder_);
  }
  fs::remove_all(part_);
  fs::create_directories(part_);
}

RunFolder::~RunFolder() {
  std::error_code ignored; // what is left over here is not a result
  fs::remove_all(part_, ignored);
}

void RunFolder::write(const base::Sources& sources, const model::Model& model, results::Run& run) {
  const base::Stopwatch watch;
  report::write_k_csv(part_ / "k.csv", model, run);
  report::write_sensitivity_csv(part_ / "sensitivity.csv", model, run);
  report::write_pressure_csv(part_ / "pressure.csv", model, run);
  report::write_load_path_csv(part_ / "load_path.csv", model, run);
  report::write_life_csv(part_ / "life.csv", model, run);
  report::write_life_curve_csv(part_ / "life_curve.csv", model, run);
  report::write_beta_csv(part_ / "beta.csv", model, run);
  report::write_test_csv(part_ / "test.csv", model, run);
  write_pictures(part_, model, run);
  write_requested(part_, model, run);
  write_results_file(part_ / results_name, sources, model, run);
  const std::vector<results::LoadTotal> totals = load_totals(model);
  write_text(part_ / "report.html", report::html_report(sources, model, run, totals));
  run.log.push_back({"OUTPUT", "tables, pictures, report", watch.cpu(), watch.wall()});
  run.cpu += watch.cpu();
  run.wall += watch.wall();
  run.peak_memory = base::peak_memory();
  write_text(part_ / listing_name, report::listing(sources, model, run, totals));
}

void RunFolder::keep(const std::string& name, const std::string& text) {
  write_text(part_ / name, text);
}

void RunFolder::commit() {
  fs::rename(part_, folder_);
}

} // namespace spricka::run
