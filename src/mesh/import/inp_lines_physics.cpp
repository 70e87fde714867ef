// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_lines.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

namespace spricka::mesh {
namespace {

/// *MATERIAL has no lines of its own.
class NoLines : public InpKeywordReader {
public:
  NoLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    std::string name;
    if (only({"NAME"}) && needs("NAME", name)) {
      InpData::InpMaterial material;
      material.name = name;
      material.place = key_.place;
      data_.materials.push_back(std::move(material));
    }
  }
  void read_line() override { complain_here("*MATERIAL takes no data lines"); }
};

/// *EQUATION: the number of terms, then as many times node, freedom, coefficient; again and again.
class EquationLines : public InpKeywordReader {
public:
  EquationLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    only({});
  }
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    if (wanted_ == 0) {
      const auto count = fields.next_integer();
      if (!count || *count <= 0 || fields.has_more()) {
        complain_here("an *EQUATION begins with the number of its terms");
        return;
      }
      wanted_ = *count;
      data_.equations.push_back({{}, text_.location()});
      return;
    }
    while (fields.has_more()) {
      const auto node = fields.next_integer();
      const auto dof = fields.next_integer();
      const auto coefficient = fields.next_real();
      if (!node || !dof || *dof < 1 || *dof > 3 || !coefficient || wanted_ == 0) {
        complain_here("a term of an *EQUATION is node number, freedom 1 to 3, coefficient");
        return;
      }
      data_.equations.back().terms.push_back({*node, static_cast<int>(*dof) - 1, *coefficient});
      --wanted_;
    }
  }
  void finish_keyword() override {
    if (wanted_ > 0) {
      complain(data_.equations.back().place, "the *EQUATION ends early");
    }
  }

private:
  std::int64_t wanted_ = 0; ///< terms that are still to come
};

/// *ELASTIC, *DENSITY, *EXPANSION: one line of numbers, the same at every temperature.
class MaterialLines : public InpKeywordReader {
public:
  MaterialLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    const std::string* type = key_.find("TYPE");
    if (data_.materials.empty()) {
      complain(key_.place, fmt::format("*{} without a *MATERIAL", key_.shown));
    } else if (key_.name == "DENSITY" ? !only({}) : !only({"TYPE"})) {
      return;
    } else if (type != nullptr && !upper_case(*type).starts_with("ISO")) {
      complain(key_.place, fmt::format("*{}: only TYPE=ISO is imported", key_.shown));
    } else {
      material_ = &data_.materials.back();
    }
  }
  void read_line() override {
    const std::size_t count = key_.name == "ELASTIC" ? 2 : 1;
    InpFieldReader fields(text_.data_line());
    std::vector<double> v;
    bool ok = ++rows_ == 1;
    while (fields.has_more()) {
      const auto value = fields.next_real();
      ok = ok && value.has_value();
      v.push_back(value.value_or(0.0));
    }
    if (!ok || v.size() != count) {
      complain_here(fmt::format("*{} takes one line of {}: nothing depends on temperature",
                                key_.shown, count == 1 ? "one number" : "two numbers"));
    } else if (material_ != nullptr) {
      take(v);
    }
  }
  void finish_keyword() override {
    if (rows_ == 0) {
      complain(key_.place, fmt::format("*{} has no data line", key_.shown));
    }
  }

private:
  void take(const std::vector<double>& v) {
    if (key_.name == "DENSITY") {
      material_->rho = v[0];
    } else if (key_.name == "EXPANSION") {
      material_->alpha = v[0];
    } else if (v[0] > 0.0 && v[1] > -1.0 && v[1] < 0.5) {
      material_->E = v[0];
      material_->nu = v[1];
      material_->elastic = true;
    } else {
      complain_here("*ELASTIC: E is positive and Poisson's ratio between -1 and 0.5");
    }
  }

  InpData::InpMaterial* material_ = nullptr; ///< no material is made while the lines are read
  std::size_t rows_ = 0;
};

class SectionLines : public InpKeywordReader {
public:
  SectionLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    InpData::InpSection section;
    section.place = key_.place;
    if (only({"ELSET", "MATERIAL"}) && needs("ELSET", section.elements) &&
        needs("MATERIAL", section.material)) {
      section.elements = plain(section.elements);
      data_.sections.push_back(std::move(section));
      sound_ = true;
    }
  }
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    const auto thickness = fields.next_real();
    if (++rows_ > 1 || !thickness || *thickness < 0.0 || fields.has_more()) {
      complain_here("*SOLID SECTION takes one number, the thickness");
    } else if (sound_ && *thickness > 0.0) { // empty: 1
      data_.sections.back().thickness = *thickness;
    }
  }

private:
  bool sound_ = false;
  std::size_t rows_ = 0;
};

} // namespace

std::unique_ptr<InpKeywordReader> make_material_and_equation_reader(InpReaderContext& shared,
                                                                    const InpKeyword& key) {
  if (key.name == "MATERIAL") {
    return std::make_unique<NoLines>(shared, key);
  }
  if (key.name == "EQUATION") {
    return std::make_unique<EquationLines>(shared, key);
  }
  if (key.name == "ELASTIC" || key.name == "DENSITY" || key.name == "EXPANSION") {
    return std::make_unique<MaterialLines>(shared, key);
  }
  if (key.name == "SOLIDSECTION") {
    return std::make_unique<SectionLines>(shared, key);
  }
  return nullptr;
}

} // namespace spricka::mesh
