// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_advance.hpp"

#include "analysis/scene/domain_rings.hpp"
#include "analysis/scene/front_functionals.hpp"
#include "analysis/scene/front_surroundings.hpp"
#include "analysis/scene/supported_rows.hpp"
#include "analysis/steps/row_opening.hpp"
#include "contact/pairing.hpp"
#include "fe/assemble.hpp"
#include "mesh/boundary.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using base::Vec3;

// Of the elements at the front: a difference to one side leaves this part of dK, and round-off
// 1e-10.
constexpr double part_of_size = 1e-6;

// Of the shorter axis: how far beyond the tube the mesh gives way; in the plane of the crack to its
// middle if the tube leaves as much as the least of them, and no farther.
constexpr double least_share_of_axis = 0.5;
constexpr double largest_share_of_axis = 0.8;

// Nodes of free sides of the body, without those of the crack's faces.
std::set<base::NodeId> skin_of(const model::Mesh& mesh, const crack::FrontIntegralDomains& fields) {
  std::set<base::NodeId> nodes;
  for (const crack::MovedFreeSide& side : fields.sides) {
    if (side.on == crack::UpperOrLowerFace::none) {
      const std::vector<base::NodeId> own = model::side_nodes(mesh, side.face);
      nodes.insert(own.begin(), own.end());
    }
  }
  return nodes;
}

// What the widest domains of all points move together: the sums of q and of q times the direction.
struct Carried {
  double q = 0.0;
  Vec3 along = Vec3::Zero();
};
std::map<base::NodeId, Carried> carried_by(const crack::FrontIntegralDomains& fields) {
  std::map<base::NodeId, Carried> sum;
  for (const std::vector<crack::VirtualExtensionField>& point : fields.points) {
    if (point.empty()) {
      continue;
    }
    for (const crack::NodeMotion& moved : point.back().motion) {
      Carried& at = sum[moved.node];
      at.q += moved.q;
      at.along += moved.q * moved.along;
    }
  }
  return sum;
}

// How far nodes go along with points belongs to the nodes: hats have kinks at places where nodes
// are. Only the directions are those of the moved front.
void keep_shares(const crack::FrontIntegralDomains& own, crack::FrontIntegralDomains& moved) {
  for (std::size_t i = 0; i < own.points.size(); ++i) {
    std::map<base::NodeId, Vec3> along;
    for (const crack::VirtualExtensionField& field : moved.points[i]) {
      for (const crack::NodeMotion& motion : field.motion) {
        along.emplace(motion.node, motion.along);
      }
    }
    moved.points[i] = own.points[i];
    for (crack::VirtualExtensionField& field : moved.points[i]) {
      for (crack::NodeMotion& motion : field.motion) {
        const auto at = along.find(motion.node);
        motion.along = at == along.end() ? motion.along : at->second;
      }
    }
  }
  moved.sides = own.sides;
  moved.degree = own.degree;
}

bool acts_by_place(const model::Model& model) {
  return std::ranges::any_of(model.cases, [](const model::LoadCase& load_case) {
    return std::ranges::any_of(load_case.loads, [](const model::Load& load) {
      return load.type == model::LoadType::temperature;
    });
  });
}

} // namespace

VirtualAxisExtension::VirtualAxisExtension(const model::Model& model, const Discretisation& scene,
                                           base::CrackId crack, EllipseAxis axis)
    : model_(model), scene_(scene), crack_(crack), axis_(axis) {
  const model::PlanarCrack& plane = model.cracks[crack.index()].plane;
  direction_ = axis == EllipseAxis::a ? plane.transverse_axis() : plane.along;
  size_ = axis == EllipseAxis::a ? plane.a : plane.c;
  if (acts_by_place(model)) {
    why_never_ = "there are temperatures";
    return;
  }
  shift_mesh();
  if (!why_never_.empty()) {
    return;
  }
  move();
  move_pairs();
  if (why_never_.empty()) {
    rows_ = displacement_K_functionals(model_, moved_);
    of_force_ = pairs_.empty() ? base::Matrix() : contact_force_K_functionals(model_, moved_);
  }
}

