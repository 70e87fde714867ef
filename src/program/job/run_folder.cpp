// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/run_folder.hpp"

#include "archive/folder_mark.hpp"
#include "archive/results_file.hpp"
#include "archive/safe_file.hpp"
#include "base/clock.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "model/model.hpp"
#include "program/job/pictures.hpp"
#include "report/report.hpp"
#include "report/topics/beta_csv.hpp"
#include "report/topics/growth_tables.hpp"
#include "report/topics/growth_test_tables.hpp"
#include "report/topics/load_path_tables.hpp"
#include "report/topics/model_tables.hpp"
#include "report/topics/sensitivity_tables.hpp"
#include "report/topics/spectrum_tables.hpp"
#include "sense/load_totals.hpp"
#include "solve/equation_ranks.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

namespace spricka::program {

namespace fs = std::filesystem;

namespace {

// Where nets were condensed elsewhere than in this process: who did what, and what it took.
void add_lines_of_ranks(std::vector<results::LogLine>& log) {
  solve::EquationRanks* const ranks = solve::equation_ranks();
  if (ranks == nullptr) {
    return;
  }
  int rank = 0;
  for (const solve::RankWork& work : ranks->work()) {
    log.push_back(
        {.processor = fmt::format("RANK {}", rank++),
         .text = fmt::format(
             "{}: {} nets{}, {} unknowns; at most {:.0f} MB of memory, forecast {:.0f} MB",
             work.machine, work.nets,
             work.nets_of_all > 0 ? fmt::format(" ({} by MUMPS over all ranks)", work.nets_of_all)
                                  : "",
             work.unknowns, 1e-6 * work.peak_memory, 1e-6 * work.forecast_memory),
         .cpu = work.cpu,
         .wall = 0.0});
  }
}

fs::path part_of(const fs::path& folder) {
  fs::path part = folder;
  part += ".part";
  return part;
}

bool is_there(const fs::path& file) {
  std::error_code unknown;
  return fs::exists(fs::symlink_status(file, unknown));
}

bool is_mount_point(const fs::path& folder) {
  struct stat own {};
  struct stat above {};
  return ::stat(folder.c_str(), &own) == 0 && ::stat(folder.parent_path().c_str(), &above) == 0 &&
         own.st_dev != above.st_dev;
}

[[noreturn]] void not_ours(const std::string& why) {
  throw archive::FileFailure("E464", why + "; name another folder with --out");
}

std::system_error trouble_with(const fs::path& file) {
  return {errno, std::generic_category(), "cannot put " + file.string() + " in place"};
}

// Renames without ever replacing anything.
bool rename_to_free(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) {
    return true;
  }
  // File systems and kernels without such a rename say these two.
  if (errno != EINVAL && errno != ENOSYS) {
    return false;
  }
  if (is_there(to)) { // a file system that cannot do both in one
    errno = EEXIST;
    return false;
  }
  return ::rename(from.c_str(), to.c_str()) == 0;
}

// Two folders change places. Afterwards the old one is at `part`.
void exchange(const fs::path& part, const fs::path& folder) {
  if (::renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) {
    return;
  }
  if (errno != EINVAL && errno != ENOSYS) {
    throw trouble_with(folder);
  }
  const fs::path old =
      base::unused_temporary_path(folder); // a file system that cannot do it in one
  if (!rename_to_free(folder, old) || !rename_to_free(part, folder) || !rename_to_free(old, part)) {
    throw trouble_with(folder);
  }
}

} // namespace

