// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/fill.hpp"
#include "mesh/link/mesher_limits.hpp"
#include "mesh/link/mesher_link.hpp"
#include "mesh/link/mesher_process.hpp"
#include "mesh/link/mesher_request.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <thread>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spricka::test_mesher {
namespace {

namespace fs = std::filesystem;

/// What the mesher does with a script that nobody has looked through before.
mesh::MesherAnswer unseen(const std::string& text) {
  mesh::MesherImportRequest import;
  import.name = "unseen.geo";
  import.text = text;
  import.script = true;
  return mesh::request_from_mesher(mesh::encode_import_request(import));
}

mesh::GmshModel model_of(const mesh::MesherAnswer& answer) {
  EXPECT_EQ(answer.end, mesh::MesherOutcome::answered) << answer.trouble;
  mesh::ByteReader in(answer.frame);
  mesh::GmshModel model;
  EXPECT_EQ(in.read_value<mesh::MesherFrameKind>(), mesh::MesherFrameKind::model);
  EXPECT_TRUE(mesh::decode_model_answer(in, model));
  return model;
}

class Mesher : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("spricka-mesher-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override {
    fs::remove_all(folder_);
    mesh::mesher_limits() = before_;
    mesh::end_mesher_process();
  }
  [[nodiscard]] std::string made() const { return (folder_ / "made").string(); }

  fs::path folder_;
  mesh::MesherLimits before_ = mesh::mesher_limits();
};

// The second wall: words that are refused by name do nothing where they pass unseen.
TEST_F(Mesher, StartsNoProgram) {
  for (const char* call : {"SystemCall", "NonBlockingSystemCall"}) {
    const mesh::MesherAnswer answer = unseen(std::string(call) + " \"touch " + made() + "\";\n");
    EXPECT_EQ(answer.end, mesh::MesherOutcome::forbidden) << call;
    EXPECT_NE(answer.trouble.find("start a program"), std::string::npos) << answer.trouble;
  }
  EXPECT_EQ(unseen("OnelabRun(\"foo\", \"/bin/touch " + made() + " \");\n").end,
            mesh::MesherOutcome::forbidden);
  EXPECT_FALSE(fs::exists(made()));
}

TEST_F(Mesher, WritesAndReadsNoFile) {
  std::ofstream(folder_ / "secret.geo") << "Error(\"the secret\");\n";
  const std::string secret = (folder_ / "secret.geo").string();
  for (const std::string& statement :
       {"Printf(\"x\") > \"" + made() + "\";", "Printf(\"x\") >> \"" + made() + "\";",
        "Merge \"" + secret + "\";", "Include \"" + secret + "\";",
        "Point(1) = {0, 0, 0}; Save \"" + made() + ".msh\";"}) {
    const mesh::GmshModel model = model_of(unseen(statement + "\n"));
    EXPECT_FALSE(model.errors.empty() && model.dim > 0) << statement;
    for (const std::string& line : model.errors) {
      EXPECT_EQ(line.find("the secret"), std::string::npos) << line;
    }
  }
  EXPECT_FALSE(fs::exists(made()));
  EXPECT_FALSE(fs::exists(made() + ".msh"));
}

TEST_F(Mesher, ItsEndIsNotOurs) {
  EXPECT_EQ(unseen("Exit;\n").end, mesh::MesherOutcome::left);
  const mesh::GmshModel model = model_of(unseen("Point(1) = {0, 0, 0};\n"));
  EXPECT_TRUE(model.errors.empty());
  EXPECT_EQ(model.dim, 0);
}

TEST_F(Mesher, TimeIsLimited) {
  mesh::mesher_limits().seconds = 0.8;
  const mesh::MesherAnswer answer = unseen("For i In {0:1e12}\n a = i;\nEndFor\n");
  EXPECT_EQ(answer.end, mesh::MesherOutcome::no_time);
  EXPECT_NE(answer.trouble.find("reading took more than"), std::string::npos) << answer.trouble;
}

/// The only child of this process.
pid_t child() {
  std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
  pid_t pid = 0;
  children >> pid;
  return pid;
}

/// Waits until something is so, for 10 s at most.
bool becomes(const std::function<bool()>& so) {
  for (int i = 0; i < 1000 && !so(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return so();
}

// What keeps a mesher from the processor takes none of its time: it is stopped for longer than it
// may wait, as it would be by other work on the machine.
TEST_F(Mesher, TimeWithoutAProcessorIsNotItsOwn) {
  mesh::end_mesher_process();
  mesh::mesher_limits().waiting = 0.2;
  model_of(unseen("Point(1) = {0, 0, 0};\n"));
  const pid_t mesher = child();
  ASSERT_GT(mesher, 0);
  kill(mesher, SIGSTOP);
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    kill(mesher, SIGCONT);
  });
  model_of(unseen("Point(1) = {0, 0, 0};\n"));
  later.join();
}

TEST_F(Mesher, ItIsSeenToWait) {
  mesh::end_mesher_process();
  const auto process = mesh::MesherProcess::start(std::size_t{2} << 30U);
  EXPECT_TRUE(becomes([&] { return process->is_sleeping(); })); // for its first request
  kill(child(), SIGSTOP);
  EXPECT_TRUE(becomes([&] { return !process->is_sleeping(); }));
}

