// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/mesher_request.hpp"

#include "mesh/gmsh_elements.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::mesh {
namespace {

using base::Vec2;

ByteWriter frame(MesherFrameKind kind) {
  ByteWriter out;
  out.write_value(kind);
  return out;
}

void write(ByteWriter& out, const Vec2& p) {
  out.write_value(p.x());
  out.write_value(p.y());
}

Vec2 read_point(ByteReader& in) {
  const auto x = in.read_value<double>();
  const auto y = in.read_value<double>();
  return {x, y};
}

void write(ByteWriter& out, const std::vector<Vec2>& points) {
  out.write_value(points.size());
  for (const Vec2& p : points) {
    write(out, p);
  }
}

std::vector<Vec2> read_points(ByteReader& in) {
  std::vector<Vec2> points;
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    points.push_back(read_point(in));
  }
  return points;
}

void write(ByteWriter& out, const std::vector<std::vector<int>>& chains) {
  out.write_value(chains.size());
  for (const std::vector<int>& chain : chains) {
    out.write_list(chain);
  }
}

std::vector<std::vector<int>> read_chains(ByteReader& in) {
  std::vector<std::vector<int>> chains;
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    chains.push_back(in.read_list<int>());
  }
  return chains;
}

void write(ByteWriter& out, const std::vector<GmshBlock>& blocks) {
  out.write_value(blocks.size());
  for (const GmshBlock& block : blocks) {
    out.write_value(block.entity);
    out.write_value(block.type);
    out.write_text(block.type_name);
    out.write_list(block.tags);
    out.write_list(block.nodes);
  }
}

/// The nodes of a block are as many as its elements have, and these are of the right dimension.
bool belong_together(const GmshBlock& block, int dim) {
  const auto known = from_gmsh(block.type);
  if (known && base::element_info(known->type).dim != dim) {
    return false;
  }
  if (block.tags.empty()) {
    return block.nodes.empty();
  }
  return known ? block.nodes.size() ==
                     block.tags.size() *
                         static_cast<std::size_t>(base::element_info(known->type).nodes)
               : block.nodes.size() % block.tags.size() == 0;
}

std::vector<GmshBlock> read_blocks(ByteReader& in, int dim, bool& good) {
  std::vector<GmshBlock> blocks;
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    GmshBlock block;
    block.entity = in.read_value<int>();
    block.type = in.read_value<int>();
    block.type_name = in.read_text();
    block.tags = in.read_list<std::size_t>();
    block.nodes = in.read_list<std::size_t>();
    good = good && belong_together(block, dim);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

} // namespace

std::string fill_request(const PlaneRegion& region, const Grading& size) {
  ByteWriter out = frame(MesherFrameKind::fill);
  write(out, region.points);
  write(out, region.loops);
  write(out, region.embedded);
  out.write_value(size.growth());
  out.write_value(size.sources().size());
  for (const Grading::SizeSource& source : size.sources()) {
    write(out, source.at);
    out.write_value(source.size);
  }
  return out.release();
}

bool read_fill_request(ByteReader& in, PlaneRegion& region, Grading& size) {
  region.points = read_points(in);
  region.loops = read_chains(in);
  region.embedded = read_chains(in);
  size = Grading(in.read_value<double>());
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    const Vec2 at = read_point(in);
    size.add_source(at, in.read_value<double>());
  }
  return in.at_end();
}

std::string fill_answer(const TriangleFill& filling) {
  ByteWriter out = frame(MesherFrameKind::filling);
  write(out, filling.added);
  out.write_list(filling.triangles);
  out.write_text(filling.trouble);
  return out.release();
}

bool read_fill_answer(ByteReader& in, const PlaneRegion& region, TriangleFill& filling) {
  filling.added = read_points(in);
  filling.triangles = in.read_list<std::array<int, 3>>();
  filling.trouble = in.read_text();
  const auto count = static_cast<int>(region.points.size() + filling.added.size());
  return in.at_end() &&
         std::all_of(
             filling.triangles.begin(), filling.triangles.end(), [&](const std::array<int, 3>& t) {
               return std::all_of(t.begin(), t.end(), [&](int n) { return n >= 0 && n < count; });
             });
}

std::string import_request(const MesherImport& import) {
  ByteWriter out = frame(MesherFrameKind::import);
  out.write_text(import.name);
  out.write_text(import.text);
  out.write_value(import.script);
  out.write_value(import.quadratic);
  out.write_texts(import.constants);
  out.write_value(static_cast<bool>(import.size));
  if (import.size) {
    out.write_value(import.size.scale);
    out.write_value(import.size.map->requests().size());
    for (const SizeMap::SizeRequest& request : import.size.map->requests()) {
      write(out, request.at);
      out.write_value(request.size);
      out.write_value(request.fresh);
    }
  }
  return out.release();
}

bool read_import_request(ByteReader& in, MesherImport& import) {
  import.name = in.read_text();
  import.text = in.read_text();
  import.script = in.read_value<bool>();
  import.quadratic = in.read_value<bool>();
  import.constants = in.read_texts();
  if (in.read_value<bool>()) {
    import.size.scale = in.read_value<double>();
    std::vector<SizeMap::SizeRequest> requests;
    for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
      SizeMap::SizeRequest request;
      request.at = read_point(in);
      request.size = in.read_value<double>();
      request.fresh = in.read_value<bool>();
      requests.push_back(request);
    }
    import.size.map = std::make_shared<const SizeMap>(std::move(requests));
  }
  return in.at_end();
}

std::string model_answer(const GmshModel& model) {
  ByteWriter out = frame(MesherFrameKind::model);
  out.write_value(model.dim);
  out.write_list(model.node_tags);
  out.write_list(model.x);
  write(out, model.elements);
  write(out, model.sides);
  out.write_value(model.groups.size());
  for (const GmshGroup& group : model.groups) {
    out.write_value(group.dim);
    out.write_value(group.tag);
    out.write_text(group.name);
    out.write_list(group.entities);
    out.write_list(group.nodes);
  }
  out.write_value(model.constants.size());
  for (const auto& [name, value] : model.constants) {
    out.write_text(name);
    out.write_value(value);
  }
  out.write_texts(model.errors);
  out.write_texts(model.warnings);
  out.write_value(static_cast<char>(model.gave_up ? 1 : 0));
  return out.release();
}

bool read_model_answer(ByteReader& in, GmshModel& model) {
  bool good = true;
  model.dim = in.read_value<int>();
  model.node_tags = in.read_list<std::size_t>();
  model.x = in.read_list<double>();
  model.elements = read_blocks(in, model.dim, good);
  model.sides = read_blocks(in, model.dim - 1, good);
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    GmshGroup group;
    group.dim = in.read_value<int>();
    group.tag = in.read_value<int>();
    group.name = in.read_text();
    group.entities = in.read_list<int>();
    group.nodes = in.read_list<std::size_t>();
    model.groups.push_back(std::move(group));
  }
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    std::string name = in.read_text();
    model.constants.emplace_back(std::move(name), in.read_value<double>());
  }
  model.errors = in.read_texts();
  model.warnings = in.read_texts();
  model.gave_up = in.read_value<char>() != 0;
  return in.at_end() && good && model.dim >= 0 && model.dim <= 3 &&
         model.x.size() == 3 * model.node_tags.size() &&
         std::all_of(model.x.begin(), model.x.end(), [](double x) { return std::isfinite(x); });
}

} // namespace spricka::mesh
