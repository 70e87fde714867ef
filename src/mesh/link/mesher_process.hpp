// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace spricka::mesh {

/// A running spricka-mesher: the process that has gmsh, with a socket to it and the end of a pipe
/// that takes what it prints. It ends with its owner, however that ends.
class MesherProcess {
public:
  /// With so much memory [bytes] beyond what it needs to begin with. Throws std::system_error where
  /// it is not installed, or the system has no process or no file left for it.
  static std::unique_ptr<MesherProcess> start(std::size_t memory);
  ~MesherProcess();
  MesherProcess(const MesherProcess&) = delete;
  MesherProcess& operator=(const MesherProcess&) = delete;

  /// A fork of this process has the sockets, but no right to the mesher.
  [[nodiscard]] bool is_owner() const;
  /// Sends a frame; false if nobody is there to read it.
  [[nodiscard]] bool send_frame(std::string_view bytes) const;

  enum class ReceiveResult { frame, nothing, gone, too_long };
  /// Takes what has arrived, waiting for at most `milliseconds`; a whole frame goes to `frame`. No
  /// frame may be longer than `most`.
  ReceiveResult receive_frame(int milliseconds, std::size_t most, std::string& frame);
  /// Seconds of processor time it has used so far.
  [[nodiscard]] double processor_time() const;
  /// Whether it waits for something now instead of working: false of one that a busy machine keeps
  /// from a processor, or that is stopped, and where the system does not tell.
  [[nodiscard]] bool is_sleeping() const;
  /// Its largest resident set so far [bytes]; empty: the system does not tell.
  [[nodiscard]] std::optional<std::size_t> peak_memory() const;
  /// The last of what it printed since the last call.
  std::string take_output();
  /// Ends it, if it has not ended; the status as waitpid gives it.
  int end();

private:
  MesherProcess(pid_t pid, int socket, int words);
  void take_printed();

  pid_t owner_;
  pid_t pid_;
  int socket_;
  int words_end_;
  std::string received_;
  std::string words_;
  std::optional<int> status_;
};

/// Where spricka-mesher is, in libexec/spricka beside the program (base/shipped_files.hpp). Empty
/// if there is none.
std::string mesher_program_path();

} // namespace spricka::mesh
