// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.hpp"
#include "solve/condense.hpp"
#include "solve/engine_choice.hpp"
#include "solve/engine_module.hpp"
#include "solve/scratch_folder.hpp"
#include "spring_net.hpp"
#include "tests/places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace spricka::solve::test_mumps {
namespace {

using namespace test_nets;

/// A cube of nodes [side, side, side], three freedoms each, with springs to all 26 neighbours and
/// the ground below: fill and fronts of solids.
struct SpringCube {
  int side;

  [[nodiscard]] std::int64_t node(int x, int y, int z) const {
    return (static_cast<std::int64_t>(z) * side + y) * side + x;
  }
  [[nodiscard]] std::int64_t face() const { return 3LL * side * side; } ///< rows of the last layer

  [[nodiscard]] SymmetricCsc matrix() const {
    SymmetricCsc K;
    K.n = face() * side;
    std::vector<std::array<double, 9>> own(at(K.n / 3), std::array<double, 9>{});
    const auto spring = [](const std::array<int, 3>& d, int a, int b) {
      return d.at(at(a)) * d.at(at(b)) / std::pow(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1.5);
    };
    const auto each_neighbour = [&](int x, int y, int z, auto&& act) { // in ascending order
      for (int c = -1; c <= 1; ++c) {
        for (int b = -1; b <= 1; ++b) {
          for (int a = -1; a <= 1; ++a) {
            if ((a != 0 || b != 0 || c != 0) && std::min({x + a, y + b, z + c}) >= 0 &&
                std::max({x + a, y + b, z + c}) < side) {
              act(std::array{a, b, c}, node(x + a, y + b, z + c));
            }
          }
        }
      }
    };
    const auto each_node = [&](auto&& act) {
      for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
          for (int x = 0; x < side; ++x) {
            act(x, y, z);
          }
        }
      }
    };
    K.start.push_back(0);
    each_node([&](int x, int y, int z) {
      std::array<double, 9> sum{};
      each_neighbour(x, y, z, [&](const std::array<int, 3>& d, std::int64_t) {
        for (int i = 0; i < 9; ++i) {
          sum.at(at(i)) += spring(d, i / 3, i % 3);
        }
      });
      for (int c = 0; c < 3; ++c) {
        sum.at(at(4 * c)) += z == 0 ? 1.0 : 0.0;
      }
      for (int j = 0; j < 3; ++j) {
        for (int i = j; i < 3; ++i) {
          K.row.push_back(3 * node(x, y, z) + i);
          K.value.push_back(sum.at(at(3 * i + j)));
        }
        each_neighbour(x, y, z, [&](const std::array<int, 3>& d, std::int64_t other) {
          for (int i = 0; i < 3 && other > node(x, y, z); ++i) {
            K.row.push_back(3 * other + i);
            K.value.push_back(-spring(d, i, j));
          }
        });
        K.start.push_back(static_cast<std::int64_t>(K.row.size()));
      }
    });
    return K;
  }
};

class Mumps : public testing::Test {
protected:
  void SetUp() override {
    const std::string missing = why_engine_module_is_missing(EngineModule::mumps);
    if (missing.find("built without") != std::string::npos) {
      GTEST_SKIP() << missing;
    }
    ASSERT_EQ(missing, "");
  }
};

CondensationSettings by_mumps(bool out_of_core) {
  return {.engine = EquationEngine::mumps, .out_of_core = out_of_core};
}
const CondensationSettings by_cholesky{.engine = EquationEngine::cholesky};

void expect_near(const Matrix& a, const Matrix& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  EXPECT_LE((a - b).norm(), tolerance * b.norm());
}

