// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/serve.hpp"
#include "mesher/answers.hpp"
#include "mesher/only_file.hpp"
#include "mesher/sandbox.hpp"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace spricka::mesher {
namespace {

using mesh::ByteReader;
using mesh::MesherFrameKind;

constexpr int line = 3; ///< the socket to spricka
/// The kernel's limit of time stands behind spricka's own, in case spricka is stopped or gone [s].
constexpr double time_of_a_request = 3600.0;

pid_t owner = 0;

bool read_all(void* into, std::size_t size) {
  auto* at = static_cast<char*>(into);
  while (size > 0) {
    const ssize_t got = read(line, at, size);
    if (got == 0 || (got < 0 && errno != EINTR)) {
      return false;
    }
    at += got > 0 ? got : 0;
    size -= static_cast<std::size_t>(got > 0 ? got : 0);
  }
  return true;
}

bool write_all(const void* from, std::size_t size) {
  const auto* at = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t sent = write(line, at, size);
    if (sent < 0 && errno != EINTR) {
      return false;
    }
    at += sent > 0 ? sent : 0;
    size -= static_cast<std::size_t>(sent > 0 ? sent : 0);
  }
  return true;
}

void say(std::string_view frame) {
  const std::size_t size = frame.size();
  if (!write_all(&size, sizeof size) || !write_all(frame.data(), size)) {
    _exit(0); // nobody listens any more
  }
}

void say(MesherFrameKind kind) {
  const char byte = static_cast<char>(kind);
  say(std::string_view(&byte, 1));
}

/// A name without a value in gmsh is left out; a list has no value here.
std::string with_questions(const mesh::MesherImportRequest& import) {
  std::string text = import.text;
  for (const std::string& name : import.constants) {
    text.append("\nIf (Exists(").append(name).append("))\nSetNumber(\"spricka/").append(name);
    text.append("\", ").append(name).append(");\nEndIf\n");
  }
  return text;
}

std::string bad_request() {
  return {static_cast<char>(MesherFrameKind::bad_request)};
}

std::string no_sandbox() {
  return {static_cast<char>(MesherFrameKind::no_sandbox)};
}

template <int dim> std::string filling_answer(ByteReader& in) {
  mesh::FillRegion<dim> region;
  mesh::SizeGrading<dim> size;
  return mesh::decode_fill_request(in, region, size)
             ? mesh::encode_fill_answer(fill_region_by_gmsh(region, size))
             : bad_request();
}

std::string answer(std::string_view request, bool locked) {
  ByteReader in(request);
  const auto kind = in.read_value<MesherFrameKind>();
  if (kind == MesherFrameKind::fill) {
    return filling_answer<2>(in);
  }
  if (kind == MesherFrameKind::fill_solid) {
    return filling_answer<3>(in);
  }
  if (kind == MesherFrameKind::import) {
    mesh::MesherImportRequest import;
    if (mesh::decode_import_request(in, import) &&
        (!locked ||
         set_memory_file(import.name, import.script ? with_questions(import) : import.text))) {
      return locked ? mesh::encode_model_answer(read_gmsh_model(
                          import, import.name, [] { say(MesherFrameKind::meshing); }))
                    : no_sandbox();
    }
  }
  if (kind == MesherFrameKind::describe) {
    mesh::StepFileText file;
    if (mesh::decode_describe_request(in, file) &&
        (!locked || set_memory_file(file.name, file.text))) {
      return locked ? mesh::encode_solids_answer(describe_step_file(file.name)) : no_sandbox();
    }
  }
  return bad_request();
}

/// Until nobody asks any more.
void answer_requests(bool locked) {
  std::size_t size = 0;
  while (read_all(&size, sizeof size)) {
    limit_processor_time(time_of_a_request);
    try {
      std::string request(size, '\0');
      if (!read_all(request.data(), size)) {
        return;
      }
      say(answer(request, locked));
    } catch (const std::bad_alloc&) {
      say(MesherFrameKind::no_memory);
      return;
    }
  }
}

// What the terminal sends to all its processes is for spricka to answer; and a mesher whose spricka
// is gone has nothing to do.
void look_at_signals() {
  for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP}) {
    std::signal(signal, SIG_IGN);
  }
  struct sigaction look {};
  look.sa_handler = [](int) {
    if (getppid() != owner) {
      _exit(0);
    }
  };
  look.sa_flags = SA_RESTART;
  sigaction(SIGALRM, &look, nullptr);
  const itimerval every{{1, 0}, {1, 0}};
  setitimer(ITIMER_REAL, &every, nullptr);
}

} // namespace
} // namespace spricka::mesher

int spricka_serve_as_mesher(int argc, char** argv) {
  using namespace spricka::mesher;
  int type = 0;
  socklen_t length = sizeof type;
  std::size_t memory = 0;
  if (argc != 3 || getsockopt(line, SOL_SOCKET, SO_TYPE, &type, &length) != 0 ||
      std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), memory).ec != std::errc() ||
      std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), owner).ec != std::errc()) {
    std::fputs(
        "spricka-mesher is a part of spricka, which starts it where a mesh is made by gmsh\n",
        stderr);
    return 2;
  }
  syscall(SYS_close_range, line + 1, ~0U, 0);
  look_at_signals();
  limit_memory(memory);
  pin_to_one_processor();
  if (getppid() != owner) { // it went while the libraries were loaded
    return 0;
  }
  const bool locked = make_memory_file() && enter_sandbox();
  answer_requests(locked);
  _exit(0);
}
