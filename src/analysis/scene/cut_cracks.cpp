// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/cut_cracks.hpp"

#include "analysis/scene/moved_borders.hpp"
#include "analysis/scene/sets_in_use.hpp"
#include "analysis/scene/tip_net_of.hpp"
#include "growth/crack_lines.hpp"
#include "mesh/cut/crack_region.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/cut/tip_mesh.hpp"
#include "mesh/tube/found_crack.hpp"
#include "mesh/tube/insert_solid.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

bool opens_into_contact(const model::Model& model, const mesh::CrackLine& line) {
  constexpr double on_it = 1e-2; // of an edge: mouths are moved onto the boundary
  const auto has = [&](base::FaceSetId set) {
    return set.valid() &&
           std::ranges::any_of(model.mesh.set_with_id(set).faces, [&](const model::Face& f) {
             const mesh::EdgeEndAndMidNodes edge = mesh::element_edge_nodes(model.mesh, f);
             const double length =
                 (model.mesh.x[edge.b.index()] - model.mesh.x[edge.a.index()]).norm();
             return mesh::nearest_point_on_edge(model.mesh, edge, line.points.front()).distance <
                    on_it * length;
           });
  };
  return !line.embedded && std::ranges::any_of(model.contacts, [&](const model::Contact& contact) {
    return has(contact.slave) || has(contact.master);
  });
}

std::vector<mesh::TipMeshParameters> tip_meshes(const model::Model& model,
                                                const mesh::HostMesh& host,
                                                const std::vector<mesh::CrackLine>& lines) {
  std::vector<mesh::TipMeshParameters> tips;
  tips.reserve(lines.size());
  for (const mesh::CrackLine& line : lines) {
    tips.push_back(
        mesh::choose_tip_mesh(host, line, find_tip_mesh_settings(model, line.crack), lines));
    tips.back().pressed = opens_into_contact(model, line);
  }
  return tips;
}

// Whether K is that of its mesh without its estimated error all along the fronts, so that the fill
// round the tubes may be coarse. Faces that rub and growth by K as computed have no estimate,
// linear elements and what acts or touches near a front need a finer fill as such.
bool may_be_coarse(const model::Model& model) {
  const bool uncorrected = model.growth && !model.growth->corrected;
  const auto near_fronts = [&](const model::Load& load) {
    return load.type == model::LoadType::temperature || load.type == model::LoadType::body ||
           std::ranges::any_of(model.cracks, [&](const model::CrackDefinition& crack) {
             return load.faces.valid() && (load.faces == crack.left || load.faces == crack.right);
           });
  };
  return !uncorrected && model.contacts.empty() &&
         std::ranges::all_of(model.mesh.type,
                             [](base::ElementType t) { return base::element_info(t).quadratic; }) &&
         std::ranges::none_of(model.cracks,
                              [](const model::CrackDefinition& c) { return c.mu > 0.0; }) &&
         std::ranges::none_of(model.cases, [&](const model::LoadCase& c) {
           return std::ranges::any_of(c.loads, near_fronts);
         });
}

// What $TIPNET does not say is 0. [crack]
std::vector<mesh::TubeMeshParameters> tube_meshes(const model::Model& model) {
  std::vector<mesh::TubeMeshParameters> tubes;
  const bool coarse = may_be_coarse(model);
  for (std::size_t i = 0; i < model.cracks.size(); ++i) {
    mesh::TubeMeshParameters tube;
    if (coarse && find_tip_mesh_settings(model, base::CrackId(i)) == nullptr) {
      tube.growth = mesh::TubeMeshParameters::wide_growth;
    }
    if (const model::TipMeshSettings* tip = find_tip_mesh_settings(model, base::CrackId(i))) {
      tube.radius = tip->radius.value_or(0.0);
      tube.size = tip->size.value_or(0.0);
      tube.rings = tip->rings;
      tube.sectors = tip->sectors;
      tube.quarter_point = tip->quarter_point;
      tube.tube = tip->tube;
      tube.finer = tip->finer;
    }
    tubes.push_back(tube);
  }
  return tubes;
}

mesh::CrackedMesh without_cracks(const model::Mesh& host) {
  mesh::CrackedMesh cracked;
  cracked.mesh = host;
  for (std::size_t e = 0; e < host.element_count(); ++e) {
    // Each element is the deck's own.
    cracked.host.emplace_back(e);
  }
  return cracked;
}

