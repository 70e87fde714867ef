// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/growth.hpp"
#include "results/k_quantities.hpp"
#include "results/measured_growth.hpp"
#include "results/results.hpp"
#include "results/store_columns.hpp"

#include <concepts>
#include <type_traits>

#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>

/// What a file keeps of each record, in this order: all of it. tests/unit/results counts.
namespace spricka::results {

template <class T, class R>
concept RecordOfType = std::same_as<std::remove_const_t<T>, R>;

/// fields() of a record whose columns have the names of its members: these, in this order.
#define SPRICKA_STORED_RECORD(RECORD, ...)                                                         \
  template <class V, RecordOfType<RECORD> T> void fields(V& v, T& r) {                             \
    BOOST_PP_SEQ_FOR_EACH(SPRICKA_STORED_MEMBER, ~, BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__))         \
  }
#define SPRICKA_STORED_MEMBER(R, DATA, MEMBER) v(BOOST_PP_STRINGIZE(MEMBER), r.MEMBER);

template <class V, RecordOfType<KErrorBar> T> void fields(V& v, T& r) {
  v("eta", r.eta);
  v("sum", r.sum);
  v("flip", r.set_change);
  v("mesh", r.mesh);
  v("edge", r.edge);
  v("floor", r.floor);
  v("best", r.best);
  v("cancels", r.cancels);
  v("of_best", r.of_best);
  v("of_element", r.of_element);
}

SPRICKA_STORED_RECORD(Sensitivity, cause, name, value, below, above, range)

template <class V, RecordOfType<FrontKSensitivities> T> void fields(V& v, T& r) {
  v("of", r.by_parameter);
  v("notes", r.notes);
}

/// Numbers of a front point: those of the table of quantities first, the ones that judge others
/// last.
template <class V, RecordOfType<FrontPointResult> T> void fields(V& v, T& r) {
  v("number", r.number);
  v("at", r.x);
  for (const bool is_quality_measure : {false, true}) {
    for (const KQuantity& q : k_quantities) {
      if (q.member != nullptr && q.is_quality_measure == is_quality_measure) {
        v(q.name, r.*q.member);
      }
    }
  }
  v("K1_domain", r.K1_domain);
  v("smooth", r.smooth);
  v("raw", r.raw);
  v("raw_smooth", r.raw_smooth);
  v("opening", r.opening);
  v("at_surface", r.at_surface);
  v("closed", r.closed);
  v("bar", r.bar);
  v("direction", r.direction);
}

template <class V, RecordOfType<FrontResult> T> void fields(V& v, T& r) {
  v("name", r.name);
  v("a", r.a);
  v("length", r.length);
  v("loop", r.is_loop);
  v("angles", r.has_angles);
  v("points", r.points);
  v("no_bar", r.missing_bar_reason);
  v("doubt", r.invalid_reason);
  v("two_materials", r.two_materials);
  v("sensitivities", r.sensitivities);
}

/// A contact point by the table of its quantities; computed ones are not kept.
template <class V, RecordOfType<ContactPoint> T> void fields(V& v, T& r) {
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

SPRICKA_STORED_RECORD(ContactResult, name, mounted, points, corners, force_on_slave,
                      moment_on_slave, min_pressure, max_pressure, mean_pressure, max_penetration,
                      area, space, radius, round, arc_from, arc_to, closed, rows, sheared, rubs,
                      sticking, slipping, shear_ratio, max_slip, stick_area, stick_from, stick_to,
                      friction_work, unbounded)
SPRICKA_STORED_RECORD(ForceBalance, body, applied, reaction, contact, tie, energy)
SPRICKA_STORED_RECORD(NetErrorEstimate, net, part, worst, worst_share)
SPRICKA_STORED_RECORD(OuterSurfaceFace, element, outline)

template <class V, RecordOfType<LoadPathFrontPoint> T> void fields(V& v, T& r) {
  v("is", r.point_at_start);
  v("K", r.K);
  v("smooth", r.smooth);
}

template <class V, RecordOfType<LoadPathFront> T> void fields(V& v, T& r) {
  v("is", r.front_without_points);
  v("points", r.points);
}

SPRICKA_STORED_RECORD(LoadPathContact, name, opening, round, from, to, closed, rows)
SPRICKA_STORED_RECORD(ContactStatusChange, t, contact, node, place, closes)
SPRICKA_STORED_RECORD(LoadPathResult, name, from, to, t, fronts, contacts, changes, stopped,
                      homogeneous, pivots, factorisations, residual, mismatch, notes)
SPRICKA_STORED_RECORD(LogLine, processor, text, cpu, wall)
SPRICKA_STORED_RECORD(CheckResult, text, wanted, found, error, tolerance, relative, passed, source,
                      trouble, bar)
SPRICKA_STORED_RECORD(ToleranceRound, number, unknowns, worst, bar, wanted, cpu, next)

template <class V, RecordOfType<GrownPointResult> T> void fields(V& v, T& r) {
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

template <class V, RecordOfType<GrowthStation> T> void fields(V& v, T& r) {
  v("increment", r.increment);
  v("cycles", r.cycles);
  v("tips", r.points);
  v("passes", r.passes);
  v("change", r.change);
}

SPRICKA_STORED_RECORD(LifeCurvePoint, cycles, a)
SPRICKA_STORED_RECORD(ComparedLife, name, what, ratio, curve)
SPRICKA_STORED_RECORD(SpectrumLevel, low, high, cycles, reached, crossed, growth, life)
SPRICKA_STORED_RECORD(OtherSpectrumLife, name, cycles_per_pass, ratio)
SPRICKA_STORED_RECORD(SpectrumParts, peaks, ranges, others)

SPRICKA_STORED_RECORD(model::LawUse, lowest_delta_k, highest_delta_k, lowest_ratio, highest_ratio,
                      outside, growth_outside, below_delta_k, above_delta_k, below_ratio,
                      above_ratio)

template <class V, RecordOfType<GrowthResult> T> void fields(V& v, T& r) {
  v("unit", r.unit);
  v("cycles_per_pass", r.cycles_per_pass);
  v("tips", r.point_names);
  v("stations", r.stations);
  v("curve", r.curve);
  v("ended", r.ended);
  v("reason", r.reason);
  v("passages", r.passages);
  v("error", r.error);
  v("corrected", r.corrected);
  v("counted", r.counted);
  v("ranges", r.ranges);
  v("law_use", r.law_use);
  v("followed", r.followed);
  v("spectrum_parts", r.spectrum_parts);
  v("life_unit", r.life_unit);
  v("life_units_per_pass", r.life_units_per_pass);
  v("interaction", r.interaction);
  v("compared", r.compared);
}

SPRICKA_STORED_RECORD(GrowthTestPoint, cycles, a, rate, rate_low, rate_high, R, K, low, high,
                      computed, covered)
SPRICKA_STORED_RECORD(GrowthTestResult, name, tip, method, reference, readings, computed, points,
                      scatter, freedoms, cycles, computed_cycles, cycles_error, notes)
SPRICKA_STORED_RECORD(base::SourceSpan, file, begin, end)
SPRICKA_STORED_RECORD(model::Face, element, side)
SPRICKA_STORED_RECORD(model::NodeSet, name, nodes, span)
SPRICKA_STORED_RECORD(model::ElementSet, name, elements, span)
SPRICKA_STORED_RECORD(model::FaceSet, name, faces, span)

#undef SPRICKA_STORED_MEMBER
#undef SPRICKA_STORED_RECORD

} // namespace spricka::results
