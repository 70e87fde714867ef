// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/peers/calculix.hpp"

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

/// Reads a .frd line by line.
class FrdReader {
public:
  FrdReader(const std::vector<base::Label>& numbers, int dim) : index_(numbers), dim_(dim) {
    const auto count = static_cast<Eigen::Index>(numbers.size());
    fields_.u = base::Vector::Constant(count * dim, none);
    fields_.stress.resize(numbers.size());
    for (results::Stress& stress : fields_.stress) {
      stress.fill(none);
    }
  }

  std::optional<NodalFields> run(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      take(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return moved_ && stressed_ ? std::optional(std::move(fields_)) : std::nullopt;
  }

private:
  enum class FrdBlock { other, displacement, stress };

  void take(std::string_view line) {
    if (line.starts_with(" -4")) {
      const std::string_view name = line.substr(std::min<std::size_t>(5, line.size()));
      block_ = name.starts_with("DISP ")     ? FrdBlock::displacement
               : name.starts_with("STRESS ") ? FrdBlock::stress
                                             : FrdBlock::other;
    } else if (line.starts_with(" -3")) {
      block_ = FrdBlock::other;
    } else if (block_ != FrdBlock::other && line.starts_with(" -1")) {
      take_values(line);
    }
  }

  void take_values(std::string_view line) {
    const auto number = read<base::Label>(line.substr(number_from, values_from - number_from));
    const std::optional<std::size_t> node = number ? index_.find(*number) : std::nullopt;
    if (!node) {
      return;
    }
    if (block_ == FrdBlock::displacement) {
      moved_ = true;
      for (int c = 0; c < dim_; ++c) {
        fields_.u[static_cast<Eigen::Index>(*node) * dim_ + c] =
            value_of(line, static_cast<std::size_t>(c));
      }
    } else {
      stressed_ = true;
      results::Stress& stress = fields_.stress[*node];
      for (std::size_t c = 0; c < stress.size(); ++c) {
        stress[c] = value_of(line, c);
      }
    }
  }

  mesh::LabelIndex index_;
  int dim_;
  FrdBlock block_ = FrdBlock::other;
  bool moved_ = false;
  bool stressed_ = false;
  NodalFields fields_;
};

} // namespace

fs::path find_calculix() {
  const char* const path = std::getenv("PATH");
  std::string_view folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const fs::path file = fs::path(folders.substr(0, end)) / "ccx";
    if (end > 0 && fs::is_regular_file(file) && access(file.c_str(), X_OK) == 0) {
      return file;
    }
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return {};
}

ChildRun calculix_run(const fs::path& program, const fs::path& inp) {
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
  for (const char* const keyword : {"*NODE FILE", "*EL FILE"}) {
    const std::size_t at = inp.rfind(keyword);
    if (dim == 2 && at != std::string::npos) {
      inp.insert(at + std::string_view(keyword).size(), ", OUTPUT=2D");
    }
  }
  return inp;
}

std::optional<NodalFields> read_frd(std::string_view text, const std::vector<base::Label>& numbers,
                                    int dim) {
  return FrdReader(numbers, dim).run(text);
}

} // namespace spricka::program
