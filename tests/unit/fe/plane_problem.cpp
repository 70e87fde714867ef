// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/fe/plane_problem.hpp"

#include "model/model.hpp"
#include "shape/shape.hpp"
#include "shape/topology.hpp"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace spricka::test {

using base::ElementId;
using base::NodeId;

namespace {

// An edge by its end nodes, whichever way it runs.
using Edge = std::pair<std::size_t, std::size_t>;
Edge edge(NodeId a, NodeId b) {
  return std::minmax({a.index(), b.index()});
}

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// Adds elements cell by cell and makes each edge node once.
class MeshMaker {
public:
  MeshMaker(base::ElementType type, const std::vector<Vec2>& points) : type_(type) {
    for (const Vec2& p : points) {
      add_node(p);
    }
  }

  void add(const std::vector<NodeId>& corners) {
    std::vector<NodeId> nodes = corners;
    if (base::element_info(type_).quadratic) {
      for (std::size_t s = 0; s < corners.size(); ++s) {
        nodes.push_back(middle(corners[s], corners[(s + 1) % corners.size()]));
      }
    }
    if (type_ == base::ElementType::quamc9) {
      Vec2 centre = Vec2::Zero();
      for (const NodeId n : corners) {
        centre += 0.25 * mesh.x[n.index()].head<2>();
      }
      nodes.push_back(add_node(centre));
    }
    const auto label = static_cast<base::Label>(mesh.element_count() + 1);
    const ElementId e = model::add_element(mesh, type_, nodes, label, base::NetId(0));
    mesh.property[e.index()] = base::PropertyId(0);
  }

  model::Mesh mesh;

private:
  NodeId add_node(const Vec2& p) {
    const auto label = static_cast<base::Label>(mesh.node_count() + 1);
    return model::add_node(mesh, Vec3(p.x(), p.y(), 0.0), label, base::NetId(0));
  }
  NodeId middle(NodeId a, NodeId b) {
    const Edge key = edge(a, b);
    const auto known = middle_.find(key);
    if (known != middle_.end()) {
      return known->second;
    }
    const Vec3 x = 0.5 * (mesh.x[a.index()] + mesh.x[b.index()]);
    return middle_[key] = add_node(x.head<2>());
  }

  base::ElementType type_;
  std::map<Edge, NodeId> middle_;
};

} // namespace

model::Model plane_model(double E, double nu, model::StressState state, double thickness) {
  model::Model model;
  model::ElasticMaterial material;
  material.E = E;
  material.nu = nu;
  model.materials.push_back(material);
  model::ElementProperty property;
  property.material = base::MaterialId(0);
  property.state = state;
  property.thickness = thickness;
  model.properties.push_back(property);
  model.nets.emplace_back();
  return model;
}

Cells unit_grid(int nx, int ny, const Map& spacing) {
  Cells grid;
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      grid.points.push_back(spacing({static_cast<double>(i) / nx, static_cast<double>(j) / ny}));
    }
  }
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int n = j * (nx + 1) + i;
      grid.cells.push_back({n, n + 1, n + nx + 2, n + nx + 1});
    }
  }
  return grid;
}

Cells macneal_harder() {
  Cells patch;
  for (const Vec2& p : {Vec2(0.0, 0.0), Vec2(0.24, 0.0), Vec2(0.24, 0.12), Vec2(0.0, 0.12),
                        Vec2(0.04, 0.02), Vec2(0.18, 0.03), Vec2(0.16, 0.08), Vec2(0.08, 0.08)}) {
    patch.points.emplace_back(p.x() / 0.24, p.y() / 0.12);
  }
  patch.cells = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
  return patch;
}

model::Mesh make_mesh(base::ElementType type, const Cells& cells, const Map& map) {
  MeshMaker maker(type, cells.points);
  for (const std::array<int, 4>& cell : cells.cells) {
    std::vector<NodeId> corners;
    corners.reserve(cell.size());
    for (const int n : cell) {
      corners.emplace_back(at(n));
    }
    if (base::element_info(type).corners == 4) {
      maker.add(corners);
    } else {
      maker.add({corners[0], corners[1], corners[2]});
      maker.add({corners[0], corners[2], corners[3]});
    }
  }
  for (Vec3& x : maker.mesh.x) {
    x.head<2>() = map(Vec2(x.head<2>()));
  }
  return maker.mesh;
}

