// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/scene.hpp"

#include "analysis/scene/gone_nodes.hpp"
#include "analysis/scene/scene_heat.hpp"
#include "analysis/scene/scene_mouths.hpp"
#include "analysis/scene/scene_nodes.hpp"
#include "analysis/scene/scene_ties.hpp"
#include "analysis/scene/tip_surroundings.hpp"
#include "contact/pairing.hpp"
#include "fe/assemble.hpp"
#include "fe/dof_map.hpp"
#include "growth/crack_lines.hpp"
#include "mesh/cut/host.hpp"
#include "sense/load_totals.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

const model::TipNet* tip_net_of(const model::Model& model, base::CrackId crack) {
  for (const model::TipNet& tip : model.tip_nets) {
    if (tip.crack == crack) {
      return &tip;
    }
  }
  return nullptr;
}

bool opens_into_contact(const model::Model& model, const mesh::CrackLine& line) {
  constexpr double on_it = 1e-2; // of an edge: mouths are moved onto the boundary
  const auto has = [&](base::FaceSetId set) {
    return set.valid() && std::ranges::any_of(model.mesh.set(set).faces, [&](const model::Face& f) {
             const mesh::Edge edge = mesh::edge_of(model.mesh, f);
             const double length =
                 (model.mesh.x[edge.b.index()] - model.mesh.x[edge.a.index()]).norm();
             return mesh::nearest_on(model.mesh, edge, line.points.front()).distance <
                    on_it * length;
           });
  };
  return model.mesh.dim == 2 && !line.embedded &&
         std::ranges::any_of(model.contacts, [&](const model::Contact& contact) {
           return has(contact.slave) || has(contact.master);
         });
}

std::vector<mesh::TipMesh> tip_meshes(const model::Model& model, const mesh::Host& host,
                                      const std::vector<mesh::CrackLine>& lines) {
  std::vector<mesh::TipMesh> tips;
  tips.reserve(lines.size());
  for (const mesh::CrackLine& line : lines) {
    tips.push_back(mesh::choose_tip_mesh(host, line, tip_net_of(model, line.crack), lines));
    tips.back().pressed = opens_into_contact(model, line);
  }
  return tips;
}

mesh::CrackedMesh without_cracks(const model::Mesh& host) {
  mesh::CrackedMesh cracked;
  cracked.mesh = host;
  for (std::size_t e = 0; e < host.element_count(); ++e) {
    cracked.host.emplace_back(e);
  }
  return cracked;
}

std::optional<mesh::CrackedMesh> cracked_mesh(const model::Model& model,
                                              const std::vector<mesh::CrackLine>& lines,
                                              base::Diagnostics& diagnostics) {
  if (model.cracks.empty()) {
    return without_cracks(model.mesh);
  }
  std::vector<base::Span> spans;
  spans.reserve(lines.size());
  for (const mesh::CrackLine& line : lines) {
    spans.push_back(model.cracks[line.crack.index()].span);
  }
  const mesh::Host host(model.mesh);
  return mesh::insert_cracks(host, lines, tip_meshes(model, host, lines), spans, diagnostics);
}

bool make_pairs(const model::Model& model, Scene& scene, base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = scene.cracked.mesh;
  bool good = true;
  scene.contacts = model.contacts;
  scene.lip_pairs.resize(scene.cracked.lips.size());
  for (const model::Contact& contact : model.contacts) {
    scene.pairs.push_back(contact::pair_rows(model, mesh, contact));
    const contact::PairRows& pair = scene.pairs.back();
    if (!pair.trouble.empty()) {
      diagnostics.error(contact.span, "E410",
                        fmt::format("contact {}: {}", contact.name, pair.trouble));
      good = false;
    } else if (!pair.found) {
      diagnostics.error(contact.span, "E411",
                        fmt::format("contact {}: the surfaces never face each other", contact.name),
                        contact.rigid.valid()
                            ? "the body is on the left of a LINE, round an ARC, or inside it where "
                              "R is negative; what lies beyond the ends of a LINE faces nothing"
                            : "look at the sets and at the side their elements lie on");
      good = false;
    }
  }
  return good;
}

// Default domains: rings 2 and on, as the tip ring alone sees the singular elements only.
std::vector<int> domains_of(const model::Model& model, base::CrackId crack) {
  for (const model::Vce& vce : model.vces) {
    if (vce.crack == crack && !vce.domains.empty()) {
      return vce.domains;
    }
  }
  const model::TipNet* tip = tip_net_of(model, crack);
  const int rings = tip != nullptr ? tip->rings : model::TipNet{}.rings;
  std::vector<int> domains;
  for (int ring = 2; ring <= rings; ++ring) {
    domains.push_back(ring);
  }
  return domains;
}

