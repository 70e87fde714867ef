// SPDX-License-Identifier: GPL-3.0-or-later
// What a ladder concludes from its variants.
#include "program/study/ladder.hpp"

#include <gtest/gtest.h>

namespace spricka::program::test_ladder {
namespace {

ModelVariantResult rung(const std::string& name, double K, double cpu, bool simpler) {
  ModelVariantResult result;
  result.variant.name = name;
  result.variant.text.emplace();
  result.variant.simpler = simpler;
  result.readings = {{.value = K, .bar = 0.0, .raw = K}};
  result.end.cpu = cpu;
  return result;
}

SimplerModelComparison ladder_of(std::vector<ModelVariantResult> variants) {
  SimplerModelComparison ladder;
  ladder.answers.resize(1);
  ladder.answers[0].check.relative = true;
  ladder.variants = std::move(variants);
  return ladder;
}

TEST(SimplerModelComparison, TakesTheCheapestThatIsWithin) {
  SimplerModelComparison ladder =
      ladder_of({rung("as given", 100.0, 10.0, false), rung("bonded", 101.0, 2.0, true),
                 rung("uniform", 120.0, 1.0, true)});
  judge_simpler_models(ladder);
  EXPECT_EQ(ladder.cheapest, std::optional<std::size_t>(1));
  EXPECT_TRUE(ladder.stopped.empty());
}

// What was ended before it had an answer may have been the cheapest, or shown that none will do.
TEST(SimplerModelComparison, ConcludesNothingWhereARungWasStopped) {
  for (const int signal : {0, 15}) {
    ModelVariantResult killed = rung("bonded", 0.0, 2.0, true);
    killed.readings.clear();
    killed.end.signal = signal;
    killed.end.exit_code = signal == 0 ? 6 : 128 + signal;
    SimplerModelComparison ladder = ladder_of({rung("as given", 100.0, 10.0, false), killed});
    judge_simpler_models(ladder);
    EXPECT_FALSE(ladder.cheapest);
    EXPECT_EQ(ladder.stopped, std::vector<std::string>{"bonded"});
  }
  ModelVariantResult refused = rung("bonded", 0.0, 2.0, true); // it has no answer of its own accord
  refused.readings.clear();
  refused.end.exit_code = 4;
  SimplerModelComparison ladder = ladder_of({rung("as given", 100.0, 10.0, false), refused});
  judge_simpler_models(ladder);
  EXPECT_EQ(ladder.cheapest, std::optional<std::size_t>(0));
}

} // namespace
} // namespace spricka::program::test_ladder
