// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/command_table.hpp"
#include "program/shell/completion.hpp"
#include "program/shell/typed_words.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/shell_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_shell_commands {
namespace {

using program::ShellReply;
using test::cracked_hub;
using test::ShellOnText;

ShellReply type(const ShellOnText& shell, const std::string& line) {
  return program::run_shell_line(*shell, {}, line);
}

TEST(ShellText, Words) {
  using List = std::vector<std::string>;
  EXPECT_EQ(program::split_shell_words("map PULL  1.5"), (List{"map", "PULL", "1.5"}));
  EXPECT_EQ(program::split_shell_words("  save a.deck replace ! more"),
            (List{"save", "a.deck", "replace"}));
  EXPECT_EQ(program::split_shell_words("LOAD C (0.3 * R)"), (List{"LOAD", "C", "(0.3 * R)"}));
  EXPECT_EQ(program::split_shell_words(""), List{});
  EXPECT_EQ(program::split_shell_words("! nothing"), List{});
  EXPECT_EQ(program::split_shell_words("save 'my deck.deck'")[1], "my deck.deck");
}

TEST(ShellText, FormsOfLines) {
  using program::classify_shell_line;
  using program::ShellLineForm;
  EXPECT_EQ(classify_shell_line(" $CRACK NAME=C A0=5"), ShellLineForm::card);
  EXPECT_EQ(classify_shell_line("K1(C,NOW)"), ShellLineForm::result);
  EXPECT_EQ(classify_shell_line("S.XX.AT(0,1,NOW)"), ShellLineForm::result);
  EXPECT_EQ(classify_shell_line("F= 3[kN] ! more"), ShellLineForm::parameter);
  EXPECT_EQ(classify_shell_line("LOAD PULL (2*T)"), ShellLineForm::command);
  EXPECT_EQ(classify_shell_line("! nothing"), ShellLineForm::nothing);
}

TEST(ShellCommands, LeavingTakesNoMoreWords) {
  const ShellOnText shell(cracked_hub());
  for (const char* line : {"quit now please", "exit 1"}) {
    const ShellReply reply = type(shell, line);
    EXPECT_FALSE(reply.quit) << line;
    EXPECT_EQ(reply.outcome, base::ProgramOutcome::usage) << line;
  }
  EXPECT_TRUE(type(shell, "exit").quit);
}

TEST(ShellCommands, EveryWordIsCarriedOut) {
  for (const program::ShellCommand& command : program::shell_commands()) {
    const ShellOnText shell(cracked_hub());
    const ShellReply help = type(shell, fmt::format("help {}", command.word));
    EXPECT_EQ(help.outcome, base::ProgramOutcome::done);
    EXPECT_NE(help.out.find(command.doc), std::string::npos);
    const ShellReply reply = type(shell, std::string(command.word)); // without arguments
    EXPECT_EQ(reply.messages.find("there is no command"), std::string::npos) << command.word;
    EXPECT_EQ(reply.quit, command.word == "quit");
    const bool needs = (!command.arguments.empty() && command.arguments.front() != '[') ||
                       command.word == "undo" || // nothing has been changed
                       command.word == "grow";   // the deck has no $GROW
    EXPECT_EQ(reply.outcome, needs ? base::ProgramOutcome::usage : base::ProgramOutcome::done)
        << command.word << reply.messages;
  }
}

TEST(ShellCommands, ASession) {
  const ShellOnText shell(cracked_hub());
  EXPECT_EQ(program::shell_prompt(*shell), "PULLED> ");
  EXPECT_EQ(type(shell, "load pull (2*1)").outcome, base::ProgramOutcome::done);
  EXPECT_EQ(program::shell_prompt(*shell), "PULLED*> ");
  const ShellReply K = type(shell, "list k c");
  EXPECT_EQ(K.outcome, base::ProgramOutcome::done) << K.messages;
  EXPECT_NE(K.out.find(fmt::format("{:.6g}", shell.K1())), std::string::npos) << K.out;
  EXPECT_EQ(program::shell_prompt(*shell), "PULLED+> ");
  const ShellReply asked = type(shell, "K1(C, NOW)");
  EXPECT_EQ(asked.out, fmt::format("K1(C,NOW) = {:.10g} MPa*mm^0.5\n", shell.K1()));
  EXPECT_EQ(type(shell, "  ! nothing").out, "");
  for (const char* line :
       {"list pressure SEAT", "CPRESS.AT(SEAT,NOW,90[deg])", "CPRESS.NEAR(SEAT,0,20,NOW)",
        "REACTION(HELD,NOW,X)", "S.MISES.AT(0,30,NOW)", "map PULL 0 2", "list sensitivity", "list",
        "list CRACK", "list $STEP", "K1.BAR(C,NOW)", "ENERGY(*,PRESS)", "ERROR(HUB,NOW)",
        "$CRACK NAME=C A0=5", "$contact name=seat interference=0.02[mm]", "T = 8", "undo"}) {
    const ShellReply reply = type(shell, line);
    EXPECT_EQ(reply.outcome, base::ProgramOutcome::done) << line << "\n" << reply.messages;
    EXPECT_NE(reply.out, "") << line;
  }
}

TEST(ShellCommands, MistakesAreAnswered) {
  const ShellOnText shell(cracked_hub());
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"laod PULL 1", "did you mean 'LOAD'"},
      {"LOAD PUL 1", "did you mean 'PULL'"},
      {"list K D", "there is no crack 'D'"},
      {"K1(C,NWO)", "did you mean 'NOW'"},
      {"K11(C,NOW)", "is not a result"},
      {"K1(C)", "K1 takes (crack, step"},
      {"LOAD PULL", "a line is LOAD case factor"},
      {"LOAD PULL (2*Q)", "Q"},
      {"FIT SAET 1", "did you mean 'SEAT'"},
      {"plot q a.svg", "no picture"},
      {"plot path a.svg", "no map"},
      {"Q = 5", "no parameter 'Q'"},
      {"set T = 5", "NAME = EXPRESSION"},
      {"length C 5", "$CRACK NAME=C A0=5"},
      {"step FIRST", "no step"},
      {"list CARDS", "no list or card"},
      {"$CRACK NAME=D A0=3", "there is no $CRACK NAME=D"},
      {"$NET", "2 cards $NET"}};
  for (const auto& [line, answer] : mistakes) {
    const ShellReply reply = type(shell, line);
    EXPECT_NE(reply.outcome, base::ProgramOutcome::done) << line;
    EXPECT_NE(reply.messages.find(answer), std::string::npos) << line << ": " << reply.messages;
    EXPECT_EQ(reply.out, "") << line;
  }
}

