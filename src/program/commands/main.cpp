// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/clock.hpp"
#include "program/commands/command_line.hpp"
#include "program/commands/ranks.hpp"
#include "solve/one_thread.hpp"
#include "solve/source_digest.hpp"

int main(int argc, char** argv) {
  spricka::base::return_large_blocks_on_free();
  spricka::solve::end_idle_threads();
  return spricka::program::run_on_first_rank([&] {
    return spricka::program::run_command_line(argc, argv, spricka::solve::source_digest());
  });
}