TEST_F(Mumps, IsCholeskyInAllThatItIsAsked) {
  for (const bool floating : {false, true}) {
    for (const bool out_of_core : {false, true}) {
      SpringNet net(24, floating ? 0.0 : 0.6);
      const std::int64_t e = net.put_last([](int x, int y) { return x == 23 && y > 3; });
      const SymmetricCsc K = net.matrix();
      Condensation own(K, e, by_mumps(out_of_core));
      Condensation other(K, e, by_cholesky);
      ASSERT_EQ(own.report().status, FactorStatus::ok) << own.report().trouble;
      EXPECT_EQ(own.report().engine, EquationEngine::mumps);
      EXPECT_EQ(own.report().out_of_core, out_of_core);
      EXPECT_LT(own.report().relative_error, 1e-9);
      EXPECT_GT(own.report().flops, 0.0);
      EXPECT_NEAR(own.report().smallest_pivot, other.report().smallest_pivot,
                  other.report().smallest_pivot); // scales are powers of two
      expect_near(own.schur(), other.schur(), 1e-12);
      EXPECT_TRUE(same_bits(own.schur(), own.schur().transpose()));
      const Matrix f = random_columns(K.n, 5);
      expect_near(own.condense_load(f), other.condense_load(f), 1e-11);
      const Matrix u_external = random_columns(e, 5);
      expect_near(own.recover(u_external, f), other.recover(u_external, f), 1e-11);
      EXPECT_EQ(own.recover(Matrix(e, 0), Matrix(K.n, 0)).cols(), 0); // a model without loads
      const SparseRightHandSides F = random_rows(K.n, 90);
      const RowCompliance rows = own.compliance_with_externals_held(F);
      const RowCompliance expected = other.compliance_with_externals_held(F);
      expect_near(rows.W, expected.W, 1e-11);
      expect_near(rows.condensed, expected.condensed, 1e-11);
      EXPECT_TRUE(same_bits(rows.W, rows.W.transpose()));
    }
  }
}

TEST_F(Mumps, SolvesWithoutExternalsAndWithNothingElse) {
  SpringNet net(13, 0.9);
  const SymmetricCsc K = net.matrix();
  const Matrix f = random_columns(K.n, 2);
  for (const bool out_of_core : {false, true}) {
    const Condensation plain(K, 0, by_mumps(out_of_core));
    ASSERT_EQ(plain.report().status, FactorStatus::ok);
    const Matrix u = plain.recover(Matrix(0, 2), f);
    EXPECT_LT((dense(K) * u - f).norm(), 1e-12 * dense(K).norm() * u.norm());
    EXPECT_EQ(plain.condense_load(f).rows(), 0);
  }
  const Condensation whole(K, K.n, by_mumps(false));
  ASSERT_EQ(whole.report().status, FactorStatus::ok);
  EXPECT_TRUE(same_bits(whole.schur(), dense(K)));
  EXPECT_TRUE(same_bits(whole.condense_load(f), f));
  EXPECT_TRUE(same_bits(whole.recover(f, f), f));
}

TEST_F(Mumps, NamesWhatIsLoose) {
  SpringNet net(9, 1.0);
  SymmetricCsc K = net.matrix();
  const std::int64_t loose = net.row(4, 7, 1);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      K.value[at(p)] = j == loose || K.row[at(p)] == loose ? 0.0 : K.value[at(p)];
    }
  }
  for (const bool out_of_core : {false, true}) {
    const Condensation c(K, 4, by_mumps(out_of_core));
    EXPECT_EQ(c.report().status, FactorStatus::not_positive_definite);
    EXPECT_EQ(c.report().failed_row, loose);
  }
  for (const int side : {3, 8, 21, 60}) { // a body that floats and has no externals
    const Condensation c(SpringNet(side, 0.0).matrix(), 0, by_mumps(false));
    EXPECT_EQ(c.report().status, FactorStatus::not_positive_definite) << side;
  }
  EXPECT_EQ(Condensation(SpringNet(21, 1e-6).matrix(), 0, by_mumps(false)).report().status,
            FactorStatus::ok);
  K = SpringNet(5, 1.0).matrix();
  K.value[at(K.start[7])] = std::nan("");
  EXPECT_EQ(Condensation(K, 4, by_mumps(false)).report().status,
            FactorStatus::not_positive_definite);
}

TEST_F(Mumps, SeveralAtATimeKeepApart) {
  std::vector<SymmetricCsc> K;
  for (const int side : {18, 23, 30, 21}) {
    SpringNet net(side, 0.5);
    net.put_last([side](int x, int) { return x == side - 1; });
    K.push_back(net.matrix());
  }
  std::vector<std::unique_ptr<Condensation>> bodies(K.size());
  base::parallel_for(K.size(), 4, [&](std::size_t i) {
    bodies[i] = std::make_unique<Condensation>(K[i], 36, by_mumps(i % 2 == 0));
  });
  const Condensation asked(K[0], 36, by_mumps(true));
  const Matrix expected = asked.recover(Matrix::Zero(36, 1), random_columns(K[0].n, 1));
  base::parallel_for(K.size(), 4, [&](std::size_t i) {
    const Matrix f = random_columns(K[i].n, 2);
    // What is done about one may ask another, between its elimination and its solution.
    const Matrix u = bodies[i]->solve(f, [&](const Matrix& left) {
      const Matrix of_other = asked.recover(Matrix::Zero(36, 1), random_columns(K[0].n, 1));
      EXPECT_TRUE(same_bits(of_other, expected));
      return left;
    });
    const Condensation other(K[i], 36, by_cholesky);
    expect_near(u, other.solve(f, [](const Matrix& left) { return left; }), 1e-11);
  });
}

