// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/build_solid_cracks.hpp"
#include "deck/flaw_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::deck {

namespace {

using base::Vec3;

constexpr double off_plane = 1e-6; // of the front's extent: a front lies in one plane
constexpr double parallel = 1e-9;  // sine of the angle of two directions that are one

Vec3 point_of(const CheckedCard& card, char number) {
  Vec3 point;
  for (int i = 0; i < 3; ++i) {
    point[i] = card.number_value(std::string{"XYZ"[i], number});
  }
  return point;
}

// The normal by NORMAL, or from the centre to X1; Y where the deck says neither, as in the plane z
// = 0 of most fronts.
bool ellipse_axes(DeckContext& c, const CheckedCard& card, model::PlanarCrack& plane) {
  int axis = 1;
  if (card.has_key("X1")) {
    const Vec3 towards = point_of(card, '1') - plane.place;
    if (towards.norm() == 0.0) {
      c.error(card.find("X1")->span, "E109", "the normal's end is the centre itself");
      return false;
    }
    plane.normal = towards.normalized();
    plane.normal.cwiseAbs().maxCoeff(&axis);
  } else if (card.has_key("NORMAL")) {
    axis = card.word_value("NORMAL").front() - 'X';
    plane.normal = Vec3::Unit(axis);
  } else {
    c.error(card.span, "E106", "an ellipse in space needs NORMAL=X|Y|Z, or X1 Y1 Z1",
            "its normal runs from the centre X0 Y0 Z0 to X1 Y1 Z1");
    return false;
  }
  Vec3 towards = Vec3::Unit((axis + 1) % 3);
  if (card.has_key("X2")) {
    towards = point_of(card, '2') - plane.place;
  }
  const Vec3 flat = towards - plane.normal.dot(towards) * plane.normal;
  if (flat.norm() <= parallel * towards.norm() || towards.norm() == 0.0) {
    c.error(card.find("X2")->span, "E109", "the axis C runs along the normal of the ellipse");
    return false;
  }
  plane.along = flat.normalized();
  return true;
}

void ellipse(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  crack.kind = model::CrackDefinitionKind::ellipse;
  crack.plane.place = point_of(card, '0');
  crack.plane.a = card.number_value("A");
  crack.plane.c = card.optional_number("C").value_or(crack.plane.a);
  ellipse_axes(c, card, crack.plane);
  if (!card.rows.empty()) {
    c.error(card.rows.front().span, "E110", "points mean nothing with A, an ellipse");
  }
}

// The plane through all points (and the one within the crack of an open front), its normal with the
// largest component positive.
bool front_plane(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  std::vector<Vec3> all = crack.points;
  if (card.has_key("X0")) {
    all.push_back(crack.plane.place);
  }
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : all) {
    centre += p / static_cast<double>(all.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : all) {
    spread += (p - centre) * (p - centre).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const double extent = std::sqrt(axes.eigenvalues()[2]);
  if (std::sqrt(std::max(0.0, axes.eigenvalues()[1])) <= off_plane * extent) {
    c.error(card.span, "E115", "the points of the front lie on one line with X0 Y0 Z0",
            "X0 Y0 Z0 is a point within the crack, beside its front");
    return false;
  }
  Vec3 normal = axes.eigenvectors().col(0);
  int largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  normal *= normal[largest] < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < crack.points.size(); ++i) {
    if (std::abs(normal.dot(crack.points[i] - centre)) > off_plane * extent) {
      c.error(card.rows[i].span, "E115",
              fmt::format("this point is {:.3g} off the plane of the others",
                          std::abs(normal.dot(crack.points[i] - centre))),
              "a crack lies in one plane in this version");
      return false;
    }
  }
  crack.plane.normal = normal;
  const Vec3 first = crack.points.back() - crack.points.front();
  const Vec3 flat =
      crack.plane.closed ? crack.points.front() - centre : Vec3(first - normal.dot(first) * normal);
  crack.plane.along = flat.normalized();
  return true;
}

// All of X0, Y0, Z0 or none.
bool has_whole_place(DeckContext& c, const CheckedCard& card) {
  const std::array<bool, 3> given{card.has_key("X0"), card.has_key("Y0"), card.has_key("Z0")};
  const auto count = std::ranges::count(given, true);
  if (count != 0 && count != 3) {
    c.error(card.span, "E106", "a point within the crack has X0, Y0 and Z0");
  }
  return count == 0 || count == 3;
}

void drawn_front(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  crack.kind = model::CrackDefinitionKind::drawn;
  crack.plane.closed = card.key_has_word("CLOSED", "YES");
  for (const char* key : {"X1", "X2"}) {
    if (card.has_key(key)) {
      c.error(card.find(key)->span, "E110",
              fmt::format("{} means nothing without A, an ellipse", key));
    }
  }
  const bool sound = read_crack_points(c, card, 3, "a point of a front in space is x y z", crack) &&
                     has_whole_place(c, card);
  const std::size_t least = crack.plane.closed ? 4 : 2;
  if (sound && crack.points.empty()) {
    c.error(card.span, "E106", "$CRACK in space needs A, FRONT, or points as data lines",
            "A, C and a centre X0 Y0 Z0 for an ellipse; or points x y z of the front");
  } else if (sound && crack.points.size() < least) {
    c.error(card.span, "E115",
            fmt::format("{} front has at least {} points",
                        crack.plane.closed ? "a closed" : "an open", least));
  } else if (sound && !crack.plane.closed && !card.has_key("X0")) {
    c.error(card.span, "E106", "an open front needs X0 Y0 Z0: a point within the crack",
            "or CLOSED=YES where the last point joins the first");
  } else if (sound) {
    if (card.has_key("X0")) {
      crack.plane.place = point_of(card, '0');
    }
    front_plane(c, card, crack);
  }
}

// The point of a line; empty after an error.
std::optional<Vec3> row_point(DeckContext& c, const grammar::DataRow& row, std::size_t dim,
                              std::string_view form) {
  if (row.fields.size() != dim) {
    c.error(row.span, "E115", std::string(form));
    return std::nullopt;
  }
  Vec3 point = Vec3::Zero();
  bool ok = true;
  for (std::size_t i = 0; i < dim; ++i) {
    const auto x = c.read_number(row.fields[i], grammar::QuantityKind::length, "a coordinate");
    point[static_cast<Eigen::Index>(i)] = x.value_or(0.0);
    ok = ok && x.has_value();
  }
  return ok ? std::optional(point) : std::nullopt;
}

} // namespace

