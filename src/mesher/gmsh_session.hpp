// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <mutex>
#include <string>
#include <vector>

namespace spricka::mesher {

/// The gmsh library at work with an empty model: silent, one thread, no configuration files, errors
/// collected instead of thrown. Only one session lives at a time (the library is one global state);
/// others wait. Starting costs a few milliseconds, so that each use begins with clean options.
class GmshSession {
public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// What gmsh reported as errors so far, in its own words.
  [[nodiscard]] static std::vector<std::string> errors();
  [[nodiscard]] static std::vector<std::string> warnings();

private:
  std::unique_lock<std::mutex> turn_;
};

} // namespace spricka::mesher
