// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/turning_points.hpp"
#include "life/rainflow.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

namespace spricka::life::test_rainflow {
namespace {

using CycleCounts = std::map<std::pair<double, double>, double>;

CycleCounts counts(const std::vector<LoadCycle>& cycles) {
  CycleCounts sum;
  for (const LoadCycle& cycle : cycles) {
    sum[{cycle.low, cycle.high}] += cycle.count;
  }
  return sum;
}

std::vector<double> random_history(std::size_t size, unsigned seed, int levels) {
  std::mt19937 engine(seed);
  std::uniform_int_distribution<int> level(0, levels);
  std::vector<double> history(size);
  for (double& x : history) {
    x = level(engine);
  }
  return history;
}

// ASTM E1049-85 (2017), 5.4.4 with figure 6: the history A to I.
const std::vector<double> astm{-2, 1, -3, 5, -1, 3, -4, 4, -2};

TEST(Rainflow, CountsTheExampleOfAstm) {
  const CycleCounts expected{{{-2, 1}, 0.5}, {{-3, 1}, 0.5}, {{-1, 3}, 1.0}, {{-3, 5}, 0.5},
                             {{-4, 5}, 0.5}, {{-4, 4}, 0.5}, {{-2, 4}, 0.5}};
  EXPECT_EQ(counts(count_rainflow_cycles(astm, false)), expected);
}

// 5.4.5 with figure 7: the same history, repeated.
TEST(Rainflow, CountsTheRepeatedExampleOfAstm) {
  const CycleCounts expected{{{-2, 1}, 1.0}, {{-1, 3}, 1.0}, {{-3, 4}, 1.0}, {{-4, 5}, 1.0}};
  EXPECT_EQ(counts(count_rainflow_cycles(astm, true)), expected);
}

TEST(Rainflow, PointsThatDoNotTurnAreLeftOut) {
  const std::vector<double> history{0, 1, 1, 2, 2, 2, 1.5, 0.5, 0.5, 3};
  EXPECT_EQ(base::turning_points(history), (std::vector<double>{0, 2, 0.5, 3}));
  EXPECT_EQ(base::turning_points(std::vector<double>{1, 1, 1}), std::vector<double>{1});
  EXPECT_TRUE(count_rainflow_cycles(std::vector<double>{1, 1, 1}, true).empty());
  EXPECT_TRUE(count_rainflow_cycles(std::vector<double>{1, 1, 1}, false).empty());
  EXPECT_TRUE(count_rainflow_cycles(std::vector<double>{}, true).empty());
}

TEST(Rainflow, AConstantAmplitudeIsItsOwnCount) {
  const std::vector<double> history{0, 1, 0, 1, 0, 1};
  EXPECT_EQ(counts(count_rainflow_cycles(history, true)), (CycleCounts{{{0, 1}, 3.0}}));
  EXPECT_EQ(counts(count_rainflow_cycles(history, false)), (CycleCounts{{{0, 1}, 2.5}}));
}

// Every range between turning points is half of one cycle, and cycles go as far up and down as the
// history does.
TEST(Rainflow, CountsEveryReversalAndTheWholeWay) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const std::vector<double> history = random_history(20 + 7 * seed, seed, seed % 2 ? 12 : 100000);
    const std::vector<double> points = base::turning_points(history);
    double reversals = 0.0;
    double way = 0.0;
    for (const LoadCycle& cycle : count_rainflow_cycles(history, false)) {
      reversals += 2.0 * cycle.count;
      way += 2.0 * cycle.count * (cycle.high - cycle.low);
    }
    double way_of_points = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      way_of_points += std::fabs(points[i] - points[i - 1]);
    }
    EXPECT_EQ(reversals, static_cast<double>(points.size() - 1));
    EXPECT_EQ(way, way_of_points);
  }
}

TEST(Rainflow, ARepeatedHistoryClosesWhereverItStarts) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::vector<double> history = random_history(30 + 3 * seed, seed, seed % 2 ? 9 : 100000);
    const CycleCounts first = counts(count_rainflow_cycles(history, true));
    for (const auto& [range, count] : first) {
      EXPECT_EQ(count, std::floor(count));
    }
    std::vector<double> turned = history;
    std::rotate(turned.begin(), turned.begin() + 11, turned.end());
    EXPECT_EQ(counts(count_rainflow_cycles(turned, true)), first);

    for (double& x : history) {
      x = -x;
    }
    CycleCounts mirrored;
    for (const auto& [range, count] : counts(count_rainflow_cycles(history, true))) {
      mirrored[{-range.second, -range.first}] = count;
    }
    EXPECT_EQ(mirrored, first);
  }
}

// The four-point rule (Amzallag et al. 1994): of four points in a row the inner range is a cycle if
// it lies within the outer one. Of a history repeated twice one pass's worth closes.
CycleCounts four_point(std::vector<double> points) {
  CycleCounts sum;
  for (std::size_t i = 0; i + 3 < points.size();) {
    const auto [a, d] = std::minmax(points[i], points[i + 3]);
    const auto [b, c] = std::minmax(points[i + 1], points[i + 2]);
    if (a <= b && c <= d) {
      sum[{b, c}] += 1.0;
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   points.begin() + static_cast<std::ptrdiff_t>(i) + 3);
      points = base::turning_points(points);
      i = 0;
    } else {
      ++i;
    }
  }
  return sum;
}

TEST(Rainflow, AgreesWithTheFourPointRule) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::vector<double> history = random_history(60, seed, 100000);
    const auto passes = [&](int n) {
      std::vector<double> all;
      for (int i = 0; i < n; ++i) {
        all.insert(all.end(), history.begin(), history.end());
      }
      return four_point(base::turning_points(all));
    };
    CycleCounts more = passes(3);
    for (const auto& [range, count] : passes(2)) {
      more[range] -= count;
    }
    std::erase_if(more, [](const auto& entry) { return entry.second == 0.0; });
    EXPECT_EQ(counts(count_rainflow_cycles(history, true)), more);
  }
}

} // namespace
} // namespace spricka::life::test_rainflow
