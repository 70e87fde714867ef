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
    Json of_run = Json::object();
    of_run["cpu_s"] = profile_.cpu;
    event("run", "run", {}, {profile_.begin, profile_.end}, std::move(of_run));
    add_lengths();
    add_intervals();
    add_nets();
    if (!profile_.mesher.empty()) {
      name("process_name", {mesher_number, 0}, "spricka-mesher");
      name("thread_name", {mesher_number, 0}, "mesher");
    }
    for (const results::MesherCost& work : profile_.mesher) {
      Json args = Json::object();
      put(args, "cpu_s", work.cpu);
      put(args, "peak_bytes", work.peak);
      event("MESHER", "mesher", {mesher_number, 0}, {work.begin, work.end}, std::move(args));
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
  template <typename T>
  static void put(Json& args, const char* name, const std::optional<T>& value) {
    if (value) {
      args[name] = *value;
    }
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
             std::pair<double, double> span, Json args) {
    const std::int64_t begin = ticks(span.first);
    events_.push_back({{"name", title},
                       {"cat", category},
                       {"ph", "X"},
                       {"ts", microseconds(begin)},
                       {"dur", microseconds(ticks(span.second) - begin)},
                       {"pid", track.process},
                       {"tid", track.thread},
                       {"args", std::move(args)}});
  }

  void add_lengths() {
    for (const CrackLengthCostSum& sum : length_costs(profile_)) {
      const results::CrackLengthCost& work = *sum.work;
      Json args = Json::object();
      args["cpu_s"] = work.cpu;
      put(args, "a", work.a);
      args["counts"] = work.counts;
      const std::string a = work.a ? fmt::format("{:.6g}", *work.a) : "unknown";
      event(fmt::format("{}, a = {}", sum.label, a), "length", {}, {work.begin, work.end},
            std::move(args));
    }
  }

  void add_intervals() {
    for (const results::ProcessorInterval& span : profile_.intervals) {
      Json args = Json::object();
      args["what"] = span.text;
      args["cpu_s"] = span.cpu;
      put(args, "flops", span.flops);
      put(args, "resident_bytes", span.resident);
      put(args, "peak_bytes", span.peak);
      event(span.processor, "processor", {}, {span.begin, span.end}, std::move(args));
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
      Json assembling = Json::object();
      assembling["cpu_s"] = net->stiffness_cpu;
      event("STIFFNESS " + net->name, "net", track, {net->begin, net->assembled},
            std::move(assembling));
      Json args = Json::object();
      args["analysis_cpu_s"] = net->analysis_cpu;
      args["numeric_cpu_s"] = net->numeric_cpu;
      args["freedoms"] = net->freedoms;
      args["externals"] = net->externals;
      put(args, "nonzeros", net->entries);
      put(args, "flops", net->flops);
      event("CONDENSE " + net->name, "net", track, {net->assembled, net->end}, std::move(args));
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
