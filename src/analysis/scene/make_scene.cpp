// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/make_scene.hpp"

#include "analysis/scene/front_scene.hpp"
#include "analysis/scene/front_surroundings.hpp"
#include "analysis/scene/gone_nodes.hpp"
#include "analysis/scene/scene_loads.hpp"
#include "analysis/scene/scene_mouths.hpp"
#include "analysis/scene/scene_nodes.hpp"
#include "analysis/scene/scene_rows.hpp"
#include "analysis/scene/scene_ties.hpp"
#include "analysis/scene/supported_rows.hpp"
#include "base/by_dimension.hpp"
#include "contact/pairing.hpp"
#include "fe/dof_map.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double most_removed = 1e-3; // of the area between solids

double removed_part(const contact::PairConstraints& pair) {
  double area = 0.0;
  for (const contact::MultiplierFunction& function : pair.functions) {
    area += function.area;
  }
  return area > 0.0 ? pair.unprojected_area / (area + pair.unprojected_area) : 0.0;
}

void note_pair(const model::Contact& contact, const contact::PairConstraints& pair,
               Discretisation& scene) {
  if (pair.swapped) {
    scene.notes.push_back(fmt::format("contact {}: pressures are those at nodes of the master ({})",
                                      contact.name, pair.choice));
  }
  if (const double removed = removed_part(pair); removed > most_removed) {
    scene.notes.push_back(fmt::format(
        "contact {}: {:.2g} % of the part that faces the other surface is not paired, because the "
        "normals there do not meet that surface: nothing keeps the bodies apart there",
        contact.name, 100.0 * removed));
  }
}

/// What contacts of plane bodies and of solids differ in.
struct ContactRules {
  void (*apply_supports_to_rows)(contact::PairConstraints&, const std::vector<model::FreedomRole>&);
  void (*note_pair)(const model::Contact&, const contact::PairConstraints&, Discretisation&);
  /// Nodes whose freedoms rows weigh. In the plane those of both surfaces, so that what is
  /// condensed is the same at the next crack length; in space, where nodes that see nothing are
  /// many, those alone.
  std::vector<base::NodeId> (*contact_nodes)(const model::Mesh&, const model::Contact&,
                                             const contact::PairConstraints&);
  const char* rigid_side; ///< where the body of a rigid surface is
};

constexpr base::ByDimension<ContactRules> contact_rules{
    .plane = {
        .apply_supports_to_rows = [](auto&, const auto&) {},
        .note_pair = [](const auto&, const auto&, auto&) {},
        .contact_nodes = [](const auto& mesh, const auto& contact,
                            const auto&) { return contact::pair_surface_nodes(mesh, contact); },
        .rigid_side = "the body is on the left of a LINE, round an ARC, or inside it where "
                      "R is negative; what lies beyond the ends of a LINE faces nothing"},
    .space = {.apply_supports_to_rows = apply_supports_to_rows,
              .note_pair = note_pair,
              .contact_nodes = [](const auto&, const auto&,
                                  const auto& pair) { return find_nodes_in_pair_rows(pair); },
              .rigid_side = "the body is where the normal of a PLANE points to, round the other "
                            "shapes, or inside them where R is negative"}};

bool make_pairs(const model::Model& model, Discretisation& scene, base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const ContactRules& rules = contact_rules.at(mesh.dim);
  bool good = true;
  scene.contacts = model.contacts;
  scene.crack_face_pairs.resize(scene.cracked.faces.size());
  for (const model::Contact& contact : model.contacts) {
    scene.pairs.push_back(contact::build_pair_constraints(model, mesh, contact));
    rules.apply_supports_to_rows(scene.pairs.back(), scene.cls);
    const contact::PairConstraints& pair = scene.pairs.back();
    if (!pair.trouble.empty()) {
      diagnostics.error(contact.span, "E410",
                        fmt::format("contact {}: {}", contact.name, pair.trouble));
      good = false;
    } else if (!pair.found) {
      diagnostics.error(contact.span, "E411",
                        fmt::format("contact {}: the surfaces never face each other", contact.name),
                        contact.rigid.valid()
                            ? rules.rigid_side
                            : "look at the sets and at the side their elements lie on");
      good = false;
    } else {
      rules.note_pair(contact, pair, scene);
    }
  }
  return good;
}

} // namespace

std::optional<Discretisation> discretise(const model::Model& model, double a,
                                         const CrackRegionPlan& plan,
                                         base::Diagnostics& diagnostics) {
  const std::optional<std::vector<mesh::CrackLine>> lines =
      growth::crack_lines(model, a, diagnostics);
  return lines ? discretise(model, *lines, plan, diagnostics) : std::nullopt;
}

void mark_rest_elements(const CrackRegionPlan& plan, Discretisation& scene) {
  const std::vector<base::ElementId>& hosts = scene.cracked.host;
  scene.rest_element.assign(hosts.size(), false);
  for (std::size_t e = 0; plan.split && !plan.region.empty() && e < hosts.size(); ++e) {
    // Elements of patches are others at each length: none can be condensed beforehand.
    scene.rest_element[e] = hosts[e].valid() && !plan.region[hosts[e].index()];
  }
}

std::optional<Discretisation> discretise(const model::Model& model,
                                         const std::vector<mesh::CrackLine>& lines,
                                         const CrackRegionPlan& plan,
                                         base::Diagnostics& diagnostics) {
  Discretisation scene;
  std::optional<mesh::CrackedMesh> cracked = make_cracked_mesh(model, lines, diagnostics);
  if (!cracked) {
    return std::nullopt;
  }
  scene.cracked = std::move(*cracked);
  fill_crack_face_sets(model, scene.cracked);
  add_second_side_nodes(model.mesh, scene.cracked.mesh);
  scene.notes = scene.cracked.notes;
  note_removed_nodes(model, scene);
  const model::Mesh& mesh = scene.cracked.mesh;
  scene.cls = fe::classify_freedoms(model, mesh);
  // Before ties, which look at the classes.
  free_symmetry_nodes_behind_tip(model, lines, scene);
  // All of these are asked before the scene is given up, so that one run tells of all mistakes.
  const bool ties = eliminate_ties(model, scene, diagnostics);
  const bool pairs = make_pairs(model, scene, diagnostics);
  const bool fronts = assign_front_domains(model, scene, diagnostics);
  const bool crack_faces = reject_total_loads_on_crack_faces(model, scene, diagnostics);
  const bool held = check_supports_survive_cut(model, scene, diagnostics);
  const bool reported = lines.empty() || check_nodes_split_by_crack(model, scene, diagnostics);
  if (!ties || !pairs || !fronts || !crack_faces || !held || !reported ||
      !check_loaded_crack_faces_exist(model, scene, diagnostics)) {
    return std::nullopt;
  }
  // Ties are made before: rows of dependent freedoms are reduced here.
  make_row_table(scene);
  const auto dim = static_cast<std::size_t>(mesh.dim);
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    for (const base::NodeId n :
         contact_rules.at(mesh.dim).contact_nodes(mesh, model.contacts[i], scene.pairs[i])) {
      for (std::size_t c = 0; c < dim; ++c) {
        make_freedom_external(dim * n.index() + c, *scene.ties, scene.cls);
      }
    }
  }
  mark_rest_elements(plan, scene);
  if (!make_case_loads(model, scene, diagnostics)) {
    return std::nullopt;
  }
  return scene;
}

} // namespace spricka::analysis
