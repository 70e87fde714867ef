// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/checkpoint.hpp"

#include "results/store_run.hpp"
#include "run/results_file.hpp"
#include "run/safe_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <limits>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace spricka::run {

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

bool our_name(const std::string& name) {
  return name.ends_with(".h5") && name.find('-') != std::string::npos &&
         std::isdigit(static_cast<unsigned char>(name.front())) != 0;
}

std::string increment_bytes(const results::Increment& increment,
                            const results::NamedArrays& state) {
  results::Store store = results::Store::in_memory();
  results::write_increment(store.root(), increment);
  results::write_arrays(store.root().group("state"), state);
  return std::string(store.bytes());
}

results::Table card_table(const std::vector<CardMark>& cards) {
  std::vector<std::string> name;
  std::vector<std::string> hash;
  std::vector<std::string> uses;
  std::vector<std::string> file;
  std::vector<std::int64_t> line;
  for (const CardMark& card : cards) {
    name.push_back(card.name);
    hash.push_back(card.hash);
    uses.push_back(card.uses);
    file.push_back(card.file);
    line.push_back(card.line);
  }
  return {{{"name", name}, {"hash", hash}, {"uses", uses}, {"file", file}, {"line", line}}};
}

template <class T>
const std::vector<T>& column(const results::Table& table, std::size_t c, const char* name) {
  const std::vector<T>* values = c < table.columns.size() && table.columns[c].name == name
                                     ? std::get_if<std::vector<T>>(&table.columns[c].values)
                                     : nullptr;
  if (values == nullptr) {
    throw results::StoreError(fmt::format("column {} is missing", name));
  }
  return *values;
}

std::vector<CardMark> cards_from(const results::Table& table) {
  std::vector<CardMark> cards(table.rows());
  for (std::size_t i = 0; i < cards.size(); ++i) {
    cards[i].name = column<std::string>(table, 0, "name")[i];
    cards[i].hash = column<std::string>(table, 1, "hash")[i];
    cards[i].uses = column<std::string>(table, 2, "uses")[i];
    cards[i].file = column<std::string>(table, 3, "file")[i];
    cards[i].line = static_cast<int>(column<std::int64_t>(table, 4, "line")[i]);
  }
  return cards;
}

void write_entries(results::StoreGroup group, const std::vector<KeptEntry>& entries) {
  std::vector<std::int64_t> round;
  std::vector<std::int64_t> number;
  std::vector<double> asked;
  std::vector<std::string> file;
  std::vector<std::string> hash;
  std::vector<double> cpu;
  std::vector<double> wall;
  std::vector<std::int64_t> lines;
  std::vector<results::LogLine> log;
  for (const KeptEntry& e : entries) {
    round.push_back(e.round);
    number.push_back(e.number);
    asked.push_back(e.asked);
    file.push_back(e.file);
    hash.push_back(e.hash);
    cpu.push_back(e.cpu);
    wall.push_back(e.wall);
    lines.push_back(static_cast<std::int64_t>(e.log.size()));
    log.insert(log.end(), e.log.begin(), e.log.end());
  }
  group.write("increments", results::Table{{{"round", round},
                                            {"number", number},
                                            {"a", asked},
                                            {"file", file},
                                            {"hash", hash},
                                            {"cpu", cpu},
                                            {"wall", wall},
                                            {"log_lines", lines}}});
  results::write_log(group, "log", log);
}

std::vector<KeptEntry> entries_from(const results::StoreGroup& group) {
  const results::Table table = group.table("increments");
  const std::vector<results::LogLine> log = results::read_log(group, "log");
  auto line = log.begin();
  std::vector<KeptEntry> entries(table.rows());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    KeptEntry& e = entries[i];
    e.round = static_cast<int>(column<std::int64_t>(table, 0, "round")[i]);
    e.number = static_cast<int>(column<std::int64_t>(table, 1, "number")[i]);
    e.asked = column<double>(table, 2, "a")[i];
    e.file = column<std::string>(table, 3, "file")[i];
    e.hash = column<std::string>(table, 4, "hash")[i];
    e.cpu = column<double>(table, 5, "cpu")[i];
    e.wall = column<double>(table, 6, "wall")[i];
    const std::int64_t lines = column<std::int64_t>(table, 7, "log_lines")[i];
    if (lines < 0 || lines > log.end() - line) {
      throw results::StoreError("the log is incomplete");
    }
    e.log.assign(line, line + lines);
    line += lines;
  }
  return entries;
}

