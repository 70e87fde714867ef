// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

/// Cards of small decks: blocks as nets, their properties, supports, ties and one load.
namespace spricka::test {

inline const std::string head =
    "$DECK VERSION=1 LENGTH=mm FORCE=N\n$MATERIAL NAME=M E=1000 NU=0.25\n";

inline std::string net(const std::string& name, const std::string& mesh) {
  return "$NET NAME=" + name + "\n  $MESH SHAPE=BLOCK " + mesh + "\n$ENDNET\n";
}
inline std::string property(const std::string& set, const std::string& state = "STRESS") {
  return "$PROPERTY ESET=" + set + " MATERIAL=M STATE=" + state + "\n";
}
inline std::string held(const std::string& set, const std::string& dof = "XY") {
  return "$FREEDOM CLASS=SUPPRESSED DOF=" + dof + "\n  " + set + "\n";
}
inline std::string tied(const std::string& slave, const std::string& master) {
  return "$MPC TYPE=TRANSITION SLAVE=" + slave + " MASTER=" + master + "\n";
}
inline std::string load(const std::string& type, const std::string& line) {
  return "$LOAD CASE=F TYPE=" + type + "\n  " + line + "\n$STEP NAME=S\n  LOAD F 1\n";
}

} // namespace spricka::test