// [node] of the surface but for the crack's own faces, where materials meet, or kept from domains.
std::vector<bool> VirtualAxisExtension::resting() const {
  const model::Mesh& mesh = scene_.cracked.mesh;
  std::vector<bool> rests =
      find_domain_exclusions(model_, scene_, scene_.cracked.fronts.front()).node;
  std::vector<std::int32_t> property(mesh.node_count(), -1);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
      std::int32_t& own = property[n.index()];
      rests[n.index()] = rests[n.index()] || (own >= 0 && own != mesh.property[e].value);
      own = mesh.property[e].value;
    }
  }
  const mesh::CrackFaceNodes& faces = scene_.cracked.faces[crack_.index()];
  std::set<model::Face> own(faces.left_sides.begin(), faces.left_sides.end());
  own.insert(faces.right_sides.begin(), faces.right_sides.end());
  for (const model::Face& face : mesh::outer_surface_faces(mesh)) {
    for (const base::NodeId n : model::side_nodes(mesh, face)) {
      rests[n.index()] = rests[n.index()] || !own.contains(face);
    }
  }
  return rests;
}

// An ellipse whose axis grows is an affine picture of itself; sections of the tube go along with
// the front as they are, on the surface as domains do (sensitivity.15).
std::vector<Vec3> VirtualAxisExtension::motion_of(std::size_t f) const {
  const mesh::CrackFront& front = scene_.cracked.fronts[f];
  const crack::FrontIntegralDomains& domains = scene_.domains[f];
  const model::PlanarCrack& plane = model_.cracks[crack_.index()].plane;
  const model::Mesh& mesh = scene_.cracked.mesh;
  std::vector<Vec3> velocity(mesh.node_count(), Vec3::Zero());
  const std::set<base::NodeId> skin = skin_of(mesh, domains);
  for (const auto& [node, carried] : carried_by(domains)) {
    const Vec3& x = mesh.x[node.index()];
    const mesh::FrontFrame foot = front.curve->at(front.curve->nearest_length(x));
    const Vec3 own = direction_.dot(foot.x - plane.place) / size_ * direction_;
    velocity[node.index()] =
        skin.contains(node) ? Vec3(own.dot(foot.m) * carried.along) : Vec3(carried.q * own);
  }
  // Elements beyond the domains take part, so that none is strained much.
  const std::vector<bool> rests = resting();
  const double tube = std::ranges::max(front.points, {}, &mesh::FrontPoint::radius).radius;
  const double axis = std::min(plane.a, plane.c);
  const double room =
      std::clamp(axis - tube, least_share_of_axis * axis, largest_share_of_axis * axis);
  for (std::size_t n = 0; n < velocity.size(); ++n) {
    const Vec3& x = mesh.x[n];
    if (rests[n] || std::abs(plane.normal.dot(x - plane.place)) > tube + room) {
      continue;
    }
    const Vec3 foot = front.curve->at(front.curve->nearest_length(x)).x;
    const double part = std::clamp((tube + room - (x - foot).norm()) / room, 0.0, 1.0);
    // Without kinks at its ends: coarse elements over one would be strained unevenly.
    const double share = part * part * (3.0 - 2.0 * part);
    const Vec3 own = share * direction_.dot(foot - plane.place) / size_ * direction_;
    velocity[n] = own.norm() > velocity[n].norm() ? own : velocity[n];
  }
  // Where rows tie nodes of the patch, they still hold of the mesh that moves.
  for (const mesh::HangingNodeTie& tie : scene_.cracked.ties) {
    Vec3 v = Vec3::Zero();
    for (std::size_t k = 0; k < tie.master.size(); ++k) {
      v += tie.weight[k] * velocity[tie.master[k].index()];
    }
    velocity[tie.slave.index()] = v;
  }
  return velocity;
}

