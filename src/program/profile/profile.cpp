// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/profile/profile.hpp"

#include "archive/deck_digest.hpp"
#include "mesh/link/mesher_use.hpp"
#include "program/profile/profile_report.hpp"
#include "program/profile/trace.hpp"

namespace spricka::program {

namespace {

void listen_to_mesher(const std::shared_ptr<analysis::ProfileRecorder>& recorder) {
  mesh::mesher_listener() = [recorder](const mesh::MesherUsage& use) {
    recorder->add_work(
        results::MesherCost{.begin = use.begin, .end = use.end, .cpu = use.cpu, .peak = use.peak});
  };
}

} // namespace

std::shared_ptr<analysis::ProfileRecorder> begin_profile() {
  auto recorder =
      std::make_shared<analysis::ProfileRecorder>(base::Stopwatch(), base::cpu_seconds());
  listen_to_mesher(recorder);
  return recorder;
}

std::shared_ptr<analysis::ProfileRecorder> begin_profile_of_process(const base::Stopwatch& since) {
  auto recorder = std::make_shared<analysis::ProfileRecorder>(since, 0.0);
  recorder->add_startup_work(since);
  listen_to_mesher(recorder);
  return recorder;
}

ProfileTexts end_profile(analysis::ProfileRecorder& recorder, const base::SourceTexts& sources,
                         const model::Model& model, std::uintmax_t written) {
  mesh::mesher_listener() = nullptr; // the floor is no part of the run
  ProfileWithCostFloor record;
  record.profile = recorder.finish();
  record.bytes_read = archive::count_deck_input_bytes(sources, model);
  record.bytes_written = written;
  record.floor = measure_factorisation_cost_floor(model);
  return {.table = profile_text(record),
          .csv = profile_csv(record),
          .trace = trace_json(record.profile)};
}

} // namespace spricka::program
