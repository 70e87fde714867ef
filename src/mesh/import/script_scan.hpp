// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// A word of a geometry script that reaches outside of it, or that gmsh would pass over in silence,
/// or that has no effect here.
struct ForbiddenStatement {
  std::size_t line = 0;
  std::string word; ///< as the script writes it
  std::string does; ///< "runs a command"
  std::string remedy = {};
};

/// A name to which a script gives a value: by DefineConstant, which leaves it alone if it has one
/// already, or by an assignment.
struct ScriptAssignment {
  std::string name;
  std::size_t line = 0;
  std::string text; ///< the default of a constant as the script writes it, at most a short line
};

struct ScriptScan {
  std::vector<ForbiddenStatement> outreach; ///< in order of the text
  /// Statements that only write what nobody reads here, in order of the text, and their places in
  /// it: from the first letter up to behind the semicolon.
  std::vector<ForbiddenStatement> passed_over;
  std::vector<std::pair<std::size_t, std::size_t>> passed_over_at;
  std::vector<ScriptAssignment> constants; ///< each name once
  std::vector<ScriptAssignment> assigned;  ///< numbers, each name once; also those of constants
  std::set<std::string> words;             ///< all names and words of the language
};

/// A number to which a geometry script gives a name.
struct GeometryScriptConstant {
  std::string name;       ///< as the script writes it
  bool defined = true;    ///< by DefineConstant; else the script sets it, whatever the deck says
  bool from_deck = false; ///< a parameter of the deck has set it
  std::optional<double> value; ///< at the end of the script; empty if it is no number or has none
  std::string text;            ///< its default, as the script writes it
};

/// Looks through a gmsh geometry script, past comments and texts in quotes, for statements that
/// start programs, read or write files, read the environment or end gmsh, so that a message can
/// name them (that they do no harm is the work of mesher/sandbox.hpp), and for the names that it
/// gives values. Source: gmsh 4.8 reference manual, section 4 and the words of its parser.
ScriptScan scan_script(std::string_view text);

} // namespace spricka::mesh
