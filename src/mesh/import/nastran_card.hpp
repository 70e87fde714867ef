// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/label.hpp"
#include "mesh/import/nested_text_files.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::mesh {

struct NastranField {
  std::string text; ///< without blanks at its ends
  InpLocation place;
  std::size_t column = 0; ///< from 1
};

/// An entry of Nastran bulk data with all lines that continue it.
struct NastranCard {
  std::string name; ///< upper case, without the star of a large field
  /// Fields 2 to 9 of the first line, then those of each further one: whatever the format, eight a
  /// line as in small fields.
  std::vector<NastranField> fields;
  InpLocation place;
  /// What a comment before a property card calls it; Patran and Simcenter write such.
  std::string title;
};

/// A number as Nastran writes it: 1.5, 1.5E-3, 1.5D-3, 1.5-3, 7.+5. Empty for other text.
std::optional<double> parse_nastran_real(std::string_view text);

/// Reads the entries of bulk data one by one: small, large and free fields, tabs, continuations,
/// INCLUDE. Executive and case control before BEGIN BULK are passed over, ENDDATA ends all.
class NastranCardReader {
public:
  using Complain = std::function<void(InpLocation, std::string)>;

  /// Complaints: lines that continue none, that are to be continued and are not, and what
  /// NestedTextFiles complains of.
  NastranCardReader(const std::filesystem::path& file, Complain complain);

  /// Moves to the next entry; false at the end.
  bool next_card();
  [[nodiscard]] const NastranCard& card() const { return card_; }
  /// Names that comments of ANSA, HyperMesh or Femap give to properties, so far.
  [[nodiscard]] const std::map<base::Label, std::string>& property_names() const {
    return property_names_;
  }
  /// Names that comments of HyperMesh give to sets, so far.
  [[nodiscard]] const std::map<base::Label, std::string>& set_names() const { return set_names_; }
  /// Paths of the files met so far, as places count them.
  [[nodiscard]] std::vector<std::string> file_paths() const { return files_.file_paths(); }

private:
  /// One line, taken apart.
  struct Line {
    bool continues = false;
    bool large = false;
    std::string first; ///< name, or the mark of a line that continues, without + or *
    std::string mark;  ///< field 10
    std::vector<NastranField> fields;
    InpLocation place;
  };

  bool next_bulk_line();
  bool next_physical_line();
  void take_comment(std::string_view text);
  void take_first_field(std::string_view text);
  void split_fixed(std::string_view text);
  void split_free(std::string_view text);
  void include(std::string_view text);
  void append_line();
  void check_continuation_end(const std::string& mark, InpLocation at);

  Complain complain_;
  NestedTextFiles files_;
  bool in_bulk_ = true;
  bool line_waits_ = false;
  Line line_;
  NastranCard card_;
  std::string title_;
  std::map<base::Label, std::string> property_names_;
  std::map<base::Label, std::string> set_names_;
};

} // namespace spricka::mesh
