// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/answers.hpp"

#include "mesher/gmsh_session.hpp"
#include "mesher/step_entities.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <new>
#include <set>
#include <string_view>

namespace spricka::mesher {
namespace {

using base::Vec3;

/// A face at one of its points.
struct LocalShape {
  Vec3 x, normal;
  double large = 0.0; ///< principal curvatures, by their amount
  double small = 0.0;
  Vec3 along_small; ///< direction of the smaller one
};

Vec3 vector_at(const std::vector<double>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

/// At some points within the face's parameters, away from poles and seams.
std::vector<LocalShape> look_at_face(int face) {
  std::vector<double> low;
  std::vector<double> high;
  gmsh::model::getParametrizationBounds(2, face, low, high);
  std::vector<double> uv;
  constexpr int parts = 5;
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; j < parts; ++j) {
      uv.push_back(low[0] + (high[0] - low[0]) * (i + 0.4) / parts);
      uv.push_back(low[1] + (high[1] - low[1]) * (j + 0.4) / parts);
    }
  }
  std::vector<double> x;
  std::vector<double> normals;
  std::vector<double> most;
  std::vector<double> least;
  std::vector<double> along_most;
  std::vector<double> along_least;
  gmsh::model::getValue(2, face, uv, x);
  gmsh::model::getNormal(face, uv, normals);
  gmsh::model::getPrincipalCurvatures(face, uv, most, least, along_most, along_least);
  const std::size_t count = uv.size() / 2;
  std::vector<LocalShape> shapes;
  if (x.size() != 3 * count || normals.size() != 3 * count || most.size() != count ||
      least.size() != count || along_most.size() != 3 * count || along_least.size() != 3 * count) {
    return shapes;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool first = std::abs(most[i]) >= std::abs(least[i]);
    shapes.push_back({vector_at(x, i), vector_at(normals, i),
                      std::max(std::abs(most[i]), std::abs(least[i])),
                      std::min(std::abs(most[i]), std::abs(least[i])),
                      vector_at(first ? along_least : along_most, i)});
  }
  return shapes;
}

/// The directions of an axis are two: of both the one that counts upwards.
Vec3 upward(const Vec3& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0.0 ? Vec3(-axis) : axis;
}

/// Whether the centres of curvature lie on the side that the outward normal points to.
bool is_hollow(const std::vector<LocalShape>& shapes, double radius, const Vec3& axis) {
  double spread_outward = 0.0;
  double spread_inward = 0.0;
  for (const LocalShape& shape : shapes) {
    const auto off = [&](double sign) {
      const Vec3 d = (shape.x + sign * radius * shape.normal) -
                     (shapes.front().x + sign * radius * shapes.front().normal);
      return (d - axis.dot(d) * axis).squaredNorm();
    };
    spread_outward += off(1.0);
    spread_inward += off(-1.0);
  }
  return spread_outward < spread_inward;
}

std::string_view kind_by_name(int face) {
  std::string type;
  gmsh::model::getType(2, face, type);
  return type == "Cone" ? "cone" : type == "Torus" ? "torus" : "curved";
}

/// By its curvatures, as many programs write round faces as splines.
void classify(int face, mesh::StepFace& result) {
  const std::vector<LocalShape> shapes = look_at_face(face);
  result.kind = kind_by_name(face);
  if (shapes.empty() || !std::ranges::all_of(shapes, [](const LocalShape& s) {
        return std::isfinite(s.large) && s.x.allFinite() && s.normal.allFinite();
      })) {
    return;
  }
  double size = 0.0; // of the face
  double largest = 0.0;
  double smallest = shapes.front().large;
  double other = 0.0;
  double other_least = shapes.front().small;
  for (const LocalShape& shape : shapes) {
    size = std::max(size, (shape.x - shapes.front().x).norm());
    largest = std::max(largest, shape.large);
    smallest = std::min(smallest, shape.large);
    other = std::max(other, shape.small);
    other_least = std::min(other_least, shape.small);
  }
  constexpr double even = 1e-5;
  const bool constant = largest - smallest <= even * largest;
  if (largest * size <= even) {
    result.kind = "plane";
    result.direction = shapes.front().normal;
  } else if (constant && other <= even * largest) {
    result.kind = "cylinder";
    result.radius = 1.0 / largest;
    result.direction = upward(shapes.front().along_small.normalized());
    result.hollow = is_hollow(shapes, result.radius, result.direction);
  } else if (constant && other_least >= (1.0 - even) * largest) {
    result.kind = "sphere";
    result.radius = 1.0 / largest;
    result.hollow = is_hollow(shapes, result.radius, Vec3::Zero());
  }
}

mesh::StepFace describe_face(int face) {
  mesh::StepFace result;
  result.entity = face;
  classify(face, result);
  gmsh::model::occ::getMass(2, face, result.area);
  gmsh::model::occ::getCenterOfMass(2, face, result.centre.x(), result.centre.y(),
                                    result.centre.z());
  constexpr double few = 8.0; // points in a direction
  const FacePoints inside = points_inside_face(face, std::sqrt(result.area) / few);
  result.points = points_of_face_edges(face);
  result.points.insert(result.points.end(), inside.points.begin(), inside.points.end());
  return result;
}

/// The last part of the path of labels that gmsh makes of an assembly; empty for what OpenCASCADE
/// writes where there is no name.
std::string part_name(int volume) {
  std::string path;
  gmsh::model::getEntityName(3, volume, path);
  const std::size_t slash = path.rfind('/');
  std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const bool none = name.starts_with("Open CASCADE STEP translator") || name == "Shapes" ||
                    name == "SOLID" || name == "COMPOUND" || name == "NONE";
  return none ? std::string() : name;
}

mesh::StepSolid describe_solid(int volume) {
  mesh::StepSolid solid;
  solid.name = part_name(volume);
  gmsh::model::occ::getMass(3, volume, solid.volume);
  gmsh::model::getBoundingBox(3, volume, solid.low.x(), solid.low.y(), solid.low.z(),
                              solid.high.x(), solid.high.y(), solid.high.z());
  for (const int face : faces_of_volume(volume)) {
    solid.faces.push_back(describe_face(face));
  }
  return solid;
}

} // namespace

mesh::StepFileContents describe_step_file(const std::string& path) {
  mesh::StepFileContents contents;
  const GmshSession session;
  try {
    gmsh::open(path);
    if (GmshSession::errors().empty()) {
      std::set<int> of_solids;
      for (const int volume : model_volumes()) {
        contents.solids.push_back(describe_solid(volume));
        for (const mesh::StepFace& face : contents.solids.back().faces) {
          of_solids.insert(face.entity);
        }
      }
      gmsh::vectorpair faces;
      gmsh::model::getEntities(faces, 2);
      contents.free_faces = static_cast<int>(faces.size()) - static_cast<int>(of_solids.size());
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) { // gmsh throws a string, or what its parts throw; the log has the words
    contents.gave_up = true;
  }
  contents.errors = GmshSession::errors();
  contents.warnings = GmshSession::warnings();
  return contents;
}

} // namespace spricka::mesher
