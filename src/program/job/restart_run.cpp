// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/restart_run.hpp"

#include "analysis/lengths/kept_fronts.hpp"
#include "archive/safe_file.hpp"
#include "model/model.hpp"
#include "program/job/run_folder.hpp"

#include <csignal>
#include <cstring>
#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

bool is_there_or_kept(const fs::path& file) {
  // A run that was killed while it wrote may have left the list before alone.
  fs::path before = file;
  before += ".1";
  std::error_code unknown;
  return fs::exists(file, unknown) || fs::exists(before, unknown);
}

archive::CheckpointOptions place_of(const RunOptions& options, const model::RestartFiles& card,
                                    const fs::path& folder) {
  const fs::path beside = folder.empty() ? options.deck.parent_path() : folder;
  archive::CheckpointOptions place;
  // Points of a sweep have their files in folders of their own.
  const auto file = [&](const std::string& name) {
    return folder.empty() ? (beside / name).lexically_normal() : beside / fs::path(name).filename();
  };
  if (!card.write.empty()) {
    place.write = file(card.write);
    place.every = card.every;
  }
  if (!card.read.empty()) {
    place.read = file(card.read);
    place.at = card.at;
  }
  // Without a file to go on from, --restart begins at the beginning.
  if (options.restart && is_there_or_kept(place.write)) {
    place.read = place.write;
    place.at.reset();
  }
  place.seconds = options.seconds;
  place.since = options.since;
  return place;
}

} // namespace

bool reject_restart_without_state(const RunOptions& options, const model::Model& model,
                                  const Log& log) {
  const bool writes = model.restart && !model.restart->write.empty();
  if (writes || (!options.restart && options.seconds <= 0.0)) {
    return false;
  }
  log.report_message(base::Severity::error, "E567",
                     fmt::format("{} needs a card $RESTART WRITE='file.rst' in the deck",
                                 options.restart ? "--restart" : "--time"));
  return true;
}

void reject_state_in_run_folder(const RunOptions& options, const model::Model& model) {
  if (!model.restart || model.restart->write.empty()) {
    return;
  }
  const fs::path file = options.deck.parent_path() / model.restart->write;
  const fs::path inside = canonical_folder(file).lexically_relative(canonical_folder(options.out));
  if (!inside.empty() && *inside.begin() != "..") {
    throw archive::FileFailure(
        "E469", fmt::format("$RESTART WRITE='{}' lies in the run folder {}, which is "
                            "replaced as a whole; give it a place beside",
                            model.restart->write, options.out.string()));
  }
}

CheckpointOrRefusal open_checkpoint(const RunOptions& options, const CheckedDeck& deck,
                                    const fs::path& folder, const Log& log) {
  CheckpointOrRefusal out;
  const std::optional<model::RestartFiles>& card = deck.model->restart;
  if (!card) {
    return out;
  }
  if (!folder.empty()) {
    fs::create_directories(folder);
  }
  auto checkpoint = std::make_unique<archive::Checkpoint>(place_of(options, *card, folder),
                                                          options.deck, deck.sources, *deck.model);
  if (const std::optional<archive::CheckpointMismatch> misfit =
          checkpoint->find_mismatch([&] { return analysis::why_law_moves_fronts(*deck.model); })) {
    base::Diagnostics list;
    list.error(misfit->span, misfit->code, misfit->text,
               "start from the beginning, or take the deck that wrote the file");
    log.report_diagnostics(deck.sources, list);
    out.refusal = RunOutcomeWithResults{base::ProgramOutcome::deck_error, misfit->text, {}};
    return out;
  }
  out.checkpoint = std::move(checkpoint);
  return out;
}

void start_reporting_skipped_state(archive::Checkpoint* checkpoint, const Log& log) {
  if (checkpoint == nullptr) {
    return;
  }
  checkpoint->set_report_listener([&log](const std::string& code, const std::string& text) {
    log.report_message(code.front() == 'W' ? base::Severity::warning : base::Severity::note, code,
                       text);
  });
}

void finish_checkpoint(archive::Checkpoint* checkpoint, results::RunResult& run) {
  if (checkpoint == nullptr) {
    return;
  }
  // Increments that EVERY has held back are written now.
  checkpoint->flush();
  for (const auto& [code, text] : checkpoint->reported_problems()) {
    run.log.push_back({"RESTART", text, 0.0, 0.0});
  }
  if (checkpoint->reused_increment_count() > 0) {
    run.log.push_back(
        {"RESTART",
         fmt::format("{} of {} increments taken over from {}", checkpoint->reused_increment_count(),
                     run.increments.size(), checkpoint->restart_source_file().string()),
         0.0, 0.0});
  }
}

std::optional<base::ProgramOutcome> stop_with_checkpoint(archive::Checkpoint& checkpoint,
                                                         const std::string& by, const Log& log) {
  try {
    const std::size_t kept = checkpoint.flush();
    const std::string what =
        kept == 0 ? "no increment is finished yet, so nothing is kept"
                  : fmt::format("{} increment{} kept in {}, run --restart goes on", kept,
                                kept == 1 ? " is" : "s are", checkpoint.written_file().string());
    log.report_message(base::Severity::note, "E566", fmt::format("stopped by {}: {}", by, what));
    return kept == 0 ? std::nullopt : std::optional(base::ProgramOutcome::stopped);
  } catch (const archive::FileFailure& trouble) {
    log.report_message(base::Severity::error, trouble.code(), trouble.what());
    return base::ProgramOutcome::file_trouble;
  }
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", signal);
}

} // namespace spricka::program
