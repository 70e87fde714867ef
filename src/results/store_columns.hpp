// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/piecewise_linear.hpp"
#include "base/vec.hpp"
#include "results/note.hpp"
#include "results/store.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// Lists of records as tables: every number, word or name is a column, and what a record holds a
/// list of stands in an array of its own beside the table, one record's part after another, with
/// the length of each part in a column NAME_count. fields(visitor, record) names the fields.
namespace spricka::results {

template <class T>
concept WholeNumber = std::is_integral_v<T> || std::is_enum_v<T>;

/// How many numbers a value is that lists keep as a row of them; 0: it is none.
template <class T> inline constexpr std::size_t row_width = 0;
template <> inline constexpr std::size_t row_width<base::Vec3> = 3;
template <std::size_t n> inline constexpr std::size_t row_width<std::array<double, n>> = n;

/// Collects records row by row.
class RecordPacker {
public:
  /// Appends a record as a row, its members in the order of fields(); all records of one type.
  template <class T> void add_record(const T& record) {
    column_ = child_ = 0;
    fields(*this, record);
    ++rows_;
  }
  /// Writes the table NAME and its lists NAME.FIELD; nothing where there is no row.
  void write(StoreGroup group, const std::string& name) const {
    if (rows_ == 0) {
      return;
    }
    group.write(name, table_);
    for (const PackedChild& child : children_) {
      const std::string full = name + "." + child.name;
      if (const auto* list = std::get_if<std::unique_ptr<RecordPacker>>(&child.data)) {
        (*list)->write(group, full);
      } else if (const auto* reals = std::get_if<std::vector<double>>(&child.data)) {
        if (!reals->empty()) {
          group.write(full, *reals, child.columns);
        }
      } else if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&child.data)) {
        if (!integers->empty()) {
          group.write(full, *integers);
        }
      } else if (const auto& texts = std::get<std::vector<std::string>>(child.data);
                 !texts.empty()) {
        group.write(full, texts);
      }
    }
  }

  // What a record's fields() calls, with each of them.
  void operator()(const char* name, const double& value) { column<double>(name).push_back(value); }
  template <WholeNumber T> void operator()(const char* name, const T& value) {
    column<std::int64_t>(name).push_back(static_cast<std::int64_t>(value));
  }
  void operator()(const char* name, const std::string& value) {
    column<std::string>(name).push_back(value);
  }
  template <class Tag> void operator()(const char* name, const base::Id<Tag>& value) {
    column<std::int64_t>(name).push_back(value.value);
  }
  void operator()(const char* name, const base::Vec3& value) {
    within(name, [&] {
      (*this)("x", value[0]);
      (*this)("y", value[1]);
      (*this)("z", value[2]);
    });
  }
  template <class T, std::size_t n>
  void operator()(const char* name, const std::array<T, n>& values) {
    constexpr std::array numbers{"1", "2", "3", "4", "5", "6"};
    static_assert(n <= numbers.size());
    within(name, [&] {
      for (std::size_t i = 0; i < n; ++i) {
        (*this)(numbers[i], values[i]);
      }
    });
  }
  template <class T> void operator()(const char* name, const std::optional<T>& value) {
    within(name, [&] {
      (*this)("given", value.has_value());
      (*this)("value", value.value_or(T{}));
    });
  }
  void operator()(const char* name, const base::PiecewiseLinear& f) {
    within(name, [&] {
      (*this)("knots", f.knots());
      (*this)("values", f.segment_start_values());
      (*this)("slopes", f.segment_slopes());
    });
  }
  void operator()(const char* name, const std::vector<Note>& notes) {
    (*this)(name, text_with_code(notes));
  }
  template <class T> void operator()(const char* name, const std::vector<T>& values) {
    within(name, [&] { (*this)("count", values.size()); });
    if constexpr (std::is_same_v<T, double>) {
      append(child<std::vector<double>>(name), values);
    } else if constexpr (std::is_same_v<T, std::string>) {
      append(child<std::vector<std::string>>(name), values);
    } else if constexpr (WholeNumber<T>) {
      append(child<std::vector<std::int64_t>>(name), values);
    } else if constexpr (requires(T v) { v.index(); }) {
      auto& all = child<std::vector<std::int64_t>>(name);
      for (const T& v : values) {
        all.push_back(v.value);
      }
    } else if constexpr (row_width<T> > 0) {
      auto& all = child<std::vector<double>>(name, row_width<T>);
      for (const T& v : values) {
        append(all, v);
      }
    } else {
      auto& list = child<std::unique_ptr<RecordPacker>>(name);
      if (!list) {
        list = std::make_unique<RecordPacker>();
      }
      for (const T& v : values) {
        list->add_record(v);
      }
    }
  }
  template <class T>
  requires std::is_class_v<T>
  void operator()(const char* name, const T& record) {
    within(name, [&] { fields(*this, record); });
  }