void VirtualAxisExtension::shift_mesh() {
  velocity_.assign(scene_.cracked.mesh.node_count(), Vec3::Zero());
  double size = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < scene_.cracked.fronts.size(); ++f) {
    const mesh::CrackFront& front = scene_.cracked.fronts[f];
    if (front.crack != crack_) {
      continue;
    }
    if (std::ranges::any_of(scene_.domains[f].points,
                            [](const auto& point) { return point.empty(); })) {
      why_never_ = "no domain fits round some points of the front";
      return;
    }
    const std::vector<Vec3> own = motion_of(f);
    for (std::size_t n = 0; n < own.size(); ++n) {
      velocity_[n] += own[n];
    }
    size = std::min(size, front.size);
  }
  step_ = part_of_size * size;
  for (std::size_t e = 0; e < scene_.cracked.mesh.element_count(); ++e) {
    const base::ElementId element(e);
    if (std::ranges::any_of(scene_.cracked.mesh.element_nodes(element),
                            [&](base::NodeId n) { return !velocity_[n.index()].isZero(0.0); })) {
      strained_.push_back(element);
    }
  }
}

void VirtualAxisExtension::move() {
  const model::PlanarCrack& plane = model_.cracks[crack_.index()].plane;
  const double rate = step_ / size_;
  moved_.cracked = scene_.cracked;
  for (std::size_t n = 0; n < velocity_.size(); ++n) {
    moved_.cracked.mesh.x[n] += step_ * velocity_[n];
  }
  moved_.domains = scene_.domains;
  for (std::size_t f = 0; f < scene_.cracked.fronts.size(); ++f) {
    const mesh::CrackFront& front = scene_.cracked.fronts[f];
    if (front.crack != crack_) {
      continue;
    }
    std::vector<Vec3> points = front.curve->points();
    for (Vec3& x : points) {
      x += rate * direction_.dot(x - plane.place) * direction_;
    }
    const std::vector<Vec3> normals(points.size(), plane.normal);
    mesh::CrackFront& moved = moved_.cracked.fronts[f];
    moved.curve =
        std::make_shared<const mesh::FrontCurve>(std::move(points), normals, front.curve->closed());
    mesh::recompute_front_point_geometry(moved_.cracked.mesh, moved);
    moved_.domains[f] =
        crack::build_front_domains(moved_.cracked, moved, domain_ring_counts(model_, crack_),
                                   find_domain_exclusions(model_, scene_, front));
    const auto cases = static_cast<Eigen::Index>(model_.cases.size());
    if (!loads_act_on_domains(model_, moved_, base::Vector::Ones(cases))) {
      moved_.domains[f].auxiliary_cache.reset(); // read once, by the rows of K
    }
    keep_shares(scene_.domains[f], moved_.domains[f]);
  }
}

void VirtualAxisExtension::move_pairs() {
  std::vector<bool> moved; // [node]
  for (const Vec3& velocity : velocity_) {
    moved.push_back(!velocity.isZero(0.0));
  }
  const auto moves = [&](const contact::ConstraintRow& row) {
    return std::ranges::any_of(row.entries, [&](const contact::RowEntry& entry) -> bool {
      return moved[entry.node.index()];
    });
  };
  moved_.pairs = scene_.pairs;
  moved_.table = scene_.table;
  moved_.contacts = scene_.contacts;
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    if (!std::ranges::any_of(scene_.pairs[c].normal, moves) &&
        !std::ranges::any_of(scene_.pairs[c].tangent, moves)) {
      continue;
    }
    pairs_.push_back(c);
    if (c >= model_.contacts.size()) {
      continue; // between the faces of a crack
    }
    contact::PairConstraints& pair = moved_.pairs[c];
    pair = contact::build_moved_pair_constraints(model_, moved_.cracked.mesh, model_.contacts[c],
                                                 scene_.pairs[c], moved);
    apply_supports_to_rows(pair, scene_.cls);
    const auto same_row = [](const auto& own, const auto& other) { return own.node == other.node; };
    if (!std::ranges::equal(pair.normal, scene_.pairs[c].normal, same_row) ||
        !std::ranges::equal(pair.tangent, scene_.pairs[c].tangent, same_row)) {
      why_never_ = "rows of a contact change where its surface moves with the front";
    }
  }
}

