// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_lines.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace spricka::mesh {
namespace {

using InpPair = InpJointCards::InpContactPair;
using InpInteraction = InpJointCards::InpSurfaceInteraction;
using InpLoadKind = InpJointCards::InpLoadKind;

/// *CONTACT PAIR, *TIE: slave and master in each line.
class PairLines : public InpKeywordReader {
public:
  PairLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    pair_.tie = key_.name == "TIE";
    pair_.place = key_.place;
    for (const std::string_view other : {"CYCLICSYMMETRY", "MULTISTAGE", "FLUIDPERIODIC"}) {
      cyclic_ = cyclic_ || key_.find(other) != nullptr;
    }
    if (const std::string* name = key_.find("NAME")) {
      pair_.name = *name;
    }
    if (const std::string* name = key_.find("INTERACTION")) {
      pair_.interaction = *name;
    }
    const std::string* adjust = key_.find("ADJUST");
    if (adjust != nullptr && !pair_.tie) {
      pair_.adjust = InpFieldReader(*adjust).next_real();
      if (!pair_.adjust) {
        shared.leave_out("CONTACT PAIR ADJUST=set", key_.place);
      }
    }
  }
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    InpPair pair = pair_;
    pair.slave = plain(fields.next_text());
    pair.master = plain(fields.next_text());
    if (cyclic_ || pair.slave.empty() || pair.master.empty() || pair.slave == pair.master) {
      shared_.leave_out(
          fmt::format("{} {}", key_.shown, cyclic_ ? "of a sector" : "of a surface with itself"),
          text_.location());
      return;
    }
    data_.joint.pairs.push_back(std::move(pair));
  }

private:
  InpPair pair_;
  bool cyclic_ = false;
};

/// *SURFACE INTERACTION and what stands below it.
class InteractionLines : public InpKeywordReader {
public:
  InteractionLines(InpReaderContext& shared, const InpKeyword& key)
      : InpKeywordReader(shared, key) {
    std::vector<InpInteraction>& all = data_.joint.interactions;
    const std::string* name = key_.find("NAME");
    if (key_.name == "SURFACEINTERACTION") {
      all.push_back({name == nullptr ? "" : *name, 0.0, false, false, false, key_.place});
    } else if (all.empty()) {
      return;
    } else if (key_.name == "SURFACEBEHAVIOR") {
      const std::string* law = key_.find("PRESSURE-OVERCLOSURE");
      all.back().tied = law != nullptr && upper_case(*law) == "TIED";
      all.back().soft = law != nullptr && upper_case(*law) != "HARD" && !all.back().tied;
      if (key_.find("NOSEPARATION") != nullptr) {
        shared.leave_out("SURFACE BEHAVIOR NO SEPARATION", key_.place);
      }
    } else {
      all.back().without_slip = key_.find("ROUGH") != nullptr;
    }
  }
  void read_line() override {
    const auto value = InpFieldReader(text_.data_line()).next_real();
    if (key_.name == "FRICTION" && value && rows_++ == 0 && !data_.joint.interactions.empty()) {
      data_.joint.interactions.back().friction = *value;
    }
  }

private:
  std::size_t rows_ = 0;
};

/// Keywords that are all parameters: *STEP, the procedure of a step, *CLEARANCE.
class ParameterCard : public InpKeywordReader {
public:
  ParameterCard(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    if (key_.name == "STEP") {
      InpJointCards::InpStepContent step;
      const std::string* large = key_.find("NLGEOM");
      step.large_displacements = large != nullptr && upper_case(*large) != "NO";
      step.place = key_.place;
      data_.joint.steps.push_back(std::move(step));
    } else if (key_.name == "CLEARANCE") {
      set_clearance();
    } else if (shared.in_step) {
      data_.joint.steps.back().procedure = key_.shown;
    }
  }
  void read_line() override {}

private:
  void set_clearance() {
    const std::string* slave = key_.find("SLAVE");
    const std::string* master = key_.find("MASTER");
    const std::string* value = key_.find("VALUE");
    for (InpPair& pair : data_.joint.pairs) {
      if (slave != nullptr && master != nullptr && value != nullptr &&
          upper_case(pair.slave) == upper_case(plain(*slave)) &&
          upper_case(pair.master) == upper_case(plain(*master))) {
        pair.clearance = InpFieldReader(*value).next_real();
      }
    }
  }
};

class TitleLines : public InpKeywordReader {
public:
  TitleLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {}
  void read_line() override {
    if (data_.joint.title.empty() && text_.location().file == 0) {
      data_.joint.title = text_.data_line();
    }
  }
};

