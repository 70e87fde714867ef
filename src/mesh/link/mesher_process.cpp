// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/mesher_process.hpp"

#include "base/clock.hpp"
#include "base/shipped_files.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spricka::mesh {
namespace {

namespace fs = std::filesystem;

constexpr const char* program = "spricka-mesher";
constexpr int socket_of_mesher = 3;
/// Descriptors of the parent are kept above those that the mesher gets.
constexpr int first_own = 16;
/// The end of what the mesher printed that is kept [bytes].
constexpr std::size_t most_words = 8192;

/// A file descriptor that closes itself.
class Handle {
public:
  explicit Handle(int fd = -1) : fd_(fd) {}
  ~Handle() { reset(-1); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  void reset(int fd) {
    if (fd_ >= 0) {
      close(fd_);
    }
    fd_ = fd;
  }
  /// The same file under a number that the mesher's own do not meet.
  void raise() {
    const int above = fcntl(fd_, F_DUPFD_CLOEXEC, first_own);
    const bool no_number = above < 0 && errno == EINVAL; // the limit of open files lies below
    const int trouble = no_number ? EMFILE : errno;
    reset(above);
    errno = trouble;
  }
  int release() { return std::exchange(fd_, -1); }
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool open() const { return fd_ >= 0; }

private:
  int fd_;
};

/// Both ends of a new socket and of a new pipe.
struct MesherChannels {
  Handle socket, of_mesher, words, printed;

  bool make() {
    std::array<int, 2> two{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, two.data()) != 0) {
      return false;
    }
    socket.reset(two[0]);
    of_mesher.reset(two[1]);
    if (pipe2(two.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
      return false;
    }
    words.reset(two[0]);
    printed.reset(two[1]);
    for (Handle* handle : {&socket, &of_mesher, &words, &printed}) {
      handle->raise();
    }
    return socket.open() && of_mesher.open() && words.open() && printed.open();
  }
};

/// The mesher sees nothing of the environment but where its libraries are and how they are to run.
std::vector<std::string> environment() {
  std::vector<std::string> result{"OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1", "LC_ALL=C",
                                  "LIBC_FATAL_STDERR_=1"};
  for (const char* name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS", "LSAN_OPTIONS"}) {
    if (const char* value = std::getenv(name)) {
      result.push_back(fmt::format("{}={}", name, value));
    }
  }
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) {
    result.push_back(text.data());
  }
  result.push_back(nullptr);
  return result;
}

pid_t spawn(const std::string& path, std::size_t memory, const MesherChannels& ends) {
  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
  if (posix_spawn_file_actions_init(&actions) != 0 || posix_spawnattr_init(&attributes) != 0) {
    return -1;
  }
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends.printed.get(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends.printed.get(), STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends.of_mesher.get(), socket_of_mesher);
  sigset_t none{};
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  std::vector<std::string> words{program, std::to_string(memory), std::to_string(getpid())};
  std::vector<std::string> variables = environment();
  pid_t pid = -1;
  const int trouble = posix_spawn(&pid, path.c_str(), &actions, &attributes, pointers(words).data(),
                                  pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  errno = trouble;
  return trouble == 0 ? pid : -1;
}

} // namespace

std::string mesher_program_path() {
  const fs::path place = base::find_shipped_file(fs::path("libexec") / "spricka" / program);
  return access(place.c_str(), X_OK) == 0 ? place.string() : std::string();
}

std::unique_ptr<MesherProcess> MesherProcess::start(std::size_t memory) {
  const std::string path = mesher_program_path();
  if (path.empty()) {
    throw std::system_error(ENOENT, std::generic_category(),
                            fmt::format("the program {} is not installed beside spricka", program));
  }
  MesherChannels ends;
  const pid_t pid = ends.make() ? spawn(path, memory, ends) : -1;
  if (pid < 0) {
    throw std::system_error(errno, std::generic_category(), fmt::format("cannot start {}", path));
  }
  return std::unique_ptr<MesherProcess>(
      new MesherProcess(pid, ends.socket.release(), ends.words.release()));
}

MesherProcess::MesherProcess(pid_t pid, int socket, int words)
    : owner_(getpid()), pid_(pid), socket_(socket), words_end_(words) {}

MesherProcess::~MesherProcess() {
  if (is_owner()) {
    end();
  }
  close(socket_);
  close(words_end_);
}

bool MesherProcess::is_owner() const {
  return owner_ == getpid();
}

bool MesherProcess::send_frame(std::string_view bytes) const {
  const std::size_t size = bytes.size();
  std::string whole(reinterpret_cast<const char*>(&size), sizeof size);
  whole += bytes;
  for (std::size_t done = 0; done < whole.size();) {
    const ssize_t sent = ::send(socket_, whole.data() + done, whole.size() - done, MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) {
      return false;
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(sent, 0));
  }
  return true;
}

MesherProcess::ReceiveResult MesherProcess::receive_frame(int milliseconds, std::size_t most,
                                                          std::string& frame) {
  const auto whole = [&] {
    std::size_t size = 0;
    if (received_.size() < sizeof size) {
      return ReceiveResult::nothing;
    }
    std::memcpy(&size, received_.data(), sizeof size);
    if (size > most) {
      return ReceiveResult::too_long;
    }
    if (received_.size() < sizeof size + size) {
      return ReceiveResult::nothing;
    }
    frame = received_.substr(sizeof size, size);
    received_.erase(0, sizeof size + size);
    return ReceiveResult::frame;
  };
  if (const ReceiveResult news = whole(); news != ReceiveResult::nothing) {
    return news;
  }
  std::array<pollfd, 2> ends{pollfd{socket_, POLLIN, 0}, pollfd{words_end_, POLLIN, 0}};
  if (poll(ends.data(), ends.size(), milliseconds) <= 0) {
    return ReceiveResult::nothing;
  }
  if (ends[1].revents != 0) {
    take_printed();
  }
  if (ends[0].revents == 0) {
    return ReceiveResult::nothing;
  }
  static constexpr std::size_t chunk = std::size_t{1} << 18U;
  const std::size_t filled = received_.size();
  received_.resize(filled + chunk);
  const ssize_t got = recv(socket_, received_.data() + filled, chunk, MSG_DONTWAIT);
  received_.resize(filled + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) {
    return ReceiveResult::gone;
  }
  return whole();
}

double MesherProcess::processor_time() const {
  clockid_t clock{};
  timespec now{};
  if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &now) != 0) {
    return 0.0;
  }
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool MesherProcess::is_sleeping() const {
  std::ifstream file(fmt::format("/proc/{}/stat", pid_));
  std::string line;
  std::getline(file, line);
  // The name of the program stands in brackets before the letter of its state (proc_pid_stat(5)).
  const std::size_t at = line.rfind(')');
  return at != std::string::npos && line.substr(at + 1, 2) == " S";
}

std::optional<std::size_t> MesherProcess::peak_memory() const {
  return base::peak_memory_of_process(std::to_string(pid_));
}

void MesherProcess::take_printed() {
  std::array<char, 4096> some{};
  for (ssize_t got = 0; (got = read(words_end_, some.data(), some.size())) > 0;) {
    words_.append(some.data(), static_cast<std::size_t>(got));
    if (words_.size() > 2 * most_words) {
      words_.erase(0, words_.size() - most_words);
    }
  }
}

std::string MesherProcess::take_output() {
  take_printed();
  return std::exchange(words_, {});
}

int MesherProcess::end() {
  if (!status_) {
    int status = 0;
    // one that has ended by itself keeps its own status
    kill(pid_, SIGKILL);
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    status_ = status;
  }
  return *status_;
}

} // namespace spricka::mesh
