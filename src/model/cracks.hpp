// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"
#include "base/vec.hpp"

#include <optional>
#include <string>
#include <vector>

/// Cracks, the nets round their tips and how K is taken.
namespace spricka::model {

enum class CrackKind { path, free, front };
enum class CrackState { stress, strain, automatic };

struct Crack {
  std::string name;
  CrackKind kind = CrackKind::path;
  base::NodeSetId path;           ///< ordered nodes: from the mouth (path), of the front (front)
  base::NetId net;                ///< the net a free crack cuts
  std::vector<base::Vec3> points; ///< free crack: from the mouth (or first tip) on
  bool smooth = false;            ///< free crack: a smooth curve through the points
  std::optional<double> angle;    ///< free crack with one point [rad], from +x
  std::optional<double> a0;       ///< first length [length]
  int normal = 1;                 ///< of the plane of a 3D crack: 0 x, 1 y, 2 z
  CrackState state = CrackState::automatic;
  bool faces_in_contact = true;
  double mu = 0.0;
  /// Its crack faces, "C1.LEFT" and "C1.RIGHT", seen along the crack: empty in the host, filled in
  /// the mesh of each length. One of them stays empty on a symmetry line.
  base::FaceSetId left, right;
  base::Span span;
};

enum class Join { conforming, transition };

/// How the patch round a tip is made; what is empty follows the crack (see mesh/cut/patch.hpp).
struct TipNet {
  base::CrackId crack;
  std::optional<double> radius; ///< of the rosette [length]
  std::optional<double> size;   ///< of the tip elements [length]
  int rings = 5;
  int sectors = 24; ///< of a full circle
  bool quarter_point = true;
  Join join = Join::conforming;
  bool patch = true;
  std::optional<double> tolerance; ///< of K, as a part of it
  double finer = 1.0;              ///< divides the sizes of the patch's elements
  base::Span span;
};

struct Vce {
  base::CrackId crack;
  std::optional<double> shift; ///< finite shift in tip element sizes; empty: analytic derivative
  std::vector<int> domains;    ///< rings that move rigidly, one value of K each; empty: default
  bool opening = false;        ///< K from the opening of the faces beside it, as a check
  base::Span span;
};

} // namespace spricka::model
