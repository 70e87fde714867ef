// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus.hpp"
#include "tests/places.hpp"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>

#include <sys/time.h>
#include <unistd.h>

namespace spricka::fuzz {

namespace {

namespace fs = std::filesystem;

constexpr int k_seconds = 5;

std::string slurp(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

extern "C" void too_long(int /*signal*/) {
  constexpr char text[] = "a deck took too long to read; it is the last fuzz.deck\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
  ::_exit(99);
}

void limit(int seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

std::vector<fs::path> files(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Deck> load() {
  std::vector<Deck> decks;
  const Reader reader;
  for (const char* folder : {"decks", "tests/diagnostics", "tests/fuzz"}) {
    for (const fs::path& path : files(fs::path(test::source_folder()) / folder)) {
      if (path.extension() == ".deck") {
        Deck deck;
        deck.name = path.stem().string();
        deck.text = slurp(path);
        deck.imports = deck.name.starts_with("import");
        deck.sound = reader.read(deck.text).model.has_value();
        decks.push_back(std::move(deck));
      }
    }
  }
  return decks;
}

} // namespace

Reader::Reader()
    : folder_(fs::temp_directory_path() / ("spricka-fuzz-" + std::to_string(getpid()))) {
  fs::create_directories(folder_);
  for (const char* from : {"decks", "tests/diagnostics", "tests/fuzz"}) {
    for (const fs::path& path : files(fs::path(test::source_folder()) / from)) {
      const bool mesh = path.extension() == ".geo" || path.extension() == ".msh" ||
                        path.extension() == ".inp" || path.extension() == ".bdf" ||
                        path.extension() == ".step";
      if (path.extension() == ".inc" || (mesh && std::string_view(from) == "tests/fuzz")) {
        fs::copy_file(path, folder_ / path.filename(), fs::copy_options::overwrite_existing);
      }
    }
  }
  std::signal(SIGPROF, too_long);
}

Reader::~Reader() {
  std::error_code ignored;
  fs::remove(deck(), ignored);
}

Outcome Reader::read(const std::string& text, std::size_t largest_mesh) const {
  std::ofstream(deck(), std::ios::binary) << text;
  Outcome outcome;
  deck::DeckReadOptions options;
  options.largest_mesh = largest_mesh;
  limit(k_seconds);
  outcome.model = deck::read_deck(deck(), options, outcome.sources, outcome.diagnostics);
  limit(0);
  return outcome;
}

const std::vector<Deck>& corpus() {
  static const std::vector<Deck> decks = load();
  return decks;
}

} // namespace spricka::fuzz
