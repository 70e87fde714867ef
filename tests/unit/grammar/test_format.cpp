// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"
#include "grammar/catalogue.hpp"
#include "grammar/format.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"
#include "tests/places.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

namespace spricka::grammar::test_format {
namespace {

namespace fs = std::filesystem;

std::string formatted(const std::string& text) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const auto result = format_deck(sources, sources.add_text("test.deck", text), diagnostics);
  return result.value_or("refused:\n" + base::format_messages(sources, diagnostics));
}

/// The meaning of a file as text: everything the parser found, places left out.
class Meaning {
public:
  explicit Meaning(const std::string& text) {
    base::Diagnostics diagnostics;
    const std::int32_t file = sources_.add_text("test.deck", text);
    for (const CardHeader& card : parse_cards(sources_, file, diagnostics)) {
      out_ << '$' << card.name;
      for (const HeaderParameter& p : card.parameters) {
        out_ << ' ' << p.key << '=';
        fields(p.values);
      }
      out_ << '\n';
      data(card, diagnostics);
    }
  }
  [[nodiscard]] std::string text() const { return out_.str(); }

private:
  void data(const CardHeader& card, base::Diagnostics& diagnostics) {
    const CardSpec* spec = find_card(card.name);
    if (spec == nullptr || spec->data == DataLineForm::table || spec->data == DataLineForm::none) {
      words(card.data);
    } else if (spec->data == DataLineForm::assignments) {
      for (const ParameterAssignment& a :
           parse_parameter_assignments(sources_, card.data, diagnostics)) {
        out_ << "  " << a.written << " = ";
        expression(a.value);
        out_ << '\n';
      }
    } else {
      for (const DataRow& row : parse_data_rows(sources_, card.data, diagnostics)) {
        fields(row.fields);
        out_ << '\n';
      }
    }
  }

  // Tables have no tree: their words, line by line.
  void words(base::SourceSpan span) {
    std::istringstream lines{std::string(sources_.text(span))};
    for (std::string line; std::getline(lines, line);) {
      std::istringstream row(line.substr(0, line.find('!')));
      std::string all;
      for (std::string word; row >> word;) {
        all += ' ' + word;
      }
      if (!all.empty()) { // the blanks in front of the next header are no line
        out_ << all << '\n';
      }
    }
  }

  void fields(const std::vector<CardField>& all) {
    for (const CardField& field : all) {
      out_ << ' ' << static_cast<int>(field.kind) << field.separator << field.text << '|';
      for (const base::Label label : field.range) {
        out_ << label << ':';
      }
      expression(field.expression);
      for (const ParsedExpression& argument : field.arguments) {
        out_ << " arg ";
        expression(argument);
      }
    }
  }

  void expression(const ParsedExpression& e) {
    for (const ExpressionTerm& t : e.terms) {
      out_ << '<' << static_cast<int>(t.kind) << ' ' << static_cast<int>(t.op) << ' ' << t.count
           << ' ' << t.value;
      if (t.kind == ExpressionTerm::ExpressionTermKind::name ||
          t.kind == ExpressionTerm::ExpressionTermKind::call) {
        out_ << ' ' << to_upper(sources_.text(t.span));
      }
      if (t.unit.valid()) {
        out_ << ' ' << sources_.text(t.unit);
      }
      out_ << '>';
    }
  }

  base::SourceTexts sources_;
  std::ostringstream out_;
};

std::vector<fs::path> corpus() {
  std::vector<fs::path> files;
  for (const std::string& folder :
       {test::decks_folder(), test::source_folder() + "/tests/diagnostics"}) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".deck" || extension == ".inc") {
        files.push_back(entry.path());
      }
    }
  }
  return files;
}

TEST(Format, KeepsTheMeaningOfEveryDeckAndRunsOnce) {
  std::size_t done = 0;
  for (const fs::path& file : corpus()) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::string once = formatted(text);
    if (once.starts_with("refused")) {
      continue; // a mistake of syntax, as some of the diagnostics have
    }
    ++done;
    EXPECT_EQ(Meaning(text).text(), Meaning(once).text()) << file;
    EXPECT_EQ(once, formatted(once)) << file;
  }
  EXPECT_GE(done, 30U);
}

