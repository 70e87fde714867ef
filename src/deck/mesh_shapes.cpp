// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/mesh_shapes.hpp"

#include "deck/dimension_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

/// Collects what is wrong with a card, by the key.
class ShapeCheck {
public:
  ShapeCheck(DeckContext& context, const CheckedCard& card) : context_(context), card_(card) {}

  /// Reports what a key must be where it is not.
  void require(bool holds, std::string_view key, std::string_view rule) {
    if (!holds) {
      const CheckedValue* value = card_.find(key);
      context_.error(value != nullptr ? value->span : card_.span, "E109",
                     fmt::format("{}: {}", key, rule));
    }
  }

private:
  DeckContext& context_;
  const CheckedCard& card_;
};

void check_ring(ShapeCheck& check, const CheckedCard& card) {
  const mesh::RingSpec spec = ring_spec(card);
  const double turn = spec.t1 - spec.t0;
  check.require(spec.ro > spec.ri, "RO", "the outer radius is larger than RI");
  check.require(turn > 0.0 && turn <= 2.0 * std::numbers::pi * (1.0 + 1e-12), "T1",
                "the ring goes from T0 to a larger T1, at most once round");
  check.require(
      spec.ri > 0.0 || element_type_of_card(card) != base::ElementType::hexec27 ||
          mesh::divides_into_quadrilaterals(spec),
      "NT",
      "a disc of HEXEC27, which cannot stand beside pentahedra, has a multiple of 6, 8, 10 "
      "or 14 elements round");
}

void check_lug(ShapeCheck& check, const CheckedCard& card) {
  const mesh::LugSpec spec = lug_spec(card);
  if (spec.ri <= 0.0) {
    check.require(false, "RI", "a lug has a bore");
  } else if (spec.width <= 2.0 * spec.ri) {
    check.require(false, "W", "the lug is wider than its bore");
  } else if (spec.length <= spec.ri) {
    check.require(false, "L", "END lies outside the bore");
  } else if (spec.ro > 0.5 * spec.width * (1.0 + 1e-9)) {
    check.require(false, "RO",
                  "the head is at most as wide as END; one that is wider has a fillet, "
                  "which $IMPORT of a drawing can give it");
  } else {
    check.require(std::hypot(spec.ex, spec.ey) + spec.ri < spec.ro,
                  card.has_key("RO") ? "RO" : "EX", "the bore lies within the round head");
  }
}

void check_plate(ShapeCheck& check, const CheckedCard& card) {
  const mesh::PlateSpec spec = plate_spec(card);
  check.require(spec.ri > 0.0, "RI", "the plate has a hole");
  const base::Vec3 low = spec.hole - spec.origin;
  const base::Vec3 high = spec.size - low;
  check.require(std::min(low.x(), high.x()) > spec.ri, card.has_key("XH") ? "XH" : "LX",
                "the hole lies within the plate");
  check.require(std::min(low.y(), high.y()) > spec.ri, card.has_key("YH") ? "YH" : "LY",
                "the hole lies within the plate");
}

} // namespace

base::ElementType element_type_of_card(const CheckedCard& card) {
  return base::element_type_by_name(card.word_value("TYPE"));
}

mesh::BlockSpec block_spec(const CheckedCard& card) {
  mesh::BlockSpec spec;
  spec.type = element_type_of_card(card);
  spec.origin = {card.number_value("X0"), card.number_value("Y0"), card.number_value("Z0")};
  spec.size = {card.number_value("LX"), card.number_value("LY"), card.number_value("LZ")};
  spec.nx = card.integer_value("NX");
  spec.ny = card.integer_value("NY");
  spec.nz = card.integer_value("NZ");
  spec.bias = card.number_value("BIAS");
  return spec;
}

mesh::RingSpec ring_spec(const CheckedCard& card) {
  mesh::RingSpec spec;
  spec.x0 = card.number_value("X0");
  spec.y0 = card.number_value("Y0");
  spec.ri = card.number_value("RI");
  spec.ro = card.number_value("RO");
  spec.t0 = card.number_value("T0");
  spec.t1 = card.number_value("T1");
  spec.nr = card.integer_value("NR");
  spec.nt = card.integer_value("NT");
  spec.bias = card.number_value("BIAS");
  return spec;
}

mesh::LugSpec lug_spec(const CheckedCard& card) {
  mesh::LugSpec spec;
  spec.x0 = card.number_value("X0");
  spec.y0 = card.number_value("Y0");
  spec.ri = card.number_value("RI");
  spec.width = card.number_value("W");
  spec.ro = card.has_key("RO") ? card.number_value("RO") : 0.5 * spec.width;
  spec.ex = card.number_value("EX");
  spec.ey = card.number_value("EY");
  spec.length = card.number_value("L");
  spec.nr = card.integer_value("NR");
  spec.nt = card.integer_value("NT");
  return spec;
}

mesh::PlateSpec plate_spec(const CheckedCard& card) {
  mesh::PlateSpec spec;
  spec.origin = {card.number_value("X0"), card.number_value("Y0"), 0.0};
  spec.size = {card.number_value("LX"), card.number_value("LY"), 0.0};
  spec.hole = spec.origin + 0.5 * spec.size;
  if (card.has_key("XH")) {
    spec.hole.x() = card.number_value("XH");
  }
  if (card.has_key("YH")) {
    spec.hole.y() = card.number_value("YH");
  }
  spec.ri = card.number_value("RI");
  spec.nr = card.integer_value("NR");
  spec.nt = card.integer_value("NT");
  return spec;
}

bool check_mesh_shape(DeckContext& context, const CheckedCard& card) {
  const DimensionRules& rules =
      dimension_rules.at(base::element_info(element_type_of_card(card)).dim);
  if (!rules.mesh_size.empty() && !card.has_key(rules.mesh_size)) {
    context.error(card.span, "E106",
                  fmt::format("$MESH with elements in {} needs {}", rules.where, rules.mesh_size));
    return false;
  }
  const std::size_t errors = context.diagnostics.error_count();
  ShapeCheck check(context, card);
  if (card.key_has_word("SHAPE", "RING")) {
    check_ring(check, card);
  } else if (card.key_has_word("SHAPE", "LUG")) {
    check_lug(check, card);
  } else if (card.key_has_word("SHAPE", "PLATE")) {
    check_plate(check, card);
  }
  return context.diagnostics.error_count() == errors;
}

} // namespace spricka::deck
