// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/store.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <hdf5.h>

/// What the sources of this room share of HDF5's C interface; nobody else includes it.
namespace spricka::results {

/// Throws a StoreError with this sentence.
[[noreturn]] inline void throw_store_error(const std::string& what) {
  throw StoreError(what);
}

/// Passes a status on; negative ones are thrown as StoreError "cannot ...".
inline herr_t check_status(herr_t status, std::string_view what) {
  if (status < 0) {
    throw_store_error(fmt::format("cannot {}", what));
  }
  return status;
}

/// An identifier of the library that is given back when it goes.
class Hdf5Id {
public:
  using Close = herr_t (*)(hid_t);
  Hdf5Id(hid_t id, Close give_back, std::string_view what) : id_(id), close_(give_back) {
    if (id < 0) {
      throw_store_error(fmt::format("cannot {}", what));
    }
  }
  Hdf5Id(Hdf5Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;
  Hdf5Id& operator=(Hdf5Id&&) = delete;
  ~Hdf5Id() {
    if (id_ >= 0) {
      close_(id_);
    }
  }
  [[nodiscard]] hid_t get() const { return id_; }
  /// Closes the item ahead of its end of life, so that a failure is thrown as StoreError.
  void close(std::string_view what) { check_status(close_(std::exchange(id_, -1)), what); }

private:
  hid_t id_;
  Close close_;
};

/// Strings of a fixed length, filled up with zeros.
Hdf5Id fixed_length_text_type(std::size_t longest);
/// The text in `size` bytes, zeros at its end taken off.
std::string text_from_padded_bytes(const char* bytes, std::size_t size);

/// Types of an array in the file and in memory.
struct ArrayTypes {
  hid_t file, memory;
};
/// A new array; `pays`: its values are worth compressing.
void write_array(hid_t group, const std::string& name, std::span<const hsize_t> extent,
                 ArrayTypes types, const void* data, bool pays = true);
/// Whether a third of the numbers are the same as those in the row before, as where a component is
/// zero in the plane: numbers with all their digits hardly become smaller, and compressing them
/// takes longer than all else.
bool is_repetitive(std::span<const double> values, std::size_t columns);

struct OpenArray {
  Hdf5Id set;
  Hdf5Id type;
  std::size_t count = 0;
};

/// Opens an array of a folder. Throws StoreError where there is none, and where its data are in
/// another file or were never stored.
OpenArray open_array(hid_t group, const std::string& name);

/// All numbers of an array, read as the type `memory`. Throws StoreError for data of another kind.
template <class T>
std::vector<T> read_numbers(hid_t group, const std::string& name, hid_t memory, H5T_class_t kind) {
  const OpenArray array = open_array(group, name);
  if (H5Tget_class(array.type.get()) != kind) {
    throw_store_error(fmt::format("array {} is of another kind", name));
  }
  std::vector<T> values(array.count);
  if (values.empty()) {
    return values;
  }
  check_status(H5Dread(array.set.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               "read array " + name);
  return values;
}

/// Opens an attribute of a folder. Throws StoreError where there is none.
Hdf5Id open_attribute(hid_t group, const std::string& name);
/// Writes one value as an attribute of a folder, in the type given.
void write_attribute(hid_t group, const std::string& name, hid_t type, const void* value);

/// One number that is an attribute, read as the type `memory`. Throws StoreError for another kind.
template <class T>
T read_attribute(hid_t group, const std::string& name, hid_t memory, H5T_class_t kind) {
  const Hdf5Id item = open_attribute(group, name);
  const Hdf5Id type(H5Aget_type(item.get()), H5Tclose, "find the type of " + name);
  if (H5Tget_class(type.get()) != kind) {
    throw_store_error(fmt::format("attribute {} is of another kind", name));
  }
  T value{};
  check_status(H5Aread(item.get(), memory, &value), "read attribute " + name);
  return value;
}

struct StoreGroup::GroupHandle {
  explicit GroupHandle(Hdf5Id held) : id(std::move(held)) {}
  Hdf5Id id;
};

} // namespace spricka::results