bool read_crack_points(DeckContext& context, const CheckedCard& card, std::size_t dim,
                       std::string_view form, model::CrackDefinition& crack) {
  bool ok = !card.rows_bad;
  for (const grammar::DataRow& row : card.rows) {
    const std::optional<Vec3> point = row_point(context, row, dim, form);
    ok = ok && point.has_value();
    if (!point) {
      continue;
    }
    if (!crack.points.empty() && (crack.points.back() - *point).norm() == 0.0) {
      context.error(row.span, "E115", "the same point twice in a row");
      ok = false;
    }
    crack.points.push_back(*point);
  }
  return ok;
}

void read_solid_crack(DeckContext& context, const CheckedCard& card,
                      model::CrackDefinition& crack) {
  if (card.has_key("AT")) {
    crack.kind = model::CrackDefinitionKind::ellipse;
    crack.plane = place_flaw(context, card).value_or(model::PlanarCrack{});
    if (!card.rows.empty()) {
      context.error(card.rows.front().span, "E110", "points mean nothing with AT");
    }
    return;
  }
  if (card.has_key("ANGLE")) {
    context.error(card.find("ANGLE")->span, "E110", "in space ANGLE belongs to AT",
                  "AT=BORE,ZMAX DEPTH=1 ANGLE=90[deg]: a corner flaw round a bore");
  }
  if (card.has_key("A")) {
    ellipse(context, card, crack);
  } else {
    drawn_front(context, card, crack);
  }
}

} // namespace spricka::deck