TEST_F(Mesher, MemoryIsLimited) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "its shadow is larger than any limit";
#endif
  mesh::end_mesher_process();
  mesh::mesher_limits().memory = std::size_t{300} << 20U;
  EXPECT_EQ(unseen("Physical Curve(\"B\") = {10:4294967297};\n").end,
            mesh::MesherOutcome::no_memory);
}

/// A quarter of a ring, divided finely along its rim.
mesh::PlaneRegion quarter() {
  mesh::PlaneRegion region;
  std::vector<int> loop;
  constexpr int count = 24;
  for (int i = 0; i <= count; ++i) {
    const double t = 0.5 * std::numbers::pi * i / count;
    loop.push_back(static_cast<int>(region.points.size()));
    region.points.emplace_back(std::cos(t), std::sin(t));
  }
  for (int i = 8; i >= 0; --i) {
    const double t = 0.5 * std::numbers::pi * i / 8;
    loop.push_back(static_cast<int>(region.points.size()));
    region.points.emplace_back(0.4 * std::cos(t), 0.4 * std::sin(t));
  }
  region.boundaries.push_back(loop);
  return region;
}

mesh::Grading sizes() {
  mesh::Grading size;
  size.add_size_source({0.4, 0.0}, 0.03);
  size.add_size_source({0.0, 1.0}, 0.1);
  return size;
}

double area(const mesh::PlaneRegion& region, const mesh::TriangleFill& filling) {
  const auto at = [&](int n) {
    const auto i = static_cast<std::size_t>(n);
    return i < region.points.size() ? region.points[i] : filling.added[i - region.points.size()];
  };
  double sum = 0.0;
  for (const auto& t : filling.cells) {
    const base::Vec2 a = at(t[1]) - at(t[0]);
    const base::Vec2 b = at(t[2]) - at(t[0]);
    sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return sum;
}

bool same(const mesh::TriangleFill& a, const mesh::TriangleFill& b) {
  return a.cells == b.cells && a.added.size() == b.added.size() &&
         std::equal(a.added.begin(), a.added.end(), b.added.begin(),
                    [](const base::Vec2& p, const base::Vec2& q) {
                      return p.x() == q.x() && p.y() == q.y();
                    });
}

TEST_F(Mesher, FillsTheSameAfterTroubleOfAnyKind) {
  const mesh::PlaneRegion region = quarter();
  const mesh::TriangleFill first = mesh::fill_triangles(region, sizes());
  ASSERT_TRUE(first.trouble.empty()) << first.trouble;
  double polygon = 0.0;
  const std::vector<int>& loop = region.boundaries.front();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const base::Vec2& p = region.points[i];
    const base::Vec2& q = region.points[(i + 1) % loop.size()];
    polygon += 0.5 * (p.x() * q.y() - p.y() * q.x());
  }
  EXPECT_NEAR(area(region, first), polygon, 1e-12);
  EXPECT_TRUE(same(first, mesh::fill_triangles(region, sizes())));
  unseen("Exit;\n");
  EXPECT_TRUE(same(first, mesh::fill_triangles(region, sizes())));
  model_of(unseen("Mesh.Algorithm = 6; Point(1) = {zz, 0, 0};\nMesh.MeshSizeFactor = 3;\n"));
  EXPECT_TRUE(same(first, mesh::fill_triangles(region, sizes())));
}

// Whoever forks has another one, and the first goes on as if nothing were.
TEST_F(Mesher, BelongsToOneProcess) {
  const mesh::PlaneRegion region = quarter();
  const mesh::TriangleFill first = mesh::fill_triangles(region, sizes());
  const pid_t child = fork();
  if (child == 0) {
    const bool good = same(first, mesh::fill_triangles(region, sizes()));
    mesh::end_mesher_process();
    _exit(good ? 0 : 1);
  }
  int status = 1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(same(first, mesh::fill_triangles(region, sizes())));
  mesh::end_mesher_process();
  EXPECT_EQ(waitpid(-1, &status, WNOHANG), -1); // no zombie, no process
  EXPECT_EQ(errno, ECHILD);
}

/// From now on the kernel has no seccomp filters for this process and those it starts.
void take_seccomp_away() {
  const std::array<sock_filter, 4> code{{
      {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
      {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_seccomp},
      {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | EINVAL},
      {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
  }};
  const sock_fprog program{static_cast<unsigned short>(code.size()),
                           const_cast<sock_filter*>(code.data())};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
      prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
    _exit(2);
  }
}

// Without a way to lock the mesher in no script is run; what is our own is filled all the same.
TEST_F(Mesher, WithoutASandboxNoScriptIsRun) {
  const pid_t child = fork();
  if (child == 0) {
    take_seccomp_away();
    const mesh::MesherAnswer answer = unseen("SystemCall \"touch " + made() + "\";\n");
    const bool refused =
        answer.end == mesh::MesherOutcome::answered &&
        answer.frame.front() == static_cast<char>(mesh::MesherFrameKind::no_sandbox);
    const bool filled = mesh::fill_triangles(quarter(), sizes()).trouble.empty();
    mesh::end_mesher_process();
    _exit(refused && filled ? 0 : 1);
  }
  int status = 1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(fs::exists(made()));
}

} // namespace
} // namespace spricka::test_mesher
