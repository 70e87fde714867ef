// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/profile/profile_sums.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using results::MesherCost;
using results::NetCost;
using results::ProcessorInterval;
using results::RunProfile;

// As a run goes along. Others stand behind these.
constexpr std::array<std::string_view, 17> order{
    "START",   "DECK", "MESHER",   "TOPOLOGY", "STIFFNESS", "CONDENSE",
    "CONTACT", "VCE",  "LOADPATH", "ADJOINT",  "ESTIMATE",  "SENSITIVITY",
    "RECOVER", "GROW", "RESTART",  "CHECKS",   "OUTPUT"};

template <typename T> void add(std::optional<T>& sum, const std::optional<T>& more) {
  sum = sum && more ? std::optional(*sum + *more) : std::nullopt;
}

class Sums {
public:
  explicit Sums(const RunProfile& profile) : profile_(profile) {}

  ProcessorCostTable make() {
    for (const ProcessorInterval& span : profile_.intervals) {
      add_span(span);
    }
    add_mesher();
    ProcessorCostTable out;
    out.program_cpu = profile_.cpu;
    out.wall = profile_.end - profile_.begin;
    out.peak = profile_.peak;
    out.cpu_rest = out.program_cpu;
    out.wall_rest = out.wall;
    for (const ProcessorCostSum& row : rows_) {
      out.wall_rest -= row.wall;
      if (row.processor == "MESHER") {
        out.mesher_cpu = row.cpu;
      } else {
        out.cpu_rest -= row.cpu.value_or(0.0);
      }
    }
    std::ranges::stable_sort(rows_, {}, [](const ProcessorCostSum& row) {
      return std::ranges::find(order, row.processor) - order.begin();
    });
    out.rows = std::move(rows_);
    return out;
  }

private:
  ProcessorCostSum& row_of(std::string_view processor) {
    const auto known = std::ranges::find(rows_, processor, &ProcessorCostSum::processor);
    if (known != rows_.end()) {
      return *known;
    }
    rows_.emplace_back().processor = processor;
    return rows_.back();
  }

  // Requests come one after another: none lies in two.
  [[nodiscard]] double waited(const ProcessorInterval& span) const {
    double wall = 0.0;
    for (const MesherCost& work : profile_.mesher) {
      wall += std::max(0.0, std::min(work.end, span.end) - std::max(work.begin, span.begin));
    }
    return wall;
  }

  void add_span(const ProcessorInterval& span) {
    double cpu = span.cpu;
    double wall = span.end - span.begin - waited(span);
    if (span.processor == "CONDENSE") {
      take_stiffness(span, cpu, wall);
    }
    ProcessorCostSum& row = row_of(span.processor);
    ++row.calls;
    row.cpu = row.cpu.value_or(0.0) + cpu;
    row.wall += wall;
    row.all_counted = row.all_counted && span.flops.has_value();
    if (span.flops) {
      row.flops = row.flops.value_or(0.0) + *span.flops;
      row.counted_cpu += cpu;
    }
    row.resident = std::max(row.resident, span.resident);
    row.peak = std::max(row.peak, span.peak);
    if (span.peak) {
      const std::size_t more = *span.peak - std::min(highest_, *span.peak);
      row.raised = row.raised.value_or(0) + more;
      highest_ += more;
    }
  }

  // What its nets took for their stiffness. Nets side by side share the time on the wall.
  void take_stiffness(const ProcessorInterval& span, double& cpu, double& wall) {
    std::vector<const NetCost*> nets; // those condensed in it, by when they began
    for (const NetCost& net : profile_.nets) {
      if (!net.reused && net.begin >= span.begin && net.begin <= span.end) {
        nets.push_back(&net);
      }
    }
    if (nets.empty()) {
      return;
    }
    std::ranges::sort(nets, {}, [](const NetCost* net) { return net->begin; });
    double stiffness = 0.0;
    double both = 0.0;
    double busy = 0.0; // on the wall, with one net or several
    double until = span.begin;
    double stiffness_cpu = 0.0;
    for (const NetCost* net : nets) {
      stiffness += net->assembled - net->begin;
      both += net->end - net->begin;
      busy += std::max(0.0, net->end - std::max(until, net->begin));
      until = std::max(until, net->end);
      stiffness_cpu += net->stiffness_cpu;
    }
    const double share = both > 0.0 ? stiffness / both * busy : 0.0;
    ProcessorCostSum& row = row_of("STIFFNESS");
    row.calls += nets.size();
    row.cpu = row.cpu.value_or(0.0) + stiffness_cpu;
    row.wall += share;
    row.all_counted = false;
    cpu -= stiffness_cpu;
    wall -= share;
  }

  void add_mesher() {
    for (const MesherCost& work : profile_.mesher) {
      ProcessorCostSum& row = row_of("MESHER");
      ++row.calls;
      add(row.cpu, work.cpu);
      row.wall += work.end - work.begin;
      row.all_counted = false;
      row.peak = std::max(row.peak, work.peak);
    }
  }

  const RunProfile& profile_;
  std::vector<ProcessorCostSum> rows_;
  std::size_t highest_ = 0; ///< [bytes] the peak so far
};

} // namespace

ProcessorCostTable processor_costs(const RunProfile& profile) {
  return Sums(profile).make();
}

std::vector<NetCostSum> net_costs(const RunProfile& profile) {
  std::vector<NetCostSum> sums;
  for (const NetCost& net : profile.nets) {
    auto sum = std::ranges::find(sums, net.name, &NetCostSum::name);
    if (sum == sums.end()) {
      sums.push_back({.name = net.name, .entries = {}, .flops = 0.0});
      sum = sums.end() - 1;
    }
    sum->freedoms = std::max(sum->freedoms, net.freedoms);
    sum->externals = std::max(sum->externals, net.externals);
    sum->entries = std::max(sum->entries, net.entries);
    if (net.reused) {
      ++sum->reused;
      continue;
    }
    ++sum->condensed;
    add(sum->flops, net.flops);
    sum->stiffness_cpu += net.stiffness_cpu;
    sum->analysis_cpu += net.analysis_cpu;
    sum->numeric_cpu += net.numeric_cpu;
  }
  return sums;
}

std::vector<CrackLengthCostSum> crack_length_costs(const RunProfile& profile) {
  std::vector<CrackLengthCostSum> sums(profile.lengths.size());
  const bool rounds = !sums.empty() && profile.lengths.back().round > 1;
  int round = 0;
  int increment = 0;
  for (std::size_t l = 0; l < sums.size(); ++l) {
    const results::CrackLengthCost& work = profile.lengths[l];
    increment = work.round == round ? increment : 0;
    round = work.round;
    sums[l].work = &work;
    sums[l].label = (rounds ? fmt::format("round {}: ", round) : "") +
                    (work.counts ? fmt::format("increment {}", ++increment) : "tried");
    for (const MesherCost& asked : profile.mesher) {
      if (asked.begin >= work.begin && asked.begin <= work.end) {
        add(sums[l].mesher_cpu, asked.cpu);
      }
    }
  }
  for (const NetCost& net : profile.nets) {
    if (!net.length || *net.length >= sums.size()) {
      continue;
    }
    CrackLengthCostSum& sum = sums[*net.length];
    (net.reused ? sum.reused : sum.condensed).push_back(net.name);
    if (!net.reused) {
      add(sum.flops, net.flops);
    }
  }
  return sums;
}

} // namespace spricka::program
