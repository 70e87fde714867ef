// SPDX-License-Identifier: GPL-3.0-or-later
// Reading speed: a deck of about a million nodes and a million ten-node tetrahedra against a bare
// from_chars loop over the same bytes, in one run. Usage: bench_read_deck [CUBES] [REPEATS]; CUBES
// along a side, six tetrahedra in each.
#include "base/clock.hpp"
#include "base/messages.hpp"
#include "deck/context.hpp"
#include "deck/load.hpp"
#include "grammar/bulk_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace {

using namespace spricka;

// Six tetrahedra of a cube, by its corners (bit 0: x, bit 1: y, bit 2: z), and the edges of one.
constexpr std::array<std::array<int, 4>, 6> tets{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

struct Grid {
  int cubes;
  [[nodiscard]] std::int64_t label(int i, int j, int k) const {
    const std::int64_t n = 2 * cubes + 1;
    return 1 + i + n * (j + n * k);
  }
};

// Nodes a little off the grid, so that every coordinate has its 16 or 17 digits.
std::string coordinates_text(const Grid& grid) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> off(-0.005, 0.005);
  std::string text;
  const int n = 2 * grid.cubes + 1;
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", grid.label(i, j, k),
                       0.1 * i + off(random), 0.1 * j + off(random), 0.1 * k + off(random));
      }
    }
  }
  return text;
}

std::string elements_text(const Grid& grid) {
  std::string text;
  std::int64_t element = 0;
  for (int cube = 0; cube < grid.cubes * grid.cubes * grid.cubes; ++cube) {
    const std::array<int, 3> at{2 * (cube % grid.cubes), 2 * (cube / grid.cubes % grid.cubes),
                                2 * (cube / grid.cubes / grid.cubes)};
    const auto place = [&](int corner, std::size_t bit) {
      return at[bit] + 2 * ((corner >> bit) & 1);
    };
    for (const auto& tet : tets) {
      fmt::format_to(std::back_inserter(text), "{}", ++element);
      for (const int c : tet) {
        fmt::format_to(std::back_inserter(text), " {}",
                       grid.label(place(c, 0), place(c, 1), place(c, 2)));
      }
      for (const auto& edge : edges) {
        const int p = tet[static_cast<std::size_t>(edge[0])];
        const int q = tet[static_cast<std::size_t>(edge[1])];
        const auto middle = [&](std::size_t bit) { return (place(p, bit) + place(q, bit)) / 2; };
        fmt::format_to(std::back_inserter(text), " {}",
                       grid.label(middle(0), middle(1), middle(2)));
      }
      text += '\n';
    }
  }
  return text;
}

// What a bare loop makes of the same bytes: labels and values in flat arrays, nothing checked.
struct Bare {
  std::vector<std::int64_t> label;
  std::vector<double> x;
  std::vector<std::int64_t> node;
};

template <class Value> const char* next(const char* p, const char* last, Value& value) {
  while (p < last && (*p == ' ' || *p == '\n')) {
    ++p;
  }
  return std::from_chars(p, last, value).ptr;
}

void bare_loop(std::string_view nodes, std::string_view elements, Bare& bare) {
  std::int64_t label = 0;
  double x = 0.0;
  for (const char *p = nodes.begin(), *last = nodes.end(); p + 1 < last;) {
    p = next(p, last, label);
    bare.label.push_back(label);
    for (int k = 0; k < 3; ++k) {
      p = next(p, last, x);
      bare.x.push_back(x);
    }
  }
  for (const char *p = elements.begin(), *last = elements.end(); p + 1 < last;) {
    p = next(p, last, label);
    bare.label.push_back(label);
    for (int k = 0; k < 10; ++k) {
      p = next(p, last, label);
      bare.node.push_back(label);
    }
  }
}

double best_of(int repeats, const std::function<void()>& work) {
  double best = 1e30;
  for (int i = 0; i < repeats; ++i) {
    const base::Stopwatch watch;
    work();
    best = std::min(best, watch.cpu_time());
  }
  return best;
}

struct Deck {
  std::size_t nodes;
  std::size_t elements;
  base::SourceSpan node_data;
  base::SourceSpan element_data;
};