/// What lines of supports and loads have in common.
class StepLines : public InpKeywordReader {
public:
  using InpKeywordReader::InpKeywordReader;

protected:
  [[nodiscard]] InpJointCards::InpStepContent& step() const {
    return shared_.in_step ? data_.joint.steps.back() : data_.joint.steps.front();
  }
  [[nodiscard]] bool has(std::string_view key, std::string_view value) const {
    const std::string* given = key_.find(key);
    return given != nullptr && upper_case(*given) == value;
  }
  [[nodiscard]] InpJointCards::InpTarget target(std::string_view field) const {
    const auto label = parse_inp_integer(field);
    return label ? InpJointCards::InpTarget{"", *label} : InpJointCards::InpTarget{plain(field), 0};
  }
  void leave_out(std::string_view what) const {
    shared_.leave_out(fmt::format("{} {}", key_.shown, what), text_.location());
  }
  /// One of these parameters: what the lines say is not meant as usual.
  [[nodiscard]] bool leave_out_with(std::initializer_list<std::string_view> parameters) const {
    for (const std::string_view parameter : parameters) {
      if (key_.find(parameter) != nullptr) {
        leave_out(parameter);
        return true;
      }
    }
    return false;
  }
};

/// *BOUNDARY: node or set, first freedom, last freedom, value; or node or set, kind of support.
class SupportLines : public StepLines {
public:
  SupportLines(InpReaderContext& shared, const InpKeyword& key) : StepLines(shared, key) {
    passed_ = leave_out_with({"FIXED", "USER", "SUBMODEL", "BASEMOTION", "MASSFLOW"}) ||
              (key_.find("TYPE") != nullptr && !has("TYPE", "DISPLACEMENT"));
    step().new_supports = step().new_supports || has("OP", "NEW");
  }
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    const InpJointCards::InpTarget of = target(fields.next_text());
    const std::string_view second = fields.next_text();
    const auto first = parse_inp_integer(second);
    const auto last = fields.has_more() ? read_last(fields, first) : first;
    const auto value = fields.next_real();
    if (passed_) {
      return;
    }
    if (!first && held(upper_case(second)) != nullptr) {
      for (const char dof : *held(upper_case(second))) {
        step().displacements.push_back({of, dof - '1', 0.0, text_.location()});
      }
      return;
    }
    if (!first || !last || !value || *first < 1) {
      leave_out("unread line");
      return;
    }
    for (auto dof = *first; dof <= std::min<std::int64_t>(*last, 3); ++dof) {
      step().displacements.push_back({of, static_cast<int>(dof) - 1, *value, text_.location()});
    }
    if (*last > 3 && *value != 0.0) {
      leave_out("of rotations or temperatures");
    }
  }

private:
  static std::optional<std::int64_t> read_last(InpFieldReader& fields,
                                               std::optional<std::int64_t> first) {
    const std::string_view text = fields.next_text();
    return text.empty() ? first : parse_inp_integer(text);
  }
  static const std::string_view* held(std::string_view kind) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kinds{
        {{"ENCASTRE", "123"},
         {"PINNED", "123"},
         {"XSYMM", "1"},
         {"YSYMM", "2"},
         {"ZSYMM", "3"},
         {"XASYMM", "23"},
         {"YASYMM", "13"},
         {"ZASYMM", "12"}}};
    const auto* const at =
        std::ranges::find_if(kinds, [&](const auto& k) { return k.first == kind; });
    return at == kinds.end() ? nullptr : &at->second;
  }

  bool passed_ = false;
};

