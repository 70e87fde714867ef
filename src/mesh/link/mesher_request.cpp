// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/mesher_request.hpp"

#include "mesh/gmsh_elements.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::mesh {
namespace {

using base::Vec2;

ByteWriter frame(MesherFrame kind) {
  ByteWriter out;
  out.one(kind);
  return out;
}

void write(ByteWriter& out, const Vec2& p) {
  out.one(p.x());
  out.one(p.y());
}

Vec2 read_point(ByteReader& in) {
  const auto x = in.one<double>();
  const auto y = in.one<double>();
  return {x, y};
}

void write(ByteWriter& out, const std::vector<Vec2>& points) {
  out.one(points.size());
  for (const Vec2& p : points) {
    write(out, p);
  }
}

std::vector<Vec2> read_points(ByteReader& in) {
  std::vector<Vec2> points;
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    points.push_back(read_point(in));
  }
  return points;
}

void write(ByteWriter& out, const std::vector<std::vector<int>>& chains) {
  out.one(chains.size());
  for (const std::vector<int>& chain : chains) {
    out.list(chain);
  }
}

std::vector<std::vector<int>> read_chains(ByteReader& in) {
  std::vector<std::vector<int>> chains;
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    chains.push_back(in.list<int>());
  }
  return chains;
}

void write(ByteWriter& out, const std::vector<GmshBlock>& blocks) {
  out.one(blocks.size());
  for (const GmshBlock& block : blocks) {
    out.one(block.entity);
    out.one(block.type);
    out.text(block.type_name);
    out.list(block.tags);
    out.list(block.nodes);
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
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    GmshBlock block;
    block.entity = in.one<int>();
    block.type = in.one<int>();
    block.type_name = in.text();
    block.tags = in.list<std::size_t>();
    block.nodes = in.list<std::size_t>();
    good = good && belong_together(block, dim);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

} // namespace

std::string fill_request(const Region& region, const Grading& size) {
  ByteWriter out = frame(MesherFrame::fill);
  write(out, region.points);
  write(out, region.loops);
  write(out, region.embedded);
  out.one(size.growth());
  out.one(size.sources().size());
  for (const Grading::Source& source : size.sources()) {
    write(out, source.at);
    out.one(source.size);
  }
  return out.take();
}

bool read_fill_request(ByteReader& in, Region& region, Grading& size) {
  region.points = read_points(in);
  region.loops = read_chains(in);
  region.embedded = read_chains(in);
  size = Grading(in.one<double>());
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    const Vec2 at = read_point(in);
    size.add(at, in.one<double>());
  }
  return in.at_end();
}

std::string fill_answer(const Filling& filling) {
  ByteWriter out = frame(MesherFrame::filling);
  write(out, filling.added);
  out.list(filling.triangles);
  out.text(filling.trouble);
  return out.take();
}

bool read_fill_answer(ByteReader& in, const Region& region, Filling& filling) {
  filling.added = read_points(in);
  filling.triangles = in.list<std::array<int, 3>>();
  filling.trouble = in.text();
  const auto count = static_cast<int>(region.points.size() + filling.added.size());
  return in.at_end() &&
         std::all_of(
             filling.triangles.begin(), filling.triangles.end(), [&](const std::array<int, 3>& t) {
               return std::all_of(t.begin(), t.end(), [&](int n) { return n >= 0 && n < count; });
             });
}

std::string import_request(const MesherImport& import) {
  ByteWriter out = frame(MesherFrame::import);
  out.text(import.name);
  out.text(import.text);
  out.one(import.script);
  out.one(import.quadratic);
  out.texts(import.constants);
  out.one(static_cast<bool>(import.size));
  if (import.size) {
    out.one(import.size.scale);
    out.one(import.size.map->given().size());
    for (const SizeMap::Wish& wish : import.size.map->given()) {
      write(out, wish.at);
      out.one(wish.size);
      out.one(wish.fresh);
    }
  }
  return out.take();
}

bool read_import_request(ByteReader& in, MesherImport& import) {
  import.name = in.text();
  import.text = in.text();
  import.script = in.one<bool>();
  import.quadratic = in.one<bool>();
  import.constants = in.texts();
  if (in.one<bool>()) {
    import.size.scale = in.one<double>();
    std::vector<SizeMap::Wish> wishes;
    for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
      SizeMap::Wish wish;
      wish.at = read_point(in);
      wish.size = in.one<double>();
      wish.fresh = in.one<bool>();
      wishes.push_back(wish);
    }
    import.size.map = std::make_shared<const SizeMap>(std::move(wishes));
  }
  return in.at_end();
}

std::string model_answer(const GmshModel& model) {
  ByteWriter out = frame(MesherFrame::model);
  out.one(model.dim);
  out.list(model.node_tags);
  out.list(model.x);
  write(out, model.elements);
  write(out, model.sides);
  out.one(model.groups.size());
  for (const GmshGroup& group : model.groups) {
    out.one(group.dim);
    out.one(group.tag);
    out.text(group.name);
    out.list(group.entities);
    out.list(group.nodes);
  }
  out.one(model.constants.size());
  for (const auto& [name, value] : model.constants) {
    out.text(name);
    out.one(value);
  }
  out.texts(model.errors);
  out.texts(model.warnings);
  out.one(static_cast<char>(model.gave_up ? 1 : 0));
  return out.take();
}

bool read_model_answer(ByteReader& in, GmshModel& model) {
  bool good = true;
  model.dim = in.one<int>();
  model.node_tags = in.list<std::size_t>();
  model.x = in.list<double>();
  model.elements = read_blocks(in, model.dim, good);
  model.sides = read_blocks(in, model.dim - 1, good);
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    GmshGroup group;
    group.dim = in.one<int>();
    group.tag = in.one<int>();
    group.name = in.text();
    group.entities = in.list<int>();
    group.nodes = in.list<std::size_t>();
    model.groups.push_back(std::move(group));
  }
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    std::string name = in.text();
    model.constants.emplace_back(std::move(name), in.one<double>());
  }
  model.errors = in.texts();
  model.warnings = in.texts();
  model.gave_up = in.one<char>() != 0;
  return in.at_end() && good && model.dim >= 0 && model.dim <= 3 &&
         model.x.size() == 3 * model.node_tags.size() &&
         std::all_of(model.x.begin(), model.x.end(), [](double x) { return std::isfinite(x); });
}

} // namespace spricka::mesh
