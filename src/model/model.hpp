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
#include "model/interaction_rules.hpp"
#include "model/loads.hpp"
#include "model/materials.hpp"
#include "model/mesh.hpp"
#include "model/mirror_plane.hpp"
#include "model/requests.hpp"
#include "model/steps.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The model: plain data, as the deck describes it, after all references are resolved. Lengths,
/// forces and stresses are in deck units (stress = force / length^2), angles in radians. Every
/// entity keeps the place in the deck that made it. Nothing here knows a card.
namespace spricka::model {

struct NetDefinition {
  std::string name; ///< empty: what stands outside every $NET
  base::SourceSpan span;
};

/// A card that is understood but whose analysis this version does not have.
struct UnimplementedAnalysis {
  std::string what;
  base::SourceSpan span;
};

struct Model {
  std::string title;
  base::UnitSystem units;
  std::vector<std::pair<std::string, double>> parameters;

  Mesh mesh;                        ///< the host: without cracks
  std::vector<MirrorPlane> mirrors; ///< of which one side is modelled
  std::vector<NetDefinition> nets;
  std::vector<ElasticMaterial> materials;
  std::vector<ElementProperty> properties;
  std::vector<NodeSetFreedomRole> freedoms;
  std::vector<Mpc> mpcs;
  std::vector<LoadCase> cases;
  std::vector<RigidTarget> rigids;
  std::vector<Contact> contacts;
  std::vector<CrackDefinition> cracks;
  std::vector<TipMeshSettings> tip_nets;           ///< at most one for each crack
  std::vector<VirtualCrackExtensionSettings> vces; ///< at most one for each crack
  std::vector<Step> steps;
  std::optional<CrackGrowthSettings> growth;
  std::vector<OutputFileRequest> outputs;
  std::vector<ResultCheck> checks;
  std::optional<RestartFiles> restart;
  std::vector<ParameterSweep> sweeps; ///< several multiply, the last varies fastest
  SolverControl control;
  std::vector<std::string> tasks; ///< empty: the default chain
  std::vector<UnimplementedAnalysis> unavailable;
  std::vector<std::string> imported_files; ///< paths of what $IMPORT brought in
  std::vector<LoadPathDefinition> load_paths;
  std::vector<SpectrumDefinition> spectra;
  std::vector<LoadInteractionDefinition> interactions;
  std::vector<GrowthTestReadings> tests;

  /// Property of an element of the mesh `m`, the model's own or one that cracks have cut out of it.
  /// The element must have one.
  [[nodiscard]] const ElementProperty& element_property(const Mesh& m, base::ElementId e) const {
    return properties[m.property[e.index()].index()];
  }
  /// Elastic material of the property of an element.
  [[nodiscard]] const ElasticMaterial& element_material(const Mesh& m, base::ElementId e) const {
    return materials[element_property(m, e).material.index()];
  }
};

/// Whether the mesh is a section through bodies about the axis x = 0; then all of it is.
inline bool is_axisymmetric(const Model& model) {
  return !model.properties.empty() && model.properties.front().state == StressState::axisymmetric;
}

/// Whether contacts or crack faces rub: then states depend on the order of loads.
inline bool has_friction(const Model& model) {
  return std::ranges::any_of(model.contacts, [](const auto& c) { return c.mu > 0.0; }) ||
         std::ranges::any_of(model.cracks,
                             [](const auto& c) { return c.faces_in_contact && c.mu > 0.0; });
}

} // namespace spricka::model
