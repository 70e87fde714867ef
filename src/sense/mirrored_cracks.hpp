// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <string>

namespace spricka::sense {

/// The plane x, y or z = `at`.
struct Mirror {
  int axis = 0;
  double at = 0.0;   ///< [length]
  double size = 0.0; ///< of the whole model [length]

  [[nodiscard]] base::Vec3 operator()(base::Vec3 x) const {
    x[axis] = 2.0 * at - x[axis];
    return x;
  }
};

/// Whether a load on the faces of a crack has the other as its image: pressures of cracks that are
/// images, alike at points of the crack and their images. Of tractions it is not asked.
bool mirrored_face_load(const model::Model& model, const Mirror& mirror, const model::Load& one,
                        const model::Load& other);

/// The crack that a load acts on the faces of; null: none.
const model::Crack* crack_of_faces(const model::Model& model, const model::Load& load);

/// Whether each crack has a crack that is its mirror image, itself or another, and both grow or
/// neither; else what stands against it.
std::string against_cracks(const model::Model& model, const Mirror& mirror);

} // namespace spricka::sense
