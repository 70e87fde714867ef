// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contiguous_ranges.hpp"

#include <gtest/gtest.h>

namespace spricka::test_contiguous_ranges {
namespace {

using Places = std::vector<std::vector<std::size_t>>;

TEST(Stretch, ALineEndsWhatGoesRoundARing) {
  const std::vector<bool> marked{true, false, true, true, false, true};
  EXPECT_EQ(
      contact::contiguous_marked_ranges(contact::SequenceLinks::link_consecutive(6, false), marked),
      (Places{{0}, {2, 3}, {5}}));
  EXPECT_EQ(
      contact::contiguous_marked_ranges(contact::SequenceLinks::link_consecutive(6, true), marked),
      (Places{{2, 3}, {5, 0}}));
  EXPECT_EQ(contact::contiguous_marked_ranges(contact::SequenceLinks::link_consecutive(6, true),
                                              marked, 4),
            (Places{{5, 0}, {2, 3}}));
}

TEST(Stretch, ARingMarkedAllRoundBeginsNowhere) {
  const std::vector<bool> all(4, true);
  EXPECT_TRUE(
      contact::contiguous_marked_ranges(contact::SequenceLinks::link_consecutive(4, true), all)
          .empty());
  EXPECT_EQ(
      contact::contiguous_marked_ranges(contact::SequenceLinks::link_consecutive(4, false), all),
      (Places{{0, 1, 2, 3}}));
}

// Two lines of three places, the second followed by the first: a surface cut by a mouth.
TEST(Stretch, LinksGoWhereNumbersDoNot) {
  contact::SequenceLinks links(6);
  for (const std::size_t i : {0u, 1u, 3u, 4u}) {
    links.join(i, i + 1);
  }
  links.join(5, 0);
  EXPECT_EQ(contact::contiguous_marked_ranges(links, {true, true, false, false, true, true}),
            (Places{{4, 5, 0, 1}}));
}

} // namespace
} // namespace spricka::test_contiguous_ranges