bool make_tips(const model::Model& model, Scene& scene, base::Diagnostics& diagnostics) {
  if (scene.cracked.tips.empty()) {
    return true;
  }
  bool good = true;
  const crack::Neighbourhood around(scene.cracked.mesh);
  for (const mesh::Tip& tip : scene.cracked.tips) {
    TipScene ring;
    const crack::DomainLimits limits = domain_limits(model, scene, tip);
    ring.fields =
        around.fields(scene.cracked, tip, domains_of(model, tip.crack), ring.left_out, limits);
    if (!ring.fields.empty()) {
      std::vector<int> ignored;
      std::vector<crack::ExtensionField> wider =
          around.fields(scene.cracked, tip, {ring.fields.back().rings + 1}, ignored, limits);
      if (!wider.empty()) {
        ring.beyond = std::move(wider.front());
      }
    }
    const model::Crack& crack = model.cracks[tip.crack.index()];
    if (ring.fields.empty()) {
      diagnostics.error(crack.span, "E412",
                        fmt::format("crack {}: no ring domain fits round the tip at a = {:.6g} (it "
                                    "would leave the body, or reach another tip, another "
                                    "material, a support, a force or the rim of what is heated)",
                                    crack.name, tip.a),
                        "give a smaller RADIUS on $TIPNET or other DOMAINS on $VCE");
      good = false;
    }
    for (const int rings : ring.left_out) {
      scene.notes.push_back(fmt::format("{}: domain of {} rings left out, it would leave the body",
                                        crack.name, rings));
    }
    scene.tips.push_back(std::move(ring));
  }
  return good;
}

// A resultant that does not arrive (a bearing load whose pin misses the bore) must not pass for a
// load of nothing.
bool arrives(const model::Model& model, const model::Mesh& mesh, const model::Load& load) {
  if (load.type != model::LoadType::bearing && load.type != model::LoadType::resultant) {
    return true;
  }
  const base::Vector f = fe::nodal_load(model, mesh, {"", {load}});
  for (int c = 0; c < mesh.dim && c < static_cast<int>(load.value.size()); ++c) {
    double sum = 0.0;
    for (Eigen::Index i = c; i < f.size(); i += mesh.dim) {
      sum += f[i];
    }
    const double wanted = load.value[static_cast<std::size_t>(c)](base::Vec3::Zero());
    if (std::abs(sum - wanted) > 1e-9 * (std::abs(wanted) + f.lpNorm<1>())) {
      return false;
    }
  }
  return f.lpNorm<1>() > 0.0 || load.value.empty() ||
         std::all_of(load.value.begin(), load.value.end(),
                     [](const base::Expression& v) { return v(base::Vec3::Zero()) == 0.0; });
}

bool make_loads(const model::Model& model, Scene& scene, base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = scene.cracked.mesh;
  bool good = true;
  const auto n = static_cast<Eigen::Index>(mesh.node_count()) * mesh.dim;
  const auto cases = static_cast<Eigen::Index>(model.cases.size());
  const Eigen::Index columns = cases + (scene.ties->has_constants() ? 1 : 0);
  scene.case_load = base::Matrix::Zero(n, columns);
  scene.case_displacement = base::Matrix::Zero(n, columns);
  for (Eigen::Index c = 0; c < cases; ++c) {
    const model::LoadCase& load_case = model.cases[static_cast<std::size_t>(c)];
    scene.case_load.col(c) = fe::nodal_load(model, mesh, without_heat(load_case));
    scene.case_displacement.col(c) = fe::prescribed_displacement(model, mesh, load_case);
    for (Eigen::Index i = 0; i < n; ++i) { // a crack may have freed one face of what a load moves
      if (scene.cls[static_cast<std::size_t>(i)] == model::FreedomClass::local ||
          scene.cls[static_cast<std::size_t>(i)] == model::FreedomClass::external) {
        scene.case_displacement(i, c) = 0.0;
      }
    }
    scene.case_heat.push_back(heat_of(model, scene, load_case));
    const fe::CaseHeat& heat = *scene.case_heat.back();
    if (heat.temperature.size() > 0) {
      if (scene.case_temperature.size() == 0) {
        scene.case_temperature = base::Matrix::Zero(heat.temperature.size(), columns);
      }
      scene.case_temperature.col(c) = heat.temperature;
      scene.case_load.col(c) += heat_load(model, mesh, heat);
    }
    for (const model::Load& load : load_case.loads) {
      if (!arrives(model, mesh, load)) {
        diagnostics.error(load.span, "E413",
                          fmt::format("load case {}: the resultant cannot be carried by this set",
                                      load_case.name),
                          "a bearing load needs faces of a bore on the side it pushes to");
        good = false;
      }
    }
  }
  return forces_are_taken(model, scene, diagnostics) && good &&
         sense::loads_are_sound(model, mesh, diagnostics) &&
         follow_prescribed(model, scene, diagnostics);
}

} // namespace

