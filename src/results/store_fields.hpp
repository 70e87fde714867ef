// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/growth.hpp"
#include "results/k_quantities.hpp"
#include "results/measured_growth.hpp"
#include "results/results.hpp"
#include "results/store_columns.hpp"

#include <concepts>

/// What a file keeps of each record, in this order: all of it. tests/unit/results counts.
namespace spricka::results {

template <class T, class R>
concept Of = std::same_as<std::remove_const_t<T>, R>;

template <class V, Of<KErrorBar> T> void fields(V& v, T& r) {
  v("eta", r.eta);
  v("sum", r.sum);
  v("flip", r.set_change);
  v("mesh", r.mesh);
  v("edge", r.edge);
  v("floor", r.floor);
  v("best", r.best);
  v("cancels", r.cancels);
  v("of_element", r.of_element);
}

template <class V, Of<Sensitivity> T> void fields(V& v, T& r) {
  v("cause", r.cause);
  v("name", r.name);
  v("value", r.value);
  v("below", r.below);
  v("above", r.above);
  v("range", r.range);
}

template <class V, Of<SensitivityResults> T> void fields(V& v, T& r) {
  v("of", r.of);
  v("notes", r.notes);
}

/// Numbers of a front point: those of the table of quantities first, the ones that judge others
/// last.
template <class V, Of<FrontPointResult> T> void fields(V& v, T& r) {
  v("number", r.number);
  v("at", r.x);
  for (const bool judges : {false, true}) {
    for (const KQuantity& q : k_quantities) {
      if (q.member != nullptr && q.judges == judges) {
        v(q.name, r.*q.member);
      }
    }
  }
  v("K1_domain", r.K1_domain);
  v("smooth", r.smooth);
  v("opening", r.opening);
  v("at_surface", r.at_surface);
  v("closed", r.closed);
  v("bar", r.bar);
  v("direction", r.direction);
}

template <class V, Of<FrontResult> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("a", r.a);
  v("length", r.length);
  v("loop", r.is_loop);
  v("angles", r.has_angles);
  v("points", r.points);
  v("no_bar", r.no_bar);
  v("doubt", r.invalid_reason);
  v("two_materials", r.two_materials);
  v("sensitivities", r.sensitivities);
}

/// A contact point by the table of its quantities; computed ones are not kept.
template <class V, Of<ContactPoint> T> void fields(V& v, T& r) {
  v("node", r.node);
  v("at", r.x);
  for (const ContactPointQuantity& q : point_quantities) {
    if (q.member != nullptr) {
      v(q.name, r.*q.member);
    } else if (q.is_word()) {
      v(q.name, r.*q.state);
    }
  }
  v("closed", r.closed);
  v("lip", r.crack_face);
  v("shear", r.shear);
}

template <class V, Of<ContactResult> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("mounted", r.mounted);
  v("points", r.points);
  v("corners", r.corners);
  v("force_on_slave", r.force_on_slave);
  v("moment_on_slave", r.moment_on_slave);
  v("min_pressure", r.min_pressure);
  v("max_pressure", r.max_pressure);
  v("mean_pressure", r.mean_pressure);
  v("max_penetration", r.max_penetration);
  v("area", r.area);
  v("space", r.space);
  v("radius", r.radius);
  v("round", r.round);
  v("arc_from", r.arc_from);
  v("arc_to", r.arc_to);
  v("closed", r.closed);
  v("rows", r.rows);
  v("sheared", r.sheared);
  v("rubs", r.rubs);
  v("sticking", r.sticking);
  v("slipping", r.slipping);
  v("shear_ratio", r.shear_ratio);
  v("max_slip", r.max_slip);
  v("stick_area", r.stick_area);
  v("stick_from", r.stick_from);
  v("stick_to", r.stick_to);
  v("friction_work", r.friction_work);
  v("unbounded", r.unbounded);
}

template <class V, Of<ForceBalance> T> void fields(V& v, T& r) {
  v("body", r.body);
  v("applied", r.applied);
  v("reaction", r.reaction);
  v("contact", r.contact);
  v("tie", r.tie);
  v("energy", r.energy);
}

template <class V, Of<NetErrorEstimate> T> void fields(V& v, T& r) {
  v("net", r.net);
  v("part", r.part);
  v("worst", r.worst);
  v("worst_share", r.worst_share);
}

template <class V, Of<OuterSurfaceFace> T> void fields(V& v, T& r) {
  v("element", r.element);
  v("outline", r.outline);
}

template <class V, Of<LoadPathFrontPoint> T> void fields(V& v, T& r) {
  v("is", r.is);
  v("K", r.K);
  v("smooth", r.smooth);
}

template <class V, Of<LoadPathFront> T> void fields(V& v, T& r) {
  v("is", r.is);
  v("points", r.points);
}

