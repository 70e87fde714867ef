// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

/// What a deck's joint is made of, as the ladder needs it: which bodies have cracks, which are
/// loaded, which surfaces meet.
namespace spricka::program {

/// One side of a contact.
struct JointSide {
  std::string net; ///< upper case; empty: outside every net, or of several
};

struct JointContact {
  std::string name; ///< upper case
  JointSide slave;
  JointSide master; ///< of a rigid target without a net
  bool rigid = false;
  bool bonded = false;
  bool rubs = false;
  bool presses = false; ///< it has an interference
  bool given_gap = false;
  bool mounted = false; ///< a step mounts or dismounts it
};

struct Joint {
  std::vector<JointContact> contacts;
  std::set<std::string> cracked; ///< nets with a crack
  std::set<std::string> loaded;  ///< nets with a load of forces
  std::set<std::string> heated;  ///< nets whose temperature changes
  bool friction = false;         ///< also between faces of a crack
};

/// Reads off a model which nets meet in contacts, and which are cracked, loaded or heated.
Joint analyse_joint(const model::Model& model);

/// Nets that are there only to press on those with cracks: they meet them by contacts, one behind
/// the other, and nothing else is known of them. Empty without cracks.
std::set<std::string> pressing_nets(const Joint& joint);

/// A surface of the plane that is straight or round.
struct AnalyticalSurface {
  bool round = false;
  base::Vec3 first = base::Vec3::Zero();  ///< end of a straight one, centre of a round one
  base::Vec3 second = base::Vec3::Zero(); ///< other end
  double radius = 0.0;
  bool body_outside = false; ///< of a round one: its body lies outside the circle
  bool body_left = false;    ///< of a straight one: its body lies left of first to second
};

/// Empty for other surfaces, and in space.
std::optional<AnalyticalSurface> fit_analytical_surface(const model::Model& model,
                                                        const std::string& contact, bool slave);

} // namespace spricka::program
