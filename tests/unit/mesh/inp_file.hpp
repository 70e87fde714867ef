// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/inp_import.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace spricka::test {

/// Writes input files into a folder of its own and imports them.
class InpFile : public testing::Test {
protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("spricka-inp-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// True without an error; the result is in model_ and diagnostics_.
  bool import(const std::string& text, const std::string& prefix = "") {
    write("a.inp", text);
    mesh::ImportRequest request;
    request.file = folder_ / "a.inp";
    request.net = base::NetId(std::size_t{0});
    request.prefix = prefix;
    request.renames = renames_;
    request.scale = scale_;
    request.skip = skip_;
    request.element_set = element_set_;
    model_ = {};
    diagnostics_ = {};
    physics_ = mesh::import_inp(model_.mesh, request, diagnostics_);
    mesh::append_materials_and_equations(model_, physics_);
    return !diagnostics_.has_errors();
  }
  /// All messages, one a line.
  [[nodiscard]] std::string messages() const {
    std::string all;
    for (const base::Diagnostic& d : diagnostics_.messages()) {
      all += d.code + " " + d.text + " = " + d.hint + "\n";
    }
    return all;
  }
  [[nodiscard]] const model::NodeSet& nodes(const std::string& name) const {
    return *std::find_if(model_.mesh.node_sets.begin(), model_.mesh.node_sets.end(),
                         [&](const auto& s) { return s.name == name; });
  }
  [[nodiscard]] const model::ElementSet& elements(const std::string& name) const {
    return *std::find_if(model_.mesh.element_sets.begin(), model_.mesh.element_sets.end(),
                         [&](const auto& s) { return s.name == name; });
  }
  [[nodiscard]] std::vector<base::Label> labels(const std::string& node_set) const {
    std::vector<base::Label> result;
    for (const base::NodeId n : nodes(node_set).nodes) {
      result.push_back(model_.mesh.node_label[n.index()]);
    }
    return result;
  }

  std::filesystem::path folder_;
  double scale_ = 1.0;
  mesh::InpSkip skip_ = mesh::InpSkip::nothing;
  std::string element_set_;
  std::vector<std::pair<std::string, std::string>> renames_;
  model::Model model_;
  mesh::ImportedMaterialsAndEquations physics_;
  base::Diagnostics diagnostics_;
};

/// Elements 10 (LEFT HALF) and 20 (RIGHT) side by side on x 0 .. 2, y 0 .. 1; eighteen lines.
inline const std::string two_quads = R"(*Heading
 a title, with commas
** a comment
*NODE, nset=all
 1, 0., 0.
 2, 1.0D0, 0.
3,2,0,0
 4, +0., 1.
 5, 1., 1.
 6, 2., 1.
 99, 50., 50.
*Element, type = CPS4R ,
  elset=Left half
 10, 1,2,
 5,4
*ELEMENT,TYPE=CPS4,ELSET=RIGHT
 20, 2,3,6,5,
)";

} // namespace spricka::test
