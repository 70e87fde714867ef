// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/content_hash.hpp"

#include <memory>

#include <xxhash.h>

namespace spricka::run {

namespace {

class Hasher {
public:
  Hasher() : state_(XXH3_createState()) { XXH3_128bits_reset(state_.get()); }

  void add(const void* data, std::size_t bytes) { XXH3_128bits_update(state_.get(), data, bytes); }
  template <class T> void value(const T& v) { add(&v, sizeof v); }
  [[nodiscard]] HashKey key() const {
    const XXH128_hash_t h = XXH3_128bits_digest(state_.get());
    return {h.high64, h.low64};
  }

private:
  struct Free {
    void operator()(XXH3_state_t* s) const { XXH3_freeState(s); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
};

} // namespace

HashKey hash_net(const model::Model& model, const model::Mesh& mesh, const Net& net,
                 const std::vector<HashKey>& parts) {
  Hasher hash;
  for (const base::ElementId e : net.elements) {
    hash.value(mesh.type[e.index()]);
    const model::Property& property = model.property_of(mesh, e);
    const model::Material& material = model.material_of(mesh, e);
    hash.value(property.state);
    hash.value(property.thickness);
    hash.value(material.E);
    hash.value(material.nu);
    for (const base::NodeId n : mesh.nodes_of(e)) {
      hash.value(n.value);
      hash.add(mesh.x[n.index()].data(), 3 * sizeof(double));
    }
  }
  hash.add(net.map.freedom.data(), net.map.freedom.size() * sizeof(std::int32_t));
  hash.value(net.map.locals);
  for (const HashKey& part : parts) {
    hash.value(part.first);
    hash.value(part.second);
  }
  return hash.key();
}

} // namespace spricka::run
