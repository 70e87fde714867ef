// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/store_run.hpp"

#include "results/store_fields.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::results {

namespace {

template <class T>
concept StrongIndex = requires(T t) {
  t.value;
};

template <class T> std::vector<std::int64_t> whole(const std::vector<T>& from) {
  std::vector<std::int64_t> to(from.size());
  std::ranges::transform(from, to.begin(), [](const T& v) {
    if constexpr (StrongIndex<T>) {
      return static_cast<std::int64_t>(v.value);
    } else {
      return static_cast<std::int64_t>(v);
    }
  });
  return to;
}

template <class T> std::vector<T> narrow(const std::vector<std::int64_t>& from) {
  std::vector<T> to(from.size());
  std::ranges::transform(from, to.begin(), [](std::int64_t v) {
    if constexpr (StrongIndex<T>) {
      T id;
      id.value = static_cast<std::int32_t>(v);
      return id;
    } else {
      return static_cast<T>(v);
    }
  });
  return to;
}

// Empty arrays are left out.
void put(StoreGroup& group, const std::string& name, std::span<const double> values,
         std::size_t columns = 1) {
  if (!values.empty()) {
    group.write(name, values, columns);
  }
}

void put(StoreGroup& group, const std::string& name, const std::vector<std::string>& values) {
  if (!values.empty()) {
    group.write(name, values);
  }
}

std::vector<double> reals(const StoreGroup& group, const std::string& name) {
  return group.has_member(name) ? group.read_reals(name) : std::vector<double>();
}

std::vector<std::string> texts(const StoreGroup& group, const std::string& name) {
  return group.has_member(name) ? group.read_texts(name) : std::vector<std::string>();
}

std::span<const double> span_of(const base::Vector& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

base::Vector vector(const StoreGroup& group, const std::string& name) {
  const std::vector<double> values = reals(group, name);
  return Eigen::Map<const base::Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// Arrays of fixed-size arrays lie in memory one after another.
template <class T> std::span<const double> flat(const std::vector<T>& values) {
  constexpr std::size_t n = sizeof(T) / sizeof(double);
  return {values.empty() ? nullptr : values.front().data(), n * values.size()};
}

template <class T> std::vector<T> rows(const std::vector<double>& values) {
  constexpr std::size_t n = sizeof(T) / sizeof(double);
  std::vector<T> to(values.size() / n);
  for (std::size_t i = 0; i < to.size(); ++i) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(n * i), n, to[i].data());
  }
  return to;
}

void write_mesh(StoreGroup group, const model::Mesh& mesh) {
  group.set_attribute("dim", std::int64_t{mesh.dim});
  put(group, "x", flat(mesh.x), 3);
  group.write("node_label", mesh.node_label);
  group.write("node_net", whole(mesh.node_net));
  group.write("type", whole(mesh.type));
  group.write("first", whole(mesh.first));
  group.write("nodes", whole(mesh.nodes));
  group.write("element_label", mesh.element_label);
  group.write("element_net", whole(mesh.element_net));
  group.write("property", whole(mesh.property));
  write_record_list(group, "node_sets", mesh.node_sets);
  write_record_list(group, "element_sets", mesh.element_sets);
  write_record_list(group, "face_sets", mesh.face_sets);
}

model::Mesh read_mesh(const StoreGroup& group) {
  model::Mesh mesh;
  mesh.dim = static_cast<int>(group.integer_attribute("dim"));
  mesh.x = rows<base::Vec3>(reals(group, "x"));
  mesh.node_label = group.read_integers("node_label");
  mesh.node_net = narrow<base::NetId>(group.read_integers("node_net"));
  mesh.type = narrow<base::ElementType>(group.read_integers("type"));
  mesh.first = narrow<std::int32_t>(group.read_integers("first"));
  mesh.nodes = narrow<base::NodeId>(group.read_integers("nodes"));
  mesh.element_label = group.read_integers("element_label");
  mesh.element_net = narrow<base::NetId>(group.read_integers("element_net"));
  mesh.property = narrow<base::PropertyId>(group.read_integers("property"));
  mesh.node_sets = read_record_list<model::NodeSet>(group, "node_sets");
  mesh.element_sets = read_record_list<model::ElementSet>(group, "element_sets");
  mesh.face_sets = read_record_list<model::FaceSet>(group, "face_sets");
  return mesh;
}

void write_step(StoreGroup group, const LoadStepResult& step, std::size_t dim) {
  put(group, "u", span_of(step.u), dim);
  put(group, "reaction", span_of(step.reaction), dim);
  put(group, "temperature", span_of(step.temperature));
  put(group, "stress", flat(step.stress), 6);
  put(group, "element_stress", flat(step.element_stress), 6);
  write_record_list(group, "fronts", step.fronts);
  write_record_list(group, "contacts", step.contacts);
  write_record_list(group, "balance", step.balance);
  write_record_list(group, "nets", step.nets);
  write_record_list(group, "errors", step.errors);
  write_record_list(group, "targets", step.targets);
  put(group, "notes", text_with_code(step.notes));
  group.set_attribute("tied", std::int64_t{step.tied});
  group.set_attribute("energy", step.energy);
  group.set_attribute("friction_work", step.friction_work);
  group.set_attribute("increments", std::int64_t{step.increments});
  group.set_attribute("iterations", std::int64_t{step.iterations});
  group.set_attribute("pivots", std::int64_t{step.pivots});
}

LoadStepResult read_step(const StoreGroup& group, const std::string& name) {
  LoadStepResult step;
  step.step = name;
  step.u = vector(group, "u");
  step.reaction = vector(group, "reaction");
  step.temperature = vector(group, "temperature");
  step.stress = rows<Stress>(reals(group, "stress"));
  step.element_stress = rows<Stress>(reals(group, "element_stress"));
  step.fronts = read_record_list<FrontResult>(group, "fronts");
  step.contacts = read_record_list<ContactResult>(group, "contacts");
  step.balance = read_record_list<ForceBalance>(group, "balance");
  step.nets = read_record_list<ForceBalance>(group, "nets");
  step.errors = read_record_list<NetErrorEstimate>(group, "errors");
  step.targets = read_record_list<ForceBalance>(group, "targets");
  step.notes = parse_notes(texts(group, "notes"));
  step.tied = group.integer_attribute("tied") != 0;
  step.energy = group.real_attribute("energy");
  step.friction_work = group.real_attribute("friction_work");
  step.increments = static_cast<int>(group.integer_attribute("increments"));
  step.iterations = static_cast<int>(group.integer_attribute("iterations"));
  step.pivots = static_cast<int>(group.integer_attribute("pivots"));
  return step;
}

} // namespace

