// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_setting.hpp"

#include "model/model.hpp"
#include "shape/quadrature.hpp"

namespace spricka::crack {

using base::Vec3;

double FrontContext::E_effective() const {
  return fe::effective_modulus(material, model::StressState::solid);
}

double FrontContext::intensity_conversion_factor(std::size_t auxiliary) const {
  switch (auxiliary) {
  case 0:
    return halves;
  case 1:
  case 2:
    return 0.5 * E_effective() * halves;
  case 3:
    return body.mu * halves;
  default:
    return E_effective() * halves;
  }
}

FrontContext make_front_context(const model::Model& model, const mesh::CrackedMesh& cracked,
                                const mesh::CrackFront& front, const FrontIntegralDomains& fields) {
  // Domains stay within one material: any of their elements tells it.
  const base::ElementId near = fields.elements().front();
  const model::ElasticMaterial& material = model.element_material(cracked.mesh, near);
  const fe::LameConstants k = fe::lame_constants(material, model::StressState::solid);
  // Logarithms of distances as a part of the front's length: a shift of the field of the line force
  // along m, which T does not see.
  const double unit = front.curve->length() / static_cast<double>(front.points.size());
  return {model,
          cracked.mesh,
          material,
          FrontBody{k.lambda, k.mu, material.nu, unit},
          FrontAxes(*front.curve),
          front.symmetric_half ? 2.0 : 1.0};
}

std::vector<std::vector<NodeWeight>>
strain_along_front_weights(const mesh::CrackFront& front, const model::Mesh& mesh,
                           const FrontIntegralDomains& fields) {
  const std::size_t count = front.points.size();
  std::vector<std::vector<NodeWeight>> weights(count);
  std::vector<double> length(count, 0.0);
  for (std::size_t i = 0; i + 1 < count + (fields.closed ? 1 : 0); ++i) {
    const std::size_t next = (i + 1) % count;
    const base::NodeId middle = fields.middle[i];
    const std::array<base::NodeId, 3> nodes{front.points[i].node, front.points[next].node, middle};
    Eigen::Matrix3d X;
    X.col(0) = mesh.x[nodes[0].index()];
    X.col(1) = mesh.x[nodes[1].index()];
    // An edge without a mid node has its functions where the third one is their mean.
    X.col(2) = middle.valid() ? mesh.x[middle.index()] : Vec3(0.5 * (X.col(0) + X.col(1)));
    for (const auto& point : shape::line_rule(5)) {
      Vec3 dN = shape::Line3::dN(point.r);
      if (!middle.valid()) {
        dN = {-0.5, 0.5, 0.0};
      }
      const Vec3 slope = X * dN;
      const Vec3 t = slope.normalized();
      const double part = 0.5 * (1.0 + point.r[0]);
      for (const auto& [at, hat] : {std::pair(i, 1.0 - part), std::pair(next, part)}) {
        length[at] += point.weight * hat * slope.norm();
        for (std::size_t k = 0; k < (middle.valid() ? 3U : 2U); ++k) {
          // t . du/ds ds
          weights[at].push_back(
              {nodes[k], point.weight * hat * dN[static_cast<Eigen::Index>(k)] * t});
        }
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (NodeWeight& entry : weights[i]) {
      entry.weight /= length[i];
    }
  }
  return weights;
}

} // namespace spricka::crack