// Cracks that the deck's own mesh has already (PATCH=NO) are looked for behind those that are cut.
bool find_cracks(const model::Model& model, mesh::CrackedMesh& cracked,
                 base::Diagnostics& diagnostics) {
  bool good = true;
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    const model::CrackDefinition& crack = model.cracks[c];
    if (crack.kind != model::CrackDefinitionKind::front || !crack.path.valid()) {
      continue;
    }
    const mesh::ExistingCrack found{base::CrackId(c), crack.name,
                                    model.mesh.set_with_id(crack.path).nodes};
    if (const std::string why = mesh::find_existing_crack(found, cracked); !why.empty()) {
      diagnostics.error(crack.span, "E439", fmt::format("crack {}: {}", crack.name, why));
      good = false;
    }
  }
  return good;
}

std::optional<mesh::CrackedMesh> cracked_solid(const model::Model& model,
                                               base::Diagnostics& diagnostics) {
  std::vector<mesh::SolidCrack> cut = mesh::make_solid_cracks(model);
  std::vector<mesh::TubeMeshParameters> tubes;
  std::vector<base::SourceSpan> cards;
  const std::vector<mesh::TubeMeshParameters> all = tube_meshes(model);
  for (const mesh::SolidCrack& crack : cut) {
    tubes.push_back(all[crack.crack.index()]);
    cards.push_back(model.cracks[crack.crack.index()].span);
  }
  std::optional<mesh::CrackedMesh> cracked =
      cut.empty() ? without_cracks(model.mesh)
                  : mesh::insert_solid_cracks(mesh::SolidHostMesh(model.mesh, sets_in_use(model)),
                                              cut, tubes, cards, diagnostics);
  if (!cracked) {
    return cracked;
  }
  std::vector<mesh::CrackFaceNodes> faces(model.cracks.size());
  for (std::size_t i = 0; i < cut.size(); ++i) {
    faces[cut[i].crack.index()] = std::move(cracked->faces[i]);
  }
  cracked->faces = std::move(faces);
  return find_cracks(model, *cracked, diagnostics) ? std::move(cracked) : std::nullopt;
}

void add_cavities(const model::Model& model, const mesh::HostMesh& host,
                  const std::vector<mesh::CrackLine>& lines, CrackRegionPlan& plan) {
  for (const base::ElementId e :
       mesh::possible_cavity_elements(host, lines, tip_meshes(model, host, lines))) {
    plan.region[e.index()] = true;
  }
}

} // namespace

std::optional<mesh::CrackedMesh> make_cracked_mesh(const model::Model& model,
                                                   const std::vector<mesh::CrackLine>& lines,
                                                   base::Diagnostics& diagnostics) {
  if (model.cracks.empty()) {
    return without_cracks(model.mesh);
  }
  if (lines.empty()) {
    return cracked_solid(model, diagnostics);
  }
  std::vector<base::SourceSpan> spans;
  spans.reserve(lines.size());
  for (const mesh::CrackLine& line : lines) {
    spans.push_back(model.cracks[line.crack.index()].span);
  }
  const mesh::HostMesh host(model.mesh);
  std::optional<mesh::CrackedMesh> cracked =
      mesh::insert_cracks(host, lines, tip_meshes(model, host, lines), spans, diagnostics);
  if (cracked) {
    warn_of_moved_borders(model, *cracked, diagnostics);
  }
  return cracked;
}

CrackRegionPlan plan_crack_region(const model::Model& model, const std::vector<double>& lengths,
                                  base::Diagnostics& diagnostics) {
  CrackRegionPlan plan;
  plan.region.assign(model.mesh.element_count(), false);
  // One length alone has nothing to keep for another; bodies of solids stay whole.
  plan.split =
      lengths.size() > 1 && std::ranges::any_of(model.cracks, &model::CrackDefinition::is_line);
  if (!plan.split) {
    return plan;
  }
  const mesh::HostMesh host(model.mesh);
  for (const double a : lengths) {
    const std::optional<std::vector<mesh::CrackLine>> lines =
        growth::crack_lines(model, a, diagnostics);
    if (!lines) {
      return plan;
    }
    add_cavities(model, host, *lines, plan);
  }
  return plan;
}

void add_to_crack_region(const model::Model& model, const std::vector<mesh::CrackLine>& lines,
                         CrackRegionPlan& plan) {
  plan.region.resize(model.mesh.element_count(), false);
  plan.split = true;
  add_cavities(model, mesh::HostMesh(model.mesh), lines, plan);
}

} // namespace spricka::analysis
