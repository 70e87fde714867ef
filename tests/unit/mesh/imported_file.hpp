// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/import/imported_physics.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace spricka::test {

/// Writes files of another program into a folder of its own and imports them.
class ImportedFile : public testing::Test {
protected:
  explicit ImportedFile(std::string name) : name_(std::move(name)) {}

  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("spricka-" + name_ + "-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// True without an error; the result is in model_ and diagnostics_.
  bool import(const std::string& text, const std::string& prefix = "") {
    write(name_, text);
    mesh::ImportRequest request;
    request.file = folder_ / name_;
    request.net = base::NetId(std::size_t{0});
    request.prefix = prefix;
    request.renames = renames_;
    request.scale = scale_;
    request.skip = skip_;
    request.element_set = element_set_;
    model_ = {};
    diagnostics_ = {};
    physics_ = read(request);
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
  /// Of the nodes of a set; none of a set that is not there.
  [[nodiscard]] std::vector<base::Label> labels(const std::string& node_set) const {
    std::vector<base::Label> result;
    for (const model::NodeSet& set : model_.mesh.node_sets) {
      for (const base::NodeId n : set.name == node_set ? set.nodes : std::vector<base::NodeId>()) {
        result.push_back(model_.mesh.node_label[n.index()]);
      }
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

private:
  /// The import of the file's format into model_.
  virtual mesh::ImportedMaterialsAndEquations read(const mesh::ImportRequest& request) = 0;

  std::string name_;
};

} // namespace spricka::test