TEST(ShellCommands, PicturesAndDeck) {
  const ShellOnText shell(cracked_hub());
  const auto at = [&](const char* name) { return (shell.folder.path() / name).string(); };
  EXPECT_NE(type(shell, "plot k " + at("k.svg")).outcome,
            base::ProgramOutcome::done); // one length only
  type(shell, "$CRACK NAME=C A0=5");
  type(shell, "map PULL 0 2");
  for (const char* kind : {"k", "pressure", "mesh", "path"}) {
    const std::string file = at(fmt::format("{}.svg", kind).c_str());
    const ShellReply reply = type(shell, fmt::format("plot {} '{}'", kind, file));
    EXPECT_EQ(reply.outcome, base::ProgramOutcome::done) << reply.messages;
    const std::string svg = test::slurp(file);
    EXPECT_TRUE(svg.starts_with("<svg xmlns")) << kind;
    EXPECT_TRUE(svg.ends_with("</svg>\n")) << kind;
  }
  EXPECT_EQ(type(shell, "save " + at("new.deck")).outcome, base::ProgramOutcome::done);
  EXPECT_TRUE(std::filesystem::exists(at("new.deck")));
  EXPECT_NE(type(shell, "save " + shell.file.string()).outcome,
            base::ProgramOutcome::done); // the deck itself
  EXPECT_EQ(type(shell, "save /no/such/folder/x.deck").outcome, base::ProgramOutcome::file_trouble);
}

TEST(ShellCommands, Completion) {
  const ShellOnText shell(cracked_hub());
  using List = std::vector<std::string>;
  const auto complete = [&](const std::string& line) {
    const std::size_t begin = line.find_last_of(" =(,") + 1;
    return program::complete_shell_line(*shell, line, begin);
  };
  EXPECT_EQ(complete("und"), (List{"undo"}));
  EXPECT_EQ(complete("LOAD "), (List{"PULL"}));
  EXPECT_EQ(complete("load pu"), (List{"pull"}));
  EXPECT_EQ(complete("LOAD PULL "), List{});
  EXPECT_EQ(complete("step P"), (List{"PRESS", "PULLED"}));
  EXPECT_EQ(complete("list pressure "), (List{"C.FACES", "SEAT"}));
  EXPECT_EQ(complete("plot p"), (List{"path", "pressure"}));
  EXPECT_EQ(complete("plot mesh "), List{}); // files
  EXPECT_EQ(complete("help und"), (List{"undo"}));
  EXPECT_EQ(complete("K1("), (List{"C"}));
  EXPECT_EQ(complete("K1(C,N"), (List{"NOW"}));
  EXPECT_EQ(complete("$CRA"), (List{"$CRACK"}));
  EXPECT_EQ(complete("$CRACK NAME="), (List{"C"}));
  EXPECT_EQ(complete("$CRACK NAME=C A0"), (List{"A0="}));
  const List results = complete("CPRESS.M");
  EXPECT_NE(std::ranges::find(results, "CPRESS.MAX"), results.end());
}

TEST(ShellCommands, ManualHasTheTable) {
  const std::string page = test::slurp(test::source_folder() + "/manual/shell.md");
  EXPECT_NE(page.find(program::shell_commands_markdown()), std::string::npos)
      << program::shell_commands_markdown();
}

} // namespace
} // namespace spricka::test_shell_commands