void add(std::string& text, double value) {
  text += fmt::format(" {:a}", value);
}

void add(std::string& text, const std::vector<double>& values) {
  for (const double value : values) {
    add(text, value);
  }
  text += ';';
}

void add(std::string& text, const std::optional<double>& value) {
  add(text, value ? std::vector{*value} : std::vector<double>());
}

// What of $GROW every increment depends on. Lengths of LAW=INCREMENT are compared one by one; AMAX
// and CYCLES only say where a growth ends.
std::string growth_text(const model::Model& model) {
  if (!model.growth) {
    return "none";
  }
  const model::Growth& g = *model.growth;
  std::string text = fmt::format("law {} direction {} history {} mounted {}",
                                 static_cast<int>(g.law), static_cast<int>(g.direction),
                                 static_cast<int>(g.history), static_cast<int>(g.mounted));
  for (const base::CrackId crack : g.cracks) {
    text += " " + model.cracks[crack.index()].name;
  }
  if (g.law == model::GrowthLaw::increment) {
    return text;
  }
  const model::LawConstants& c = g.constants;
  text += fmt::format(" from {} to {} corrected {} law", g.kmin.value, g.kmax.value, g.corrected);
  add(text, {c.C, c.m, c.p, c.q, c.alpha, c.stress_ratio, c.threshold, c.k_unit, c.a_unit});
  add(text, c.k_c);
  add(text, c.delta_k);
  add(text, c.growth);
  add(text, g.largest_advance);
  add(text, g.flow_stress);
  add(text, g.tolerance);
  return text;
}

// Where a growth by a law ends: AMAX, CYCLES.
std::array<double, 2> ends_of(const model::Model& model) {
  constexpr double never = std::numeric_limits<double>::infinity();
  return model.growth ? std::array{model.growth->last_length.value_or(never),
                                   model.growth->cycles.value_or(never)}
                      : std::array{never, never};
}

const std::vector<std::string> changeable{"STEP", "GROW", "SPECTRUM"};

} // namespace

Checkpoint::Checkpoint(CheckpointPlace place, const fs::path& deck, const base::Sources& sources,
                       const model::Model& model)
    : place_(std::move(place)), sources_(sources), model_(model), cards_(card_marks(deck, model)) {
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
  for (const auto& [code, text] : told_) {
    listener_(code, text);
  }
}

void Checkpoint::tell(const std::string& code, const std::string& text) {
  told_.emplace_back(code, text);
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
      for (const KeptEntry& e : read_list(list).entries) {
        before_.push_back(e.file);
      }
    } catch (const FileTrouble& trouble) {
      if (trouble.code() == "E564") {
        throw FileTrouble("E564", std::string(trouble.what()) + ", and is not overwritten");
      }
    }
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw FileTrouble("E563", fmt::format("{}: {}", folder.string(), error.message()));
  }
  lock_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) {
    throw FileTrouble("E563", fmt::format("{}: {}", folder.string(), std::strerror(errno)));
  }
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw FileTrouble("E563", fmt::format("{}: another run is writing it", place_.write.string()));
  }
}

Checkpoint::List Checkpoint::read_list(const fs::path& file) const {
  const std::string bytes = read_framed(file, "state");
  try {
    const results::Store store = results::Store::from_bytes(bytes);
    const results::StoreGroup root = store.root();
    List list;
    list.cards = cards_from(root.table("cards"));
    list.entries = entries_from(root);
    list.growth = root.text("growth");
    list.ends = {root.real("amax"), root.real("cycles")};
    return list;
  } catch (const results::StoreError& trouble) {
    throw FileTrouble("E560", fmt::format("{}: {}", file.string(), trouble.what()));
  }
}

// The newest list whose increments are all there and whole; with AT those up to it.
Checkpoint::List Checkpoint::read_newest() {
  std::optional<FileTrouble> first_trouble;
  for (const fs::path& file : {place_.read, list_before(place_.read)}) {
    try {
      List list = read_list(file);
      for (const KeptEntry& e : list.entries) {
        if (place_.at && e.number > *place_.at) {
          continue;
        }
        const fs::path part = folder_of(place_.read) / e.file;
        if (hash_of(read_framed(part, "increment")) != e.hash) {
          throw FileTrouble("E560", part.string() + ": not the one that the list means");
        }
      }
      if (first_trouble) {
        tell("W560", fmt::format("{}; the list before it is whole and is taken: {}",
                                 first_trouble->what(), file.string()));
      }
      return list;
    } catch (const FileTrouble& trouble) {
      if (!first_trouble) {
        first_trouble = trouble;
      }
    }
  }
  throw FileTrouble(*first_trouble);
}

