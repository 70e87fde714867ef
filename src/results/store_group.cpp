// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/store_hdf5.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace spricka::results {

namespace {

std::size_t longest(std::span<const std::string> texts) {
  std::size_t most = 1;
  for (const std::string& text : texts) {
    most = std::max(most, text.size());
  }
  return most;
}

/// Rows of a table as bytes: the columns' offsets and the compound type.
struct TableRowLayout {
  Hdf5Id type;
  std::vector<std::size_t> offset, size; ///< [column]
  std::size_t bytes = 0;                 ///< of a row
};

TableRowLayout row_layout(const ColumnTable& table) {
  std::vector<std::size_t> offset;
  std::vector<std::size_t> size;
  std::size_t bytes = 0;
  for (const ColumnTable::NamedColumn& column : table.columns) {
    const auto* texts = std::get_if<std::vector<std::string>>(&column.values);
    offset.push_back(bytes);
    size.push_back(texts != nullptr ? longest(*texts) : 8);
    bytes += size.back();
  }
  Hdf5Id type(H5Tcreate(H5T_COMPOUND, bytes), H5Tclose, "make a table's type");
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const ColumnTable::NamedColumn& column = table.columns[c];
    const Hdf5Id text = fixed_length_text_type(size[c]);
    const std::array<hid_t, 3> types{H5T_IEEE_F64LE, H5T_STD_I64LE, text.get()};
    check_status(
        H5Tinsert(type.get(), column.name.c_str(), offset[c], types[column.values.index()]),
        "make column " + column.name);
  }
  return {std::move(type), std::move(offset), std::move(size), bytes};
}

void put(char* at, double value, std::size_t /*size*/) {
  std::memcpy(at, &value, sizeof value);
}
void put(char* at, std::int64_t value, std::size_t /*size*/) {
  std::memcpy(at, &value, sizeof value);
}
void put(char* at, const std::string& value, std::size_t size) {
  std::copy_n(value.data(), std::min(size, value.size()), at);
}

template <class T> T take(const char* at, std::size_t size) {
  if constexpr (std::is_same_v<T, std::string>) {
    return text_from_padded_bytes(at, size);
  } else {
    T value{};
    std::memcpy(&value, at, sizeof value);
    return value;
  }
}

template <class T>
std::vector<T> column_from(const std::vector<char>& rows, std::size_t row, std::size_t offset,
                           std::size_t size) {
  std::vector<T> values(row == 0 ? 0 : rows.size() / row);
  for (std::size_t r = 0; r < values.size(); ++r) {
    values[r] = take<T>(rows.data() + r * row + offset, size);
  }
  return values;
}

} // namespace

