// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "imported_file.hpp"
#include "mesh/import/nastran_import.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace spricka::test {

enum class NastranFieldFormat { narrow, wide, free };

/// One entry in small, large or free fields, with the lines that continue it.
inline std::string entry(NastranFieldFormat format, const std::string& name,
                         const std::vector<std::string>& fields) {
  const std::size_t width = format == NastranFieldFormat::wide ? 4 : 8;
  std::string text;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i % width == 0) {
      const std::string first = i == 0 ? name : format == NastranFieldFormat::wide ? "*" : "+";
      const std::string star = i == 0 && format == NastranFieldFormat::wide ? "*" : "";
      text += i == 0                               ? ""
              : format == NastranFieldFormat::free ? ",+\n"
              : format == NastranFieldFormat::wide ? "*\n"
                                                   : "+\n";
      text += format == NastranFieldFormat::free ? first : fmt::format("{:<8}", first + star);
    }
    text += format == NastranFieldFormat::free     ? "," + fields[i]
            : format == NastranFieldFormat::narrow ? fmt::format("{:>8}", fields[i])
                                                   : fmt::format("{:>16}", fields[i]);
  }
  return text + "\n";
}

inline std::vector<std::string> words(const std::vector<int>& numbers) {
  std::vector<std::string> text;
  for (const int n : numbers) {
    text.push_back(std::to_string(n));
  }
  return text;
}

class Nastran : public ImportedFile {
protected:
  Nastran() : ImportedFile("a.bdf") {}

  [[nodiscard]] std::size_t elements(const std::string& name) const {
    for (const model::ElementSet& set : model_.mesh.element_sets) {
      if (set.name == name) {
        return set.elements.size();
      }
    }
    return 0;
  }

private:
  mesh::ImportedMaterialsAndEquations read(const mesh::ImportRequest& request) override {
    return mesh::import_nastran(model_.mesh, request, diagnostics_);
  }
};

using Edges = std::vector<std::pair<int, int>>;

/// A single element: its corners, and the edges that the quick reference guide puts the further
/// nodes on, in its order.
struct NastranSample {
  std::string name;
  base::ElementType linear, quadratic;
  std::vector<base::Vec3> corners;
  Edges edges;
  double volume;
};
inline const std::vector<NastranSample> samples{
    {"CHEXA",
     base::ElementType::hexe8,
     base::ElementType::hexec20,
     {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}},
     {{1, 2},
      {2, 3},
      {3, 4},
      {4, 1},
      {1, 5},
      {2, 6},
      {3, 7},
      {4, 8},
      {5, 6},
      {6, 7},
      {7, 8},
      {8, 5}},
     2.0},
    {"CPENTA",
     base::ElementType::penta6,
     base::ElementType::pentac15,
     {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {0, 1, 1}},
     {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 5}, {3, 6}, {4, 5}, {5, 6}, {6, 4}},
     1.0},
    {"CTETRA",
     base::ElementType::tet4,
     base::ElementType::tet10,
     {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, 1}},
     {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 4}, {3, 4}},
     0.5},
    {"CQUAD8",
     base::ElementType::quam4,
     base::ElementType::quamc8,
     {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}},
     {{1, 2}, {2, 3}, {3, 4}, {4, 1}},
     2.0},
    {"CTRIA6",
     base::ElementType::trim3,
     base::ElementType::trimc6,
     {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}},
     {{1, 2}, {2, 3}, {3, 1}},
     1.0}};

inline std::string grid(NastranFieldFormat format, int label, const base::Vec3& x) {
  return entry(format, "GRID",
               {std::to_string(label), "", fmt::format("{:.3f}", x.x()),
                fmt::format("{:.3f}", x.y()), fmt::format("{:.3f}", x.z())});
}

/// The text of one element; `mirror` changes its sense.
inline std::string text_of(const NastranSample& sample, NastranFieldFormat format, bool middles,
                           bool mirror = false) {
  const auto at = [&](const base::Vec3& x) {
    return mirror ? base::Vec3(-x.x(), x.y(), x.z()) : x;
  };
  std::string text = "SOL 101\nCEND\nSPC = 1\nBEGIN BULK\n$ comment\n";
  std::vector<int> fields{7, 3};
  int label = 0;
  for (const base::Vec3& x : sample.corners) {
    text += grid(format, ++label, at(x));
    fields.push_back(label);
  }
  for (const auto& [a, b] : middles ? sample.edges : Edges()) {
    text += grid(format, ++label,
                 at(0.5 * (sample.corners[static_cast<std::size_t>(a) - 1] +
                           sample.corners[static_cast<std::size_t>(b) - 1])));
    fields.push_back(label);
  }
  return text + entry(format, sample.name, words(fields)) + "ENDDATA\nrubbish\n";
}

// One tetrahedron, in lines that other tests add to.
inline const std::string tetrahedron = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,0.,1.,0.
GRID,4,,0.,0.,1.
CTETRA,10,5,1,2,3,4
)";

// A square with its lower edge as a bar.
inline const std::string square = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
CQUAD4,10,5,1,2,3,4
)";

} // namespace spricka::test
