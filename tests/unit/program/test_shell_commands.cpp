// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/command_table.hpp"
#include "program/shell/reply_text.hpp"
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

std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> out;
  for (const program::ShellWord& word : program::shell_words(line)) {
    EXPECT_EQ(line.substr(word.begin + (word.quoted ? 1 : 0), word.text.size()), word.text);
    out.push_back(word.text);
  }
  return out;
}

TEST(ShellText, Words) {
  using List = std::vector<std::string>;
  EXPECT_EQ(words("load PULL  1.5"), (List{"load", "PULL", "1.5"}));
  EXPECT_EQ(words("  fit SEAT=0.1[mm] ! more"), (List{"fit", "SEAT", "=", "0.1[mm]"}));
  EXPECT_EQ(words("length C (0.3 * R)"), (List{"length", "C", "(0.3 * R)"}));
  EXPECT_EQ(words(""), List{});
  EXPECT_EQ(words("! nothing"), List{});
  EXPECT_EQ(program::shell_words("save 'my deck.deck'")[1].text, "my deck.deck");
}

TEST(ShellText, NumbersAreThoseOfTheDeck) {
  const ShellOnText shell(cracked_hub());
  double value = 0.0;
  EXPECT_FALSE(program::read_number("2*T + 1", shell->model(), grammar::Quantity::number, value));
  EXPECT_EQ(value, 21.0);
  EXPECT_FALSE(program::read_number("0.5[in]", shell->model(), grammar::Quantity::length, value));
  EXPECT_NEAR(value, 12.7, 1e-12);
  EXPECT_TRUE(program::read_number("0.5[kN]", shell->model(), grammar::Quantity::length, value));
  EXPECT_TRUE(program::read_number("2*Q", shell->model(), grammar::Quantity::number, value));
  EXPECT_TRUE(program::read_number("1e", shell->model(), grammar::Quantity::number, value));
}

TEST(ShellCommands, LeavingTakesNoMoreWords) {
  const ShellOnText shell(cracked_hub());
  for (const char* line : {"quit now please", "exit 1"}) {
    const ShellReply reply = type(shell, line);
    EXPECT_FALSE(reply.quit) << line;
    EXPECT_EQ(reply.outcome, base::Outcome::usage) << line;
  }
  EXPECT_TRUE(type(shell, "exit").quit);
}

TEST(ShellCommands, EveryWordIsCarriedOut) {
  for (const program::ShellCommand& command : program::shell_commands()) {
    const ShellOnText shell(cracked_hub());
    const ShellReply help = type(shell, fmt::format("help {}", command.word));
    EXPECT_EQ(help.outcome, base::Outcome::done);
    EXPECT_NE(help.out.find(command.doc), std::string::npos);
    const ShellReply reply = type(shell, std::string(command.word)); // without arguments
    EXPECT_EQ(reply.messages.find("there is no command"), std::string::npos) << command.word;
    EXPECT_EQ(reply.quit, command.word == "quit");
    const bool needs = !command.arguments.empty() && command.arguments.front() != '[';
    EXPECT_EQ(reply.outcome, needs ? base::Outcome::usage : base::Outcome::done)
        << command.word << reply.messages;
  }
}

TEST(ShellCommands, ASession) {
  const ShellOnText shell(cracked_hub());
  EXPECT_EQ(program::shell_prompt(*shell), "PULLED> ");
  EXPECT_EQ(type(shell, "LOAD pull 2*1").outcome, base::Outcome::done);
  EXPECT_EQ(program::shell_prompt(*shell), "PULLED*> ");
  const ShellReply K = type(shell, "k c");
  EXPECT_EQ(K.outcome, base::Outcome::done) << K.messages;
  EXPECT_NE(K.out.find(fmt::format("{:.7g}", shell.K1())), std::string::npos) << K.out;
  EXPECT_EQ(program::shell_prompt(*shell), "PULLED+> ");
  const ShellReply asked = type(shell, "K1(C, NOW)");
  EXPECT_EQ(asked.out, fmt::format("K1(C,NOW) = {:.10g} MPa*mm^0.5\n", shell.K1()));
  EXPECT_EQ(type(shell, "  ! nothing").out, "");
  for (const char* line :
       {"pressure SEAT", "pressure SEAT 90[deg]", "pressure SEAT 0 20", "arc SEAT", "reaction HELD",
        "displacement -50 0", "stress 0 30", "map PULL 0 2", "sensitivity", "show", "K1.BAR(C,NOW)",
        "ENERGY(*,PRESS)", "ERROR(HUB,NOW)", "length C 5", "fit SEAT = 0.02[mm]", "set T = 8"}) {
    const ShellReply reply = type(shell, line);
    EXPECT_EQ(reply.outcome, base::Outcome::done) << line << "\n" << reply.messages;
    EXPECT_NE(reply.out, "") << line;
  }
}