RegionPlan plan_region(const model::Model& model, const std::vector<double>& lengths,
                       base::Diagnostics& diagnostics) {
  RegionPlan plan;
  plan.region.assign(model.mesh.element_count(), false);
  plan.split = lengths.size() > 1 && !model.cracks.empty();
  if (!plan.split) {
    return plan;
  }
  for (const double a : lengths) {
    const std::optional<std::vector<mesh::CrackLine>> lines =
        growth::crack_lines(model, a, diagnostics);
    if (!lines) {
      return plan;
    }
    add_to_region(model, *lines, plan);
  }
  return plan;
}

void add_to_region(const model::Model& model, const std::vector<mesh::CrackLine>& lines,
                   RegionPlan& plan) {
  plan.region.resize(model.mesh.element_count(), false);
  plan.split = true;
  const mesh::Host host(model.mesh);
  for (const base::ElementId e : mesh::crack_region(host, lines, tip_meshes(model, host, lines))) {
    plan.region[e.index()] = true;
  }
}

void make_table(Scene& scene) {
  scene.table = {};
  for (const contact::PairRows& pair : scene.pairs) {
    scene.table.first.push_back(scene.table.rows.size());
    for (const contact::ConstraintRow& row : pair.normal) {
      scene.table.rows.push_back(&row);
    }
    for (const contact::ConstraintRow& row : pair.tangent) {
      scene.table.rows.push_back(&row);
    }
  }
  scene.table.first.push_back(scene.table.rows.size());
  reduce_rows(scene);
}

std::optional<Scene> make_scene(const model::Model& model, double a, const RegionPlan& plan,
                                base::Diagnostics& diagnostics) {
  const std::optional<std::vector<mesh::CrackLine>> lines =
      growth::crack_lines(model, a, diagnostics);
  return lines ? make_scene(model, *lines, plan, diagnostics) : std::nullopt;
}

std::optional<Scene> make_scene(const model::Model& model,
                                const std::vector<mesh::CrackLine>& lines, const RegionPlan& plan,
                                base::Diagnostics& diagnostics) {
  Scene scene;
  std::optional<mesh::CrackedMesh> cracked = cracked_mesh(model, lines, diagnostics);
  if (!cracked) {
    return std::nullopt;
  }
  scene.cracked = std::move(*cracked);
  fill_lip_sets(model, scene.cracked);
  add_second_sides(model.mesh, scene.cracked.mesh);
  scene.notes = scene.cracked.notes;
  note_gone_nodes(model, scene);
  const model::Mesh& mesh = scene.cracked.mesh;
  scene.cls = fe::classify_freedoms(model, mesh);
  release_lips(model, lines, scene);
  const bool ties = make_scene_ties(model, scene, diagnostics);
  const bool pairs = make_pairs(model, scene, diagnostics);
  const bool tips = make_tips(model, scene, diagnostics);
  const bool lips = lips_carry_no_totals(model, scene, diagnostics);
  const bool held = supports_are_kept(model, scene, diagnostics);
  const bool told = mouths_are_told(model, scene, diagnostics);
  if (!ties || !pairs || !tips || !lips || !held || !told ||
      !loaded_faces_are_there(model, scene, diagnostics)) {
    return std::nullopt;
  }
  make_table(scene);
  const auto dim = static_cast<std::size_t>(mesh.dim);
  for (const model::Contact& contact : model.contacts) {
    for (const base::NodeId n : contact::surface_nodes(mesh, contact)) {
      for (std::size_t c = 0; c < dim; ++c) {
        make_external(dim * n.index() + c, *scene.ties, scene.cls);
      }
    }
  }
  scene.rest_element.assign(mesh.element_count(), false);
  for (std::size_t e = 0; plan.split && e < mesh.element_count(); ++e) {
    const base::ElementId host = scene.cracked.host[e];
    scene.rest_element[e] = host.valid() && !plan.region[host.index()];
  }
  if (!make_loads(model, scene, diagnostics)) {
    return std::nullopt;
  }
  return scene;
}

base::Matrix loads_with_supports(const model::Model& model, const Scene& scene) {
  base::Matrix load = scene.case_load;
  std::vector<base::ElementId> all;
  for (std::size_t e = 0; e < scene.cracked.mesh.element_count(); ++e) {
    all.emplace_back(e);
  }
  for (Eigen::Index c = 0; c < load.cols(); ++c) {
    if ((scene.case_displacement.col(c).array() != 0.0).any()) {
      base::Vector pull = base::Vector::Zero(load.rows());
      fe::add_internal_force(model, scene.cracked.mesh, all, scene.case_displacement.col(c), pull);
      load.col(c) -= pull;
    }
  }
  scene.ties->reduce(load);
  return load;
}

} // namespace spricka::analysis
