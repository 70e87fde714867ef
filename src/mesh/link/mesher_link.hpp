// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace spricka::mesh {

/// How a request to the mesher ended.
enum class MesherOutcome {
  answered,
  crashed,   ///< by a signal
  left,      ///< it ended by itself, without an answer
  forbidden, ///< it tried what it may not, and was ended by the kernel
  no_time,   ///< a limit of time
  no_memory, ///< the limit of memory
};

struct MesherAnswer {
  MesherOutcome end = MesherOutcome::answered;
  std::string frame;              ///< the answer
  std::string trouble;            ///< in words, unless answered
  std::vector<std::string> words; ///< what gmsh printed last, line by line, unless answered
};

/// Asks the mesher: a process with the gmsh library, started when first needed, that can neither
/// start programs nor reach the network or any file, and that is limited in time and memory
/// (mesher_limits.hpp). It goes on for later requests; after trouble the next one starts another.
/// One request runs at a time, others wait. Throws std::system_error where none can be started.
MesherAnswer request_from_mesher(std::string_view request);

/// Ends the mesher, if there is one: what a file has done to it is not to outlive that file.
void end_mesher_process();

} // namespace spricka::mesh