const std::string& VirtualAxisExtension::crack_name() const {
  return model_.cracks[crack_.index()].name;
}

std::string VirtualAxisExtension::why_no_derivative(const FrozenContactStep& step) const {
  if (!why_never_.empty()) {
    return why_never_;
  }
  for (const std::size_t c : pairs_) {
    const std::vector<bool>& closed = step.state.pair_closed[c];
    if (c >= model_.contacts.size() && std::ranges::find(closed, true) != closed.end()) {
      return "faces of the crack touch";
    }
  }
  return {};
}

// Forces on nodes with u kept: applied loads and contact forces less internal ones.
base::Vector VirtualAxisExtension::loads(const Discretisation& side, const StepState& state) const {
  base::Vector internal = base::Vector::Zero(state.u.size());
  fe::add_internal_force(model_, side.cracked.mesh, strained_, state.u, internal);
  base::Vector out = -internal;
  for (std::size_t c = 0; c < model_.cases.size(); ++c) {
    const double factor = state.case_factor[static_cast<Eigen::Index>(c)];
    if (factor != 0.0) {
      out += factor * fe::consistent_load_vector(model_, side.cracked.mesh, model_.cases[c]);
    }
  }
  for (const std::size_t c : pairs_) {
    const contact::PairConstraints& pair = side.pairs[c];
    Eigen::Index r = 0;
    for (const auto* rows : {&pair.normal, &pair.tangent}) {
      for (const contact::ConstraintRow& row : *rows) {
        const double value = state.pair_lambda[c][r++];
        for (const contact::RowEntry& entry : row.entries) {
          out.segment<3>(3 * static_cast<Eigen::Index>(entry.node.index())) += value * entry.weight;
        }
      }
    }
  }
  return out;
}

// Weighted gaps of the rows that move, u kept. [row of the table]
base::Vector VirtualAxisExtension::openings(const Discretisation& side,
                                            const FrozenContactStep& step) const {
  base::Vector out = base::Vector::Zero(static_cast<Eigen::Index>(scene_.table.size()));
  const base::Vector& u = step.state.u;
  for (const std::size_t c : pairs_) {
    const double fit = scene_.contacts[c].gap ? step.solver.factors().fit[c] : 1.0;
    auto r = static_cast<Eigen::Index>(scene_.table.first[c]);
    for (const auto* rows : {&side.pairs[c].normal, &side.pairs[c].tangent}) {
      for (const contact::ConstraintRow& row : *rows) {
        out[r++] = row_opening(row, 3, u) + fit * row.gap;
      }
    }
  }
  return out;
}

// K with u and contact forces kept, less what it is now.
base::Vector VirtualAxisExtension::change(const FrozenContactStep& step,
                                          const KFunctionals& K) const {
  const StepState& state = step.state;
  base::Vector out = rows_.transpose() * state.u - K.of_displacements().transpose() * state.u;
  out += K_added_by_loads(model_, moved_, state.case_factor) -
         K_added_by_loads(model_, scene_, state.case_factor);
  if (!pairs_.empty()) {
    base::Vector lambda(static_cast<Eigen::Index>(scene_.table.size()));
    for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
      lambda.segment(static_cast<Eigen::Index>(scene_.table.first[c]),
                     state.pair_lambda[c].size()) = state.pair_lambda[c];
    }
    out += of_force_ * lambda - K.of_contact_forces() * lambda;
  }
  return out;
}

ParameterPartialDerivatives
VirtualAxisExtension::axis_partial_derivatives(const FrozenContactStep& step,
                                               const KFunctionals& K) const {
  ParameterPartialDerivatives out;
  out.is.cause = axis_ == EllipseAxis::a ? results::SensitivityParameter::length
                                         : results::SensitivityParameter::axis;
  out.is.name = crack_name();
  out.is.value = size_;
  out.load = (loads(moved_, step.state) - loads(scene_, step.state)) / step_;
  if (!pairs_.empty()) {
    out.gap = (openings(moved_, step) - openings(scene_, step)) / step_;
  }
  out.direct = change(step, K) / step_;
  return out;
}

} // namespace spricka::analysis
