// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/script_scan.hpp"
#include "mesh/import/script_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace spricka::test_script_scan {
namespace {

std::vector<std::string> refused(const std::string& text) {
  std::vector<std::string> words;
  for (const mesh::ForbiddenStatement& o : mesh::scan_script(text).outreach) {
    words.push_back(std::to_string(o.line) + " " + o.word);
  }
  return words;
}

using Words = std::vector<std::string>;

TEST(ScriptScan, NamesWhatReachesOutside) {
  EXPECT_EQ(refused("a = 1;\nSystemCall \"x\";\nMerge \"y\"; Exit;"),
            (Words{"2 SystemCall", "3 Merge", "3 Exit"}));
  EXPECT_EQ(refused("View.Light = 0; Print.Text = 1;"), Words{});
  EXPECT_EQ(refused("View \"a\" {}; a = 1; Save"), (Words{"1 View", "1 Save"}));
}

TEST(ScriptScan, LeavesOutWhatOnlyWrites) {
  const std::string text = "a = 1;\nSave \"x.msh\";\nIf (a)\n  Print Str(\"x\",\n\".png\"); EndIf\n"
                           "Mesh.SaveAll = 1; Mesh.SaveAll = 0; b = Saved;";
  const mesh::ScriptScan scan = mesh::scan_script(text);
  EXPECT_TRUE(scan.outreach.empty());
  Words words;
  for (const mesh::ForbiddenStatement& o : scan.passed_over) {
    words.push_back(std::to_string(o.line) + " " + o.word);
  }
  EXPECT_EQ(words, (Words{"2 Save", "4 Print", "6 Mesh.SaveAll"}));
  base::Diagnostics diagnostics;
  const mesh::PreparedScript script =
      mesh::prepare_script_with_parameters(text, scan, {}, diagnostics);
  EXPECT_EQ(script.text.find("msh"), std::string::npos);
  EXPECT_EQ(script.text.find("png"), std::string::npos);
  EXPECT_NE(script.text.find("EndIf"), std::string::npos);
  EXPECT_EQ(std::ranges::count(script.text, '\n'), std::ranges::count(text, '\n'));
  EXPECT_EQ(refused("Save GetEnv(\"HOME\");"), Words{});
  EXPECT_EQ(refused("a = Print;"), Words{"1 Print"});
}

TEST(ScriptScan, NamesWhatGmshWouldPassOver) {
  EXPECT_EQ(refused("For i In {1:3}\n  Point(i) = {i, 0, 0};\n"), Words{"1 For"});
  EXPECT_EQ(refused("For i In {1:3}\nIf (i == 2)\nEndFor\n"), (Words{"1 For", "2 If"}));
  EXPECT_EQ(refused("For i In {1:3}\nIf (i == 2)\nElseIf (i == 3)\nElse\nEndIf\nEndFor"), Words{});
  EXPECT_EQ(refused("Mesh.ScalingFactor = 0.001;"), Words{"1 Mesh.ScalingFactor"});
  EXPECT_EQ(refused("Mesh.ScalingFactor = s;"), Words{"1 Mesh.ScalingFactor"});
  for (const char* text :
       {"= 1*0.001;", "= 1/1000;", "*= 0.001;", "= 1e-3;", "= -1;", "= 1", "= 1,5;"}) {
    EXPECT_EQ(refused("Mesh.ScalingFactor " + std::string(text)), Words{"1 Mesh.ScalingFactor"})
        << text;
  }
  EXPECT_EQ(refused("Mesh.ScalingFactor = 1.0; ScalingFactor = 3;"), Words{});
  EXPECT_EQ(refused("a = 2 * Mesh.ScalingFactor;"), Words{});
}

TEST(ScriptScan, PassesOverCommentsAndTexts) {
  EXPECT_EQ(refused("// Exit\n/* Exit\n Exit */ \"Exit\" 'Exit'"), Words{});
  EXPECT_EQ(refused("\"// no comment\" Exit"), Words{"1 Exit"});
  EXPECT_EQ(refused("// \"\nExit"), Words{"2 Exit"});
  EXPECT_EQ(refused("/*/ Exit */Abort"), Words{"1 Abort"});
  EXPECT_EQ(refused("\"a\\\" Exit; \""), Words{"1 Exit"}); // a backslash hides nothing
  EXPECT_EQ(refused("Exiting = 1; myExit = 2; Exit_ = 3; Exit2 = 1;"), Words{});
  EXPECT_EQ(refused("x = 2Exit"), Words{}); // a number, to gmsh a mistake
}

TEST(ScriptScan, FindsConstantsAndAssignments) {
  const mesh::ScriptScan scan = mesh::scan_script(
      "DefineConstant[ a = 3, Bc = {4, Min 1, Name \"c, d\"},\n l[] = {1, 2}, e, f = Max(1, 2) ];\n"
      "g = 2; For i In {1:2}\n h = i; EndFor k[] = {1}; If (g == 1) m = 1; EndIf x~{1} = 2;");
  std::vector<std::string> names;
  for (const mesh::ScriptAssignment& n : scan.constants) {
    names.push_back(n.name + ":" + n.text);
  }
  EXPECT_EQ(names, (Words{"a:3", "Bc:{4, Min 1, Name \"c, d\"}", "e:", "f:Max(1, 2)"}));
  names.clear();
  for (const mesh::ScriptAssignment& n : scan.assigned) {
    names.push_back(n.name);
  }
  EXPECT_EQ(names, (Words{"g", "h", "m"}));
}

// Texts made to take long: time grows with their length, not its square.
TEST(ScriptScan, IsLinear) {
  const auto begin = std::chrono::steady_clock::now();
  for (const char* piece : {"DefineConstant[", "DefineConstant[a=", "a=1;", "\"", "/*"}) {
    std::string text;
    for (int i = 0; i < 100000; ++i) {
      text += piece;
    }
    mesh::scan_script(text);
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(taken.count(), 20.0);
}

class Parameters : public testing::Test {
protected:
  mesh::PreparedScript with(std::vector<std::pair<std::string, double>> parameters) {
    request_.file = "x.geo";
    request_.parameters = std::move(parameters);
    const std::string text = "DefineConstant[ Ro = 45, r = 1, R = 2 ]; own = 3; y = free;";
    return mesh::prepare_script_with_parameters(text, mesh::scan_script(text), request_,
                                                diagnostics_);
  }

  mesh::ImportRequest request_;
  base::Diagnostics diagnostics_;
};

TEST_F(Parameters, ArriveWhateverTheCase) {
  for (const char* name : {"Ro", "RO", "ro", "rO"}) {
    const mesh::PreparedScript script = with({{name, 60.0}});
    EXPECT_NE(script.text.find("Ro = 60;"), std::string::npos) << script.text;
    EXPECT_TRUE(script.constants.at(0).from_deck);
    EXPECT_FALSE(script.constants.at(1).from_deck);
    EXPECT_EQ(script.text.find('\n'), std::string::npos); // lines keep their numbers
  }
}

TEST_F(Parameters, OfTwoNamesTakeTheirOwn) {
  const mesh::PreparedScript script = with({{"R", 7.0}});
  EXPECT_FALSE(diagnostics_.has_errors());
  EXPECT_FALSE(script.constants.at(1).from_deck);
  EXPECT_TRUE(script.constants.at(2).from_deck);
  EXPECT_NE(script.text.find("R = 7;"), std::string::npos);
  EXPECT_EQ(script.text.find("r = 7;"), std::string::npos);
}

TEST_F(Parameters, TellWhatTheScriptSetsItself) {
  const mesh::PreparedScript script = with({{"own", 4.0}, {"FREE", 5.0}});
  ASSERT_EQ(script.constants.size(), 5U);
  EXPECT_EQ(script.constants[3].name, "free");
  EXPECT_TRUE(script.constants[3].from_deck);
  EXPECT_EQ(script.constants[4].name, "own");
  EXPECT_FALSE(script.constants[4].defined);
}

} // namespace
} // namespace spricka::test_script_scan
