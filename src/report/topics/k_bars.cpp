// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/k_bars.hpp"

#include "report/topics/result_rows.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::report {

namespace {

// What is printed of a bar.
results::KErrorBar bar_in_output_unit(const results::KErrorBar& bar, const base::OutputUnit& unit) {
  results::KErrorBar written;
  written.mesh = unit.from_deck(bar.mesh);
  written.edge = unit.from_deck(bar.edge);
  written.floor = unit.from_deck(bar.floor);
  written.of_best = bar.of_best;
  return written;
}

// Which K is printed: with its estimated error taken out, or not.
std::string kind_of_K_text(const results::KErrorBar& bar, const std::string& raw) {
  return bar.of_best ? "raw " + raw : "as the mesh has it";
}

} // namespace

namespace {

/// Decimals that show two digits of a bar.
int decimals_of_bar(double size) {
  return std::max(0, 1 - static_cast<int>(std::floor(std::log10(size))));
}

bool has_no_digits(double size) {
  return !(size > 0.0) || !std::isfinite(size) || std::abs(std::log10(size)) > 9.0;
}

std::string rounded_text(double value, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}", std::abs(value) < 0.5 * unit ? 0.0 : value, decimals);
}

} // namespace

std::string k_by_bar_text(double K, double size) {
  return has_no_digits(size) ? fmt::format("{:.6g}", K) : rounded_text(K, decimals_of_bar(size));
}

std::string k_and_bar_text(double K, double size) {
  if (has_no_digits(size)) {
    return fmt::format("{:.4g} +- {:.2g}", K, size);
  }
  const int decimals = decimals_of_bar(size);
  return fmt::format("{} +- {}", rounded_text(K, decimals), rounded_text(size, decimals));
}

std::string k_with_bar_text(double K, double raw, const results::KErrorBar& bar) {
  const double size = bar.size();
  if (size == 0.0) { // K that is 0 whatever the mesh
    return fmt::format("{:.6g} +- 0", K);
  }
  if (has_no_digits(size)) {
    return fmt::format("{:.6g} +- {:.2g}; {}", K, size,
                       kind_of_K_text(bar, fmt::format("{:.6g}", raw)));
  }
  const auto number = [decimals = decimals_of_bar(size)](double value) {
    return rounded_text(value, decimals);
  };
  return fmt::format("{} +- {} (mesh {}, contact edge {}, floor {}); {}", number(K), number(size),
                     number(bar.mesh), number(bar.edge), number(bar.floor),
                     kind_of_K_text(bar, number(raw)));
}

std::string format_error_bar(double size) {
  if (!(size >= 99.5) || size >= 1e6) {
    return fmt::format("{:.2g}", size);
  }
  const double unit = std::pow(10.0, std::floor(std::log10(size)) - 1.0);
  return fmt::format("{:.0f}", unit * std::round(size / unit));
}

std::string k_error_bar_lines(const results::CrackLengthResult& increment,
                              const base::OutputUnit& unit) {
  const std::vector<FrontRow> rows = front_rows({&increment, 1});
  std::size_t step_width = 0;
  std::size_t name_width = 0;
  for (const FrontRow& row : rows) {
    step_width = std::max(step_width, row.step.step.size());
    name_width = std::max(name_width, row.front.name.size());
  }
  std::string lines;
  for (const FrontRow& row : rows) {
    for (std::size_t k = 0; k < 2 && row.front.is_tip() && row.front.has_error_bar(); ++k) {
      const results::FrontPointResult& tip = row.front.single_point();
      lines +=
          fmt::format("  {:<{}}  {:<{}}  K{} = {}\n", row.step.step, step_width, row.front.name,
                      name_width, k + 1,
                      k_with_bar_text(unit.from_deck(tip.K()[k]), unit.from_deck(tip.raw_K()[k]),
                                      bar_in_output_unit(tip.bar[k], unit)));
    }
  }
  return lines;
}

} // namespace spricka::report
