// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/note.hpp"

#include <gtest/gtest.h>

namespace spricka::results::test_note {
namespace {

// Files of all versions keep the mark in the text.
TEST(Note, IsMarkedInFilesOnly) {
  const std::vector<Note> notes{note("PIN slides"), warning("K1 is in doubt"), warning(""),
                                note("warnings")};
  const std::vector<std::string> kept = marked(notes);
  EXPECT_EQ(kept, (std::vector<std::string>{"PIN slides", "warning: K1 is in doubt",
                                            "warning: ", "warnings"}));
  EXPECT_EQ(notes_from(kept), notes);
}

} // namespace
} // namespace spricka::results::test_note
