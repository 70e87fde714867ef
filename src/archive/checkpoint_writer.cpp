// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/checkpoint_writer.hpp"

#include "archive/safe_file.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace spricka::archive {

namespace {

namespace fs = std::filesystem;

fs::path with(fs::path file, const char* more) {
  file += more;
  return file;
}

// "0003-0f1e2d3c.h5": whatever is overwritten or not, a name stands for one content.
std::string file_name(int round, int number, const std::string& hash) {
  return fmt::format("{}{:04}-{}.h5", round > 1 ? fmt::format("{}.", round) : "", number,
                     hash.substr(0, 8));
}

// As file_name() makes them, "2.0003-0f1e2d3c.h5", and with the first line of an increment: nobody
// else's file.
bool is_ours(const fs::path& file) {
  const std::string name = file.filename().string();
  constexpr std::string_view digits = "0123456789";
  const std::size_t round = name.find_first_not_of(digits);
  const std::size_t number = round < name.size() && name[round] == '.' ? round + 1 : 0;
  const std::size_t dash = std::min(name.find_first_not_of(digits, number), name.size());
  const std::string_view rest = std::string_view(name).substr(dash);
  constexpr std::string_view form = "-01234567.h5";
  if (dash < number + 4 || rest.size() != form.size() || rest.front() != '-' ||
      !rest.ends_with(".h5") ||
      rest.substr(1, 8).find_first_not_of("0123456789abcdef") != std::string_view::npos) {
    return false;
  }
  try {
    return base::read_file_beginning(file, frame_size).starts_with("spricka increment ");
  } catch (const base::UnreadableFile&) {
    return false;
  }
}

} // namespace

fs::path increments_folder(const fs::path& file) {
  return with(file, ".d");
}

fs::path previous_list_file(const fs::path& file) {
  return with(file, ".1");
}

CheckpointList read_checkpoint_list_file(const fs::path& file) {
  const std::string bytes = read_file_with_header(file, "state");
  try {
    return read_checkpoint_list_group(results::Store::from_bytes(bytes).root());
  } catch (const results::StoreError& trouble) {
    throw FileFailure("E560", fmt::format("{}: {}", file.string(), trouble.what()));
  }
}

CheckpointWriter::CheckpointWriter(fs::path file, ListBytes list_bytes)
    : file_(std::move(file)), list_bytes_(std::move(list_bytes)) {
  open_to_write();
}

CheckpointWriter::~CheckpointWriter() {
  if (lock_ >= 0) {
    ::close(lock_);
  }
}

// A restart file of this name may be replaced, anything else is not ours.
void CheckpointWriter::open_to_write() {
  const fs::path folder = increments_folder(file_);
  for (const fs::path& list : {file_, previous_list_file(file_)}) {
    std::error_code unknown;
    if (!fs::exists(list, unknown)) {
      continue;
    }
    try {
      for (const CheckpointEntry& e : read_checkpoint_list_file(list).entries) {
        before_.push_back(e.file);
      }
    } catch (const FileFailure& trouble) {
      // A list that is damaged is ours and may be replaced; what is no list at all is not.
      if (trouble.code() == "E564") {
        throw FileFailure("E564", std::string(trouble.what()) + ", and is not overwritten");
      }
    }
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw FileFailure("E563", fmt::format("{}: {}", folder.string(), error.message()));
  }
  lock_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) {
    throw FileFailure("E563", fmt::format("{}: {}", folder.string(), std::strerror(errno)));
  }
  // Where a file system has no locks the run goes on: only another holder is a reason to refuse.
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw FileFailure("E563", fmt::format("{}: another run is writing it", file_.string()));
  }
}

void CheckpointWriter::add_existing_entry(const CheckpointEntry& entry) {
  const std::scoped_lock lock(guard_);
  entries_.push_back(entry);
  ++on_disk_;
}

void CheckpointWriter::add_increment(CheckpointEntry entry, const std::string& bytes) {
  entry.hash = hash_bytes(bytes);
  entry.file = file_name(entry.round, entry.number, entry.hash);
  const std::scoped_lock lock(guard_);
  pending_.push_back({entry.file, prepend_file_header("increment", bytes)});
  entries_.push_back(std::move(entry));
  pending_list_ = prepend_file_header("state", list_bytes_(entries_));
}

std::size_t CheckpointWriter::flush() {
  const std::scoped_lock lock(guard_);
  if (!pending_.empty()) {
    put_on_disk();
  }
  return on_disk_;
}

// Increments first: a list names only what is there. The list before stays until the new one is.
void CheckpointWriter::put_on_disk() {
  const fs::path folder = increments_folder(file_);
  for (const PendingFile& p : pending_) {
    write_file_atomically(folder / p.file, p.bytes);
  }
  pending_.clear();
  const fs::path before = previous_list_file(file_);
  std::error_code none;
  if (fs::exists(file_, none)) {
    const fs::path linked = base::unused_temporary_path(before);
    // The name never vanishes: a second link to the list becomes the one before.
    fs::create_hard_link(file_, linked, none);
    if (!none) {
      fs::rename(linked, before, none);
    } else {
      fs::rename(file_, before, none); // a file system without links
    }
  }
  write_file_atomically(file_, pending_list_);
  on_disk_ = entries_.size();
  sweep_folder();
  // What this list names is what the next list may not sweep away.
  before_.clear();
  for (const CheckpointEntry& e : entries_) {
    before_.push_back(e.file);
  }
}

// Files that neither this list nor the one before names.
void CheckpointWriter::sweep_folder() const {
  std::error_code none;
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(increments_folder(file_), none)) {
    const std::string name = entry.path().filename().string();
    const bool listed =
        std::ranges::find(before_, name) != before_.end() ||
        std::ranges::any_of(entries_, [&](const CheckpointEntry& e) { return e.file == name; });
    if (!listed && is_ours(entry.path())) {
      old.push_back(entry.path());
    }
  }
  for (const fs::path& file : old) {
    fs::remove(file, none);
  }
}

} // namespace spricka::archive