std::optional<Misfit> Checkpoint::misfit() {
  if (place_.read.empty()) {
    return std::nullopt;
  }
  const auto of = [&](const CardDifference& d) {
    return Misfit{"E561", d.span,
                  fmt::format("{} was written for another deck: {}", place_.read.string(), d.text)};
  };
  if (const auto d =
          first_difference(without(found_.cards, changeable), without(cards_, changeable))) {
    return of(*d);
  }
  if (auto steps = misfit_of_steps()) {
    return steps;
  }
  if (auto growth = misfit_of_growth()) {
    return growth;
  }
  int last = 0;
  for (const KeptEntry& e : found_.entries) {
    last = std::max(last, e.number);
  }
  if (place_.at && *place_.at > last) {
    return Misfit{"E562", model_.restart ? model_.restart->span : base::Span{},
                  fmt::format("AT={}, but {} holds {} increment{}", *place_.at,
                              place_.read.string(), last, last == 1 ? "" : "s")};
  }
  if (place_.at) {
    std::erase_if(found_.entries, [&](const KeptEntry& e) { return e.number > *place_.at; });
  }
  return std::nullopt;
}

// Steps are walked one after another: those behind the common ones change nothing before them.
std::optional<Misfit> Checkpoint::misfit_of_steps() {
  const std::vector<CardMark> before = only(found_.cards, {"STEP"});
  const std::vector<CardMark> now = only(cards_, {"STEP"});
  const auto d = first_difference(before, now);
  if (!d) {
    return std::nullopt;
  }
  const std::vector<CardMark> shorter(
      before.begin(),
      before.begin() + static_cast<std::ptrdiff_t>(std::min(now.size(), before.size())));
  if (now.size() < before.size() && !first_difference(shorter, now)) {
    dropped_steps_ = before.size() - now.size();
    tell("W561", fmt::format("the last {} of {} steps are gone from the deck: what increments of "
                             "{} say of them is left out",
                             dropped_steps_, before.size(), place_.read.string()));
    return std::nullopt;
  }
  return Misfit{"E561", d->span,
                fmt::format("{}: its increments were solved with other steps: {}",
                            place_.read.string(), d->text)};
}

std::optional<Misfit> Checkpoint::misfit_of_growth() const {
  const auto d = first_difference(only(found_.cards, {"GROW", "SPECTRUM"}),
                                  only(cards_, {"GROW", "SPECTRUM"}));
  if (!d) {
    return std::nullopt;
  }
  const bool lengths = !model_.growth || model_.growth->law == model::GrowthLaw::increment;
  const std::array<double, 2> ends = ends_of(model_);
  const bool further = ends[0] >= found_.ends[0] && ends[1] >= found_.ends[1];
  const bool same_history =
      !first_difference(only(found_.cards, {"SPECTRUM"}), only(cards_, {"SPECTRUM"}));
  if (found_.growth == growth_text(model_) && (lengths || (further && same_history))) {
    return std::nullopt; // other lengths, or a later end
  }
  return Misfit{
      "E561", d->span,
      fmt::format("{}: its cracks grew by other rules: {}", place_.read.string(), d->text)};
}

const KeptEntry* Checkpoint::find(int number) const {
  const auto entry = std::ranges::find_if(
      found_.entries, [&](const KeptEntry& e) { return e.round == round_ && e.number == number; });
  return entry == found_.entries.end() ? nullptr : &*entry;
}

bool Checkpoint::has(int number) const {
  return find(number) != nullptr;
}

double Checkpoint::asked(int number) const {
  return find(number)->asked;
}

