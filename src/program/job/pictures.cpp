// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/pictures.hpp"

#include "model/model.hpp"
#include "report/report.hpp"
#include "results/shown_step.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// Names of the pictures: those of the first VTU output of the deck, else "results".
std::string picture_stem(const model::Model& model) {
  for (const model::OutputFileRequest& output : model.outputs) {
    if (output.format == model::OutputFormat::vtu) {
      return fs::path(output.file).stem().string();
    }
  }
  return "results";
}

bool shows_surfaces(const results::LoadStepResult& step) {
  return std::ranges::any_of(step.contacts, [](const results::ContactResult& contact) {
    return contact.mounted && !contact.corners.empty();
  });
}

// What ParaView shows as the time of an increment: its cycles, where a law tells them, else its
// crack length; of a run with one increment alone the number of the step.
double picture_time(const results::RunResult& run, std::size_t increment, std::size_t step) {
  if (run.growth && increment < run.growth->stations.size()) {
    return run.growth->stations[increment].cycles;
  }
  return run.increments.size() > 1 ? run.increments[increment].a : static_cast<double>(step) + 1.0;
}

std::vector<report::PvdEntry> write_step(const model::Model& model,
                                         const results::CrackLengthResult& increment,
                                         const results::LoadStepResult& step, double time,
                                         const FileCreator& put) {
  std::vector<report::PvdEntry> entries;
  const auto add = [&](const std::string& stem, int part, const auto& write) {
    const std::string name = fmt::format("{}_{:03}_{}.vtu", stem, increment.number, step.step);
    put(name, write);
    entries.push_back({.time = time, .part = part, .name = name});
  };
  add(picture_stem(model), 0,
      [&](const fs::path& file) { report::write_step_vtu(file, model, increment, step); });
  if (shows_surfaces(step)) {
    add("contact", 1, [&](const fs::path& file) { report::write_contact_vtu(file, model, step); });
  }
  if (!std::ranges::all_of(step.fronts, &results::FrontResult::is_tip)) {
    add("fronts", 2, [&](const fs::path& file) { report::write_front_vtu(file, model, step); });
  }
  return entries;
}

} // namespace

// Over several increments each step has a collection of its own, as all its files have one time.
void write_vtu_files(const model::Model& model, const results::RunResult& run,
                     const FileCreator& put) {
  const std::string stem = picture_stem(model);
  const std::string leading = results::shown_step_name(model, run.increments);
  const bool grows = run.increments.size() > 1 || run.growth;
  std::map<std::string, std::vector<report::PvdEntry>> collections{{stem, {}}};
  for (std::size_t i = 0; i < run.increments.size(); ++i) {
    const results::CrackLengthResult& increment = run.increments[i];
    for (std::size_t s = 0; s < increment.steps.size(); ++s) {
      const results::LoadStepResult& step = increment.steps[s];
      if (step.stress.empty()) {
        continue;
      }
      std::vector<report::PvdEntry>& into =
          collections[grows && step.step != leading ? stem + "_" + step.step : stem];
      std::ranges::move(write_step(model, increment, step, picture_time(run, i, s), put),
                        std::back_inserter(into));
    }
  }
  for (const auto& collection : collections) {
    put(collection.first + ".pvd",
        [&](const fs::path& file) { report::write_pvd(file, collection.second); });
  }
}

} // namespace spricka::program
