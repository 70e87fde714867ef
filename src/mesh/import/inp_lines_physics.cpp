// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_lines.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace spricka::mesh {
namespace {

/// *MATERIAL has no lines of its own.
class NoLines : public InpKeywordReader {
public:
  NoLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    std::string name;
    const bool sound = only({"NAME"}) && needs("NAME", name);
    if (sound) {
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
      start_ = text_.location();
      left_out_ = false;
      data_.equations.push_back({{}, start_});
      return;
    }
    while (fields.has_more()) {
      const auto node = fields.next_integer();
      const auto dof = fields.next_integer();
      const auto coefficient = fields.next_real();
      if (!node || !dof || *dof < 1 || *dof > 3 || !coefficient || wanted_ == 0) {
        if (shared_.lenient && dof && coefficient && wanted_ > 0) { // a set, a rotation
          leave_out();
          --wanted_;
          continue;
        }
        complain_here("a term of an *EQUATION is node number, freedom 1 to 3, coefficient");
        return;
      }
      if (!left_out_) {
        data_.equations.back().terms.push_back({*node, static_cast<int>(*dof) - 1, *coefficient});
      }
      --wanted_;
    }
  }
  void finish_keyword() override {
    if (wanted_ > 0) {
      complain(start_, "the *EQUATION ends early");
    }
  }

private:
  void leave_out() {
    if (!left_out_) {
      shared_.leave_out("EQUATION", start_);
      data_.equations.pop_back();
    }
    left_out_ = true;
  }

  InpLocation start_;
  bool left_out_ = false;   ///< the equation being read
  std::int64_t wanted_ = 0; ///< terms that are still to come
};

/// *ELASTIC, *DENSITY, *EXPANSION: a table over temperature, of which one row holds everywhere.
class MaterialLines : public InpKeywordReader {
public:
  MaterialLines(InpReaderContext& shared, const InpKeyword& key)
      : InpKeywordReader(shared, key), count_(key.name == "ELASTIC" ? 2 : 1) {
    const std::string* type = key_.find("TYPE");
    if (data_.materials.empty()) {
      complain(key_.place, fmt::format("*{} without a *MATERIAL", key_.shown));
    } else if (type != nullptr && !upper_case(*type).starts_with("ISO")) {
      complain_or_leave_out(fmt::format("TYPE={}", *type),
                            fmt::format("*{}: only TYPE=ISO is imported", key_.shown));
    } else if (key_.name == "EXPANSION" ? only({"TYPE", "ZERO"}) : only({"TYPE"})) {
      material_ = &data_.materials.back();
    }
  }
  void read_line() override {
    if (material_ == nullptr) {
      return;
    }
    InpFieldReader fields(text_.data_line());
    std::vector<double> row;
    while (fields.has_more()) {
      const auto value = fields.next_real();
      if (!value) {
        row.clear();
        break;
      }
      row.push_back(*value);
    }
    if (row.size() < count_) {
      complain_here(fmt::format("a line of *{} is {}", key_.shown,
                                count_ == 1 ? "one number and a temperature"
                                            : "E, Poisson's ratio and a temperature"));
      material_ = nullptr;
    } else if (rows_++ == 0) {
      row_ = row;
      place_ = text_.location();
    } else {
      varies_ = varies_ ||
                !std::equal(row.begin(), row.begin() + static_cast<long>(count_), row_.begin());
    }
  }
  void finish_keyword() override {
    if (material_ == nullptr) {
      return;
    }
    if (rows_ == 0) {
      complain_or_leave_out("without a line", fmt::format("*{} has no data line", key_.shown));
    } else if (varies_ && !shared_.lenient) {
      complain(place_,
               fmt::format("*{} of {} has {} rows of different values", key_.shown, material_->name,
                           rows_),
               "materials here do not depend on temperature: leave one row, or SKIP=ALL takes the "
               "first one");
    } else {
      say_what_is_taken();
      take();
    }
  }

private:
  void say_what_is_taken() {
    if (varies_) {
      const std::string at =
          row_.size() > count_ ? fmt::format(", that at {:g} degrees", row_[count_]) : "";
      data_.remarks.push_back({place_,
                               fmt::format("*{} of {} has {} rows of different values: the first "
                                           "one is taken{}",
                                           key_.shown, material_->name, rows_, at),
                               {}});
    }
  }
  void take() {
    if (key_.name == "DENSITY") {
      material_->rho = row_[0];
    } else if (key_.name == "EXPANSION") {
      material_->alpha = row_[0];
    } else if (row_[0] > 0.0 && row_[1] > -1.0 && row_[1] < 0.5) {
      material_->E = row_[0];
      material_->nu = row_[1];
      material_->elastic = true;
    } else if (shared_.lenient) {
      shared_.leave_out("ELASTIC outside E > 0, -1 < NU < 0.5", place_);
    } else {
      complain(place_, "*ELASTIC: E is positive and Poisson's ratio between -1 and 0.5");
    }
  }

  std::size_t count_;                        ///< values of a row, without its temperature
  InpData::InpMaterial* material_ = nullptr; ///< no material is made while the lines are read
  std::vector<double> row_;                  ///< the first one
  InpLocation place_;
  std::size_t rows_ = 0;
  bool varies_ = false;
};

class SectionLines : public InpKeywordReader {
public:
  SectionLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    InpData::InpSection section;
    section.place = key_.place;
    if (shared.lenient && key_.find("COMPOSITE") != nullptr) {
      shared.leave_out("SOLID SECTION COMPOSITE", key_.place);
    } else if (only({"ELSET", "MATERIAL"}) && needs("ELSET", section.elements) &&
               needs("MATERIAL", section.material)) {
      section.elements = plain(section.elements);
      data_.sections.push_back(std::move(section));
      sound_ = true;
    }
  }
  void read_line() override {
    if (!sound_) {
      return;
    }
    InpFieldReader fields(text_.data_line());
    const auto thickness = fields.next_real();
    if (++rows_ > 1 || !thickness || *thickness < 0.0 || fields.has_more()) {
      complain_here("*SOLID SECTION takes one number, the thickness");
    } else if (*thickness > 0.0) { // empty: 1
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
