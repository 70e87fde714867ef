// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/quantity.hpp"
#include "model/forward.hpp"
#include "report/view/shown_surface.hpp"

#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace spricka::report {

/// A field that the view may show, as data.js names it.
struct ShownField {
  std::string_view key;
  std::string_view name;
  base::QuantityKind kind;
};

/// What a step has beside displacements, which are always there.
inline constexpr std::array<ShownField, 4> step_fields{
    {{"mises", "von Mises stress", base::QuantityKind::stress},
     {"p1", "largest principal stress", base::QuantityKind::stress},
     {"pressure", "contact pressure", base::QuantityKind::stress},
     {"gap", "gap of contacts", base::QuantityKind::length}}};

/// A step at the points of a surface: its name, displacements by component and fields by key. What
/// is round-off is nothing; pressure and gap stand at the points of contacts alone.
nlohmann::ordered_json encode_step(const model::Model& model,
                                   const results::CrackLengthResult& increment,
                                   const results::LoadStepResult& step,
                                   const ShownSurface& surface);

} // namespace spricka::report
