// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"
#include "base/units.hpp"
#include "model/contacts.hpp"
#include "model/crack_growth.hpp"
#include "model/cracks.hpp"
#include "model/freedoms.hpp"
#include "model/growth_test.hpp"
#include "model/loads.hpp"
#include "model/materials.hpp"
#include "model/mesh.hpp"
#include "model/mirror_plane.hpp"
#include "model/requests.hpp"
#include "model/steps.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The model: plain data, as the deck describes it, after all references are resolved. Lengths,
/// forces and stresses are in deck units (stress = force / length^2), angles in radians. Every
/// entity keeps the place in the deck that made it. Nothing here knows a card.
namespace spricka::model {

struct Net {
  std::string name; ///< empty: what stands outside every $NET
  base::Span span;
};

/// A card that is understood but whose analysis this version does not have.
struct Unavailable {
  std::string what;
  base::Span span;
};

struct Model {
  std::string title;
  base::UnitSystem units;
  std::vector<std::pair<std::string, double>> parameters;

  Mesh mesh;                        ///< the host: without cracks
  std::vector<MirrorPlane> mirrors; ///< of which one side is modelled
  std::vector<Net> nets;
  std::vector<Material> materials;
  std::vector<Property> properties;
  std::vector<Freedom> freedoms;
  std::vector<Mpc> mpcs;
  std::vector<LoadCase> cases;
  std::vector<Rigid> rigids;
  std::vector<Contact> contacts;
  std::vector<Crack> cracks;
  std::vector<TipNet> tip_nets; ///< at most one for each crack
  std::vector<Vce> vces;        ///< at most one for each crack
  std::vector<Step> steps;
  std::optional<Growth> growth;
  std::vector<Output> outputs;
  std::vector<Check> checks;
  std::optional<Restart> restart;
  std::vector<Sweep> sweeps; ///< several multiply, the last varies fastest
  Control control;
  std::vector<std::string> tasks; ///< empty: the default chain
  std::vector<Unavailable> unavailable;
  std::vector<std::string> imported_files; ///< paths of what $IMPORT brought in
  std::vector<LoadPath> load_paths;
  std::vector<Spectrum> spectra;
  std::vector<GrowthTest> tests;

  [[nodiscard]] const Property& property_of(const Mesh& m, base::ElementId e) const {
    return properties[m.property[e.index()].index()];
  }
  [[nodiscard]] const Material& material_of(const Mesh& m, base::ElementId e) const {
    return materials[property_of(m, e).material.index()];
  }
};

/// Whether the mesh is a section through bodies about the axis x = 0; then all of it is.
inline bool axisymmetric(const Model& model) {
  return !model.properties.empty() && model.properties.front().state == State::axisymmetric;
}

} // namespace spricka::model
