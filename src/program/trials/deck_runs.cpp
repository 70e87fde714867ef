// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/deck_runs.hpp"

#include "archive/folder_mark.hpp"
#include "archive/safe_file.hpp"
#include "base/exit_codes.hpp"
#include "base/input_file.hpp"
#include "program/trials/run_record.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <stdlib.h> // NOLINT(modernize-deprecated-headers): mkdtemp is of POSIX

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

fs::path new_folder(const fs::path& prefix) {
  fs::create_directories(prefix.parent_path().empty() ? "." : prefix.parent_path());
  std::string name = prefix.string() + ".XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  return name;
}

std::string without(std::string text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
    text.erase(at, word.size());
  }
  return text;
}

} // namespace

DeckRuns::DeckRuns(const fs::path& prefix, bool keep, std::function<void(int signal)> stopped_by,
                   SharedRunOptions sharing)
    : folder_(new_folder(prefix)), keep_(keep), sharing_(std::move(sharing)),
      interrupt_([this, last = std::move(stopped_by)](int signal) {
        runner_.stop();
        remove();
        last(signal);
        return sharing_.task ? base::exit_code(base::ProgramOutcome::stopped) : 128 + signal;
      }) {
  if (sharing_.is_shared()) {
    sharing_.digest += program_version_and_build();
    shared_.emplace(sharing_.folder);
    try {
      shared_->open(archive::LockSharing::shared);
    } catch (...) {
      remove();
      throw;
    }
  }
}

void DeckRuns::remove() const {
  std::error_code ignored;
  if (!keep_) {
    fs::remove_all(folder_, ignored);
  }
}

fs::path DeckRuns::run_folder(const std::string& name) const {
  return (shared_ ? shared_->path() : folder_) / name;
}

// Decks that are made lie in a folder that has another name in each task, and may name it.
std::string DeckRuns::digest_of(const ChildRun& run) const {
  std::string text = sharing_.digest;
  text += '\n' + run.deck.filename().string() + '\n' + run.engine + '\n';
  text += without(base::read_file(run.deck, base::largest_mesh_file), folder_.string());
  for (const auto& [name, value] : run.defines) {
    text += fmt::format("\n{}={}", name, value);
  }
  return archive::hash_bytes(text);
}

// What an earlier attempt has left of the run goes, so that nothing old is taken for its result.
// False: another process is at it.
bool DeckRuns::make_room(const ChildRun& run) {
  std::error_code unknown;
  try {
    archive::remove_manifest_files(record_folder(run.out));
    if (fs::is_directory(run.out, unknown) && archive::read_folder_manifest(run.out)) {
      const auto lock = archive::FolderLock::acquire_lock(run.out, run.out);
      fs::remove_all(run.out);
    }
    return true;
  } catch (const archive::FileFailure&) {
    return false;
  }
}

void DeckRuns::run_all_children(
    std::span<const ChildRun> runs, int at_once,
    const std::function<void(std::size_t, const ChildProcessResult&)>& ended) {
  std::vector<ChildRun> begun;
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (sharing_.task && !sharing_.task->has_run(i)) {
      continue;
    }
    if (shared_) {
      const std::optional<ChildProcessResult> known =
          read_run_record(runs[i].out, digest_of(runs[i]));
      // A task tries again what had no results; a collector takes it as it is.
      if (known && (sharing_.collect || ended_with_results(*known))) {
        ended(i, *known);
        continue;
      }
      if (sharing_.collect || !make_room(runs[i])) {
        missing_.push_back(runs[i].out.filename());
        continue;
      }
    }
    begun.push_back(runs[i]);
    index.push_back(i);
  }
  runner_.run_all_children(begun, at_once, [&](std::size_t k, const ChildProcessResult& end) {
    std::error_code ignored;
    if (!shared_) {
      ended(index[k], end);
      if (!keep_) {
        fs::remove_all(begun[k].out, ignored);
      }
      return;
    }
    if (ended_by_itself(end)) {
      write_run_record(begun[k].out, end, digest_of(begun[k]));
    } else {
      missing_.push_back(begun[k].out.filename());
    }
    ended(index[k], end);
  });
}

} // namespace spricka::program
