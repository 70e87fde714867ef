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

using InpLabelSet = InpData::InpLabelSet;

/// What the readers of single keywords share.
struct InpReaderContext {
  InpLineReader& text;
  InpData& data;
  std::function<void(InpLocation, std::string, std::string)> complain; ///< place, words, hint
  std::map<std::string, std::size_t> node_sets{};                      ///< by name in upper case
  std::map<std::string, std::size_t> element_sets{};
  std::string instance{}; ///< name of the one *INSTANCE
  bool in_assembly = false;
  bool in_step = false;
  bool lenient = false;     ///< SKIP=ALL: what is not understood is listed
  std::size_t included = 0; ///< ranges that sets took from other sets so far

  /// Lists a card, or a part of what it says, that is passed over.
  void leave_out(const std::string& what, InpLocation at) const {
    InpData::InpLeftOut& kind = data.left_out[what];
    kind.first = kind.count++ == 0 ? at : kind.first;
  }
};

/// Reads the data lines of one keyword.
class InpKeywordReader {
public:
  InpKeywordReader(InpReaderContext& shared, InpKeyword key)
      : text_(shared.text), data_(shared.data), shared_(shared), key_(std::move(key)) {}
  virtual ~InpKeywordReader() = default;
  InpKeywordReader(const InpKeywordReader&) = delete;
  InpKeywordReader& operator=(const InpKeywordReader&) = delete;

  /// The line that the text stands at.
  virtual void read_line() = 0;
  /// At the next keyword.
  virtual void finish_keyword() {}

protected:
  void complain(InpLocation at, std::string words, std::string hint = {}) const {
    shared_.complain(at, std::move(words), std::move(hint));
  }
  void complain_here(std::string words) const { complain(text_.location(), std::move(words)); }
  /// A complaint at the keyword; with SKIP=ALL `what` of it is listed as left out.
  void complain_or_leave_out(std::string_view what, std::string words) const;
  /// Parameters the keyword is understood with; others could change its meaning. False after a
  /// complaint.
  bool only(std::initializer_list<std::string_view> known) const;
  /// The value of a parameter; a complaint without one.
  bool needs(std::string_view key, std::string& value) const;
  /// The set that a parameter of the keyword names, made at its first use; null without one. The
  /// pointer holds until another set is made.
  InpLabelSet* set_named_by(std::string_view key, std::vector<InpLabelSet>& sets,
                            std::map<std::string, std::size_t>& index) const;
  /// A set by its name, made at its first use; its place in `sets`.
  std::size_t set_of(std::vector<InpLabelSet>& sets, std::map<std::string, std::size_t>& index,
                     const std::string& name) const;
  /// P-1.NAME of the one instance is NAME.
  [[nodiscard]] std::string plain(std::string_view name) const;

  InpLineReader& text_;
  InpData& data_;
  InpReaderContext& shared_;
  InpKeyword key_;
};

// The reader of a keyword; empty for those that are not of this kind.
std::unique_ptr<InpKeywordReader> make_inp_mesh_reader(InpReaderContext& shared,
                                                       const InpKeyword& key);
/// The reader of *NSET, *ELSET or *SURFACE; null for other keywords.
std::unique_ptr<InpKeywordReader> make_inp_set_reader(InpReaderContext& shared,
                                                      const InpKeyword& key);
/// With SKIP=ALL the reader of contact, ties, supports and loads, in steps too; null for others.
std::unique_ptr<InpKeywordReader> make_inp_joint_reader(InpReaderContext& shared,
                                                        const InpKeyword& key);
/// The reader of materials, sections and *EQUATION; null for other keywords.
std::unique_ptr<InpKeywordReader> make_material_and_equation_reader(InpReaderContext& shared,
                                                                    const InpKeyword& key);

} // namespace spricka::mesh
