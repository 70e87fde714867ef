// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmsh.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// Writes a lug with a round head, a bush in its bore and a pin in the bush to a STEP file, by gmsh
// and OpenCASCADE: three solids that touch and share nothing, in mm. Usage: write_joint FILE;
// decks/lug_joint.step is such a file.
namespace {

namespace occ = gmsh::model::occ;

constexpr double bore = 15.0;
constexpr double inside = 12.0;
constexpr double thick = 12.0;

void draw() {
  constexpr double width = 64.0;
  constexpr double length = 100.0;
  gmsh::vectorpair outline;
  gmsh::vectorpair lug;
  std::vector<gmsh::vectorpair> parts;
  const int bar = occ::addBox(-length, -width / 2, 0, length, width, thick);
  const int head = occ::addCylinder(0, 0, 0, 0, 0, thick, width / 2);
  occ::fuse({{3, bar}}, {{3, head}}, outline, parts);
  const int hole = occ::addCylinder(0, 0, 0, 0, 0, thick, bore);
  occ::cut(outline, {{3, hole}}, lug, parts);
  gmsh::vectorpair bush;
  const int round = occ::addCylinder(0, 0, 0, 0, 0, thick, bore);
  const int middle = occ::addCylinder(0, 0, 0, 0, 0, thick, inside);
  occ::cut({{3, round}}, {{3, middle}}, bush, parts);
  constexpr double beyond = 4.0; // of the pin on both sides
  occ::addCylinder(0, 0, -beyond, 0, 0, thick + 2 * beyond, inside);
  occ::synchronize();
}

/// OpenCASCADE numbers the solids that have no names.
void name_solids(const char* file) {
  std::ifstream in(file);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::array<std::pair<std::string, std::string>, 3> names{
      {{".1'", "'LUG'"}, {".2'", "'BUSH'"}, {".3'", "'PIN'"}}};
  const std::string unnamed = "'Open CASCADE STEP translator";
  for (std::size_t at = text.find(unnamed); at != std::string::npos; at = text.find(unnamed, at)) {
    const std::size_t end = text.find('\'', at + 1) + 1;
    const std::string old = text.substr(at, end - at);
    std::string fresh = "'JOINT'";
    for (const auto& [number, name] : names) {
      fresh = old.ends_with(number) ? name : fresh;
    }
    text.replace(at, old.size(), fresh);
    at += fresh.size();
  }
  std::ofstream(file) << text;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    return EXIT_FAILURE;
  }
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  draw();
  gmsh::write(argv[1]);
  gmsh::finalize();
  name_solids(argv[1]);
  return EXIT_SUCCESS;
}
