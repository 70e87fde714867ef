// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/checkpoint.hpp"

#include "archive/results_file.hpp"
#include "archive/safe_file.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "model/model.hpp"
#include "results/increment_flaw.hpp"
#include "results/store_run.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

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

fs::path folder_of(const fs::path& file) {
  return with(file, ".d");
}

fs::path list_before(const fs::path& file) {
  return with(file, ".1");
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
    return base::read_beginning(file, frame_size).starts_with("spricka increment ");
  } catch (const base::UnreadableFile&) {
    return false;
  }
}

std::string increment_bytes(const results::Increment& increment,
                            const results::NamedArrays& state) {
  results::Store store = results::Store::in_memory();
  results::write_increment(store.root(), increment);
  results::write_arrays(store.root().group("state"), state);
  return std::string(store.finish_bytes());
}

// What an increment names of the deck that the deck does not have; or what find_increment_flaw()
// finds. Hashes tell files that were changed by chance, not those that were made.
std::string flaw_in_deck(const results::Increment& increment, const model::Model& model) {
  if (std::string flaw = results::find_increment_flaw(increment); !flaw.empty()) {
    return flaw;
  }
  const auto beyond = [](const auto& ids, std::size_t count) {
    return std::ranges::any_of(
        ids, [&](const auto& id) { return id.value < -1 || (id.valid() && id.index() >= count); });
  };
  const model::Mesh& mesh = increment.mesh;
  if (mesh.dim != model.mesh.dim) {
    return "a mesh of another dimension";
  }
  if (beyond(mesh.node_net, model.nets.size()) || beyond(mesh.element_net, model.nets.size()) ||
      beyond(mesh.property, model.properties.size())) {
    return "nets or properties that the deck does not have";
  }
  if (!std::ranges::equal(increment.steps, model.steps, {}, &results::StepResult::step,
                          &model::Step::name)) {
    return "other steps than the deck's";
  }
  return {};
}

CheckpointList read_list_file(const fs::path& file) {
  const std::string bytes = read_framed(file, "state");
  try {
    return read_checkpoint_list(results::Store::from_bytes(bytes).root());
  } catch (const results::StoreError& trouble) {
    throw FileFailure("E560", fmt::format("{}: {}", file.string(), trouble.what()));
  }
}

} // namespace

Checkpoint::Checkpoint(CheckpointOptions place, const fs::path& deck,
                       const base::SourceTexts& sources, const model::Model& model)
    : place_(std::move(place)), sources_(sources), model_(model),
      cards_(card_fingerprints(deck, model)) {
  if (!place_.read.empty()) {
    found_ = read_newest();
  }
  if (writes()) {
    open_to_write();
  }
}

Checkpoint::~Checkpoint() {
  if (lock_ >= 0) {
    ::close(lock_);
  }
}

void Checkpoint::listen(Listener listener) {
  listener_ = std::move(listener);
  for (const auto& [code, text] : reported_) {
    listener_(code, text);
  }
}

void Checkpoint::tell(const std::string& code, const std::string& text) {
  reported_.emplace_back(code, text);
  if (listener_) {
    listener_(code, text);
  }
}

