// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/note.hpp"

#include <gtest/gtest.h>

namespace spricka::results::test_note {
namespace {

// Files of all versions keep the mark in the text.
TEST(Note, IsMarkedInFilesOnly) {
  const std::vector<Note> notes{make_note("PIN slides"), invalid_result_note("K1 is negative"),
                                less_exact_note(""), questionable_input_note("so many tests"),
                                make_note("warnings")};
  const std::vector<std::string> kept = text_with_code(notes);
  EXPECT_EQ(kept, (std::vector<std::string>{"PIN slides", "warning W508: K1 is negative",
                                            "warning W507: ", "warning W502: so many tests",
                                            "warnings"}));
  EXPECT_EQ(parse_notes(kept), notes);
}

// A code of a note is one of the kind that the note has, or the order of warnings would tell lies.
TEST(Note, HasACodeOfItsKind) {
  for (const base::ResultConcern doubt :
       {base::ResultConcern::no_answer, base::ResultConcern::less_exact,
        base::ResultConcern::odd}) {
    EXPECT_EQ(base::concern_of_warning_code(warning_code(doubt)), doubt);
  }
}

TEST(Warning, IsKeptWithItsCode) {
  const std::vector<Warning> warnings{{"W508", "K1: negative"}, {"W456", ""}};
  EXPECT_EQ(text_with_code(warnings), (std::vector<std::string>{"W508: K1: negative", "W456: "}));
  EXPECT_EQ(parse_warnings(text_with_code(warnings)), warnings);
}

} // namespace
} // namespace spricka::results::test_note