StoreGroup StoreGroup::group(const std::string& name) const {
  if (has_member(name)) {
    return StoreGroup(std::make_shared<GroupHandle>(Hdf5Id(
        H5Gopen2(handle_->id.get(), name.c_str(), H5P_DEFAULT), H5Gclose, "find folder " + name)));
  }
  const Hdf5Id list(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "make a property list");
  check_status(H5Pset_obj_track_times(list.get(), 0), "leave out times");
  return StoreGroup(std::make_shared<GroupHandle>(
      Hdf5Id(H5Gcreate2(handle_->id.get(), name.c_str(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
             H5Gclose, "find or make folder " + name)));
}

bool StoreGroup::has_member(const std::string& name) const {
  return H5Lexists(handle_->id.get(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> StoreGroup::names() const {
  std::vector<std::string> list;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  check_status(H5Literate(handle_->id.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &list),
               "list a folder");
  return list;
}

void StoreGroup::write(const std::string& name, std::span<const double> values,
                       std::size_t columns) {
  const std::array<hsize_t, 2> extent{values.size() / columns, columns};
  write_array(handle_->id.get(), name, std::span(extent).first(columns > 1 ? 2 : 1),
              {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE}, values.data(), is_repetitive(values, columns));
}

void StoreGroup::write(const std::string& name, std::span<const std::int64_t> values,
                       std::size_t columns) {
  const std::array<hsize_t, 2> extent{values.size() / columns, columns};
  write_array(handle_->id.get(), name, std::span(extent).first(columns > 1 ? 2 : 1),
              {H5T_STD_I64LE, H5T_NATIVE_INT64}, values.data());
}

void StoreGroup::write(const std::string& name, std::span<const std::string> values) {
  const std::size_t size = longest(values);
  std::string bytes(values.size() * size, '\0');
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::copy(values[i].begin(), values[i].end(),
              bytes.begin() + static_cast<std::ptrdiff_t>(i * size));
  }
  const Hdf5Id type = fixed_length_text_type(size);
  const std::array<hsize_t, 1> extent{values.size()};
  write_array(handle_->id.get(), name, extent, {type.get(), type.get()}, bytes.data());
}

void StoreGroup::write(const std::string& name, const ColumnTable& table) {
  const TableRowLayout layout = row_layout(table);
  const std::size_t rows = table.rows();
  std::string bytes(rows * layout.bytes, '\0');
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::visit(
        [&](const auto& values) {
          for (std::size_t r = 0; r < rows; ++r) {
            put(bytes.data() + r * layout.bytes + layout.offset[c], values[r], layout.size[c]);
          }
        },
        table.columns[c].values);
  }
  const std::array<hsize_t, 1> extent{rows};
  write_array(handle_->id.get(), name, extent, {layout.type.get(), layout.type.get()},
              bytes.data());
}

void StoreGroup::set_attribute(const std::string& name, double value) {
  write_attribute(handle_->id.get(), name, H5T_NATIVE_DOUBLE, &value);
}

void StoreGroup::set_attribute(const std::string& name, std::int64_t value) {
  write_attribute(handle_->id.get(), name, H5T_NATIVE_INT64, &value);
}

void StoreGroup::set_attribute(const std::string& name, std::string_view value) {
  const Hdf5Id type = fixed_length_text_type(value.size());
  const std::string bytes = value.empty() ? std::string(1, '\0') : std::string(value);
  write_attribute(handle_->id.get(), name, type.get(), bytes.data());
}

std::vector<double> StoreGroup::read_reals(const std::string& name) const {
  return read_numbers<double>(handle_->id.get(), name, H5T_NATIVE_DOUBLE, H5T_FLOAT);
}

std::vector<std::int64_t> StoreGroup::read_integers(const std::string& name) const {
  return read_numbers<std::int64_t>(handle_->id.get(), name, H5T_NATIVE_INT64, H5T_INTEGER);
}

std::vector<std::string> StoreGroup::read_texts(const std::string& name) const {
  const OpenArray array = open_array(handle_->id.get(), name);
  if (H5Tget_class(array.type.get()) != H5T_STRING || H5Tis_variable_str(array.type.get()) > 0) {
    throw_store_error(fmt::format("array {} is of another kind", name));
  }
  const std::size_t size = H5Tget_size(array.type.get());
  if (array.count == 0) {
    return {};
  }
  std::vector<char> bytes(array.count * size);
  check_status(
      H5Dread(array.set.get(), array.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
      "read array " + name);
  return column_from<std::string>(bytes, size, 0, size);
}

ColumnTable StoreGroup::read_table(const std::string& name) const {
  const OpenArray array = open_array(handle_->id.get(), name);
  if (H5Tget_class(array.type.get()) != H5T_COMPOUND) {
    throw_store_error(fmt::format("array {} is no table", name));
  }
  const std::size_t row = H5Tget_size(array.type.get());
  std::vector<char> bytes(array.count * row);
  check_status(
      H5Dread(array.set.get(), array.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
      "read table " + name);
  ColumnTable table;
  const int members = H5Tget_nmembers(array.type.get());
  for (int m = 0; m < members; ++m) {
    const auto member = static_cast<unsigned>(m);
    const Hdf5Id type(H5Tget_member_type(array.type.get(), member), H5Tclose, "find a column");
    const std::size_t offset = H5Tget_member_offset(array.type.get(), member);
    const std::size_t size = H5Tget_size(type.get());
    char* const label = H5Tget_member_name(array.type.get(), member);
    ColumnTable::NamedColumn& column = table.columns.emplace_back();
    column.name = label == nullptr ? "" : label;
    H5free_memory(label);
    if (H5Tequal(type.get(), H5T_IEEE_F64LE) > 0) {
      column.values = column_from<double>(bytes, row, offset, size);
    } else if (H5Tequal(type.get(), H5T_STD_I64LE) > 0) {
      column.values = column_from<std::int64_t>(bytes, row, offset, size);
    } else if (H5Tget_class(type.get()) == H5T_STRING) {
      column.values = column_from<std::string>(bytes, row, offset, size);
    } else {
      throw_store_error(fmt::format("column {} of {} is of another kind", column.name, name));
    }
  }
  return table;
}

double StoreGroup::real_attribute(const std::string& name) const {
  return read_attribute<double>(handle_->id.get(), name, H5T_NATIVE_DOUBLE, H5T_FLOAT);
}

std::int64_t StoreGroup::integer_attribute(const std::string& name) const {
  return read_attribute<std::int64_t>(handle_->id.get(), name, H5T_NATIVE_INT64, H5T_INTEGER);
}

std::string StoreGroup::text_attribute(const std::string& name) const {
  const Hdf5Id item = open_attribute(handle_->id.get(), name);
  const Hdf5Id type(H5Aget_type(item.get()), H5Tclose, "find the type of " + name);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0) {
    throw_store_error(fmt::format("attribute {} is of another kind", name));
  }
  std::string bytes(H5Tget_size(type.get()), '\0');
  check_status(H5Aread(item.get(), type.get(), bytes.data()), "read attribute " + name);
  return text_from_padded_bytes(bytes.data(), bytes.size());
}

} // namespace spricka::results
