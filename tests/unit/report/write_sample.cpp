// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report.hpp"
#include "sample.hpp"

#include <filesystem>
#include <fstream>

/// Writes the sample's run folder for readers other than our own.
int main(int count, char** arguments) {
  using namespace spricka;
  if (count != 2) {
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  const test::Sample sample = test::make_sample();
  std::vector<std::pair<double, std::string>> entries;
  for (const results::Increment& increment : sample.run.increments) {
    const std::string name = "sample." + std::to_string(increment.number) + ".vtu";
    report::write_vtu(folder / name, sample.model, increment, increment.steps[1]);
    entries.emplace_back(increment.a, name);
  }
  report::write_pvd(folder / "sample.pvd", entries);
  report::write_k_csv(folder / "k.csv", sample.model, sample.run);
  report::write_pressure_csv(folder / "pressure.csv", sample.model, sample.run);
  std::ofstream(folder / "report.html")
      << report::html_report(sample.sources, sample.model, sample.run);
}
