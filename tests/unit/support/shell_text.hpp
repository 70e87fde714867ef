// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/shell/session.hpp"
#include "tests/unit/support/run_text.hpp"

#include <fstream>
#include <memory>
#include <string>

namespace spricka::test {

/// A session on a deck given as text.
struct ShellOnText {
  Folder folder;
  std::filesystem::path file = folder.path() / "test.deck";
  bool stop = false; ///< what the session hears when it asks
  std::unique_ptr<program::ShellSession> session;

  explicit ShellOnText(const std::string& deck,
                       const std::vector<std::pair<std::string, std::string>>& defines = {}) {
    std::ofstream(file) << deck;
    program::SessionOptions options;
    options.read = [this](const deck::DeckReadOptions& read) {
      return program::read_and_check_deck(file, read, program::Log(program::LogFormat::text));
    };
    options.defines = defines;
    options.stopped = [this] { return stop; };
    session = std::make_unique<program::ShellSession>(std::move(options));
    good(session->open());
  }
  static void good(const base::OptionalFailure& trouble) {
    EXPECT_FALSE(trouble) << (trouble ? trouble->why : "");
  }
  program::ShellSession& operator*() const { return *session; }
  program::ShellSession* operator->() const { return session.get(); }
  [[nodiscard]] double K1(std::size_t tip = 0) const {
    return session->current_result().fronts.at(tip).single_point().K1;
  }
  [[nodiscard]] double K2(std::size_t tip = 0) const {
    return session->current_result().fronts.at(tip).single_point().K2;
  }
  [[nodiscard]] program::CrackSize crack_size() const {
    return program::crack_size(session->model(), session->current_result(), 0);
  }
};

/// A pin pressed into a hub with a crack at its outside, and pulled; where `more` stands further
/// cards, the crack's own keys are `crack`.
inline std::string cracked_hub(const std::string& crack = "A0=4",
                               const std::string& contact = "INTERFERENCE=0.01",
                               const std::string& more = "") {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  T = 10   ! thickness
$NET NAME=HUB
  $MESH SHAPE=RING TYPE=QUAMC8 RI=20 RO=50 NR=4 NT=36
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=5 RO=20 NR=4 NT=32
$ENDNET
$MATERIAL NAME=S E=210000 NU=0.3
$PROPERTY ESET=HUB.BODY MATERIAL=S STATE=STRESS THICK=(T)
$PROPERTY ESET=PIN.BODY MATERIAL=S STATE=STRESS THICK=(T)
$NSET NAME=HELD WHERE=(x < -44)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$LOAD CASE=PULL TYPE=RESULTANT
  PIN.BODY 20000 3000
$CONTACT NAME=SEAT SLAVE=PIN.OUTER MASTER=HUB.INNER )" +
         contact + R"(
$STEP NAME=PRESS
  FIT SEAT 1
$STEP NAME=PULLED
  LOAD PULL 1
$CRACK NAME=C NET=HUB ANGLE=-90[deg] )" +
         crack + "\n  0 50\n" + more + "$END\n";
}

} // namespace spricka::test
