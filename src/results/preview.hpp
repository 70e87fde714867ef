// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/units.hpp"
#include "base/vec.hpp"
#include "results/imported_geometry.hpp"
#include "results/load_total.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// What is known of a deck before it is solved, as plain records: `check` shows nothing else.
namespace spricka::results {

/// A net of the mesh with the cracks of the first length in it.
struct NetPreview {
  std::string name;
  std::size_t nodes = 0;
  std::size_t elements = 0;
  std::vector<std::pair<std::string, std::size_t>> types;
  std::size_t local = 0; ///< freedoms by class
  std::size_t external = 0;
  std::size_t suppressed = 0;
  std::size_t prescribed = 0;
  std::size_t dependent = 0;
};

/// The element that is worst by one measure.
struct WorstElementPreview {
  std::string where;   ///< "host" or "crack patches"
  std::string measure; ///< "scaled Jacobian", "aspect", "smallest angle", "largest angle"
  double value = 0.0;  ///< angles in degrees
  std::string net;
  base::Label element = 0;
  base::Vec3 at = base::Vec3::Zero();
};

struct ContactPairPreview {
  std::string name;
  bool rigid = false; ///< the master is: it has no faces
  bool declared = false;
  double declared_gap = 0.0; ///< of a declared one, negative for a fit [length]
  double gap_low = 0.0;      ///< measured along the normals of the side with the multipliers
  double gap_high = 0.0;
  double gap_mean = 0.0;
  double angle = 0.0; ///< largest between the normals [deg]
  std::size_t slave_edges = 0, slave_facing = 0;
  std::size_t master_edges = 0, master_facing = 0;
  double slave_overhang = 0.0; ///< part of its length that sees no target
  double master_overhang = 0.0;
  std::string pairing;
  std::string choice; ///< the side that carries the multipliers, and why
  std::size_t rows = 0;
  int merged = 0;
};

/// Rigid modes of a body: how many, and what holds them.
struct BodyRestraintPreview {
  std::string name;
  std::size_t nodes = 0;
  std::size_t elements = 0;
  int modes = 0;
  int by_supports = 0;
  int by_contact = 0; ///< that some contact of the deck opens by; whether it holds, loads decide
  std::vector<std::string> by_nothing;
};

/// A front of a crack; in the plane a tip.
struct FrontPreview {
  std::string name;
  std::string kind; ///< of a crack in space: embedded, surface, corner, through
  double a = 0.0;   ///< in space the radius of a circle as large as the crack
  base::Vec3 mouth = base::Vec3::Zero(); ///< in the plane
  base::Vec3 at = base::Vec3::Zero();    ///< the tip, or half way along the front
  double length = 0.0;                   ///< of the front
  std::size_t elements = 0;              ///< along it
  double radius = 0.0;                   ///< of the rosette, or of the tube the smallest
  double size = 0.0;                     ///< of the elements at the front
};

/// One crack length of the growth plan.
struct CrackLengthPreview {
  int number = 1;
  double a = 0.0;
  std::size_t nodes = 0;
  std::size_t elements = 0;
  std::size_t replaced = 0; ///< host elements
  std::size_t fresh = 0;    ///< elements that stand in their place
  std::size_t rows = 0;     ///< of all contacts
  std::size_t unknowns = 0; ///< of the nets factorised at this length
  std::size_t externals = 0;
  double factor_entries = 0.0;           ///< as DeckPreview::exact says
  double flops = 0.0;                    ///< of the factorisations, likewise
  double memory = 0.0;                   ///< [bytes] forecast of the largest need up to here
  double seconds = 0.0;                  ///< [s] forecast of the CPU time
  std::vector<std::string> engines = {}; ///< of nets that Cholesky in core does not do, and why
  int condensed = 0;                     ///< nets
  int reused = 0;
  std::vector<FrontPreview> fronts;
  std::vector<std::string> notes;
};

/// A plane in which all bodies are their own mirror image.
struct SymmetryPlanePreview {
  int axis = 0;             ///< 0 x, 1 y, 2 z: across it
  double at = 0.0;          ///< coordinate [length]
  std::string against;      ///< what is not mirrored; empty: half a model does
  std::string no_half = {}; ///< why $SYMMETRY can't make that half all the same
};

struct DeckPreview {
  std::string deck;
  std::string title;
  base::UnitSystem units;
  int dim = 2;
  std::vector<NetPreview> nets;
  std::vector<WorstElementPreview> quality;
  std::size_t inside_out = 0; ///< elements
  std::vector<ContactPairPreview> pairs;
  std::vector<BodyRestraintPreview> bodies;
  std::vector<LoadTotal> loads; ///< of each case that has forces
  std::vector<SymmetryPlanePreview> mirrors;
  std::vector<CrackLengthPreview> lengths;
  ReportedGeometry geometry;
  std::vector<std::string> steps;
  /// Contacts that a step behind the first mounts, each with that step: absent before it.
  std::vector<std::pair<std::string, std::string>> mounted_later;
  std::vector<std::string> sweep; ///< "001: delta = 0.084", one for each point
  std::vector<std::string> warnings;
  bool exact = false;          ///< fill and flops are those of the matrices; else by a law
  double flop_rate = 0.0;      ///< [flop/s] one core, measured
  double flops = 0.0;          ///< of all lengths
  double memory = 0.0;         ///< [bytes] forecast of the run's largest need
  double seconds = 0.0;        ///< [s] forecast of the run's CPU time
  double machine_memory = 0.0; ///< [bytes]
};

} // namespace spricka::results