TEST(ShellCommands, MistakesAreAnswered) {
  const ShellOnText shell(cracked_hub());
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"laod PULL 1", "did you mean 'load'"},
      {"load PUL 1", "did you mean 'PULL'"},
      {"K D", "there is no crack 'D'"},
      {"K1(C,NWO)", "did you mean 'NOW'"},
      {"K11(C,NOW)", "there is no result"},
      {"K1(C)", "write K1(crack, step"},
      {"load PULL", "write load"},
      {"load PULL 2*Q", "Q"},
      {"plot q a.svg", "no picture"},
      {"plot path a.svg", "no map"},
      {"set T 5", "write set"},
      {"step FIRST", "no step"},
      {"length C 3[kN]", "not the unit of"},
      {"pressure SEAT 1 2 3", "write pressure"}};
  for (const auto& [line, answer] : mistakes) {
    const ShellReply reply = type(shell, line);
    EXPECT_NE(reply.outcome, base::Outcome::done) << line;
    EXPECT_NE(reply.messages.find(answer), std::string::npos) << line << ": " << reply.messages;
    EXPECT_EQ(reply.out, "") << line;
  }
}

TEST(ShellCommands, PicturesAndDeck) {
  const ShellOnText shell(cracked_hub());
  const auto at = [&](const char* name) { return (shell.folder.path() / name).string(); };
  EXPECT_NE(type(shell, "plot k " + at("k.svg")).outcome, base::Outcome::done); // one length only
  type(shell, "length C 5");
  type(shell, "map PULL 0 2");
  for (const char* kind : {"k", "pressure", "mesh", "path"}) {
    const std::string file = at(fmt::format("{}.svg", kind).c_str());
    const ShellReply reply = type(shell, fmt::format("plot {} '{}'", kind, file));
    EXPECT_EQ(reply.outcome, base::Outcome::done) << reply.messages;
    const std::string svg = test::slurp(file);
    EXPECT_TRUE(svg.starts_with("<svg xmlns")) << kind;
    EXPECT_TRUE(svg.ends_with("</svg>\n")) << kind;
  }
  EXPECT_EQ(type(shell, "save " + at("new.deck")).outcome, base::Outcome::done);
  EXPECT_TRUE(std::filesystem::exists(at("new.deck")));
  EXPECT_NE(type(shell, "save " + shell.file.string()).outcome,
            base::Outcome::done); // the deck itself
  EXPECT_EQ(type(shell, "save /no/such/folder/x.deck").outcome, base::Outcome::file_trouble);
}

TEST(ShellCommands, Completion) {
  const ShellOnText shell(cracked_hub());
  using List = std::vector<std::string>;
  const auto complete = [&](const std::string& line) {
    const std::size_t begin = line.find_last_of(" =(,") + 1;
    return program::complete_shell_line(*shell, line, begin);
  };
  EXPECT_EQ(complete("len"), (List{"length"}));
  EXPECT_EQ(complete("load "), (List{"PULL"}));
  EXPECT_EQ(complete("load pu"), (List{"pull"}));
  EXPECT_EQ(complete("load PULL "), List{});
  EXPECT_EQ(complete("step P"), (List{"PRESS", "PULLED"}));
  EXPECT_EQ(complete("pressure "), (List{"C.FACES", "SEAT"}));
  EXPECT_EQ(complete("plot p"), (List{"path", "pressure"}));
  EXPECT_EQ(complete("plot mesh "), List{}); // files
  EXPECT_EQ(complete("help sen"), (List{"sensitivity"}));
  EXPECT_EQ(complete("K1("), (List{"C"}));
  EXPECT_EQ(complete("K1(C,N"), (List{"NOW"}));
  EXPECT_EQ(complete("set "), (List{"T"}));
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