private:
  using ChildData = std::variant<std::vector<double>, std::vector<std::int64_t>,
                                 std::vector<std::string>, std::unique_ptr<RecordPacker>>;
  struct PackedChild {
    std::string name;
    ChildData data;
    std::size_t columns = 1;
  };

  template <class To, class From> static void append(std::vector<To>& to, const From& from) {
    to.insert(to.end(), from.begin(), from.end());
  }
  // Names are put together for the first row only.
  template <class Inner> void within(const char* name, const Inner& inner) {
    const std::size_t outer = prefix_.size();
    if (rows_ == 0) {
      prefix_ += std::string(name) + "_";
    }
    inner();
    prefix_.resize(outer);
  }
  template <class T> std::vector<T>& column(const char* name) {
    if (rows_ == 0) {
      table_.columns.push_back({prefix_ + name, std::vector<T>()});
    }
    return std::get<std::vector<T>>(table_.columns[column_++].values);
  }
  template <class T> T& child(const char* name, std::size_t columns = 1) {
    if (rows_ == 0) {
      children_.push_back({prefix_ + name, T(), columns});
    }
    return std::get<T>(children_[child_++].data);
  }

  ColumnTable table_;
  std::vector<PackedChild> children_;
  std::string prefix_;
  std::size_t rows_ = 0, column_ = 0, child_ = 0;
};

/// Gives records back in the order in which they were packed. Throws StoreError where a table is
/// not one of such records.
class RecordUnpacker {
public:
  RecordUnpacker(StoreGroup group, std::string name)
      : group_(std::move(group)), name_(std::move(name)) {
    if (group_.has_member(name_)) {
      table_ = group_.read_table(name_);
    }
  }

  [[nodiscard]] std::size_t rows() const { return table_.rows(); }
  /// The record of the next row. Throws StoreError where there is none left.
  template <class T> T next_record() {
    if (row_ >= rows()) {
      throw StoreError(name_ + " has too few rows");
    }
    column_ = child_ = 0;
    T record{};
    fields(*this, record);
    ++row_;
    return record;
  }

  void operator()(const char* name, double& value) { value = column<double>(name); }
  template <WholeNumber T> void operator()(const char* name, T& value) {
    value = static_cast<T>(column<std::int64_t>(name));
  }
  void operator()(const char* name, std::string& value) { value = column<std::string>(name); }
  template <class Tag> void operator()(const char* name, base::Id<Tag>& value) {
    value.value = static_cast<std::int32_t>(column<std::int64_t>(name));
  }
  void operator()(const char* name, base::Vec3& value) {
    within(name, [&] {
      (*this)("x", value[0]);
      (*this)("y", value[1]);
      (*this)("z", value[2]);
    });
  }
  template <class T, std::size_t n> void operator()(const char* name, std::array<T, n>& values) {
    constexpr std::array numbers{"1", "2", "3", "4", "5", "6"};
    within(name, [&] {
      for (std::size_t i = 0; i < n; ++i) {
        (*this)(numbers[i], values[i]);
      }
    });
  }
  template <class T> void operator()(const char* name, std::optional<T>& value) {
    within(name, [&] {
      bool given = false;
      T found{};
      (*this)("given", given);
      (*this)("value", found);
      value = given ? std::optional<T>(std::move(found)) : std::nullopt;
    });
  }
  void operator()(const char* name, base::PiecewiseLinear& f) {
    within(name, [&] {
      std::vector<double> knots;
      std::vector<double> values;
      std::vector<double> slopes;
      (*this)("knots", knots);
      (*this)("values", values);
      (*this)("slopes", slopes);
      if (values.empty()) {
        return;
      }
      if (knots.size() != values.size() + 1 || slopes.size() != values.size()) {
        throw StoreError(name_ + " has a broken curve");
      }
      f = base::PiecewiseLinear(std::move(knots), std::move(values), std::move(slopes));
    });
  }
  void operator()(const char* name, std::vector<Note>& notes) {
    std::vector<std::string> texts;
    (*this)(name, texts);
    notes = parse_notes(texts);
  }
  template <class T> void operator()(const char* name, std::vector<T>& values) {
    std::size_t count = 0;
    within(name, [&] { (*this)("count", count); });
    UnpackedChild& from = child(name);
    values.clear();
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::string>) {
      slice<T>(from, count, 1, [&](const auto* v) { values.assign(v, v + count); });
    } else if constexpr (WholeNumber<T> || requires(T v) { v.index(); }) {
      slice<std::int64_t>(from, count, 1, [&](const std::int64_t* v) {
        for (std::size_t i = 0; i < count; ++i) {
          values.push_back(whole<T>(v[i]));
        }
      });
    } else if constexpr (row_width<T> > 0) {
      slice<double>(from, count, row_width<T>, [&](const double* v) {
        values.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
          std::copy_n(v + row_width<T> * i, row_width<T>, values[i].begin());
        }
      });
    } else if (count > 0) {
      if (!from.list) {
        from.list = std::make_unique<RecordUnpacker>(group_, name_ + "." + from.name);
      }
      for (std::size_t i = 0; i < count; ++i) {
        values.push_back(from.list->next_record<T>());
      }
    }
  }
  template <class T>
  requires std::is_class_v<T>
  void operator()(const char* name, T& record) {
    within(name, [&] { fields(*this, record); });
  }

