// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/nastran_bulk.hpp"
#include "mesh/import/nastran_card.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// The fields of one entry, from 0 on, as numbers. What is none is complained of with its line and
/// column; the entry is not sound then.
class NastranFields {
public:
  using Complain = std::function<void(InpLocation, std::string)>;

  NastranFields(const NastranCard& card, const Complain& complain)
      : card_(card), complain_(complain) {}

  [[nodiscard]] const std::string& name() const { return card_.name; }
  [[nodiscard]] InpLocation place() const { return card_.place; }
  [[nodiscard]] std::size_t count() const { return card_.fields.size(); }
  [[nodiscard]] bool is_sound() const { return sound_; }
  [[nodiscard]] std::string_view text(std::size_t at) const;
  [[nodiscard]] bool is_blank(std::size_t at) const { return text(at).empty(); }
  /// The number of a node, element, set ..: positive. `what` names the field.
  base::Label label(std::size_t at, std::string_view what);
  /// A whole number that is not negative, or what a blank field stands for.
  base::Label label_or(std::size_t at, std::string_view what, base::Label otherwise);
  /// A real number, or what a blank field stands for.
  double real_or(std::size_t at, std::string_view what, double otherwise);
  /// Numbers from a field to the end: 3, 5 THRU 9; blank fields are passed over.
  std::vector<NastranBulk::LabelRange> ranges(std::size_t from, std::string_view what);
  /// Complains of the entry.
  void complain(const std::string& words);

private:
  void complain_of(std::size_t at, std::string_view what, std::string_view wanted);

  const NastranCard& card_;
  const Complain& complain_;
  bool sound_ = true;
};

// Each takes an entry of its kind into `bulk`; false for those of others.
/// GRID, GRDSET, coordinate systems, elements of solids, shells and bars, lists of numbers.
bool read_nastran_mesh_card(NastranFields& card, NastranBulk& bulk);
/// PSOLID, PSHELL, properties of bars and springs, MAT1, PARAM.
bool read_nastran_property_card(NastranFields& card, NastranBulk& bulk);
/// Supports and loads; of SPC, SPC1, SPCADD, PLOAD4 and FORCE it takes down where they act.
bool read_nastran_load_card(NastranFields& card, NastranBulk& bulk);

} // namespace spricka::mesh
