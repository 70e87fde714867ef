// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "mesh/step_solids.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace spricka::deck {

/// A data line that names faces of solids.
struct NamedFaces {
  std::string name;                      ///< of their set
  std::vector<std::array<int, 2>> faces; ///< solid and face
  double size = 0.0;                     ///< of the elements there, in lengths of the deck; 0: none
};

/// Chooses faces of the solids of a STEP file that are meshed: by number (F3 F4), by what they are
/// (CYLINDER 15, PLANE -Z), by where they lie, an expression in x y z rho theta that holds at all
/// points of a face, or by the last two together.
class FaceChoices {
public:
  /// `scale`: a millimetre of the file in lengths of the deck.
  FaceChoices(const mesh::StepFileContents& contents, const mesh::StepMeshRequest& request,
              double scale)
      : contents_(contents), request_(request), scale_(scale) {}

  /// A line "faces = NAME [size]". Empty after an error, which is reported, as where no face is so.
  [[nodiscard]] std::optional<NamedFaces> read_row(DeckContext& context,
                                                   const grammar::DataRow& row) const;
  [[nodiscard]] double scale() const { return scale_; }

private:
  using Fields = std::vector<grammar::CardField>;
  [[nodiscard]] std::optional<std::vector<std::array<int, 2>>>
  faces_by_number(DeckContext& context, const Fields& fields) const;
  [[nodiscard]] std::optional<std::vector<std::array<int, 2>>>
  faces_by_shape(DeckContext& context, const Fields& fields, base::SourceSpan row) const;
  /// "its cylinders have the radii 12, 15": of a kind, for a message.
  [[nodiscard]] std::string radii_hint(const std::string& kind) const;

  const mesh::StepFileContents& contents_;
  const mesh::StepMeshRequest& request_;
  double scale_;
};

} // namespace spricka::deck