private:
  struct UnpackedChild {
    std::string name;
    Values values;
    bool loaded = false;
    std::size_t at = 0;
    std::unique_ptr<RecordUnpacker> list;
  };

  template <class T> static T whole(std::int64_t value) {
    if constexpr (WholeNumber<T>) {
      return static_cast<T>(value);
    } else {
      T id;
      id.value = static_cast<std::int32_t>(value);
      return id;
    }
  }
  template <class Inner> void within(const char* name, const Inner& inner) {
    const std::size_t outer = prefix_.size();
    if (row_ == 0) {
      prefix_ += std::string(name) + "_";
    }
    inner();
    prefix_.resize(outer);
  }
  template <class T> const T& column(const char* name) {
    if (column_ >= table_.columns.size()) {
      throw StoreError(name_ + " has no column " + prefix_ + name);
    }
    const ColumnTable::NamedColumn& found = table_.columns[column_++];
    const auto* values = std::get_if<std::vector<T>>(&found.values);
    if (values == nullptr || (row_ == 0 && found.name != prefix_ + name)) {
      throw StoreError(name_ + " has column " + found.name + " where another belongs");
    }
    return (*values)[row_];
  }
  UnpackedChild& child(const char* name) {
    if (row_ == 0) {
      children_.emplace_back().name = prefix_ + name;
    }
    return children_[child_++];
  }
  template <class T> void load(UnpackedChild& from) {
    const std::string full = name_ + "." + from.name;
    if constexpr (std::is_same_v<T, double>) {
      from.values = group_.read_reals(full);
    } else if constexpr (std::is_same_v<T, std::string>) {
      from.values = group_.read_texts(full);
    } else {
      from.values = group_.read_integers(full);
    }
    from.loaded = true;
  }
  template <class T, class Take>
  void slice(UnpackedChild& from, std::size_t count, std::size_t columns, const Take& take) {
    if (count == 0) {
      return;
    }
    if (!from.loaded) {
      load<T>(from);
    }
    const auto& all = std::get<std::vector<T>>(from.values);
    if (count > all.size() || from.at + count * columns > all.size()) {
      throw StoreError(name_ + "." + from.name + " is too short");
    }
    take(all.data() + from.at);
    from.at += count * columns;
  }

  StoreGroup group_;
  std::string name_;
  ColumnTable table_;
  std::vector<UnpackedChild> children_;
  std::string prefix_;
  std::size_t row_ = 0, column_ = 0, child_ = 0;
};

/// A list of records as table NAME; nothing where it is empty.
template <class T>
void write_record_list(const StoreGroup& group, const std::string& name,
                       const std::vector<T>& list) {
  RecordPacker packer;
  for (const T& record : list) {
    packer.add_record(record);
  }
  packer.write(group, name);
}

/// A list of records from table NAME; empty where the folder has no such table.
template <class T>
std::vector<T> read_record_list(const StoreGroup& group, const std::string& name) {
  RecordUnpacker unpacker(group, name);
  std::vector<T> list;
  list.reserve(unpacker.rows());
  for (std::size_t r = 0, n = unpacker.rows(); r < n; ++r) {
    list.push_back(unpacker.next_record<T>());
  }
  return list;
}

} // namespace spricka::results
