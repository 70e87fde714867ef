// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/gmsh_session.hpp"

#include <gmsh.h>

#include <string_view>

namespace spricka::mesher {
namespace {

std::mutex& turn() {
  static std::mutex mutex;
  return mutex;
}

} // namespace

GmshSession::GmshSession() : turn_(turn()) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.AbortOnError", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::option::setNumber("Mesh.MaxNumThreads1D", 1);
  gmsh::option::setNumber("Mesh.MaxNumThreads2D", 1);
  gmsh::option::setNumber("Mesh.MaxNumThreads3D", 1);
  gmsh::option::setNumber("Mesh.SecondOrderLinear", 0);
  // our library has the elements without face nodes in every shape
  gmsh::option::setNumber("Mesh.SecondOrderIncomplete", 1);
  gmsh::logger::start();
}

GmshSession::~GmshSession() {
  gmsh::logger::stop();
  gmsh::finalize();
}

namespace {

std::vector<std::string> lines_marked(std::string_view mark) {
  std::vector<std::string> log;
  gmsh::logger::get(log);
  std::vector<std::string> result;
  for (const std::string& line : log) {
    if (line.starts_with(mark)) {
      result.push_back(line.substr(mark.size()));
    }
  }
  return result;
}

} // namespace

std::vector<std::string> GmshSession::errors() {
  return lines_marked("Error: ");
}

std::vector<std::string> GmshSession::warnings() {
  return lines_marked("Warning: ");
}

} // namespace spricka::mesher
