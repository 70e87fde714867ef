// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/preview/preview_model.hpp"

#include "analysis/scene/front_name.hpp"
#include "contact/survey.hpp"
#include "mesh/measure_quality.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string net_name(const model::Model& model, base::NetId net) {
  const std::string& name = model.nets[net.index()].name;
  return name.empty() ? "(deck)" : name;
}

void count_freedoms(const analysis::Discretisation& scene, const std::vector<bool>& used,
                    base::NetId net, results::NetPreview& preview) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const auto dim = static_cast<std::size_t>(mesh.dim);
  constexpr std::array counts{&results::NetPreview::local, &results::NetPreview::external,
                              &results::NetPreview::suppressed, &results::NetPreview::prescribed,
                              &results::NetPreview::dependent}; // by FreedomRole
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (!used[n] || mesh.node_net[n] != net) {
      continue;
    }
    ++preview.nodes;
    for (std::size_t c = 0; c < dim; ++c) {
      ++(preview.*counts.at(static_cast<std::size_t>(scene.cls[dim * n + c])));
    }
  }
}

void add_quality(const model::Model& model, const model::Mesh& mesh, const std::string& where,
                 const std::vector<base::ElementId>& elements,
                 std::vector<results::WorstElementPreview>& list) {
  const std::optional<mesh::MeshQuality> quality = mesh::measure_quality(mesh, elements);
  if (!quality) {
    return;
  }
  const auto add = [&](const char* measure, const mesh::WorstElement& worst, double unit) {
    const std::size_t e = worst.element.index();
    list.push_back({.where = where,
                    .measure = measure,
                    .value = worst.value / unit,
                    .net = net_name(model, mesh.element_net[e]),
                    .element = mesh.element_label[e],
                    .at = worst.at});
  };
  add("scaled Jacobian", quality->scaled_jacobian, 1.0);
  add("aspect", quality->aspect, 1.0);
  add("smallest angle", quality->smallest_angle, degree);
  add("largest angle", quality->largest_angle, degree);
}

} // namespace

std::vector<results::NetPreview> preview_nets(const model::Model& model,
                                              const analysis::Discretisation& scene) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const std::vector<bool> used = model::mark_nodes_in_use(mesh); // not those that cracks cut out
  std::vector<results::NetPreview> nets;
  for (std::size_t net = 0; net < model.nets.size(); ++net) {
    results::NetPreview preview;
    preview.name = net_name(model, base::NetId(net));
    std::array<std::size_t, base::element_infos.size()> count{};
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (mesh.element_net[e] == base::NetId(net)) {
        ++count[static_cast<std::size_t>(mesh.type[e])];
        ++preview.elements;
      }
    }
    for (std::size_t t = 0; t < count.size(); ++t) {
      if (count[t] > 0) {
        preview.types.emplace_back(base::element_infos[t].name, count[t]);
      }
    }
    count_freedoms(scene, used, base::NetId(net), preview);
    if (preview.elements > 0) {
      nets.push_back(std::move(preview));
    }
  }
  return nets;
}

std::vector<results::WorstElementPreview>
preview_mesh_quality(const model::Model& model, const analysis::Discretisation& scene) {
  std::vector<results::WorstElementPreview> list;
  std::vector<base::ElementId> host;
  for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
    host.emplace_back(e);
  }
  std::vector<base::ElementId> patches;
  for (std::size_t e = 0; e < scene.cracked.mesh.element_count(); ++e) {
    if (!scene.cracked.host[e].valid()) {
      patches.emplace_back(e);
    }
  }
  add_quality(model, model.mesh, "host", host, list);
  add_quality(model, scene.cracked.mesh, "crack patches", patches, list);
  return list;
}

std::vector<results::ContactPairPreview>
preview_contact_pairs(const analysis::Discretisation& scene) {
  std::vector<results::ContactPairPreview> list;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const contact::PairConstraints& pair = scene.pairs[c];
    const model::Contact& card = scene.contacts[c];
    const contact::GapSurvey own = pair.rigid ? contact::survey_gaps(pair.contact, *pair.rigid)
                                              : contact::survey_gaps(pair.contact, pair.target);
    const contact::GapSurvey other =
        pair.rigid ? contact::GapSurvey() : contact::survey_gaps(pair.target, pair.contact);
    const contact::GapSurvey& slave = pair.swapped ? other : own;
    const contact::GapSurvey& master = pair.swapped ? own : other;
    results::ContactPairPreview preview;
    preview.name = card.name;
    preview.rigid = pair.rigid.has_value();
    preview.declared = card.gap.has_value();
    preview.declared_gap = card.gap.value_or(0.0);
    preview.gap_low = own.gap_low;
    preview.gap_high = own.gap_high;
    preview.gap_mean = own.gap_mean;
    preview.angle = own.angle_high / degree;
    preview.slave_edges = slave.edges;
    preview.slave_facing = slave.facing;
    preview.master_edges = master.edges;
    preview.master_facing = master.facing;
    preview.slave_overhang = slave.unpaired_fraction();
    preview.master_overhang = master.unpaired_fraction();
    preview.pairing = card.pairing == model::PairingMethod::node ? "node" : "segment";
    preview.choice = pair.choice;
    preview.rows = pair.normal.size() + pair.tangent.size();
    preview.merged = pair.merged;
    list.push_back(std::move(preview));
  }
  return list;
}

results::CrackLengthPreview preview_mesh_at_crack_length(const model::Model& model,
                                                         const analysis::Discretisation& scene) {
  results::CrackLengthPreview length;
  const mesh::CrackedMesh& cracked = scene.cracked;
  length.nodes = cracked.mesh.node_count();
  length.elements = cracked.mesh.element_count();
  length.fresh =
      static_cast<std::size_t>(std::count_if(cracked.host.begin(), cracked.host.end(),
                                             [](base::ElementId host) { return !host.valid(); }));
  length.replaced = model.mesh.element_count() - (length.elements - length.fresh);
  length.rows = scene.table.size();
  length.notes = scene.notes;
  for (const mesh::CrackFront& front : cracked.fronts) {
    results::FrontPreview preview;
    preview.name = analysis::front_name(model, scene, front);
    preview.a = front.a;
    preview.radius = front.radius;
    preview.size = front.size;
    if (front.is_tip()) {
      const std::vector<base::NodeId>& crack_face =
          cracked.faces[front.crack.index()].meshed_face_nodes();
      if (!crack_face.empty()) {
        preview.mouth = cracked.mesh.x[crack_face.front().index()];
      }
      preview.at = front.tip_point().x;
    } else {
      preview.kind = mesh::configuration_name(front.kind);
      preview.at = front.curve->at(0.5 * front.curve->length()).x;
      preview.length = front.curve->length();
      preview.elements = front.points.size() - (front.curve->closed() ? 0 : 1);
    }
    length.a = length.a > 0.0 ? length.a : front.a;
    length.fronts.push_back(std::move(preview));
  }
  return length;
}

} // namespace spricka::program
