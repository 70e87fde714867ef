// SPDX-License-Identifier: GPL-3.0-or-later
// What is read from a store is what was written, to the bit, and nothing of a record is left out.
#include "results/store_fields.hpp"
#include "results/store_run.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <type_traits>

#include <gtest/gtest.h>

namespace spricka::results::test_store {
namespace {

/// Fills every field with something of its own, and compares bit by bit.
class Dice {
public:
  template <class T> T record() {
    T r{};
    fields(*this, r);
    return r;
  }
  template <class T> std::vector<T> list(std::size_t n) {
    std::vector<T> all;
    for (std::size_t i = 0; i < n; ++i) {
      T value{};
      (*this)("", value);
      all.push_back(std::move(value));
    }
    return all;
  }

  void operator()(const char*, double& v) {
    constexpr std::array odd{-0.0, 5e-324, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()};
    const auto k = engine_() % 12;
    v = k < odd.size() ? odd[k] : std::ldexp(static_cast<double>(engine_()), -70) - 1.0 / 3.0;
  }
  template <WholeNumber T> void operator()(const char*, T& v) {
    if constexpr (std::is_same_v<T, bool>) {
      v = engine_() % 2 == 0;
    } else {
      v = static_cast<T>(engine_() % 4);
    }
  }
  void operator()(const char*, std::string& v) {
    constexpr std::array texts{"", "LOAD", "Rissöffnung µm ≤ 1", "a\nb", " blank "};
    v = texts[engine_() % texts.size()];
  }
  void operator()(const char* n, Note& v) {
    (*this)(n, v.text);
    constexpr std::array<std::optional<base::ResultConcern>, 4> doubts{
        std::nullopt, base::ResultConcern::odd, base::ResultConcern::less_exact,
        base::ResultConcern::no_answer};
    v.kind = doubts[engine_() % doubts.size()];
  }
  template <class Tag> void operator()(const char*, base::Id<Tag>& v) {
    v.value = static_cast<std::int32_t>(engine_() % 1000) - 1;
  }
  void operator()(const char* n, base::Vec3& v) {
    for (double& x : v) {
      (*this)(n, x);
    }
  }
  template <class T, std::size_t n> void operator()(const char* name, std::array<T, n>& v) {
    for (T& x : v) {
      (*this)(name, x);
    }
  }
  template <class T> void operator()(const char* name, std::optional<T>& v) {
    if (engine_() % 2 == 0) {
      v.emplace();
      (*this)(name, *v);
    }
  }
  void operator()(const char*, base::PiecewiseLinear& f) {
    if (engine_() % 3 > 0) {
      f = base::PiecewiseLinear({0.0, 0.1, 1.0}, {0.3, 1.0 / 3.0}, {-0.0, 2e300});
    }
  }
  template <class T> void operator()(const char*, std::vector<T>& v) { v = list<T>(engine_() % 4); }
  template <class T>
  requires std::is_class_v<T>
  void operator()(const char*, T& v) { fields(*this, v); }

private:
  std::mt19937_64 engine_{20261121};
};

/// How many fields a record's fields() names.
struct Count {
  std::size_t n = 0;
  template <class T> void operator()(const char*, const T&) { ++n; }
};

template <class T> inline constexpr bool is_optional = false;
template <class T> inline constexpr bool is_optional<std::optional<T>> = true;

// An optional would take it by two ways: as itself and as its content.
struct Anything {
  template <class T>
  requires(!is_optional<T>) operator T() const { std::abort(); } // NOLINT: only named
};

// How many members an aggregate has: as many as can be initialised.
template <class T, class... Args> constexpr std::size_t members() {
  if constexpr (requires { T{Args{}..., Anything{}}; }) {
    return members<T, Args..., Anything>();
  } else {
    return sizeof...(Args);
  }
}

template <class T> std::size_t named() {
  Count count;
  T record{};
  fields(count, record);
  return count.n;
}

template <class T> class Records : public ::testing::Test {};
using AllRecords =
    ::testing::Types<KErrorBar, Sensitivity, FrontKSensitivities, FrontPointResult, FrontResult,
                     ContactPoint, ContactResult, ForceBalance, NetErrorEstimate, OuterSurfaceFace,
                     LoadPathFrontPoint, LoadPathFront, LoadPathContact, ContactStatusChange,
                     LoadPathResult, LogLine, CheckResult, ToleranceRound, GrownPointResult,
                     GrowthStation, LifeCurvePoint, ComparedLife, GrowthResult, GrowthTestPoint,
                     GrowthTestResult, base::SourceSpan, model::NodeSet, model::ElementSet,
                     model::FaceSet>;
TYPED_TEST_SUITE(Records, AllRecords);

// A member that somebody adds and no file keeps would be lost in a restart.
TYPED_TEST(Records, every_member_is_kept) {
  EXPECT_EQ(named<TypeParam>(), members<TypeParam>());
}

// The bytes of a store are those of all it holds: equal bytes, equal records.
template <class T> std::string bytes_of(const std::vector<T>& list) {
  Store store = Store::in_memory();
  write_record_list(store.root(), "list", list);
  return std::string(store.finish_bytes());
}

TYPED_TEST(Records, come_back_to_the_bit) {
  Dice dice;
  for (const std::size_t n : {0U, 1U, 2U, 40U}) {
    const std::vector<TypeParam> list = dice.list<TypeParam>(n);
    const std::string bytes = bytes_of(list);
    const Store again = Store::from_bytes(bytes);
    const std::vector<TypeParam> back = read_record_list<TypeParam>(again.root(), "list");
    ASSERT_EQ(back.size(), list.size());
    EXPECT_EQ(bytes_of(back), bytes);
  }
}

base::Vector random_vector(Dice& dice, Eigen::Index n) {
  base::Vector v(n);
  for (double& x : v) {
    dice("", x);
  }
  return v;
}

using WholeRun = RunResult; // within a test, Run is one of its own functions

WholeRun random_run() {
  Dice dice;
  RunResult run;
  for (int i = 1; i <= 3; ++i) {
    CrackLengthResult increment;
    increment.number = i;
    increment.a = 0.1 * i;
    increment.kept = 7;
    increment.unknowns = 1234;
    increment.mesh.dim = 2;
    for (int n = 0; n < 5; ++n) {
      model::add_node(increment.mesh, {0.1 * n, 1.0 / 3.0, -0.0}, 10 + n, base::NetId{0U});
    }
    const std::array<base::NodeId, 3> corners{base::NodeId{0U}, base::NodeId{1U}, base::NodeId{4U}};
    model::add_element(increment.mesh, base::ElementType::trim3, corners, 77, base::NetId{1U});
    increment.mesh.node_sets = dice.list<model::NodeSet>(3);
    increment.mesh.face_sets = dice.list<model::FaceSet>(2);
    increment.surface = dice.list<OuterSurfaceFace>(4);
    increment.paths = dice.list<LoadPathResult>(2);
    increment.notes = {make_note("first"), make_note("second")};
    for (const char* name : {"PRESS", "LOAD"}) {
      LoadStepResult step;
      step.step = name;
      step.u = random_vector(dice, 10);
      step.reaction = random_vector(dice, 10);
      step.stress = dice.list<Stress>(i == 2 ? 0 : 6);
      step.element_stress = dice.list<Stress>(2);
      step.fronts = dice.list<FrontResult>(3);
      step.fronts[0].points = dice.list<FrontPointResult>(1); // a tip
      step.fronts[1].points = dice.list<FrontPointResult>(3);
      step.contacts = dice.list<ContactResult>(2);
      step.balance = dice.list<ForceBalance>(1);
      step.nets = dice.list<ForceBalance>(2);
      step.targets = dice.list<ForceBalance>(1);
      step.errors = dice.list<NetErrorEstimate>(2);
      step.tied = i == 1;
      dice("", step.energy);
      dice("", step.friction_work);
      step.increments = 4;
      step.iterations = 5;
      step.pivots = 6;
      step.notes = {invalid_result_note("öäü"), make_note("")};
      increment.steps.push_back(std::move(step));
    }
    run.increments.push_back(std::move(increment));
  }
  run.log = dice.list<LogLine>(5);
  run.checks = dice.list<CheckResult>(3);
  run.warnings = {{"W508", "one: so"}, {"W502", "two"}};
  run.rounds = dice.list<ToleranceRound>(2);
  run.growth = dice.record<GrowthResult>();
  run.tests = dice.list<GrowthTestResult>(2);
  run.cpu = 1.5;
  run.wall = 2.5;
  run.peak_memory = 123456789;
  return run;
}

std::string bytes_of(const RunResult& run) {
  Store store = Store::in_memory();
  write_run(store.root(), run, TimeRecording::kept);
  return std::string(store.finish_bytes());
}

bool same_bits(const base::Vector& a, const base::Vector& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

bool same_bits(double a, double b) { // also of what is not a number
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(Store, a_run_comes_back_to_the_bit) {
  const WholeRun run = random_run();
  const std::string bytes = bytes_of(run);
  const WholeRun back = read_run(Store::from_bytes(bytes).root());
  EXPECT_EQ(bytes_of(back), bytes);
  EXPECT_EQ(members<CrackLengthResult>(), 9U) << "a new member needs a place in store_run.cpp";
  EXPECT_EQ(members<WholeRun>(), 10U) << "a new member needs a place in store_run.cpp";
  EXPECT_EQ(members<LoadStepResult>(), 19U) << "a new member needs a place in store_run.cpp";
  EXPECT_EQ(members<model::Mesh>(), 13U) << "a new member needs a place in store_run.cpp";
  ASSERT_EQ(back.increments.size(), 3U);
  const LoadStepResult& a = run.increments[2].steps[1];
  const LoadStepResult& b = back.increments[2].steps[1];
  EXPECT_EQ(b.step, "LOAD");
  EXPECT_TRUE(same_bits(a.u, b.u));
  EXPECT_TRUE(same_bits(a.reaction, b.reaction));
  EXPECT_EQ(std::memcmp(a.stress.data(), b.stress.data(), a.stress.size() * sizeof(Stress)), 0);
  ASSERT_EQ(b.fronts.size(), 3U);
  EXPECT_EQ(b.fronts[1].name, a.fronts[1].name);
  EXPECT_EQ(b.fronts[1].sensitivities.by_parameter.size(),
            a.fronts[1].sensitivities.by_parameter.size());
  for (std::size_t f = 0; f < 3; ++f) {
    ASSERT_EQ(b.fronts[f].points.size(), a.fronts[f].points.size());
    for (std::size_t i = 0; i < a.fronts[f].points.size(); ++i) {
      EXPECT_TRUE(same_bits(b.fronts[f].points[i].K3, a.fronts[f].points[i].K3));
    }
  }
  EXPECT_TRUE(b.fronts[0].is_tip());
  EXPECT_EQ(b.fronts[1].points.size(), 3U);
  EXPECT_EQ(b.contacts[1].points.size(), a.contacts[1].points.size());
  EXPECT_EQ(back.increments[0].mesh.element_label, run.increments[0].mesh.element_label);
  EXPECT_EQ(back.increments[1].steps[0].notes, run.increments[1].steps[0].notes);
  EXPECT_EQ(back.peak_memory, run.peak_memory);
  EXPECT_EQ(back.growth->reason, run.growth->reason);
}

TEST(Store, fields_of_some_increments_can_be_left_out) {
  const WholeRun run = random_run();
  Store store = Store::in_memory();
  write_run(store.root(), run, TimeRecording::left_out, {true, false, true});
  const WholeRun back = read_run(Store::from_bytes(std::string(store.finish_bytes())).root());
  ASSERT_EQ(back.increments.size(), 3U);
  const LoadStepResult& whole = run.increments[1].steps[1];
  const LoadStepResult& thin = back.increments[1].steps[1];
  EXPECT_EQ(thin.u.size(), 0);
  EXPECT_TRUE(thin.stress.empty());
  EXPECT_TRUE(back.increments[1].mesh.x.empty());
  ASSERT_EQ(thin.fronts.size(), whole.fronts.size());
  ASSERT_TRUE(thin.fronts[0].is_tip());
  EXPECT_TRUE(same_bits(thin.fronts[0].single_point().K1, whole.fronts[0].single_point().K1));
  EXPECT_TRUE(same_bits(thin.fronts[0].single_point().bar[0].mesh,
                        whole.fronts[0].single_point().bar[0].mesh));
  for (std::size_t f = 0; f < whole.fronts.size(); ++f) {
    ASSERT_EQ(thin.fronts[f].points.size(), whole.fronts[f].points.size());
    for (const FrontPointResult& point : thin.fronts[f].points) {
      for (const KErrorBar& bar : point.bar) {
        EXPECT_TRUE(bar.of_element.empty());
      }
    }
  }
  EXPECT_EQ(thin.contacts[1].points.size(), whole.contacts[1].points.size());
  EXPECT_TRUE(same_bits(back.increments[2].steps[1].u, run.increments[2].steps[1].u));
}

TEST(Store, times_can_be_left_out) {
  WholeRun run = random_run();
  const auto timeless = [&] {
    Store store = Store::in_memory();
    write_run(store.root(), run, TimeRecording::left_out);
    return std::string(store.finish_bytes());
  };
  const std::string before = timeless();
  run.cpu = 77.0;
  run.wall = 78.0;
  run.peak_memory = 1;
  run.log.clear();
  run.rounds.front().cpu = 4.0;
  EXPECT_EQ(timeless(), before);
  run.increments[0].a = 5.0;
  EXPECT_NE(timeless(), before);
}

TEST(Store, arrays_of_any_size) {
  Store store = Store::in_memory();
  StoreGroup root = store.root();
  std::vector<std::vector<double>> all;
  for (const std::size_t n : {0U, 1U, 2047U, 2048U, 2049U, 100001U}) {
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) {
      values[i] = n % 2 == 0 ? 0.0 : std::sin(static_cast<double>(i));
    }
    root.write("n" + std::to_string(n), values);
    root.write("t" + std::to_string(n), ColumnTable{{{"x", values}}});
    all.push_back(std::move(values));
  }
  const Store again = Store::from_bytes(store.finish_bytes());
  for (const std::vector<double>& values : all) {
    EXPECT_EQ(again.root().read_reals("n" + std::to_string(values.size())), values);
    EXPECT_EQ(std::get<std::vector<double>>(
                  again.root().read_table("t" + std::to_string(values.size())).columns[0].values),
              values);
  }
}

// A small array of a large file.
TEST(Store, a_file_is_read_where_it_is_asked) {
  const auto bytes_read = [] {
    std::ifstream counts("/proc/self/io");
    std::string word;
    std::size_t count = 0;
    counts >> word >> count;
    return count;
  };
  Store store = Store::in_memory();
  StoreGroup root = store.root();
  const std::vector<double> other(200, 0.5);
  std::vector<double> small(3000);
  for (std::size_t i = 0; i < small.size(); ++i) {
    small[i] = std::sin(static_cast<double>(i));
    root.write("other" + std::to_string(i), other);
  }
  root.write("small", small);
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "test_store_file.h5";
  const std::string bytes(store.finish_bytes());
  std::ofstream(file, std::ios::binary) << bytes;
  {
    const std::size_t before = bytes_read();
    const Store again = Store::from_file(file);
    EXPECT_EQ(again.root().read_reals("small"), small);
    EXPECT_LT(bytes_read() - before, bytes.size() / 10);
  }
  std::filesystem::remove(file);
  EXPECT_THROW(Store::from_file(file), StoreError);
}

TEST(Store, trouble_is_said) {
  EXPECT_THROW(Store::from_bytes("no store"), StoreError);
  Store store = Store::in_memory();
  StoreGroup root = store.root();
  root.write("numbers", std::vector{1.0, 2.0});
  root.set_attribute("word", std::string_view("text"));
  EXPECT_THROW((void)root.read_reals("none"), StoreError);
  EXPECT_THROW((void)root.read_integers("numbers"), StoreError);
  EXPECT_THROW((void)root.read_texts("numbers"), StoreError);
  EXPECT_THROW((void)root.read_table("numbers"), StoreError);
  EXPECT_THROW((void)root.integer_attribute("word"), StoreError);
  EXPECT_THROW((void)root.text_attribute("none"), StoreError);
  EXPECT_THROW(root.write("numbers", std::vector{1.0}), StoreError);
  EXPECT_THROW((void)read_record_list<ForceBalance>(root, "numbers"), StoreError);
  write_record_list(root, "log", std::vector<LogLine>(2));
  EXPECT_THROW((void)read_record_list<ForceBalance>(root, "log"), StoreError);
}

} // namespace
} // namespace spricka::results::test_store