TEST_F(Mumps, TakesHalfTheMemoryOutOfCore) {
  const SpringCube cube{spricka::test::full_size() ? 33 : 20};
  const std::int64_t e = 3LL * (spricka::test::full_size() ? 1000 : cube.side * cube.side / 4);
  const auto report = [&](bool out_of_core) {
    return forecast_equations(cube.matrix(), e, by_mumps(out_of_core));
  };
  const FactorReport inside = report(false);
  const FactorReport outside = report(true);
  ASSERT_EQ(inside.status, FactorStatus::ok);
  EXPECT_FALSE(inside.out_of_core);
  // Of a small body S, the matrix and the largest front are more of it.
  EXPECT_LT(outside.memory, (spricka::test::full_size() ? 0.55 : 0.75) * inside.memory);
  EXPECT_GT(outside.disk, 0.0);
  const FactorReport cholesky = forecast_equations(cube.matrix(), e, by_cholesky);
  EXPECT_NEAR(inside.flops, cholesky.flops, 0.2 * cholesky.flops); // our own order serves both
  RecordProperty("in_core", std::to_string(inside.memory));
  RecordProperty("out_of_core", std::to_string(outside.memory));
}

TEST_F(Mumps, IsTakenWhereCholeskyDoesNotFit) {
  const SpringCube cube{20};
  const std::int64_t e = cube.face() / 4;
  const SymmetricCsc K = cube.matrix();
  const FactorReport in_core = forecast_equations(K, e, by_cholesky);
  const FactorReport on_disk = forecast_equations(K, e, by_mumps(true));
  // As if others wanted what lies between the two.
  const double besides = in_core.memory_left - 0.5 * (in_core.memory + on_disk.memory);
  const CondensationSettings tight{.besides = besides};
  const Condensation c(K, e, tight);
  ASSERT_EQ(c.report().status, FactorStatus::ok) << c.report().trouble;
  EXPECT_EQ(engine_text(c.report()), "MUMPS out of core");
  EXPECT_NE(c.report().engine_reason.find("in core would need"), std::string::npos);
  EXPECT_EQ(engine_text(forecast_equations(K, e, tight)), "MUMPS out of core");
  expect_near(c.schur(), Condensation(K, e, by_cholesky).schur(), 1e-12);
  // Nothing fits: what each would need is said, and nothing is tried.
  const Condensation none(K, e, {.besides = in_core.memory_left});
  EXPECT_EQ(none.report().status, FactorStatus::out_of_memory);
  EXPECT_NE(none.report().trouble.find("MUMPS out of core would need"), std::string::npos);
}

TEST_F(Mumps, SaysWhereItCannotWrite) {
  const SymmetricCsc K = SpringNet(20, 0.5).matrix();
  CondensationSettings settings = by_mumps(true);
  for (const std::string& folder :
       {std::string("/nowhere/at/all"), "/tmp/" + std::string(300, 'x')}) {
    settings.scratch_folder = folder;
    const Condensation c(K, 0, settings);
    EXPECT_EQ(c.report().status, FactorStatus::engine_failed) << folder;
    EXPECT_NE(c.report().trouble.find("TMPDIR"), std::string::npos) << c.report().trouble;
  }
}

TEST(ScratchFolder, IsRemovedWithWhatIsInItAndMadeAgain) {
  const std::string first = scratch_folder();
  ASSERT_FALSE(first.empty());
  EXPECT_TRUE(std::filesystem::is_directory(first));
  EXPECT_EQ(scratch_folder(), first);
  remove_scratch_folder();
  EXPECT_FALSE(std::filesystem::exists(first));
  // What a process left that is no more goes too.
  const std::filesystem::path left =
      std::filesystem::temp_directory_path() / "spricka-scratch-left00";
  std::filesystem::create_directory(left);
  std::fclose(std::fopen((left / "in_use").c_str(), "w"));
  EXPECT_NE(scratch_folder(), "");
  EXPECT_FALSE(std::filesystem::exists(left));
}

TEST(EngineModules, TwoBuildsOfMumpsAreNeverInOneProcess) {
  if (!why_engine_module_is_missing(EngineModule::mumps).empty()) {
    GTEST_SKIP() << why_engine_module_is_missing(EngineModule::mumps);
  }
  EXPECT_NE(
      why_engine_module_is_missing(EngineModule::mumps_over_mpi).find("cannot work in one process"),
      std::string::npos);
}

} // namespace
} // namespace spricka::solve::test_mumps