void write_crack_length_result(const StoreGroup& given, const CrackLengthResult& increment) {
  StoreGroup group = given;
  group.set_attribute("number", std::int64_t{increment.number});
  group.set_attribute("a", increment.a);
  group.set_attribute("unknowns", static_cast<std::int64_t>(increment.unknowns));
  group.set_attribute("kept", static_cast<std::int64_t>(increment.kept));
  write_mesh(group.group("mesh"), increment.mesh);
  write_record_list(group, "surface", increment.surface);
  write_record_list(group, "paths", increment.paths);
  put(group, "notes", text_with_code(increment.notes));
  const StoreGroup steps = group.group("steps");
  std::vector<std::string> names;
  for (const LoadStepResult& step : increment.steps) {
    names.push_back(step.step);
    write_step(steps.group(step.step), step, static_cast<std::size_t>(increment.mesh.dim));
  }
  put(group, "order", names);
}

CrackLengthResult read_crack_length_result(const StoreGroup& group) {
  CrackLengthResult increment;
  increment.number = static_cast<int>(group.integer_attribute("number"));
  increment.a = group.real_attribute("a");
  increment.unknowns = static_cast<std::size_t>(group.integer_attribute("unknowns"));
  increment.kept = static_cast<std::size_t>(group.integer_attribute("kept"));
  increment.mesh = read_mesh(group.group("mesh"));
  increment.surface = read_record_list<OuterSurfaceFace>(group, "surface");
  increment.paths = read_record_list<LoadPathResult>(group, "paths");
  increment.notes = parse_notes(texts(group, "notes"));
  const StoreGroup steps = group.group("steps");
  for (const std::string& name : texts(group, "order")) {
    increment.steps.push_back(read_step(steps.group(name), name));
  }
  return increment;
}

void write_restart_arrays(const StoreGroup& group, const NamedArrays& arrays) {
  StoreGroup reals = group.group("reals");
  for (const auto& [name, values] : arrays.reals) {
    reals.write(name, values);
  }
  StoreGroup integers = group.group("integers");
  for (const auto& [name, values] : arrays.integers) {
    integers.write(name, values);
  }
  StoreGroup texts = group.group("texts");
  for (const auto& [name, values] : arrays.texts) {
    texts.write(name, values);
  }
}

