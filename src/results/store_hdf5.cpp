// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/store_hdf5.hpp"

#include "base/deflater.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace spricka::results {

namespace {

// From this on an array is compressed if that pays, below it stands beside its description.
constexpr std::size_t large = 16384; // [bytes]
constexpr hsize_t piece = 65536;     // [bytes]
constexpr unsigned effort = 1;       // of zlib, 0 to 9, as the file tells it

Hdf5Id space_of(std::span<const hsize_t> extent) {
  return {H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
          "make a data space"};
}

hsize_t rows_of_piece(std::span<const hsize_t> extent, std::size_t row_bytes) {
  return std::clamp<hsize_t>(piece / row_bytes, 1, extent[0]);
}

// Compressed where that pays, and without times.
Hdf5Id creation(std::span<const hsize_t> extent, std::size_t row_bytes, bool pays) {
  Hdf5Id list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
  check_status(H5Pset_obj_track_times(list.get(), 0), "leave out times");
  const std::size_t bytes = static_cast<std::size_t>(extent[0]) * row_bytes;
  if (bytes == 0 || (bytes >= large && !pays)) {
    check_status(H5Pset_layout(list.get(), H5D_CONTIGUOUS), "set the layout");
  } else if (bytes >= large) {
    std::array<hsize_t, 2> chunk{rows_of_piece(extent, row_bytes),
                                 extent.size() > 1 ? extent[1] : 0};
    check_status(H5Pset_chunk(list.get(), static_cast<int>(extent.size()), chunk.data()),
                 "set pieces");
    check_status(H5Pset_shuffle(list.get()), "set the order of bytes");
    check_status(H5Pset_deflate(list.get(), effort), "set compression");
  } else {
    check_status(H5Pset_layout(list.get(), H5D_COMPACT), "set the layout");
  }
  return list;
}

// Elements of `size` bytes as HDF5's filter shuffle leaves them: their first bytes, their second
// ones and so on.
void shuffle(std::string_view elements, std::size_t size, std::string& bytes) {
  const std::size_t count = elements.size() / size;
  bytes.resize(elements.size());
  for (std::size_t b = 0; b < size; ++b) {
    for (std::size_t i = 0; i < count; ++i) {
      bytes[b * count + i] = elements[i * size + b];
    }
  }
}

// The pieces of an array, as the filters shuffle and deflate make them. The library's own looks for
// all that comes again, in numbers twice the time for nothing.
void write_pieces(const Hdf5Id& set, std::span<const hsize_t> extent, std::size_t row_bytes,
                  std::size_t element_bytes, const char* data) {
  const hsize_t rows = rows_of_piece(extent, row_bytes);
  const std::size_t bytes = static_cast<std::size_t>(rows) * row_bytes;
  base::Deflater deflater(base::RepetitionSearch::runs, bytes);
  std::string last(bytes, '\0'); // a piece is whole in the file
  std::string shuffled;
  for (hsize_t first = 0; first < extent[0]; first += rows) {
    const char* from = data + static_cast<std::size_t>(first) * row_bytes;
    if (extent[0] - first < rows) {
      std::memcpy(last.data(), from, static_cast<std::size_t>(extent[0] - first) * row_bytes);
      from = last.data();
    }
    shuffle({from, bytes}, element_bytes, shuffled);
    const std::string_view packed = deflater.pack(shuffled);
    const std::array<hsize_t, 2> place{first, 0};
    check_status(
        H5Dwrite_chunk(set.get(), H5P_DEFAULT, 0, place.data(), packed.size(), packed.data()),
        "write a piece of an array");
  }
}

} // namespace

Hdf5Id fixed_length_text_type(std::size_t longest) {
  Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text type");
  check_status(H5Tset_size(type.get(), std::max<std::size_t>(longest, 1)), "size a text type");
  check_status(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "pad a text type");
  check_status(H5Tset_cset(type.get(), H5T_CSET_UTF8), "name the characters of a text type");
  return type;
}

std::string text_from_padded_bytes(const char* bytes, std::size_t size) {
  while (size > 0 && bytes[size - 1] == '\0') {
    --size;
  }
  return {bytes, size};
}

bool is_repetitive(std::span<const double> values, std::size_t columns) {
  std::size_t same = 0;
  for (std::size_t i = columns; i < values.size(); ++i) {
    same +=
        std::bit_cast<std::uint64_t>(values[i]) == std::bit_cast<std::uint64_t>(values[i - columns])
            ? 1U
            : 0U;
  }
  return values.size() > columns && 3 * same >= values.size() - columns;
}

void write_array(hid_t group, const std::string& name, std::span<const hsize_t> extent,
                 ArrayTypes types, const void* data, bool pays) {
  const Hdf5Id space = space_of(extent);
  const auto [file, memory] = types;
  const std::size_t element = H5Tget_size(file);
  std::size_t row = element;
  for (std::size_t d = 1; d < extent.size(); ++d) {
    row *= static_cast<std::size_t>(extent[d]);
  }
  const Hdf5Id list = creation(extent, row, pays);
  const Hdf5Id set(
      H5Dcreate2(group, name.c_str(), file, space.get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
      H5Dclose, "make array " + name);
  if (extent[0] == 0) {
    return;
  }
  const bool in_pieces = H5Pget_layout(list.get()) == H5D_CHUNKED;
  if (in_pieces && H5Tequal(file, memory) > 0) {
    write_pieces(set, extent, row, element, static_cast<const char*>(data));
    return;
  }
  check_status(H5Dwrite(set.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data),
               "write array " + name);
}

OpenArray open_array(hid_t group, const std::string& name) {
  Hdf5Id set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "find array " + name);
  Hdf5Id type(H5Dget_type(set.get()), H5Tclose, "find the type of " + name);
  const Hdf5Id space(H5Dget_space(set.get()), H5Sclose, "find the size of " + name);
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (count < 0) {
    throw_store_error("cannot find the size of " + name);
  }
  const Hdf5Id list(H5Dget_create_plist(set.get()), H5Pclose, "find how " + name + " is stored");
  // Another file is nothing to read from; and what is not stored has no size to make room for.
  if (H5Pget_external_count(list.get()) != 0 ||
      (count > 0 && H5Dget_storage_size(set.get()) == 0)) {
    throw_store_error(fmt::format("array {} is not in the file", name));
  }
  return {std::move(set), std::move(type), static_cast<std::size_t>(count)};
}

Hdf5Id open_attribute(hid_t group, const std::string& name) {
  return {H5Aopen(group, name.c_str(), H5P_DEFAULT), H5Aclose, "find attribute " + name};
}

void write_attribute(hid_t group, const std::string& name, hid_t type, const void* value) {
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Hdf5Id item(H5Acreate2(group, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                    H5Aclose, "make attribute " + name);
  check_status(H5Awrite(item.get(), type, value), "write attribute " + name);
}

} // namespace spricka::results
