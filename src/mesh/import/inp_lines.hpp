// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/inp_data.hpp"

#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::mesh {

using InpLabelSet = InpData::Named<base::Label>;

/// What the readers of single keywords share.
struct InpShared {
  InpText& text;
  InpData& data;
  std::function<void(InpPlace, std::string, std::string)> complain; ///< place, words, hint
  std::map<std::string, std::size_t> node_sets{};                   ///< by name in upper case
  std::map<std::string, std::size_t> element_sets{};
  std::string instance{}; ///< name of the one *INSTANCE
  bool in_assembly = false;
};

/// Reads the data lines of one keyword.
class InpLines {
public:
  InpLines(InpShared& shared, InpKeyword key)
      : text_(shared.text), data_(shared.data), shared_(shared), key_(std::move(key)) {}
  virtual ~InpLines() = default;
  InpLines(const InpLines&) = delete;
  InpLines& operator=(const InpLines&) = delete;

  /// The line that the text stands at.
  virtual void line() = 0;
  /// At the next keyword.
  virtual void finish() {}

protected:
  void complain(InpPlace at, std::string words, std::string hint = {}) const {
    shared_.complain(at, std::move(words), std::move(hint));
  }
  void complain_here(std::string words) const { complain(text_.place(), std::move(words)); }
  /// Parameters the keyword is understood with; others could change its meaning.
  bool only(std::initializer_list<std::string_view> known) const;
  /// The value of a parameter; a complaint without one.
  bool needs(std::string_view key, std::string& value) const;
  /// A set by its name, made at its first use; its place in `sets`.
  std::size_t set_of(std::vector<InpLabelSet>& sets, std::map<std::string, std::size_t>& index,
                     const std::string& name) const;
  /// P-1.NAME of the one instance is NAME.
  [[nodiscard]] std::string plain(std::string_view name) const;

  InpText& text_;
  InpData& data_;
  InpShared& shared_;
  InpKeyword key_;
};

// The reader of a keyword; empty for those that are not of this kind.
std::unique_ptr<InpLines> inp_mesh_lines(InpShared& shared, const InpKeyword& key);
std::unique_ptr<InpLines> inp_set_lines(InpShared& shared, const InpKeyword& key);
std::unique_ptr<InpLines> inp_physics_lines(InpShared& shared, const InpKeyword& key);

} // namespace spricka::mesh
