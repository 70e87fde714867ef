// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/checkpoint.hpp"

#include "archive/results_file.hpp"
#include "archive/safe_file.hpp"
#include "model/model.hpp"
#include "results/increment_flaw.hpp"
#include "results/store_run.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::archive {

namespace {

namespace fs = std::filesystem;

std::string increment_bytes(const results::CrackLengthResult& increment,
                            const results::NamedArrays& state) {
  results::Store store = results::Store::in_memory();
  results::write_crack_length_result(store.root(), increment);
  results::write_restart_arrays(store.root().group("state"), state);
  return std::string(store.finish_bytes());
}

// What an increment names of the deck that the deck does not have; or what
// describe_increment_corruption() finds. Hashes tell files that were changed by chance, not those
// that were made.
std::string flaw_in_deck(const results::CrackLengthResult& increment, const model::Model& model) {
  if (std::string flaw = results::describe_increment_corruption(increment); !flaw.empty()) {
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
  if (!std::ranges::equal(increment.steps, model.steps, {}, &results::LoadStepResult::step,
                          &model::Step::name)) {
    return "other steps than the deck's";
  }
  return {};
}

} // namespace

Checkpoint::Checkpoint(CheckpointOptions place, const fs::path& deck,
                       const base::SourceTexts& sources, const model::Model& model)
    : place_(std::move(place)), sources_(sources), model_(model),
      cards_(fingerprints_of_result_cards(deck, model)) {
  if (!place_.read.empty()) {
    found_ = read_newest();
  }
  if (!place_.write.empty()) {
    writer_.emplace(place_.write, [this](const std::vector<CheckpointEntry>& entries) {
      return list_bytes(entries);
    });
  }
}

void Checkpoint::set_report_listener(Listener listener) {
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

// The newest list whose increments are all there and whole; with AT those up to it.
CheckpointList Checkpoint::read_newest() {
  std::optional<FileFailure> first_trouble;
  for (const fs::path& file : {place_.read, previous_list_file(place_.read)}) {
    try {
      CheckpointList list = read_checkpoint_list_file(file);
      for (const CheckpointEntry& e : list.entries) {
        // Increments behind AT are not used: they may be damaged or gone.
        if (place_.at && e.number > *place_.at) {
          continue;
        }
        const fs::path part = increments_folder(place_.read) / e.file;
        if (hash_bytes(read_file_with_header(part, "increment")) != e.hash) {
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

bool Checkpoint::has_stored_increment(int number) const {
  return find(number) != nullptr;
}

double Checkpoint::requested_length_of_increment(int number) const {
  return find(number)->asked;
}

StoredIncrement Checkpoint::read_stored_increment(int number) const {
  const CheckpointEntry& entry = *find(number);
  const fs::path file = increments_folder(place_.read) / entry.file;
  const std::string bytes = read_file_with_header(file, "increment");
  StoredIncrement kept;
  try {
    const results::Store store = results::Store::from_bytes(bytes);
    kept.increment = results::read_crack_length_result(store.root());
    kept.state = results::read_restart_arrays(store.root().group("state"));
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

void Checkpoint::accept_increment(int number) {
  if (another_law_) {
    return; // whether it serves is not known yet
  }
  list_again(*find(number));
}

// Into another file, or without its last steps, it is written anew.
void Checkpoint::list_again(const CheckpointEntry& entry) {
  ++taken_;
  if (!writer_) {
    return;
  }
  if (dropped_steps_ > 0) {
    const StoredIncrement kept = read_stored_increment(entry.number);
    writer_->add_increment(entry, increment_bytes(kept.increment, kept.state));
  } else if (place_.read != place_.write) {
    writer_->add_increment(
        entry, read_file_with_header(increments_folder(place_.read) / entry.file, "increment"));
  } else {
    writer_->add_existing_entry(entry);
  }
}

void Checkpoint::reject_increments_from(int number, const std::string& why) {
  const auto later = [&](const CheckpointEntry& e) {
    return e.round > round_ || (e.round == round_ && e.number >= number);
  };
  // Increments behind it were made from what it leaves: they go with it.
  const auto gone = std::erase_if(found_.entries, later);
  tell("W561", fmt::format("{}: {} increment{} from number {} on solved anew: {}",
                           place_.read.string(), gone, gone == 1 ? " is" : "s are", number, why));
}

void Checkpoint::list_increment_of_another_law(int number, std::vector<results::LogLine> log) {
  CheckpointEntry entry = *find(number);
  entry.asked = 0.0; // the growth has found it, as it were
  entry.log = std::move(log);
  list_again(entry);
}

void Checkpoint::store_last_of_another_law(SolvedIncrement again) {
  ++taken_;
  add_to_writer(0.0, std::move(again)); // the list before has it: no need to hurry
}

void Checkpoint::store_increment(double asked, SolvedIncrement done) {
  walls_.push_back(done.wall);
  const bool due = done.increment.number % place_.every == 0;
  add_to_writer(asked, std::move(done));
  if (due && writer_) {
    writer_->flush();
  }
}

void Checkpoint::add_to_writer(double asked, SolvedIncrement done) {
  if (!writer_) {
    return;
  }
  CheckpointEntry entry;
  entry.round = round_;
  entry.number = done.increment.number;
  entry.asked = asked;
  entry.law = growth_law_text(model_, cards_);
  entry.cpu = done.cpu;
  entry.wall = done.wall;
  entry.log = std::move(done.log);
  writer_->add_increment(std::move(entry), increment_bytes(done.increment, done.state));
}

bool Checkpoint::would_exceed_time_limit() const {
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

std::string Checkpoint::run_limit_text() const {
  return fmt::format("--time {:.6g}", place_.seconds);
}

std::size_t Checkpoint::flush() {
  return writer_ ? writer_->flush() : taken_.load();
}

std::string Checkpoint::list_bytes(const std::vector<CheckpointEntry>& entries) const {
  results::Store store = results::Store::in_memory();
  results::StoreGroup root = store.root();
  root.set_attribute("format", "spricka state");
  write_provenance(root, model_);
  store_deck_texts(root, sources_, model_);
  write_checkpoint_list_group(root,
                              {cards_, entries, growth_settings_text(model_),
                               growth_course_text(model_), growth_length_and_cycle_limits(model_)});
  return std::string(store.finish_bytes());
}

} // namespace spricka::archive