KeptIncrement Checkpoint::look_at(int number) const {
  const KeptEntry& entry = *find(number);
  const fs::path file = folder_of(place_.read) / entry.file;
  const std::string bytes = read_framed(file, "increment");
  KeptIncrement kept;
  try {
    const results::Store store = results::Store::from_bytes(bytes);
    kept.increment = results::read_increment(store.root());
    kept.state = results::read_arrays(store.root().group("state"));
  } catch (const results::StoreError& trouble) {
    throw FileTrouble("E560", fmt::format("{}: {}", file.string(), trouble.what()));
  }
  kept.log = entry.log;
  kept.cpu = entry.cpu;
  kept.wall = entry.wall;
  for (std::size_t s = 0; s < dropped_steps_ && !kept.increment.steps.empty(); ++s) {
    kept.increment.steps.pop_back();
  }
  return kept;
}

// Into another file, or without its last steps, it is written anew.
void Checkpoint::take(int number) {
  const KeptEntry& entry = *find(number);
  std::string bytes;
  if (writes() && dropped_steps_ > 0) {
    const KeptIncrement kept = look_at(number);
    bytes = increment_bytes(kept.increment, kept.state);
  } else if (writes() && place_.read != place_.write) {
    bytes = read_framed(folder_of(place_.read) / entry.file, "increment");
  }
  const std::scoped_lock lock(guard_);
  entries_.push_back(entry);
  ++taken_;
  if (bytes.empty()) {
    ++on_disk_;
    return;
  }
  entries_.back().hash = hash_of(bytes);
  entries_.back().file = file_name(entry.round, entry.number, entries_.back().hash);
  pending_.push_back({entries_.back().file, framed("increment", bytes)});
  pending_list_ = framed("state", list_bytes());
}

void Checkpoint::solve_from(int number, const std::string& why) {
  const auto later = [&](const KeptEntry& e) {
    return e.round > round_ || (e.round == round_ && e.number >= number);
  };
  const auto gone = std::erase_if(found_.entries, later);
  tell("W561", fmt::format("{}: {} increment{} from number {} on solved anew: {}",
                           place_.read.string(), gone, gone == 1 ? " is" : "s are", number, why));
}

void Checkpoint::keep(double asked, SolvedIncrement done) {
  walls_.push_back(done.wall);
  if (!writes()) {
    return;
  }
  KeptEntry entry;
  entry.round = round_;
  entry.number = done.increment.number;
  entry.asked = asked;
  entry.cpu = done.cpu;
  entry.wall = done.wall;
  const std::string bytes = increment_bytes(done.increment, done.state);
  entry.log = std::move(done.log);
  entry.hash = hash_of(bytes);
  entry.file = file_name(entry.round, entry.number, entry.hash);
  const std::scoped_lock lock(guard_);
  pending_.push_back({entry.file, framed("increment", bytes)});
  entries_.push_back(std::move(entry));
  pending_list_ = framed("state", list_bytes());
  if (entries_.back().number % place_.every == 0) {
    put_on_disk();
  }
}

bool Checkpoint::out_of_time() const {
  if (place_.seconds <= 0.0 || walls_.empty()) {
    return false;
  }
  double next = walls_.back();
  if (walls_.size() > 1) {
    next = std::max(next, walls_[walls_.size() - 2]);
  }
  return place_.since.wall() + next > place_.seconds;
}

std::string Checkpoint::limit() const {
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
  root.describe("format", "spricka state");
  root.describe("growth", growth_text(model_));
  root.describe("amax", ends_of(model_)[0]);
  root.describe("cycles", ends_of(model_)[1]);
  describe_origin(root, model_);
  store_deck(root, sources_, model_);
  root.write("cards", card_table(cards_));
  write_entries(root, entries_);
  return std::string(store.bytes());
}

// Increments first: a list names only what is there. The list before stays until the new one is.
void Checkpoint::put_on_disk() {
  const fs::path folder = folder_of(place_.write);
  for (const Pending& p : pending_) {
    write_safely(folder / p.file, p.bytes);
  }
  pending_.clear();
  const fs::path before = list_before(place_.write);
  std::error_code none;
  if (fs::exists(place_.write, none)) {
    const fs::path linked = with(place_.write, ".1.part");
    fs::remove(linked, none);
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
  before_.clear();
  for (const KeptEntry& e : entries_) {
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
        std::ranges::any_of(entries_, [&](const KeptEntry& e) { return e.file == name; });
    if (!listed && (our_name(name) || name.ends_with(".h5.part"))) {
      old.push_back(entry.path());
    }
  }
  for (const fs::path& file : old) {
    fs::remove(file, none);
  }
}

} // namespace spricka::run
