// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/exit_codes.hpp"
#include "grammar/editor.hpp"
#include "grammar/help.hpp"
#include "program/commands/commands.hpp"
#include "program/job/standard_streams.hpp"

#include <fmt/format.h>

namespace spricka::program {

int schema_command() {
  to_stdout(grammar::schema_json());
  return base::exit_code::done;
}

int editor_command(const std::string& editor) {
  to_stdout(editor == "vim" ? grammar::vim_syntax() : grammar::textmate_grammar());
  return base::exit_code::done;
}

} // namespace spricka::program