template <class V, Of<LoadPathContact> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("opening", r.opening);
  v("round", r.round);
  v("from", r.from);
  v("to", r.to);
  v("closed", r.closed);
  v("rows", r.rows);
}

template <class V, Of<ContactStatusChange> T> void fields(V& v, T& r) {
  v("t", r.t);
  v("contact", r.contact);
  v("node", r.node);
  v("place", r.place);
  v("closes", r.closes);
}

template <class V, Of<LoadPathResult> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("from", r.from);
  v("to", r.to);
  v("t", r.t);
  v("fronts", r.fronts);
  v("contacts", r.contacts);
  v("changes", r.changes);
  v("stopped", r.stopped);
  v("homogeneous", r.homogeneous);
  v("pivots", r.pivots);
  v("factorisations", r.factorisations);
  v("residual", r.residual);
  v("mismatch", r.mismatch);
  v("notes", r.notes);
}

template <class V, Of<LogLine> T> void fields(V& v, T& r) {
  v("processor", r.processor);
  v("text", r.text);
  v("cpu", r.cpu);
  v("wall", r.wall);
}

template <class V, Of<CheckResult> T> void fields(V& v, T& r) {
  v("text", r.text);
  v("wanted", r.wanted);
  v("found", r.found);
  v("error", r.error);
  v("tolerance", r.tolerance);
  v("relative", r.relative);
  v("passed", r.passed);
  v("source", r.source);
  v("trouble", r.trouble);
  v("bar", r.bar);
}

template <class V, Of<ToleranceRound> T> void fields(V& v, T& r) {
  v("number", r.number);
  v("unknowns", r.unknowns);
  v("worst", r.worst);
  v("bar", r.bar);
  v("wanted", r.wanted);
  v("cpu", r.cpu);
  v("next", r.next);
}

template <class V, Of<GrownTipResult> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("a", r.a);
  v("K_max", r.K_max);
  v("K_min", r.K_min);
  v("K2_max", r.K2_max);
  v("rate", r.rate);
  v("turn", r.turn);
  v("at", r.x);
  v("first_max", r.first_max);
  v("first_min", r.first_min);
}

template <class V, Of<GrowthStation> T> void fields(V& v, T& r) {
  v("increment", r.increment);
  v("cycles", r.cycles);
  v("tips", r.tips);
  v("passes", r.passes);
  v("change", r.change);
}

template <class V, Of<LifeCurvePoint> T> void fields(V& v, T& r) {
  v("cycles", r.cycles);
  v("a", r.a);
}

template <class V, Of<ScaledLife> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("ratio", r.ratio);
  v("curve", r.curve);
}

template <class V, Of<GrowthResult> T> void fields(V& v, T& r) {
  v("unit", r.unit);
  v("cycles_per_pass", r.cycles_per_pass);
  v("tips", r.tips);
  v("stations", r.stations);
  v("curve", r.curve);
  v("ended", r.ended);
  v("reason", r.reason);
  v("passages", r.passages);
  v("error", r.error);
  v("corrected", r.corrected);
  v("counted", r.counted);
  v("ranges", r.ranges);
  v("followed", r.followed);
  v("scaled", r.scaled);
}

template <class V, Of<GrowthTestPoint> T> void fields(V& v, T& r) {
  v("cycles", r.cycles);
  v("a", r.a);
  v("rate", r.rate);
  v("rate_low", r.rate_low);
  v("rate_high", r.rate_high);
  v("R", r.R);
  v("K", r.K);
  v("low", r.low);
  v("high", r.high);
  v("computed", r.computed);
  v("covered", r.covered);
}

template <class V, Of<GrowthTestResult> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("tip", r.tip);
  v("method", r.method);
  v("reference", r.reference);
  v("readings", r.readings);
  v("computed", r.computed);
  v("points", r.points);
  v("scatter", r.scatter);
  v("freedoms", r.freedoms);
  v("cycles", r.cycles);
  v("computed_cycles", r.computed_cycles);
  v("cycles_error", r.cycles_error);
  v("notes", r.notes);
}

template <class V, Of<base::SourceSpan> T> void fields(V& v, T& r) {
  v("file", r.file);
  v("begin", r.begin);
  v("end", r.end);
}

template <class V, Of<model::Face> T> void fields(V& v, T& r) {
  v("element", r.element);
  v("side", r.side);
}

template <class V, Of<model::NodeSet> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("nodes", r.nodes);
  v("span", r.span);
}

template <class V, Of<model::ElementSet> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("elements", r.elements);
  v("span", r.span);
}

template <class V, Of<model::FaceSet> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("faces", r.faces);
  v("span", r.span);
}

} // namespace spricka::results
