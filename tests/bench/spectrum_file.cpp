// SPDX-License-Identifier: GPL-3.0-or-later
// What reading the file of a spectrum costs, over a bare loop that reads the same numbers: lines of
// three columns, and of one. Usage: bench_spectrum_file [LINES] [REPEATS].
#include "base/input_file.hpp"
#include "base/messages.hpp"
#include "best_of.hpp"
#include "deck/read_deck.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace {

using namespace spricka;
using bench::best_of;
namespace fs = std::filesystem;

// The file in memory, and every number of it in a list.
double read_barely(const fs::path& file) {
  const std::string all = base::read_file(file, base::largest_number_file);
  std::vector<double> numbers;
  const char* at = all.data();
  const char* const end = at + all.size();
  while (at != end) {
    double value = 0.0;
    const auto [behind, trouble] = std::from_chars(at, end, value);
    if (trouble == std::errc()) {
      numbers.push_back(value);
      at = behind;
    } else {
      ++at;
    }
  }
  return numbers.empty() ? 0.0 : numbers.back();
}

std::string deck_with(const std::string& type) {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n$COOR DIM=2\n 1 0 0\n 2 1 0\n 3 1 1\n 4 0 1\n"
         "$ELEMENT TYPE=QUAM4 ESET=PLATE\n 1 1 2 3 4\n$MATERIAL NAME=STEEL E=210[GPa] NU=0.3\n"
         "$PROPERTY ESET=PLATE MATERIAL=STEEL STATE=STRESS\n$STEP NAME=S\n$STEP NAME=T\n"
         "$LOADPATH NAME=UP FROM=S TO=T\n$SPECTRUM NAME=A PATH=UP AT0=0 AT1=200 FILE='loads.txt' " +
         type + "\n$END\n";
}

std::size_t read_by_deck(const fs::path& deck) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::optional<model::Model> model = deck::read_deck(deck, {}, sources, diagnostics);
  if (!model) {
    fmt::print("{}", base::format_messages(sources, diagnostics));
    std::exit(1);
  }
  return model->spectra.front().turning_points.size() + model->spectra.front().cycles.size();
}

void compare(const fs::path& folder, std::size_t lines, int repeats, bool blocks) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> load(0.0, 100.0);
  {
    std::ofstream out(folder / "loads.txt");
    for (std::size_t i = 0; i < lines; ++i) {
      out << (blocks ? fmt::format("{:.3f} {:.3f} 1\n", 100.0 + load(engine), load(engine))
                     : fmt::format("{:.3f}\n", (i % 2 == 0 ? 0.0 : 100.0) + load(engine)));
    }
    std::ofstream(folder / "bench.deck")
        << deck_with(blocks ? "TYPE=BLOCKS ORDER=MAX,MIN,COUNT" : "TYPE=SEQUENCE");
  }
  const double bare = best_of(repeats, [&] { read_barely(folder / "loads.txt"); });
  std::size_t found = 0;
  const double deck = best_of(repeats, [&] { found = read_by_deck(folder / "bench.deck"); });
  fmt::print("{}: {} lines, bare loop {:.1f} ms, deck {:.1f} ms, {:.2f} times; {} kept\n",
             blocks ? "BLOCKS" : "SEQUENCE", lines, 1e3 * bare, 1e3 * deck, deck / bare, found);
}

} // namespace

int main(int argc, char** argv) {
  const auto lines = static_cast<std::size_t>(argc > 1 ? std::atoll(argv[1]) : 1000000);
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
  const fs::path folder =
      fs::temp_directory_path() / fmt::format("spricka_bench_spectrum_{}", getpid());
  fs::create_directories(folder);
  compare(folder, lines, repeats, true);
  compare(folder, lines, repeats, false);
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return 0;
}
