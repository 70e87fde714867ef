// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/editor.hpp"
#include "grammar/help.hpp"
#include "program/commands/commands.hpp"
#include "program/job/standard_streams.hpp"

#include <fmt/format.h>

namespace spricka::program {

base::ProgramOutcome schema_command() {
  write_to_stdout(grammar::card_catalogue_json());
  return base::ProgramOutcome::done;
}

base::ProgramOutcome editor_command(const std::string& editor) {
  write_to_stdout(editor == "vim" ? grammar::vim_syntax() : grammar::textmate_grammar());
  return base::ProgramOutcome::done;
}

} // namespace spricka::program