// The tables alone into flat arrays, labels as they stand.
void tables_alone(const base::SourceTexts& sources, const Deck& deck) {
  base::Diagnostics diagnostics;
  grammar::ExpressionScope scope;
  scope.sources = &sources;
  Bare flat;
  flat.label.reserve(deck.nodes + deck.elements);
  flat.x.reserve(3 * deck.nodes);
  flat.node.reserve(10 * deck.elements);
  grammar::BulkRowFormat form;
  form.columns = 3;
  grammar::parse_node_lines(form, deck.node_data, scope, diagnostics, [&](const auto& rows) {
    flat.label.insert(flat.label.end(), rows.label.begin(), rows.label.end());
    flat.x.insert(flat.x.end(), rows.value.begin(), rows.value.end());
  });
  form.columns = 10;
  grammar::parse_element_lines(form, deck.element_data, scope, diagnostics, [&](const auto& rows) {
    flat.label.insert(flat.label.end(), rows.label.begin(), rows.label.end());
    flat.node.insert(flat.node.end(), rows.value.begin(), rows.value.end());
  });
  if (diagnostics.has_errors() || flat.x.size() != 3 * deck.nodes) {
    std::abort();
  }
}

// Cards to a mesh with labels resolved, as read_deck does it up to the mesh.
double read_to_mesh(const std::filesystem::path& path, std::size_t& arrays) {
  const base::Stopwatch watch;
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const deck::DeckFileCards loaded = deck::read_deck_and_includes(path, sources, diagnostics);
  deck::DeckContext context{sources, diagnostics};
  deck::check_cards_and_define_names(context, loaded.cards, {});
  deck::build_mesh(context);
  const double spent = watch.cpu_time();
  const model::Mesh& mesh = context.model.mesh;
  arrays = mesh.node_count() * (sizeof(base::Vec3) + sizeof(base::Label) + sizeof(base::NetId)) +
           mesh.nodes.size() * sizeof(base::NodeId) +
           mesh.element_count() *
               (1 + 4 + sizeof(base::Label) + sizeof(base::NetId) + sizeof(base::PropertyId));
  fmt::print("{}", base::format_messages(sources, diagnostics));
  return spent;
}

} // namespace

int main(int argc, char** argv) {
  base::return_large_blocks_on_free();
  const Grid grid{argc > 1 ? std::atoi(argv[1]) : 55};
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "spricka_read.deck";
  {
    std::ofstream file(path);
    file << "$DECK VERSION=1 LENGTH=mm FORCE=N\n$COOR\n"
         << coordinates_text(grid) << "$ELEMENT TYPE=TET10\n"
         << elements_text(grid) << "$END\n";
  }
  const auto cubes = static_cast<std::size_t>(grid.cubes);
  const std::size_t side = 2 * cubes + 1;
  std::size_t arrays = 0;
  double mesh = 1e30;
  base::return_free_memory_to_system();
  mesh = read_to_mesh(path, arrays);
  const std::size_t peak = base::peak_memory();
  for (int i = 1; i < repeats; ++i) {
    mesh = std::min(mesh, read_to_mesh(path, arrays));
  }
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const deck::DeckFileCards loaded = deck::read_deck_and_includes(path, sources, diagnostics);
  const Deck deck{side * side * side, 6 * cubes * cubes * cubes, loaded.cards[1].data,
                  loaded.cards[2].data};
  const double bare = best_of(repeats, [&] {
    Bare flat;
    flat.label.reserve(deck.nodes + deck.elements);
    flat.x.reserve(3 * deck.nodes);
    flat.node.reserve(10 * deck.elements);
    bare_loop(sources.text(deck.node_data), sources.text(deck.element_data), flat);
  });
  const double reading = best_of(repeats, [&] {
    const auto bytes = std::make_unique_for_overwrite<char[]>(std::filesystem::file_size(path));
    std::ifstream(path, std::ios::binary)
        .read(bytes.get(), static_cast<std::streamsize>(std::filesystem::file_size(path)));
  });
  const double tables = best_of(repeats, [&] { tables_alone(sources, deck); });
  const double size = static_cast<double>(std::filesystem::file_size(path));
  fmt::print("{} nodes, {} TET10, {:.1f} MB\n", deck.nodes, deck.elements, size / 1e6);
  fmt::print("bare from_chars loop            {:.3f} s\n", bare);
  fmt::print("tables into flat arrays         {:.3f} s  {:.2f} times\n", tables, tables / bare);
  fmt::print("the same loop with its file     {:.3f} s\n", bare + reading);
  fmt::print("file to mesh, labels resolved   {:.3f} s  {:.2f} times\n", mesh,
             mesh / (bare + reading));
  fmt::print(
      "peak memory {:.1f} MB; arrays of the mesh {:.1f} MB + file: {:.2f} times the arrays\n",
      static_cast<double>(peak) / 1e6, static_cast<double>(arrays) / 1e6,
      (static_cast<double>(peak) - size) / static_cast<double>(arrays));
  std::filesystem::remove(path);
  return 0;
}
