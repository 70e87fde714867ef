// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/peers/calculix.hpp"

#include "base/by_dimension.hpp"
#include "mesh/label_index.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>

#include <unistd.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
// A line of values: " -1", the node's number in 10 columns, values of 12 columns each.
constexpr std::size_t number_from = 3;
constexpr std::size_t values_from = 13;
constexpr std::size_t width = 12;

template <class ScannedNumber> std::optional<ScannedNumber> read(std::string_view columns) {
  columns.remove_prefix(std::min(columns.find_first_not_of(' '), columns.size()));
  ScannedNumber value{};
  const auto end = std::from_chars(columns.data(), columns.data() + columns.size(), value);
  return end.ec == std::errc() ? std::optional(value) : std::nullopt;
}

double value_of(std::string_view line, std::size_t column) {
  const std::size_t from = values_from + width * column;
  return from < line.size() ? read<double>(line.substr(from, width)).value_or(none) : none;
}

enum class FrdBlock { other, displacement, stress };

FrdBlock block_of(std::string_view header) {
  const std::string_view name = header.substr(std::min<std::size_t>(5, header.size()));
  return name.starts_with("DISP ")     ? FrdBlock::displacement
         : name.starts_with("STRESS ") ? FrdBlock::stress
                                       : FrdBlock::other;
}

// The first part of a text that ends with a mark, which is taken from it with the mark.
std::string_view split_off_part(std::string_view& text, char mark) {
  const std::string_view part = text.substr(0, text.find(mark));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

} // namespace

fs::path find_calculix() {
  const char* const path = std::getenv("PATH");
  std::string_view folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::string_view folder = split_off_part(folders, ':');
    fs::path file = fs::path(folder) / "ccx";
    if (!folder.empty() && fs::is_regular_file(file) && access(file.c_str(), X_OK) == 0) {
      return file;
    }
  }
  return {};
}

ChildRun make_calculix_run(const fs::path& program, const fs::path& inp) {
  ChildRun run;
  // What it is to read without the extension, as it adds one.
  run.other = {"/usr/bin/env",
               "OMP_NUM_THREADS=1",
               "CCX_NPROC_STIFFNESS=1",
               program.string(),
               "-i",
               fs::path(inp).replace_extension().string()};
  return run;
}

std::string adapt_input_for_calculix(std::string inp, int dim) {
  constexpr base::ByDimension<const char*> parameter{", OUTPUT=2D", ""};
  for (const char* const keyword : {"*NODE FILE", "*EL FILE"}) {
    if (const std::size_t at = inp.rfind(keyword); at != std::string::npos) {
      inp.insert(at + std::string_view(keyword).size(), parameter.at(dim));
    }
  }
  return inp;
}

std::optional<NodalFields> read_calculix_results(std::string_view text,
                                                 const std::vector<base::Label>& numbers, int dim) {
  const mesh::LabelIndex index(numbers);
  NodalFields fields;
  fields.u = base::Vector::Constant(static_cast<Eigen::Index>(numbers.size()) * dim, none);
  fields.stress.resize(numbers.size());
  for (results::Stress& stress : fields.stress) {
    stress.fill(none);
  }
  bool moved = false;
  bool stressed = false;
  FrdBlock block = FrdBlock::other;
  while (!text.empty()) {
    const std::string_view line = split_off_part(text, '\n');
    if (line.starts_with(" -4") || line.starts_with(" -3")) {
      block = line.starts_with(" -4") ? block_of(line) : FrdBlock::other;
    }
    if (block == FrdBlock::other || !line.starts_with(" -1")) {
      continue;
    }
    const auto number = read<base::Label>(line.substr(number_from, values_from - number_from));
    const std::optional<std::size_t> node = number ? index.find(*number) : std::nullopt;
    if (node && block == FrdBlock::displacement) {
      moved = true;
      for (int c = 0; c < dim; ++c) {
        fields.u[static_cast<Eigen::Index>(*node) * dim + c] =
            value_of(line, static_cast<std::size_t>(c));
      }
    } else if (node) {
      stressed = true;
      results::Stress& stress = fields.stress[*node];
      for (std::size_t c = 0; c < stress.size(); ++c) {
        stress[c] = value_of(line, c);
      }
    }
  }
  return moved && stressed ? std::optional(std::move(fields)) : std::nullopt;
}

} // namespace spricka::program
