// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/by_dimension.hpp"
#include "base/exit_codes.hpp"
#include "report/check_listing.hpp"

#include <nlohmann/json.hpp>

namespace spricka::report {

namespace {

using nlohmann::json;

json place(const base::Vec3& x) {
  return {x.x(), x.y(), x.z()};
}

template <class List, class Make> json array_of(const List& list, Make make) {
  json out = json::array();
  for (const auto& entry : list) {
    out.push_back(make(entry));
  }
  return out;
}

json of(const results::NetPreview& n) {
  json types = json::object();
  for (const auto& [type, count] : n.types) {
    types[type] = count;
  }
  return {{"net", n.name},
          {"nodes", n.nodes},
          {"elements", n.elements},
          {"types", types},
          {"freedoms",
           {{"local", n.local},
            {"external", n.external},
            {"suppressed", n.suppressed},
            {"prescribed", n.prescribed},
            {"dependent", n.dependent}}}};
}

json of(const results::WorstElementPreview& q) {
  return {{"of", q.where}, {"measure", q.measure}, {"value", q.value},
          {"net", q.net},  {"element", q.element}, {"at", place(q.at)}};
}

json of(const results::ContactPairPreview& c) {
  json out{
      {"contact", c.name},
      {"gap", {{"low", c.gap_low}, {"mean", c.gap_mean}, {"high", c.gap_high}}},
      {"declared_gap", nullptr},
      {"normals_angle", c.angle},
      {"slave",
       {{"faces", c.slave_edges}, {"facing", c.slave_facing}, {"overhang", c.slave_overhang}}},
      {"master",
       {{"faces", c.master_edges}, {"facing", c.master_facing}, {"overhang", c.master_overhang}}},
      {"pairing", c.pairing},
      {"choice", c.choice},
      {"rows", c.rows},
      {"merged", c.merged}};
  if (c.rigid) {
    out["master"] = "rigid";
  }
  if (c.declared) {
    out["declared_gap"] = c.declared_gap;
  }
  return out;
}

json of(const results::BodyRestraintPreview& b) {
  return {{"body", b.name},
          {"nodes", b.nodes},
          {"elements", b.elements},
          {"modes",
           {{"all", b.modes},
            {"supports", b.by_supports},
            {"contact", b.by_contact},
            {"nothing", b.by_nothing}}}};
}

json of(const results::LoadTotal& l) {
  return {{"case", l.load_case}, {"force", place(l.force)}, {"moment", place(l.moment)}};
}

json tip_json(const results::FrontPreview& f) {
  return {{"tip", f.name},     {"a", f.a},           {"mouth", place(f.mouth)},
          {"at", place(f.at)}, {"radius", f.radius}, {"size", f.size}};
}

json front_json(const results::FrontPreview& f) {
  return {{"front", f.name},    {"kind", f.kind},         {"a", f.a},           {"at", place(f.at)},
          {"length", f.length}, {"elements", f.elements}, {"radius", f.radius}, {"size", f.size}};
}

/// The list that fronts stand in, and what it tells of each.
struct FrontList {
  const char* name;
  json (*of)(const results::FrontPreview&);
};
constexpr base::ByDimension<FrontList> front_lists{{"tips", tip_json}, {"fronts", front_json}};

json of(const results::CrackLengthPreview& l, const FrontList& list) {
  json out{{"number", l.number},         {"a", l.a},
           {"nodes", l.nodes},           {"elements", l.elements},
           {"elements_cut", l.replaced}, {"elements_new", l.fresh},
           {"contact_rows", l.rows},     {"nets_new", l.condensed},
           {"nets_reused", l.reused},    {"unknowns_new", l.unknowns},
           {"externals", l.externals},   {"factor_entries", l.factor_entries},
           {"flops", l.flops},           {"memory", l.memory},
           {"cpu", l.seconds},           {"tips", json::array()},
           {"fronts", json::array()},    {"notes", l.notes},
           {"engines", l.engines}};
  out[list.name] = array_of(l.fronts, list.of);
  return out;
}

json of(const results::SymmetryPlanePreview& m) {
  return {{"across", std::string(1, "xyz"[m.axis])},
          {"at", m.at},
          {"against", m.against},
          {"no_half", m.no_half}};
}

json of(const results::ReportedScriptConstant& c) {
  return {{"file", c.file}, {"name", c.name}, {"value", c.value}, {"from", c.from}};
}

json of(const results::ReportedSolid& s) {
  return {{"file", s.file},     {"number", s.number},  {"name", s.name},       {"sets", s.sets},
          {"volume", s.volume}, {"low", place(s.low)}, {"high", place(s.high)}};
}

json of(const results::ReportedSolidFace& f) {
  return {{"sets", f.sets},
          {"kind", f.kind},
          {"radius", f.radius > 0.0 ? json(f.radius) : json(nullptr)},
          {"direction", f.direction.norm() > 0.0 ? json(place(f.direction)) : json(nullptr)},
          {"area", f.area},
          {"centre", place(f.centre)}};
}

} // namespace

std::string deck_preview_json(const results::DeckPreview& p, base::ProgramOutcome outcome) {
  const auto make = [](const auto& entry) { return of(entry); };
  const json out{
      {"spricka", SPRICKA_VERSION},
      {"deck", p.deck},
      {"title", p.title},
      {"length_unit", p.units.length_name},
      {"exit_code", base::exit_code(outcome)},
      {"nets", array_of(p.nets, make)},
      {"quality", array_of(p.quality, make)},
      {"inside_out", p.inside_out},
      {"contacts", array_of(p.pairs, make)},
      {"bodies", array_of(p.bodies, make)},
      {"loads", array_of(p.loads, make)},
      {"symmetry", array_of(p.mirrors, make)},
      {"lengths", array_of(p.lengths, [&](const auto& l) { return of(l, front_lists.at(p.dim)); })},
      {"scripts", array_of(p.geometry.scripts, make)},
      {"solids", array_of(p.geometry.solids, make)},
      {"faces", array_of(p.geometry.faces, make)},
      {"steps", p.steps},
      {"sweep", p.sweep},
      {"warnings", p.warnings},
      {"forecast",
       {{"exact", p.exact},
        {"memory", p.memory},
        {"machine_memory", p.machine_memory},
        {"flops", p.flops},
        {"cpu", p.seconds},
        {"flop_rate", p.flop_rate}}}};
  return out.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

} // namespace spricka::report
