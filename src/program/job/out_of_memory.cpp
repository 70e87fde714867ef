// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/out_of_memory.hpp"

#include "base/clock.hpp"
#include "base/memory.hpp"

#include <new>
#include <stdexcept>

#include <fmt/format.h>

namespace spricka::program {

bool is_out_of_memory(const std::exception& trouble) {
  return dynamic_cast<const std::bad_alloc*>(&trouble) != nullptr ||
         dynamic_cast<const std::length_error*>(&trouble) != nullptr; // more than can be counted
}

std::string out_of_memory_message() {
  constexpr double mebi = 1048576.0;
  return fmt::format("out of memory: {:.0f} MiB were in use, the machine or its limits (ulimit -v, "
                     "a job queue) allow {:.0f} MiB; spricka check foretells what the deck needs",
                     static_cast<double>(base::peak_memory()) / mebi,
                     static_cast<double>(base::process_memory_limit()) / mebi);
}

} // namespace spricka::program
