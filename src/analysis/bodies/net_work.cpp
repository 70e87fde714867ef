// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/net_work.hpp"

#include "model/model.hpp"
#include "solve/engine_choice.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Reports leave what they do not count at zero.
std::optional<double> counted(double number) {
  return number > 0.0 ? std::optional(number) : std::nullopt;
}

} // namespace

std::string substructure_name(const model::Model& model, const model::Mesh& mesh,
                              const std::string& body, const PartAndRegionElements& elements) {
  const auto net_of = [&](base::ElementId e) { return mesh.element_net[e.index()]; };
  const base::NetId net = net_of(elements.part.front());
  const bool cut =
      std::ranges::any_of(elements.region, [&](base::ElementId e) { return net_of(e) == net; });
  const std::string& own = model.nets[net.index()].name;
  const std::string name = own.empty() ? "MODEL" : own;
  if (!cut) {
    return fmt::format("{}: {}", body, name);
  }
  return body.find('+') == std::string::npos ? fmt::format("{}: rest", body)
                                             : fmt::format("{}: rest of {}", body, name);
}

void add_factor_sizes(const fe::DofMap& map, const solve::FactorReport& report,
                      results::NetCost& work) {
  work.freedoms = map.size();
  work.externals = map.external_count();
  work.entries = counted(report.factor_entries);
  work.engine = solve::explain_engine(report);
  if (!work.reused) {
    work.flops = counted(report.flops);
    work.analysis_cpu = report.analysis_cpu;
    work.numeric_cpu = report.numeric_cpu;
  }
}

} // namespace spricka::analysis