void make_quarter_points(model::Mesh& mesh, NodeId tip) {
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementInfo& info = base::element_info(mesh.type[i]);
    const std::span<const NodeId> nodes = mesh.element_nodes(ElementId(i));
    if (!info.quadratic || std::ranges::find(nodes, tip) == nodes.end()) {
      continue;
    }
    for (int s = 0; s < info.sides; ++s) {
      const std::span<const int> side = shape::side_nodes(mesh.type[i], s);
      const NodeId a = nodes[at(side[0])];
      const NodeId b = nodes[at(side[1])];
      if (a == tip || b == tip) {
        const Vec3& far = mesh.x[(a == tip ? b : a).index()];
        mesh.x[nodes[at(side[2])].index()] = 0.75 * mesh.x[tip.index()] + 0.25 * far;
      }
    }
    if (mesh.type[i] == base::ElementType::quamc9) {
      const Eigen::Matrix<double, 8, 1> N = shape::Quamc8::N(shape::Point<2>::Zero());
      Vec3 centre = Vec3::Zero();
      for (int k = 0; k < 8; ++k) {
        centre += N[k] * mesh.x[nodes[at(k)].index()];
      }
      mesh.x[nodes[8].index()] = centre;
    }
  }
}

std::vector<model::Face> boundary(const model::Mesh& mesh, const Where& where) {
  std::map<Edge, int> uses;
  std::vector<std::pair<model::Face, Edge>> sides;
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const ElementId e(i);
    for (int s = 0; s < base::element_info(mesh.type[i]).sides; ++s) {
      const std::span<const int> local = shape::side_nodes(mesh.type[i], s);
      const Edge key =
          edge(mesh.element_nodes(e)[at(local[0])], mesh.element_nodes(e)[at(local[1])]);
      ++uses[key];
      sides.push_back({{e, s}, key});
    }
  }
  std::vector<model::Face> faces;
  for (const auto& side : sides) {
    const model::Face& face = side.first;
    const std::span<const int> local =
        shape::side_nodes(mesh.type[face.element.index()], face.side);
    const bool inside = std::ranges::all_of(local, [&](int n) {
      return where(mesh.x[mesh.element_nodes(face.element)[at(n)].index()]);
    });
    if (uses[side.second] == 1 && inside) {
      faces.push_back(face);
    }
  }
  return faces;
}

base::NodeSetId node_set(model::Model& model, const Where& where) {
  model::NodeSet set;
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    if (where(model.mesh.x[n])) {
      set.nodes.emplace_back(n);
    }
  }
  model.mesh.node_sets.push_back(set);
  return base::NodeSetId(model.mesh.node_sets.size() - 1);
}

base::FaceSetId face_set(model::Model& model, const Where& where) {
  model.mesh.face_sets.push_back({"", boundary(model.mesh, where), {}});
  return base::FaceSetId(model.mesh.face_sets.size() - 1);
}

base::ElementSetId all_elements(model::Model& model) {
  model.mesh.element_sets.push_back({"", every_element(model.mesh), {}});
  return base::ElementSetId(model.mesh.element_sets.size() - 1);
}

void set_freedom(model::Model& model, model::FreedomRole cls, const Where& where, bool x, bool y) {
  model::NodeSetFreedomRole freedom;
  freedom.cls = cls;
  freedom.dof = {x, y, false};
  freedom.nodes = node_set(model, where);
  model.freedoms.push_back(freedom);
}

base::Vector solve(const model::Model& model, const model::LoadCase& load_case,
                   base::Vector* reaction) {
  const model::Mesh& mesh = model.mesh;
  std::vector<NodeId> nodes;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    nodes.emplace_back(n);
  }
  const std::vector<ElementId> elements = every_element(mesh);
  const fe::DofMap dofs = fe::number_freedoms(mesh, nodes, fe::classify_freedoms(model, mesh));
  const base::SymmetricCsc K = fe::assemble_stiffness(model, mesh, elements, {}, dofs);

  base::Vector u = fe::prescribed_displacement_vector(model, mesh, load_case);
  const base::Vector f = fe::consistent_load_vector(model, mesh, load_case);
  base::Vector r = -f;
  fe::add_internal_force(model, mesh, elements, u, r);
  base::Vector rhs(dofs.size());
  for (Eigen::Index i = 0; i < rhs.size(); ++i) {
    rhs[i] = -r[dofs.freedom[static_cast<std::size_t>(i)]];
  }
  const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>> lower(
      K.n, K.n, static_cast<std::int64_t>(K.row.size()), K.start.data(), K.row.data(),
      K.value.data());
  const Eigen::SparseMatrix<double> A = lower.cast<double>();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(A);
  EXPECT_EQ(factor.info(), Eigen::Success);
  const base::Vector x = factor.solve(rhs);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    u[dofs.freedom[static_cast<std::size_t>(i)]] += x[i];
  }
  if (reaction != nullptr) {
    *reaction = -f;
    fe::add_internal_force(model, mesh, elements, u, *reaction);
  }
  return u;
}

base::CompiledExpression linear(double c, double cx, double cy) {
  using base::OpCode;
  return {{{OpCode::number, c},
           {OpCode::number, cx},
           {OpCode::x},
           {OpCode::multiply},
           {OpCode::add},
           {OpCode::number, cy},
           {OpCode::y},
           {OpCode::multiply},
           {OpCode::add}}};
}

std::vector<ElementId> every_element(const model::Mesh& mesh) {
  std::vector<ElementId> elements;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    elements.emplace_back(e);
  }
  return elements;
}

} // namespace spricka::test
