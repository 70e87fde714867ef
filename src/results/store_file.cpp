// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/store.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fmt/format.h>
#include <hdf5.h>

namespace spricka::results {

namespace {

// From this on an array is compressed if that pays, below it stands beside its description.
constexpr std::size_t large = 16384; // [bytes]
constexpr hsize_t piece = 65536;     // [bytes]
constexpr unsigned effort = 1;       // of zlib, 0 to 9

[[noreturn]] void fail(const std::string& what) {
  throw StoreError(what);
}

herr_t good(herr_t status, std::string_view what) {
  if (status < 0) {
    fail(fmt::format("cannot {}", what));
  }
  return status;
}

/// An identifier of the library that is given back when it goes.
class Id {
public:
  using Close = herr_t (*)(hid_t);
  Id(hid_t id, Close give_back, std::string_view what) : id_(id), close_(give_back) {
    if (id < 0) {
      fail(fmt::format("cannot {}", what));
    }
  }
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  Id& operator=(Id&&) = delete;
  ~Id() {
    if (id_ >= 0) {
      close_(id_);
    }
  }
  [[nodiscard]] hid_t get() const { return id_; }
  void close(std::string_view what) { good(close_(std::exchange(id_, -1)), what); }

private:
  hid_t id_;
  Close close_;
};

Id space_of(std::span<const hsize_t> extent) {
  return {H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
          "make a data space"};
}

Id text_type(std::size_t longest) {
  Id type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text type");
  good(H5Tset_size(type.get(), std::max<std::size_t>(longest, 1)), "size a text type");
  good(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "pad a text type");
  good(H5Tset_cset(type.get(), H5T_CSET_UTF8), "name the characters of a text type");
  return type;
}

std::size_t longest(std::span<const std::string> texts) {
  std::size_t most = 1;
  for (const std::string& text : texts) {
    most = std::max(most, text.size());
  }
  return most;
}

std::string text_from(const char* bytes, std::size_t size) {
  while (size > 0 && bytes[size - 1] == '\0') {
    --size;
  }
  return {bytes, size};
}

// Numbers with all their digits hardly become smaller, and compressing them takes longer than all
// else: those are compressed of which half repeat the one before.
bool repeats(std::span<const double> values) {
  std::size_t same = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    same += std::memcmp(&values[i], &values[i - 1], sizeof(double)) == 0 ? 1U : 0U;
  }
  return 2 * same > values.size();
}

// Compressed where that pays, and without times.
Id creation(std::span<const hsize_t> extent, std::size_t row_bytes, bool pays) {
  Id list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
  good(H5Pset_obj_track_times(list.get(), 0), "leave out times");
  const std::size_t bytes = static_cast<std::size_t>(extent[0]) * row_bytes;
  if (bytes == 0 || (bytes >= large && !pays)) {
    good(H5Pset_layout(list.get(), H5D_CONTIGUOUS), "set the layout");
  } else if (bytes >= large) {
    std::array<hsize_t, 2> chunk{std::clamp<hsize_t>(piece / row_bytes, 1, extent[0]),
                                 extent.size() > 1 ? extent[1] : 0};
    good(H5Pset_chunk(list.get(), static_cast<int>(extent.size()), chunk.data()), "set pieces");
    good(H5Pset_shuffle(list.get()), "set the order of bytes");
    good(H5Pset_deflate(list.get(), effort), "set compression");
  } else {
    good(H5Pset_layout(list.get(), H5D_COMPACT), "set the layout");
  }
  return list;
}

void write_array(hid_t group, const std::string& name, std::span<const hsize_t> extent,
                 std::pair<hid_t, hid_t> file_and_memory, const void* data, bool pays = true) {
  const Id space = space_of(extent);
  const auto [file, memory] = file_and_memory;
  std::size_t row = H5Tget_size(file);
  for (std::size_t d = 1; d < extent.size(); ++d) {
    row *= static_cast<std::size_t>(extent[d]);
  }
  const Id list = creation(extent, row, pays);
  const Id set(
      H5Dcreate2(group, name.c_str(), file, space.get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
      H5Dclose, "make array " + name);
  if (extent[0] == 0) {
    return;
  }
  good(H5Dwrite(set.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "write array " + name);
}

struct OpenArray {
  Id set;
  Id type;
  std::size_t count = 0;
};

OpenArray open_array(hid_t group, const std::string& name) {
  Id set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "find array " + name);
  Id type(H5Dget_type(set.get()), H5Tclose, "find the type of " + name);
  const Id space(H5Dget_space(set.get()), H5Sclose, "find the size of " + name);
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (count < 0) {
    fail("cannot find the size of " + name);
  }
  return {std::move(set), std::move(type), static_cast<std::size_t>(count)};
}

template <class T>
std::vector<T> read_numbers(hid_t group, const std::string& name, hid_t memory, H5T_class_t kind) {
  const OpenArray array = open_array(group, name);
  if (H5Tget_class(array.type.get()) != kind) {
    fail(fmt::format("array {} is of another kind", name));
  }
  std::vector<T> values(array.count);
  if (values.empty()) {
    return values;
  }
  good(H5Dread(array.set.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
       "read array " + name);
  return values;
}

/// Rows of a table as bytes: the columns' offsets and the compound type.
struct RowLayout {
  Id type;
  std::vector<std::size_t> offset, size; ///< [column]
  std::size_t bytes = 0;                 ///< of a row
};

RowLayout row_layout(const Table& table) {
  std::vector<std::size_t> offset;
  std::vector<std::size_t> size;
  std::size_t bytes = 0;
  for (const Table::Column& column : table.columns) {
    const auto* texts = std::get_if<std::vector<std::string>>(&column.values);
    offset.push_back(bytes);
    size.push_back(texts != nullptr ? longest(*texts) : 8);
    bytes += size.back();
  }
  Id type(H5Tcreate(H5T_COMPOUND, bytes), H5Tclose, "make a table's type");
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Table::Column& column = table.columns[c];
    const Id text = text_type(size[c]);
    const std::array<hid_t, 3> types{H5T_IEEE_F64LE, H5T_STD_I64LE, text.get()};
    good(H5Tinsert(type.get(), column.name.c_str(), offset[c], types[column.values.index()]),
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
  std::memcpy(at, value.data(), std::min(size, value.size()));
}

template <class T> T take(const char* at, std::size_t size) {
  if constexpr (std::is_same_v<T, std::string>) {
    return text_from(at, size);
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

Id attribute(hid_t group, const std::string& name) {
  return {H5Aopen(group, name.c_str(), H5P_DEFAULT), H5Aclose, "find attribute " + name};
}

void write_attribute(hid_t group, const std::string& name, hid_t type, const void* value) {
  const Id space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Id item(H5Acreate2(group, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                H5Aclose, "make attribute " + name);
  good(H5Awrite(item.get(), type, value), "write attribute " + name);
}

template <class T>
T read_attribute(hid_t group, const std::string& name, hid_t memory, H5T_class_t kind) {
  const Id item = attribute(group, name);
  const Id type(H5Aget_type(item.get()), H5Tclose, "find the type of " + name);
  if (H5Tget_class(type.get()) != kind) {
    fail(fmt::format("attribute {} is of another kind", name));
  }
  T value{};
  good(H5Aread(item.get(), memory, &value), "read attribute " + name);
  return value;
}

// The library's own messages say nothing to a user; what fails is said by StoreError.
Id file_access() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Id list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  good(H5Pset_libver_bounds(list.get(), H5F_LIBVER_V18, H5F_LIBVER_V18), "choose the format");
  good(H5Pset_fclose_degree(list.get(), H5F_CLOSE_STRONG), "choose how the file is closed");
  return list;
}

Id file_creation() {
  Id list(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make a property list");
  good(H5Pset_obj_track_times(list.get(), 0), "leave out times");
  return list;
}

/// The bytes of a store in memory, which the library gives away when the file is closed: a file
/// that is still open has a head with a wrong checksum (H5Fget_file_image of 1.10).
struct Image {
  std::unique_ptr<void, void (*)(void*)> data{nullptr, &std::free};
  std::size_t length = 0;
};

void* take_memory(std::size_t size, H5FD_file_image_op_t /*op*/, void* /*image*/) {
  return std::malloc(size);
}

void* resize_memory(void* old, std::size_t size, H5FD_file_image_op_t /*op*/, void* /*image*/) {
  return std::realloc(old, size);
}

// The length of the file stands in its head, behind the signature and six other fields.
herr_t give_memory(void* data, H5FD_file_image_op_t op, void* image) {
  if (op == H5FD_FILE_IMAGE_OP_FILE_CLOSE && data != nullptr) {
    constexpr std::size_t length_at = 28;
    std::uint64_t length = 0;
    std::memcpy(&length, static_cast<const char*>(data) + length_at, sizeof length);
    auto* const kept = static_cast<Image*>(image);
    kept->data.reset(data);
    kept->length = length;
    return 0;
  }
  std::free(data);
  return 0;
}

void* same_image(void* image) {
  return image;
}

herr_t keep_image(void* /*image*/) {
  return 0;
}

// The library tells open files apart by their names.
std::string name_of(const Image& image) {
  return fmt::format("memory at {}", static_cast<const void*>(&image));
}

constexpr std::size_t growth = 1 << 20; // [bytes] by which memory for a store grows

} // namespace

struct StoreGroup::Handle {
  Id id;
};

struct Store::Handle {
  Handle(Id file, std::unique_ptr<Image> where) : image(std::move(where)), id(std::move(file)) {}
  std::unique_ptr<Image> image; ///< lives longer than the file
  Id id;
};

StoreGroup StoreGroup::group(const std::string& name) const {
  if (has(name)) {
    return StoreGroup(std::make_shared<Handle>(Id(
        H5Gopen2(handle_->id.get(), name.c_str(), H5P_DEFAULT), H5Gclose, "find folder " + name)));
  }
  const Id list(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "make a property list");
  good(H5Pset_obj_track_times(list.get(), 0), "leave out times");
  return StoreGroup(std::make_shared<Handle>(
      Id(H5Gcreate2(handle_->id.get(), name.c_str(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
         H5Gclose, "find or make folder " + name)));
}

bool StoreGroup::has(const std::string& name) const {
  return H5Lexists(handle_->id.get(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> StoreGroup::names() const {
  std::vector<std::string> list;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  good(H5Literate(handle_->id.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &list),
       "list a folder");
  return list;
}

void StoreGroup::write(const std::string& name, std::span<const double> values,
                       std::size_t columns) {
  const std::array<hsize_t, 2> extent{values.size() / columns, columns};
  write_array(handle_->id.get(), name, std::span(extent).first(columns > 1 ? 2 : 1),
              {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE}, values.data(), repeats(values));
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
  const Id type = text_type(size);
  const std::array<hsize_t, 1> extent{values.size()};
  write_array(handle_->id.get(), name, extent, {type.get(), type.get()}, bytes.data());
}

void StoreGroup::write(const std::string& name, const Table& table) {
  const RowLayout layout = row_layout(table);
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

void StoreGroup::describe(const std::string& name, double value) {
  write_attribute(handle_->id.get(), name, H5T_NATIVE_DOUBLE, &value);
}

void StoreGroup::describe(const std::string& name, std::int64_t value) {
  write_attribute(handle_->id.get(), name, H5T_NATIVE_INT64, &value);
}

void StoreGroup::describe(const std::string& name, std::string_view value) {
  const Id type = text_type(value.size());
  const std::string bytes = value.empty() ? std::string(1, '\0') : std::string(value);
  write_attribute(handle_->id.get(), name, type.get(), bytes.data());
}

std::vector<double> StoreGroup::reals(const std::string& name) const {
  return read_numbers<double>(handle_->id.get(), name, H5T_NATIVE_DOUBLE, H5T_FLOAT);
}

std::vector<std::int64_t> StoreGroup::integers(const std::string& name) const {
  return read_numbers<std::int64_t>(handle_->id.get(), name, H5T_NATIVE_INT64, H5T_INTEGER);
}

std::vector<std::string> StoreGroup::texts(const std::string& name) const {
  const OpenArray array = open_array(handle_->id.get(), name);
  if (H5Tget_class(array.type.get()) != H5T_STRING || H5Tis_variable_str(array.type.get()) > 0) {
    fail(fmt::format("array {} is of another kind", name));
  }
  const std::size_t size = H5Tget_size(array.type.get());
  if (array.count == 0) {
    return {};
  }
  std::vector<char> bytes(array.count * size);
  good(H5Dread(array.set.get(), array.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
       "read array " + name);
  return column_from<std::string>(bytes, size, 0, size);
}

Table StoreGroup::table(const std::string& name) const {
  const OpenArray array = open_array(handle_->id.get(), name);
  if (H5Tget_class(array.type.get()) != H5T_COMPOUND) {
    fail(fmt::format("array {} is no table", name));
  }
  const std::size_t row = H5Tget_size(array.type.get());
  std::vector<char> bytes(array.count * row);
  good(H5Dread(array.set.get(), array.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
       "read table " + name);
  Table table;
  const int members = H5Tget_nmembers(array.type.get());
  for (int m = 0; m < members; ++m) {
    const auto member = static_cast<unsigned>(m);
    const Id type(H5Tget_member_type(array.type.get(), member), H5Tclose, "find a column");
    const std::size_t offset = H5Tget_member_offset(array.type.get(), member);
    const std::size_t size = H5Tget_size(type.get());
    char* const label = H5Tget_member_name(array.type.get(), member);
    Table::Column& column = table.columns.emplace_back();
    column.name = label == nullptr ? "" : label;
    H5free_memory(label);
    if (H5Tequal(type.get(), H5T_IEEE_F64LE) > 0) {
      column.values = column_from<double>(bytes, row, offset, size);
    } else if (H5Tequal(type.get(), H5T_STD_I64LE) > 0) {
      column.values = column_from<std::int64_t>(bytes, row, offset, size);
    } else if (H5Tget_class(type.get()) == H5T_STRING) {
      column.values = column_from<std::string>(bytes, row, offset, size);
    } else {
      fail(fmt::format("column {} of {} is of another kind", column.name, name));
    }
  }
  return table;
}

double StoreGroup::real(const std::string& name) const {
  return read_attribute<double>(handle_->id.get(), name, H5T_NATIVE_DOUBLE, H5T_FLOAT);
}

std::int64_t StoreGroup::integer(const std::string& name) const {
  return read_attribute<std::int64_t>(handle_->id.get(), name, H5T_NATIVE_INT64, H5T_INTEGER);
}

std::string StoreGroup::text(const std::string& name) const {
  const Id item = attribute(handle_->id.get(), name);
  const Id type(H5Aget_type(item.get()), H5Tclose, "find the type of " + name);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0) {
    fail(fmt::format("attribute {} is of another kind", name));
  }
  std::string bytes(H5Tget_size(type.get()), '\0');
  good(H5Aread(item.get(), type.get(), bytes.data()), "read attribute " + name);
  return text_from(bytes.data(), bytes.size());
}

Store Store::in_memory() {
  const Id access = file_access();
  auto image = std::make_unique<Image>();
  H5FD_file_image_callbacks_t calls{take_memory, nullptr,    resize_memory, give_memory,
                                    same_image,  keep_image, image.get()};
  good(H5Pset_fapl_core(access.get(), growth, 0), "work in memory");
  good(H5Pset_file_image_callbacks(access.get(), &calls), "work in memory");
  const Id made = file_creation();
  Id id(H5Fcreate(name_of(*image).c_str(), H5F_ACC_TRUNC, made.get(), access.get()), H5Fclose,
        "make a store in memory");
  return Store(std::make_shared<Handle>(std::move(id), std::move(image)));
}

Store Store::from_bytes(std::string_view bytes) {
  const Id access = file_access();
  good(H5Pset_fapl_core(access.get(), growth, 0), "work in memory");
  // the library copies what it is given
  std::string copy(bytes);
  good(H5Pset_file_image(access.get(), copy.data(), copy.size()), "take over bytes");
  auto image = std::make_unique<Image>();
  Id id(H5Fopen(name_of(*image).c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose,
        "understand its bytes");
  return Store(std::make_shared<Handle>(std::move(id), std::move(image)));
}

StoreGroup Store::root() const {
  return StoreGroup(std::make_shared<StoreGroup::Handle>(
      Id(H5Gopen2(handle_->id.get(), "/", H5P_DEFAULT), H5Gclose, "open the store")));
}

std::string_view Store::bytes() {
  if (handle_->id.get() >= 0) {
    good(H5Fflush(handle_->id.get(), H5F_SCOPE_GLOBAL), "collect the store");
    handle_->id.close("close the store");
  }
  return {static_cast<const char*>(handle_->image->data.get()), handle_->image->length};
}

std::string store_library_version() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

} // namespace spricka::results