// The same for decks that a careless hand has been at: whatever still parses keeps its meaning.
TEST(Format, KeepsTheMeaningOfDamagedDecks) {
  const std::vector<std::string> pieces{" ",    "\t", "\n", "\r\n", "\n& ", " ! c\n", "\n!\n& ",
                                        "'",    "(",  ")",  "! ",   "=",    ",",      "$",
                                        "[mm]", "&",  "-X", ".5",   "\n\n", "é"};
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return random() % n; }; // the same on every machine
  std::size_t done = 0;
  for (const fs::path& file : corpus()) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (int trial = 0; trial < 100 && !text.empty(); ++trial) {
      std::string damaged = text;
      for (std::size_t k = below(3) + 1; k > 0; --k) {
        damaged.insert(below(damaged.size()), pieces[below(pieces.size())]);
      }
      const std::string once = formatted(damaged);
      if (once.starts_with("refused")) {
        continue;
      }
      ++done;
      ASSERT_EQ(Meaning(damaged).text(), Meaning(once).text()) << damaged << "\n---\n" << once;
      ASSERT_EQ(once, formatted(once)) << damaged;
    }
  }
  EXPECT_GE(done, 300U);
}

TEST(Format, LaysOutHeaders) {
  EXPECT_EQ(formatted("  $deck  version = 1 length=Mm\tforce=n title='a  !b'\n"),
            "$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='a  !b'\n");
  EXPECT_EQ(formatted("$vce crack=Top domains=2 , 3,4\n"), "$VCE CRACK=Top DOMAINS=2,3,4\n");
  EXPECT_EQ(formatted("$MESH RI=( a + b )[mm] T1=90[deg] shape=ring\n"),
            "$MESH RI=( a + b )[mm] T1=90[deg] SHAPE=RING\n");
}

TEST(Format, KeepsNamesAsWrittenAndWordsInCapitals) {
  EXPECT_EQ(formatted("$step name=Load\n load Case1 1 ! on\n mount Pin\n"),
            "$STEP NAME=Load\n  LOAD Case1 1  ! on\n  MOUNT Pin\n");
  EXPECT_EQ(formatted("$check\n  k(Top,load) = 1  rel 0.1  source 'x y'\n"),
            "$CHECK\n  K(Top,load) = 1  REL 0.1  SOURCE 'x y'\n");
  EXPECT_EQ(formatted("$parameter\nname = 3\n"), "$PARAMETER\n  name = 3\n");
}

TEST(Format, KeepsSpacingInsideDataLines) {
  EXPECT_EQ(formatted("$PARAMETER\n D     = 72\n fine  = 1\n"),
            "$PARAMETER\n  D     = 72\n  fine  = 1\n");
}

TEST(Format, LeavesTablesAlone) {
  EXPECT_EQ(formatted("$COOR DIM=2\n 1   0\t1  \r\n      2 1 1 ! last\n"),
            "$COOR DIM=2\n 1   0\t1\n      2 1 1  ! last\n");
}

TEST(Format, ContinuesLines) {
  EXPECT_EQ(formatted("$CONTACT NAME=A\n&SLAVE=B\n ! why\n  & MASTER = (1 +\n& 2)\n"),
            "$CONTACT NAME=A\n  & SLAVE=B\n  ! why\n  & MASTER=(1 +\n  & 2)\n");
}

TEST(Format, IndentsNets) {
  EXPECT_EQ(formatted("$NET NAME=A\n! of the set\n$NSET NAME=B\n1 : 4\n$ENDNET\n$END\n"),
            "$NET NAME=A\n  ! of the set\n  $NSET NAME=B\n    1 : 4\n$ENDNET\n$END\n");
}

TEST(Format, KeepsCommentsInTheirColumn) {
  EXPECT_EQ(formatted("$STEP   NAME=A      ! one\n\n\n\n$END ! two  \n"),
            "$STEP NAME=A        ! one\n\n$END  ! two  \n");
}

TEST(Format, TakesBlankLinesOffBothEnds) {
  EXPECT_EQ(formatted("\xEF\xBB\xBF\n\n! first\n$END\n\n\n"), "! first\n$END\n");
  EXPECT_EQ(formatted(""), "");
}

TEST(Format, RefusesSyntaxErrors) {
  EXPECT_TRUE(formatted("$STEP NAME=\n").starts_with("refused"));
  EXPECT_TRUE(formatted("$STEP NAME=A\n  LOAD 'open\n").starts_with("refused"));
}

} // namespace
} // namespace spricka::grammar::test_format
