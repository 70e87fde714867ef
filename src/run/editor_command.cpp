// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/editor.hpp"
#include "grammar/help.hpp"
#include "run/commands.hpp"
#include "run/exit_codes.hpp"
#include "run/standard_streams.hpp"

#include <fmt/format.h>

namespace spricka::run {

int schema_command() {
  to_stdout(grammar::schema_json());
  return exit_code::done;
}

int editor_command(const std::string& editor) {
  to_stdout(editor == "vim" ? grammar::vim_syntax() : grammar::textmate_grammar());
  return exit_code::done;
}

} // namespace spricka::run
