// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/machine.hpp"

#include "archive/safe_file.hpp"
#include "base/input_file.hpp"
#include "base/memory.hpp"
#include "program/trials/child_run.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <sched.h>
#include <sys/utsname.h>

namespace spricka::program {

namespace {

// The kernel's name of the processor, where it has one.
std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  utsname names{};
  return uname(&names) == 0 ? std::string(names.machine) : "unknown processor";
}

} // namespace

int core_count() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  return sched_getaffinity(0, sizeof cores, &cores) == 0 ? std::max(1, CPU_COUNT(&cores)) : 1;
}

std::string machine_description() {
  return fmt::format("{}, {} cores, {:.0f} GB", processor_name(), core_count(),
                     1e-9 * static_cast<double>(base::process_memory_limit()));
}

std::string program_version_and_build() {
  // Piece by piece: what this process once had counts as memory of all that it starts.
  std::ifstream file(running_program_file(), std::ios::binary);
  std::string piece(base::mebibyte, '\0');
  std::string hashes;
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())) || file.gcount() > 0) {
    hashes += archive::hash_bytes({piece.data(), static_cast<std::size_t>(file.gcount())});
  }
  const std::string hash = archive::hash_bytes(hashes);
  return fmt::format("spricka {} ({})", SPRICKA_VERSION, hash.substr(0, 8));
}

} // namespace spricka::program
