// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "program/study/deck_variant.hpp"

#include <set>
#include <string>
#include <vector>

/// What a deck's joint is made of, as the ladder needs it: which bodies have cracks, which are
/// loaded, which surfaces meet.
namespace spricka::program {

/// A contact; names in upper case. A net is empty where a surface lies outside every net, or in
/// several.
struct JointContact {
  std::string name;
  std::string slave_net;
  std::string master_net; ///< of a rigid target empty
  bool rigid = false;
  bool bonded = false;
  bool presses = false; ///< it has an interference
  bool mounted = false; ///< a step mounts or dismounts it
};

struct Joint {
  std::vector<JointContact> contacts;
  std::set<std::string> cracked;   ///< nets with a crack
  std::set<std::string> loaded;    ///< nets with a load of forces
  std::set<std::string> heated;    ///< nets whose temperature changes
  std::set<std::string> supported; ///< nets that are held along x and along y somewhere
  bool friction = false;           ///< also between faces of a crack
};

/// Reads off a model which nets meet in contacts, and which are cracked, loaded or heated.
Joint analyse_joint(const model::Model& model);

/// Nets that are there only to press on those with cracks: they meet them by contacts, one behind
/// the other, and nothing else is known of them. Empty without cracks.
std::set<std::string> find_only_pressing_nets(const Joint& joint);

/// Makes what only presses rigid in `text`: a body that is loaded by a modulus 1e4 times as large,
/// as rigid targets do not move; one that stands in one contact and carries nothing by a rigid
/// target in the place of its surface, where that is straight or round. Fits of such contacts are
/// taken from `steps`, the deck as it was given.
DeckVariant make_pressing_bodies_rigid(const model::Model& model, const Joint& joint,
                                       deck::DeckCardList text, const deck::DeckCardList& steps);

} // namespace spricka::program