NamedArrays read_restart_arrays(const StoreGroup& group) {
  NamedArrays arrays;
  const StoreGroup reals = group.group("reals");
  for (const std::string& name : reals.names()) {
    arrays.reals[name] = reals.read_reals(name);
  }
  const StoreGroup integers = group.group("integers");
  for (const std::string& name : integers.names()) {
    arrays.integers[name] = integers.read_integers(name);
  }
  const StoreGroup texts = group.group("texts");
  for (const std::string& name : texts.names()) {
    arrays.texts[name] = texts.read_texts(name);
  }
  return arrays;
}

namespace {

// Tables of fronts, contacts and balances stay.
CrackLengthResult without_fields(const CrackLengthResult& whole) {
  CrackLengthResult thin;
  thin.number = whole.number;
  thin.a = whole.a;
  thin.unknowns = whole.unknowns;
  thin.kept = whole.kept;
  thin.mesh.dim = whole.mesh.dim;
  thin.paths = whole.paths;
  thin.notes = whole.notes;
  for (const LoadStepResult& step : whole.steps) {
    LoadStepResult& copy = thin.steps.emplace_back(step);
    for (base::Vector* field : {&copy.u, &copy.reaction, &copy.temperature}) {
      field->resize(0);
    }
    copy.stress.clear();
    copy.element_stress.clear();
    for (FrontResult& front : copy.fronts) {
      for (FrontPointResult& place : front.points) {
        for (KErrorBar& bar : place.bar) {
          bar.of_element.clear();
        }
      }
    }
  }
  return thin;
}

} // namespace

void write_run(const StoreGroup& given, const RunResult& run, TimeRecording times,
               const std::vector<bool>& fields) {
  StoreGroup group = given;
  const StoreGroup all = group.group("increments");
  for (std::size_t i = 0; i < run.increments.size(); ++i) {
    const CrackLengthResult& whole = run.increments[i];
    const StoreGroup place = all.group(fmt::format("{:04}", i + 1));
    if (fields.empty() || fields[i]) {
      write_crack_length_result(place, whole);
    } else {
      write_crack_length_result(place, without_fields(whole));
    }
  }
  write_record_list(group, "checks", run.checks);
  put(group, "warnings", text_with_code(run.warnings));
  std::vector<ToleranceRound> rounds = run.rounds;
  if (times == TimeRecording::left_out) {
    std::ranges::for_each(rounds, [](ToleranceRound& round) { round.cpu = 0.0; });
  }
  write_record_list(group, "rounds", rounds);
  if (run.growth) {
    write_record_list(group, "growth", std::vector{*run.growth});
  }
  write_record_list(group, "tests", run.tests);
  if (times == TimeRecording::kept) {
    write_record_list(group, "log", run.log);
    group.set_attribute("cpu", run.cpu);
    group.set_attribute("wall", run.wall);
    group.set_attribute("peak_memory", static_cast<std::int64_t>(run.peak_memory));
  }
  group.set_attribute("times", std::int64_t{times == TimeRecording::kept});
}

std::vector<CheckResult> read_checks(const StoreGroup& group) {
  return read_record_list<CheckResult>(group, "checks");
}

RunResult read_run(const StoreGroup& group) {
  RunResult run;
  const StoreGroup all = group.group("increments");
  for (std::size_t i = 0; all.has_member(fmt::format("{:04}", i + 1)); ++i) {
    run.increments.push_back(read_crack_length_result(all.group(fmt::format("{:04}", i + 1))));
  }
  run.checks = read_checks(group);
  run.warnings = parse_warnings(texts(group, "warnings"));
  run.rounds = read_record_list<ToleranceRound>(group, "rounds");
  const std::vector<GrowthResult> growth = read_record_list<GrowthResult>(group, "growth");
  if (!growth.empty()) {
    run.growth = growth.front();
  }
  run.tests = read_record_list<GrowthTestResult>(group, "tests");
  if (group.integer_attribute("times") != 0) {
    run.log = read_record_list<LogLine>(group, "log");
    run.cpu = group.real_attribute("cpu");
    run.wall = group.real_attribute("wall");
    run.peak_memory = static_cast<std::size_t>(group.integer_attribute("peak_memory"));
  }
  return run;
}

} // namespace spricka::results