fs::path canonical_folder(const fs::path& folder) {
  fs::path path = fs::weakly_canonical(fs::absolute(folder)).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

void check_folder_ownership(const fs::path& folder, bool sweep) {
  if (!is_there(folder)) {
    return;
  }
  if (!fs::is_directory(folder)) {
    not_ours(fmt::format("{} is not a folder, and is not overwritten", folder.string()));
  }
  const std::optional<archive::FolderManifest> mark = archive::read_folder_manifest(folder);
  if (mark && (mark->kind == archive::RunOrSweepFolder::sweep) != sweep) {
    not_ours(fmt::format("{} holds {}", folder.string(), sweep ? "a single run" : "a sweep"));
  }
  if (!mark && !fs::is_empty(folder)) {
    not_ours(fmt::format("{} holds files that no run of spricka wrote (it has no mark {}), and is "
                         "left as it is",
                         folder.string(), archive::mark_name));
  }
}

RunFolder::RunFolder(const fs::path& folder)
    : folder_(canonical_folder(folder)), part_(part_of(folder_)) {
  fs::create_directories(folder_.parent_path());
  open_place();
  open_part();
}

void RunFolder::open_place() {
  check_folder_ownership(folder_, false);
  if (is_there(folder_)) {
    if (is_mount_point(folder_)) {
      not_ours(fmt::format("{} is a mount point, which no folder can take the place of",
                           folder_.string()));
    }
    place_lock_ = archive::FolderLock::acquire_lock(folder_, part_);
    check_folder_ownership(folder_, false); // another run may have ended meanwhile
    replaces_ = is_there(folder_ / listing_name);
  }
}

// What a killed run has left is removed; what is not ours is left, and the run refused.
void RunFolder::open_part() {
  constexpr int attempts = 100; // another run that ends takes the folder away
  for (int attempt = 0; !part_lock_ && attempt < attempts; ++attempt) {
    if (::mkdir(part_.c_str(), 0777) != 0 && errno != EEXIST) {
      throw std::system_error(errno, std::generic_category(), "cannot make " + part_.string());
    }
    // Another run that ended has taken it away, or moved it into place.
    if (!is_there(part_)) {
      continue;
    }
    if (fs::is_symlink(part_) || !fs::is_directory(part_)) {
      not_ours(fmt::format("{} is in the way, which no run wrote", part_.string()));
    }
    std::optional<archive::FolderLock> lock = archive::FolderLock::acquire_lock(part_, part_);
    if (!lock) {
      continue;
    }
    const std::optional<archive::FolderManifest> mark = archive::read_folder_manifest(part_);
    const std::vector<std::string> foreign =
        archive::find_foreign_files(part_, mark.value_or(archive::FolderManifest{}));
    if (!foreign.empty()) {
      not_ours(fmt::format("{} is in the way: it holds '{}', which no run wrote", part_.string(),
                           foreign.front()));
    }
    archive::remove_manifest_files(part_);
    if (!is_there(part_)) {
      continue; // of a killed run: the name is free now
    }
    part_lock_ = std::move(lock);
  }
  if (!part_lock_) {
    not_ours(fmt::format("{} is in the way and keeps changing", part_.string()));
  }
  try {
    archive::write_folder_manifest(part_, {archive::RunOrSweepFolder::run, {}});
    archive::write_lock_owner(part_);
  } catch (...) { // a full disk
    archive::remove_manifest_files(part_);
    std::error_code ignored;
    fs::remove(part_, ignored); // where it is empty
    throw;
  }
}

RunFolder::~RunFolder() {
  if (!done_) {
    archive::remove_manifest_files(part_);
  }
}

void RunFolder::put(const std::string& name, const std::function<void(const fs::path&)>& write) {
  const std::scoped_lock lock(writing_);
  if (std::ranges::find(names_, name) != names_.end()) {
    throw archive::FileFailure("E464",
                               fmt::format("two results would be written into one file '{}'; give "
                                           "one $OUTPUT another FILE",
                                           name));
  }
  names_.push_back(name);
  // The name first: a run that is killed while it writes leaves nothing that is not known as its
  // own.
  archive::add_to_folder_manifest(part_, name);
  write(part_ / name);
}

void RunFolder::put_requested(const model::Model& model, const results::RunResult& run) {
  for (const model::OutputFileRequest& output : model.outputs) {
    if (output.format == model::OutputFormat::csv) {
      put(fs::path(output.file).filename().string(),
          [&](const fs::path& file) { report::write_requested_csv(file, model, output, run); });
    }
  }
}

void RunFolder::write_interim_k(const model::Model& model, const results::RunResult& so_far) {
  const std::scoped_lock lock(writing_);
  try {
    if (!shows_k_) {
      archive::add_to_folder_manifest(part_, k_table_name);
    }
    shows_k_ = true;
    report::write_k_csv(part_ / k_table_name, model, so_far);
  } catch (const std::system_error&) {
    // A full disk is told of when the results are written.
  }
}

std::optional<fs::path> RunFolder::retain_interim_k() {
  std::optional<std::string> table;
  try {
    table = base::read_file(part_ / k_table_name, base::largest_number_file);
  } catch (const std::exception&) { // no K has been found yet
  }
  archive::remove_manifest_files(part_);
  if (!table || ::mkdir(part_.c_str(), 0777) != 0) {
    return std::nullopt;
  }
  archive::write_folder_manifest(part_, {archive::RunOrSweepFolder::run, {k_table_name}});
  base::write_atomically(part_ / k_table_name, *table);
  done_ = true;
  return part_ / k_table_name;
}

void RunFolder::write_results(const base::SourceTexts& sources, const model::Model& model,
                              results::RunResult& run, const results::ReportedGeometry& geometry) {
  const base::Stopwatch watch;
  using Table = void (*)(const fs::path&, const model::Model&, const results::RunResult&);
  constexpr std::array<std::pair<const char*, Table>, 10> tables{
      {{k_table_name, report::write_k_csv},
       {"sensitivity.csv", report::write_sensitivity_csv},
       {"pressure.csv", report::write_pressure_csv},
       {"load_path.csv", report::write_K_along_load_path_csv},
       {"load_path_fronts.csv", report::write_load_path_fronts_csv},
       {"life.csv", report::write_life_csv},
       {"life_curve.csv", report::write_life_curve_csv},
       {"spectrum.csv", report::write_spectrum_csv},
       {"beta.csv", report::write_beta_csv},
       {"test.csv", report::write_growth_test_csv}}};
  std::error_code none;
  fs::remove(part_ / k_table_name, none); // that of a run under way
  for (const auto& [name, table] : tables) {
    put(name, [&, make = table](const fs::path& file) { make(file, model, run); });
  }
  write_vtu_files(model, run, [this](const auto& name, const auto& write) { put(name, write); });
  put_requested(model, run);
  put(results_name,
      [&](const fs::path& file) { archive::write_results_file(file, sources, model, run); });
  const std::vector<results::LoadTotal> totals = sense::compute_load_totals(model);
  add_file("report.html", report::html_report(sources, model, run, totals));
  run.log.push_back({"OUTPUT", "tables, pictures, report", watch.cpu_time(), watch.wall_time()});
  run.cpu += watch.cpu_time();
  run.wall += watch.wall_time();
  // The listing comes last, as it has the figures of all before.
  run.peak_memory = base::peak_memory();
  add_lines_of_ranks(run.log);
  add_file(listing_name,
           report::listing_text(sources, model, run, totals) +
               report::imported_geometry_section(geometry, model.units.output_length()));
}

std::uintmax_t RunFolder::written_bytes() const {
  std::uintmax_t bytes = 0;
  for (const std::string& name : names_) {
    std::error_code none; // a table without rows
    const std::uintmax_t size = fs::file_size(part_ / name, none);
    bytes += none ? 0 : size;
  }
  return bytes;
}

void RunFolder::add_file(const std::string& name, const std::string& text) {
  put(name, [&](const fs::path& file) { base::write_atomically(file, text); });
}

// Files that no run wrote keep their names, or where a result has that name now, get one more word.
void RunFolder::take_over_foreign(const fs::path& old) const {
  const std::optional<archive::FolderManifest> mark = archive::read_folder_manifest(old);
  for (const std::string& name :
       archive::find_foreign_files(old, mark.value_or(archive::FolderManifest{}))) {
    fs::path to = folder_ / name;
    for (int number = 0; !rename_to_free(old / name, to); ++number) {
      if (errno != EEXIST) {
        throw trouble_with(to);
      }
      to = folder_ / (number == 0 ? name + ".kept" : fmt::format("{}.kept{}", name, number));
    }
  }
}

void RunFolder::move_into_place() {
  check_folder_ownership(folder_, false); // it may have been made meanwhile
  if (rename_to_free(part_, folder_)) {
    return;
  }
  if (errno != EEXIST) {
    throw trouble_with(folder_);
  }
  if (!place_lock_) {
    place_lock_ = archive::FolderLock::acquire_lock(folder_, part_);
  }
  // The new folder has the permissions of the one that it replaces.
  fs::permissions(part_, fs::status(folder_).permissions());
  exchange(part_, folder_);
  take_over_foreign(part_);
  if (archive::read_folder_manifest(part_)) {
    archive::remove_manifest_files(part_);
  } else {
    fs::remove(part_); // an empty folder
  }
}

void RunFolder::commit() {
  const std::scoped_lock lock(writing_);
  // Tables without rows write no file.
  std::erase_if(names_, [&](const std::string& name) { return !is_there(part_ / name); });
  archive::write_folder_manifest(part_, {archive::RunOrSweepFolder::run, names_});
  done_ = true; // from now on the results are whole: whatever happens, they stay
  try {
    move_into_place();
  } catch (const std::exception& trouble) {
    throw archive::FileFailure(
        "E464", fmt::format("{}; the results are in {}", trouble.what(),
                            is_there(part_ / listing_name) ? part_.string() : folder_.string()));
  }
  std::error_code ignored;
  fs::remove(folder_ / archive::owner_name, ignored);
}

std::optional<fs::path> RunFolder::abandon(bool leaves_k) {
  using namespace std::chrono_literals;
  // The lock is held to the end of the process, so that no thread writes a file behind the removal.
  const bool quiet = writing_.try_lock_for(10s); // not given back
  if (quiet && !done_) {
    if (leaves_k) {
      return retain_interim_k();
    }
    archive::remove_manifest_files(part_);
  }
  return std::nullopt;
}

void InterimKTable::update_increment(const results::CrackLengthResult& increment) {
  // A state that was tried and not taken is replaced by the next.
  run_.increments.resize(finished_);
  results::CrackLengthResult& shown = run_.increments.emplace_back();
  shown.number = static_cast<int>(finished_) + 1;
  shown.a = increment.a;
  bool any = false;
  for (const results::LoadStepResult& step : increment.steps) {
    results::LoadStepResult& copy = shown.steps.emplace_back();
    copy.step = step.step;
    copy.fronts = step.fronts;
    any = any || !step.fronts.empty();
  }
  if (any) {
    folder_.write_interim_k(model_, run_);
  }
}

} // namespace spricka::program
