// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/assemble.hpp"
#include "fe/dof_map.hpp"
#include "model/model.hpp"

#include <functional>
#include <vector>

/// Small plane problems for tests: meshes made from corner points and cells, boundary sets by
/// place, and a direct solution.
namespace spricka::test {

using base::Vec2;
using base::Vec3;

/// A model with one material and one property; the mesh is model.mesh.
model::Model plane_model(double E, double nu, model::StressState state, double thickness = 1.0);

/// Quadrilateral cells (anticlockwise) over corner points.
struct Cells {
  std::vector<Vec2> points;
  std::vector<std::array<int, 4>> cells;
};

/// nx by ny cells on the unit square; `spacing` moves the corner points, so that layers may grow
/// while mid nodes stay in the middle of their edges.
using Map = std::function<Vec2(const Vec2&)>;
Cells unit_grid(
    int nx, int ny, const Map& spacing = [](const Vec2& p) { return p; });

/// The five irregular quadrilaterals of MacNeal and Harder (1985) on the unit square.
Cells macneal_harder();

/// Elements of any plane type on cells, all with property 0; triangles halve each cell, mid nodes
/// lie halfway. All nodes, mid nodes too, are then moved by `map`.
model::Mesh make_mesh(
    base::ElementType type, const Cells& cells, const Map& map = [](const Vec2& p) { return p; });

/// Moves the mid nodes of all edges that end at a corner node to the quarter next to it, and the
/// centre of a QUAMC9 to the place its eight other nodes give it.
void make_quarter_points(model::Mesh& mesh, base::NodeId tip);

using Where = std::function<bool(const Vec3&)>;

/// Sides that belong to one element only and whose nodes all satisfy `where`.
std::vector<model::Face> boundary(const model::Mesh& mesh, const Where& where);

/// Adds sets to the mesh of a model and returns their numbers.
base::NodeSetId node_set(model::Model& model, const Where& where);
base::FaceSetId face_set(model::Model& model, const Where& where);
base::ElementSetId all_elements(model::Model& model);

/// Adds a freedom card: the nodes where `where` holds, x and/or y.
void set_freedom(model::Model& model, model::FreedomRole cls, const Where& where, bool x, bool y);

/// Displacements [dim * node] for one load case, by Eigen's simplicial LDLT; external freedoms
/// are solved for like local ones. `reaction`, when given, receives K u - f.
base::Vector solve(const model::Model& model, const model::LoadCase& load_case,
                   base::Vector* reaction = nullptr);

/// Expressions of test fields.
base::CompiledExpression linear(double c, double cx, double cy);

std::vector<base::ElementId> every_element(const model::Mesh& mesh);

} // namespace spricka::test