// A restart file of this name may be replaced, anything else is not ours.
void Checkpoint::open_to_write() {
  const fs::path folder = folder_of(place_.write);
  for (const fs::path& list : {place_.write, list_before(place_.write)}) {
    std::error_code unknown;
    if (!fs::exists(list, unknown)) {
      continue;
    }
    try {
      for (const CheckpointEntry& e : read_list_file(list).entries) {
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
    throw FileFailure("E563", fmt::format("{}: another run is writing it", place_.write.string()));
  }
}

// The newest list whose increments are all there and whole; with AT those up to it.
CheckpointList Checkpoint::read_newest() {
  std::optional<FileFailure> first_trouble;
  for (const fs::path& file : {place_.read, list_before(place_.read)}) {
    try {
      CheckpointList list = read_list_file(file);
      for (const CheckpointEntry& e : list.entries) {
        // Increments behind AT are not used: they may be damaged or gone.
        if (place_.at && e.number > *place_.at) {
          continue;
        }
        const fs::path part = folder_of(place_.read) / e.file;
        if (hash_bytes(read_framed(part, "increment")) != e.hash) {
          throw FileFailure("E560", part.string() + ": not the one that the list means");
        }
      }
      if (first_trouble) {
        tell("W560", fmt::format("{}; the list before it is whole and is taken: {}",
                                 first_trouble->what(), file.string()));
      }
      return list;
    } catch (const FileFailure& trouble) {
      if (!first_trouble) {
        first_trouble = trouble;
      }
    }
  }
  throw FileFailure(*first_trouble);
}

const CheckpointEntry* Checkpoint::find(int number) const {
  const auto entry = std::ranges::find_if(found_.entries, [&](const CheckpointEntry& e) {
    return e.round == round_ && e.number == number;
  });
  return entry == found_.entries.end() ? nullptr : &*entry;
}

bool Checkpoint::has_increment(int number) const {
  return find(number) != nullptr;
}

double Checkpoint::requested_length(int number) const {
  return find(number)->asked;
}

StoredIncrement Checkpoint::load_increment(int number) const {
  const CheckpointEntry& entry = *find(number);
  const fs::path file = folder_of(place_.read) / entry.file;
  const std::string bytes = read_framed(file, "increment");
  StoredIncrement kept;
  try {
    const results::Store store = results::Store::from_bytes(bytes);
    kept.increment = results::read_increment(store.root());
    kept.state = results::read_arrays(store.root().group("state"));
  } catch (const results::StoreError& trouble) {
    throw FileFailure("E560", fmt::format("{}: {}", file.string(), trouble.what()));
  }
  kept.log = entry.log;
  kept.cpu = entry.cpu;
  kept.wall = entry.wall;
  for (std::size_t s = 0; s < dropped_steps_ && !kept.increment.steps.empty(); ++s) {
    kept.increment.steps.pop_back();
  }
  if (const std::string flaw = flaw_in_deck(kept.increment, model_); !flaw.empty()) {
    throw FileFailure("E560",
                      fmt::format("{}: it names what is not there: {}", file.string(), flaw));
  }
  return kept;
}

// Into another file, or without its last steps, it is written anew.
void Checkpoint::accept_increment(int number) {
  const CheckpointEntry& entry = *find(number);
  std::string bytes;
  if (writes() && dropped_steps_ > 0) {
    const StoredIncrement kept = load_increment(number);
    bytes = increment_bytes(kept.increment, kept.state);
  } else if (writes() && place_.read != place_.write) {
    bytes = read_framed(folder_of(place_.read) / entry.file, "increment");
  }
  const std::scoped_lock lock(guard_);
  entries_.push_back(entry);
  ++taken_;
  // Taken over as it stands: its file is on disk already.
  if (bytes.empty()) {
    ++on_disk_;
    return;
  }
  entries_.back().hash = hash_bytes(bytes);
  entries_.back().file = file_name(entry.round, entry.number, entries_.back().hash);
  pending_.push_back({entries_.back().file, add_frame_line("increment", bytes)});
  pending_list_ = add_frame_line("state", list_bytes());
}

void Checkpoint::solve_from(int number, const std::string& why) {
  const auto later = [&](const CheckpointEntry& e) {
    return e.round > round_ || (e.round == round_ && e.number >= number);
  };
  // Increments behind it were made from what it leaves: they go with it.
  const auto gone = std::erase_if(found_.entries, later);
  tell("W561", fmt::format("{}: {} increment{} from number {} on solved anew: {}",
                           place_.read.string(), gone, gone == 1 ? " is" : "s are", number, why));
}

void Checkpoint::store_increment(double asked, SolvedIncrement done) {
  walls_.push_back(done.wall);
  if (!writes()) {
    return;
  }
  CheckpointEntry entry;
  entry.round = round_;
  entry.number = done.increment.number;
  entry.asked = asked;
  entry.cpu = done.cpu;
  entry.wall = done.wall;
  const std::string bytes = increment_bytes(done.increment, done.state);
  entry.log = std::move(done.log);
  entry.hash = hash_bytes(bytes);
  entry.file = file_name(entry.round, entry.number, entry.hash);
  const std::scoped_lock lock(guard_);
  pending_.push_back({entry.file, add_frame_line("increment", bytes)});
  entries_.push_back(std::move(entry));
  pending_list_ = add_frame_line("state", list_bytes());
  if (entries_.back().number % place_.every == 0) {
    put_on_disk();
  }
}

bool Checkpoint::out_of_time() const {
  if (place_.seconds <= 0.0 || walls_.empty()) {
    return false;
  }
  // The next increment is expected to take as long as the longer of the last two.
  double next = walls_.back();
  if (walls_.size() > 1) {
    next = std::max(next, walls_[walls_.size() - 2]);
  }
  return place_.since.wall_time() + next > place_.seconds;
}

std::string Checkpoint::limit_text() const {
  return fmt::format("--time {:.6g}", place_.seconds);
}

std::size_t Checkpoint::flush() {
  const std::scoped_lock lock(guard_);
  if (writes() && !pending_.empty()) {
    put_on_disk();
  }
  return on_disk_;
}

std::string Checkpoint::list_bytes() const {
  results::Store store = results::Store::in_memory();
  results::StoreGroup root = store.root();
  root.set_attribute("format", "spricka state");
  describe_origin(root, model_);
  store_deck(root, sources_, model_);
  write_checkpoint_list(root, {cards_, entries_, growth_rules(model_), growth_ends(model_)});
  return std::string(store.finish_bytes());
}

// Increments first: a list names only what is there. The list before stays until the new one is.
void Checkpoint::put_on_disk() {
  const fs::path folder = folder_of(place_.write);
  for (const PendingFile& p : pending_) {
    write_safely(folder / p.file, p.bytes);
  }
  pending_.clear();
  const fs::path before = list_before(place_.write);
  std::error_code none;
  if (fs::exists(place_.write, none)) {
    const fs::path linked = base::unused_part_path(before);
    // The name never vanishes: a second link to the list becomes the one before.
    fs::create_hard_link(place_.write, linked, none);
    if (!none) {
      fs::rename(linked, before, none);
    } else {
      fs::rename(place_.write, before, none); // a file system without links
    }
  }
  write_safely(place_.write, pending_list_);
  on_disk_ = entries_.size();
  sweep_folder();
  // What this list names is what the next list may not sweep away.
  before_.clear();
  for (const CheckpointEntry& e : entries_) {
    before_.push_back(e.file);
  }
}

// Files that neither this list nor the one before names.
void Checkpoint::sweep_folder() const {
  std::error_code none;
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(place_.write), none)) {
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