/// *CLOAD, *DLOAD, *DSLOAD.
class LoadLines : public StepLines {
public:
  LoadLines(InpReaderContext& shared, const InpKeyword& key) : StepLines(shared, key) {
    passed_ = leave_out_with({"USER", "SUBMODEL", "SECTOR", "CYCLICMODE"});
    bool& fresh = key_.name == "CLOAD" ? step().new_forces : step().new_pressures;
    fresh = fresh || has("OP", "NEW");
  }
  void read_line() override {
    if (passed_) {
      return;
    }
    InpFieldReader fields(text_.data_line());
    const InpJointCards::InpTarget on = target(fields.next_text());
    const std::string what = upper_case(fields.next_text());
    const auto value = fields.next_real();
    if (!value) {
      leave_out("unread line");
    } else if (key_.name == "CLOAD") {
      add_force(on, what, *value);
    } else if (key_.name == "DSLOAD" && what == "P" && !on.set.empty()) {
      add_pressure(on.set, *value);
    } else if (key_.name == "DLOAD" && what.size() == 2 && what[0] == 'P' && what[1] >= '1' &&
               what[1] <= '6') {
      add_side_pressure(on, what[1] - '1', *value);
    } else if (key_.name == "DLOAD" && !on.set.empty()) {
      add_body_force(on, what, *value, fields);
    } else {
      leave_out(what.empty() ? "unread line" : what);
    }
  }

private:
  void add(const InpJointCards::InpLoad& load) const { step().loads.push_back(load); }
  void add_force(const InpJointCards::InpTarget& on, const std::string& what, double value) const {
    const auto dof = parse_inp_integer(what);
    if (!dof || *dof < 1 || *dof > 3) {
      leave_out("of moments");
      return;
    }
    base::Vec3 force = base::Vec3::Zero();
    force[static_cast<int>(*dof) - 1] = value;
    add({InpLoadKind::force, on, force, false, text_.location()});
  }
  void add_body_force(const InpJointCards::InpTarget& on, const std::string& what, double value,
                      InpFieldReader& fields) const {
    base::Vec3 force = base::Vec3::Zero();
    if (what == "GRAV") {
      for (int i = 0; i < 3; ++i) {
        force[i] = fields.next_real().value_or(0.0);
      }
      force *= force.norm() > 0.0 ? value / force.norm() : 0.0;
    } else if (what == "BX" || what == "BY" || what == "BZ") {
      force[what[1] - 'X'] = value;
    } else {
      leave_out(what);
      return;
    }
    add({InpLoadKind::body, on, force, what == "GRAV", text_.location()});
  }
  /// The sides under one pressure become a surface: a deck names what it loads.
  void add_side_pressure(const InpJointCards::InpTarget& on, int side, double value) {
    if (!on.set.empty()) {
      const std::string name = fmt::format("{}_P{}", on.set, side + 1);
      const auto same = [&](const InpData::InpSurface& surface) { return surface.name == name; };
      if (std::ranges::none_of(data_.surfaces, same)) {
        data_.surfaces.push_back({name, {{on.set, 0, side, text_.location()}}, text_.location()});
      }
      add_pressure(name, value);
      return;
    }
    if (surface_of_.size() == most_values || data_.joint.steps.size() > 2) {
      leave_out(surface_of_.size() == most_values ? "of more than 100 values"
                                                  : "on single elements in a later step");
      return;
    }
    const auto [at, fresh] = surface_of_.try_emplace(value, data_.surfaces.size());
    if (fresh) {
      const std::string name = fmt::format("DLOAD_{}", ++data_.joint.side_pressures);
      data_.surfaces.push_back({name, {}, text_.location()});
      add_pressure(name, value);
    }
    data_.surfaces[at->second].members.push_back({"", on.node, side, text_.location()});
  }
  void add_pressure(const std::string& surface, double value) const {
    add({InpLoadKind::pressure, {surface, 0}, {value, 0.0, 0.0}, false, text_.location()});
  }

  static constexpr std::size_t most_values = 100;
  bool passed_ = false;
  std::map<double, std::size_t> surface_of_; ///< of single elements, by pressure
};

bool is_procedure(std::string_view name) {
  static constexpr std::array<std::string_view, 14> procedures{"STATIC",
                                                               "DYNAMIC",
                                                               "FREQUENCY",
                                                               "BUCKLE",
                                                               "VISCO",
                                                               "MODALDYNAMIC",
                                                               "HEATTRANSFER",
                                                               "GREEN",
                                                               "STEADYSTATEDYNAMICS",
                                                               "SENSITIVITY",
                                                               "COMPLEXFREQUENCY",
                                                               "SUBSTRUCTUREGENERATE",
                                                               "COUPLEDTEMPERATURE-DISPLACEMENT",
                                                               "UNCOUPLEDTEMPERATURE-DISPLACEMENT"};
  return std::ranges::find(procedures, name) != procedures.end();
}

} // namespace

std::unique_ptr<InpKeywordReader> make_inp_joint_reader(InpReaderContext& shared,
                                                        const InpKeyword& key) {
  if (!shared.lenient) {
    return nullptr;
  }
  const std::string& name = key.name;
  if (name == "CONTACTPAIR" || name == "TIE") {
    return std::make_unique<PairLines>(shared, key);
  }
  if (name == "SURFACEINTERACTION" || name == "SURFACEBEHAVIOR" || name == "FRICTION") {
    return std::make_unique<InteractionLines>(shared, key);
  }
  if (name == "STEP" || name == "CLEARANCE" || is_procedure(name)) {
    return std::make_unique<ParameterCard>(shared, key);
  }
  if (name == "BOUNDARY") {
    return std::make_unique<SupportLines>(shared, key);
  }
  if (name == "CLOAD" || name == "DLOAD" || name == "DSLOAD") {
    return std::make_unique<LoadLines>(shared, key);
  }
  return name == "HEADING" ? std::make_unique<TitleLines>(shared, key) : nullptr;
}

} // namespace spricka::mesh
