// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/profile/trace.hpp"

#include "program/profile/profile_sums.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace spricka::program {

namespace {

using Json = nlohmann::ordered_json;

constexpr int program_number = 1;
constexpr int mesher_number = 2;

/// Where an event stands in the viewer.
struct Track {
  int process = program_number;
  int thread = 0;
};

class Trace {
public:
  explicit Trace(const results::RunProfile& profile) : profile_(profile) {}

  std::string text() {
    name("process_name", {program_number, 0}, "spricka");
    name("thread_name", {program_number, 0}, "main");
    event("run", "run", {}, {profile_.begin, profile_.end}, {{"cpu_s", profile_.cpu}});
    add_lengths();
    add_intervals();
    add_nets();
    if (!profile_.mesher.empty()) {
      name("process_name", {mesher_number, 0}, "spricka-mesher");
      name("thread_name", {mesher_number, 0}, "mesher");
    }
    for (const results::MesherCost& work : profile_.mesher) {
      event("MESHER", "mesher", {mesher_number, 0}, {work.begin, work.end},
            {{"cpu_s", if_known(work.cpu)}, {"peak_bytes", if_known(work.peak)}});
    }
    // A line for each event, so that it can be read and searched as a text, too.
    std::string out = "{\"displayTimeUnit\": \"ms\", \"traceEvents\": [\n";
    for (std::size_t e = 0; e < events_.size(); ++e) {
      out += events_[e].dump(-1, ' ', false, Json::error_handler_t::replace);
      out += e + 1 < events_.size() ? ",\n" : "\n";
    }
    return out + "]}\n";
  }

private:
  // Without what is not known.
  static Json known(const Json& all) {
    Json args = Json::object();
    for (const auto& [name, value] : all.items()) {
      if (!value.is_null()) {
        args[name] = value;
      }
    }
    return args;
  }
  template <typename T> static Json if_known(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
  }

  // Of 1/1024 microsecond, before anything is taken from them: what lies within another still does,
  // and a viewer's sum of begin and duration is exact, so that what follows begins where this ends.
  [[nodiscard]] std::int64_t ticks(double moment) const {
    const double time = std::clamp(moment, profile_.begin, profile_.end) - profile_.begin; // [s]
    return std::llround(1024e6 * time);
  }
  static double microseconds(std::int64_t ticks) { return static_cast<double>(ticks) / 1024.0; }

  void name(const char* what, Track track, const std::string& text) {
    events_.push_back({{"name", what},
                       {"ph", "M"},
                       {"pid", track.process},
                       {"tid", track.thread},
                       {"args", {{"name", text}}}});
  }

  void event(const std::string& title, const char* category, Track track,
             std::pair<double, double> span, const Json& args) {
    const std::int64_t begin = ticks(span.first);
    events_.push_back({{"name", title},
                       {"cat", category},
                       {"ph", "X"},
                       {"ts", microseconds(begin)},
                       {"dur", microseconds(ticks(span.second) - begin)},
                       {"pid", track.process},
                       {"tid", track.thread},
                       {"args", known(args)}});
  }

  void add_lengths() {
    for (const CrackLengthCostSum& sum : crack_length_costs(profile_)) {
      const results::CrackLengthCost& work = *sum.work;
      const std::string a = work.a ? fmt::format("{:.6g}", *work.a) : "unknown";
      event(fmt::format("{}, a = {}", sum.label, a), "length", {}, {work.begin, work.end},
            {{"cpu_s", work.cpu}, {"a", if_known(work.a)}, {"counts", work.counts}});
    }
  }

  void add_intervals() {
    for (const results::ProcessorInterval& span : profile_.intervals) {
      event(span.processor, "processor", {}, {span.begin, span.end},
            {{"what", span.text},
             {"cpu_s", span.cpu},
             {"flops", if_known(span.flops)},
             {"resident_bytes", if_known(span.resident)},
             {"peak_bytes", if_known(span.peak)}});
      if (span.resident) {
        events_.push_back({{"name", "memory"},
                           {"ph", "C"},
                           {"ts", microseconds(ticks(span.end))},
                           {"pid", program_number},
                           {"tid", 0},
                           {"args", {{"resident_bytes", *span.resident}}}});
      }
    }
  }

  void add_nets() {
    std::vector<double> busy_until; // of each thread beside the main one
    std::vector<const results::NetCost*> nets;
    for (const results::NetCost& net : profile_.nets) {
      if (!net.reused) {
        nets.push_back(&net);
      }
    }
    std::ranges::stable_sort(nets, {}, [](const results::NetCost* net) { return net->begin; });
    for (const results::NetCost* net : nets) {
      const Track track{program_number, net->beside ? free_thread(*net, busy_until) : 0};
      event("STIFFNESS " + net->name, "net", track, {net->begin, net->assembled},
            {{"cpu_s", net->stiffness_cpu}});
      event("CONDENSE " + net->name, "net", track, {net->assembled, net->end},
            {{"analysis_cpu_s", net->analysis_cpu},
             {"numeric_cpu_s", net->numeric_cpu},
             {"freedoms", net->freedoms},
             {"externals", net->externals},
             {"nonzeros", if_known(net->entries)},
             {"flops", if_known(net->flops)}});
    }
  }

  // Threads have no names of their own: a net gets the first that is free.
  int free_thread(const results::NetCost& net, std::vector<double>& busy_until) {
    auto thread =
        std::ranges::find_if(busy_until, [&](double until) { return until <= net.begin; });
    if (thread == busy_until.end()) {
      busy_until.push_back(0.0);
      thread = busy_until.end() - 1;
      name("thread_name", {program_number, static_cast<int>(busy_until.size())}, "nets");
    }
    *thread = net.end;
    return static_cast<int>(thread - busy_until.begin()) + 1;
  }

  const results::RunProfile& profile_;
  Json events_ = Json::array();
};

} // namespace

std::string trace_json(const results::RunProfile& profile) {
  return Trace(profile).text();
}

} // namespace spricka::program
