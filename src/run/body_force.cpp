// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/body_force.hpp"

#include "fe/assemble.hpp"

#include <algorithm>
#include <set>

namespace spricka::run {

namespace {

// One load on elements near the tip: density = factor * (value(x) or total / volume).
struct Share {
  const model::Load* load = nullptr;
  double factor = 0.0;
  std::set<base::ElementId> elements;
};

double weighted_volume(const model::Model& model, const model::Mesh& mesh,
                       base::ElementSetId elements) {
  model::Load unit;
  unit.type = model::LoadType::body;
  unit.elements = elements;
  unit.value = {base::Expression::constant(1.0)};
  const base::Vector f = fe::nodal_load(model, mesh, {"", {unit}});
  double sum = 0.0;
  for (Eigen::Index i = 0; i < f.size(); i += mesh.dim) {
    sum += f[i];
  }
  return sum;
}

// The loads on elements near the tip.
std::vector<Share> shares_near(const model::Model& model, const Scene& scene,
                               const std::vector<crack::ExtensionField>& fields,
                               const base::Vector& case_factor) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::set<base::ElementId> near;
  for (const crack::ExtensionField& field : fields) {
    near.insert(field.elements.begin(), field.elements.end());
  }
  std::vector<Share> shares;
  for (std::size_t c = 0; c < model.cases.size(); ++c) {
    const double factor = case_factor[static_cast<Eigen::Index>(c)];
    for (const model::Load& load : model.cases[c].loads) {
      const bool on_elements = load.type == model::LoadType::body ||
                               (load.type == model::LoadType::resultant && load.elements.valid());
      if (!on_elements || factor == 0.0) {
        continue;
      }
      Share share{&load, factor, {}};
      for (const base::ElementId e : mesh.set(load.elements).elements) {
        if (near.contains(e)) {
          share.elements.insert(e);
        }
      }
      if (share.elements.empty()) {
        continue;
      }
      if (load.type == model::LoadType::resultant) {
        share.factor /= weighted_volume(model, mesh, load.elements);
      }
      shares.push_back(std::move(share));
    }
  }
  return shares;
}

} // namespace

crack::BodyForce body_force(const model::Model& model, const Scene& scene,
                            const std::vector<crack::ExtensionField>& fields,
                            const base::Vector& case_factor) {
  const std::vector<Share> shares = shares_near(model, scene, fields, case_factor);
  if (shares.empty()) {
    return {};
  }
  return [shares](base::ElementId e, const base::Vec2& x) {
    base::Vec2 b = base::Vec2::Zero();
    for (const Share& share : shares) {
      if (share.elements.contains(e)) {
        for (std::size_t k = 0; k < std::min<std::size_t>(2, share.load->value.size()); ++k) {
          b[static_cast<Eigen::Index>(k)] +=
              share.factor * share.load->value[k](base::Vec3(x.x(), x.y(), 0.0));
        }
      }
    }
    return b;
  };
}

bool body_force_varies(const model::Model& model, const Scene& scene,
                       const std::vector<crack::ExtensionField>& fields,
                       const base::Vector& case_factor) {
  const std::vector<Share> shares = shares_near(model, scene, fields, case_factor);
  return std::ranges::any_of(shares, [](const Share& share) {
    return share.load->type == model::LoadType::body &&
           !std::ranges::all_of(share.load->value,
                                [](const base::Expression& v) { return v.is_constant(); });
  });
}

} // namespace spricka::run
