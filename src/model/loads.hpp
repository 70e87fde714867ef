// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"
#include "base/id.hpp"
#include "base/source.hpp"

#include <string>
#include <vector>

/// Loads, in cases.
namespace spricka::model {

enum class LoadType {
  force,        ///< per node of a node set [force]
  resultant,    ///< total over a face or element set [force]
  traction,     ///< per area of a face set [stress]
  pressure,     ///< against the outer normal of a face set [stress]
  body,         ///< per volume of an element set [force/length^3]
  bearing,      ///< pin on a bore given by its resultant [force]
  displacement, ///< values of prescribed freedoms [length]
  temperature   ///< [K]
};
enum class BearingShape { uniform, cosine };

struct Load {
  LoadType type = LoadType::force;
  BearingShape shape = BearingShape::uniform;
  base::NodeSetId nodes; ///< exactly one of the three sets is valid
  base::ElementSetId elements;
  base::FaceSetId faces;
  std::vector<base::CompiledExpression> value; ///< 1 to 3 components, fields of x y z
  base::SourceSpan span;
};
/// Whether it acts by forces, not by given displacements or a temperature.
inline bool is_force_load(const Load& load) {
  return load.type != LoadType::displacement && load.type != LoadType::temperature;
}

struct LoadCase {
  std::string name;
  std::vector<Load> loads;
};

} // namespace spricka::model
