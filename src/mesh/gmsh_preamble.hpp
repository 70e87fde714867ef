// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/gmsh_import.hpp"

#include <filesystem>
#include <string>

namespace spricka::mesh {

/// A temporary script that sets the deck's parameters, in upper and lower case, and then includes
/// the user's file: gmsh's DefineConstant leaves a name alone that has a value. (Names set on
/// gmsh's command line would do the same, but outlive the session.)
class GmshPreamble {
public:
  explicit GmshPreamble(const ImportRequest& request);
  ~GmshPreamble();
  GmshPreamble(const GmshPreamble&) = delete;
  GmshPreamble& operator=(const GmshPreamble&) = delete;
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] std::string path() const { return path_.string(); }

private:
  std::filesystem::path path_;
  bool complete_ = false;
};

} // namespace spricka::mesh
