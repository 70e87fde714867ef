// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/store_hdf5.hpp"

#include <cstdlib>
#include <cstring>

namespace spricka::results {

namespace {

// The library's own messages say nothing to a user; what fails is said by StoreError.
Hdf5Id file_access() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Hdf5Id list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  check_status(H5Pset_libver_bounds(list.get(), H5F_LIBVER_V18, H5F_LIBVER_V18),
               "choose the format");
  check_status(H5Pset_fclose_degree(list.get(), H5F_CLOSE_STRONG), "choose how the file is closed");
  return list;
}

Hdf5Id file_creation() {
  Hdf5Id list(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make a property list");
  check_status(H5Pset_obj_track_times(list.get(), 0), "leave out times");
  return list;
}

/// The bytes of a store in memory, which the library gives away when the file is closed: a file
/// that is still open has a head with a wrong checksum (H5Fget_file_image of 1.10).
struct Image {
  std::unique_ptr<void, void (*)(void*)> data{nullptr, &std::free};
  std::size_t length = 0;
};

// The library asks for memory and gives it away as C does.
// NOLINTBEGIN(cppcoreguidelines-no-malloc)
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
// NOLINTEND(cppcoreguidelines-no-malloc)

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

struct Store::StoreHandle {
  StoreHandle(Hdf5Id file, std::unique_ptr<Image> where)
      : image(std::move(where)), id(std::move(file)) {}
  std::unique_ptr<Image> image; ///< lives longer than the file
  Hdf5Id id;
};

Store Store::in_memory() {
  const Hdf5Id access = file_access();
  auto image = std::make_unique<Image>();
  H5FD_file_image_callbacks_t calls{take_memory, nullptr,    resize_memory, give_memory,
                                    same_image,  keep_image, image.get()};
  check_status(H5Pset_fapl_core(access.get(), growth, 0), "work in memory");
  check_status(H5Pset_file_image_callbacks(access.get(), &calls), "work in memory");
  const Hdf5Id made = file_creation();
  Hdf5Id id(H5Fcreate(name_of(*image).c_str(), H5F_ACC_TRUNC, made.get(), access.get()), H5Fclose,
            "make a store in memory");
  return Store(std::make_shared<StoreHandle>(std::move(id), std::move(image)));
}

Store Store::from_bytes(std::string_view bytes) {
  const Hdf5Id access = file_access();
  check_status(H5Pset_fapl_core(access.get(), growth, 0), "work in memory");
  // the library copies what it is given
  std::string copy(bytes);
  check_status(H5Pset_file_image(access.get(), copy.data(), copy.size()), "take over bytes");
  auto image = std::make_unique<Image>();
  Hdf5Id id(H5Fopen(name_of(*image).c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose,
            "understand its bytes");
  return Store(std::make_shared<StoreHandle>(std::move(id), std::move(image)));
}

Store Store::from_file(const std::filesystem::path& file) {
  const Hdf5Id access = file_access();
#if H5_VERSION_GE(1, 10, 7)
  // Our files are never written in place; many file systems of clusters have no locks.
  check_status(H5Pset_file_locking(access.get(), false, true), "leave out locks");
#endif
  Hdf5Id id(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose, "read its bytes");
  return Store(std::make_shared<StoreHandle>(std::move(id), std::make_unique<Image>()));
}

StoreGroup Store::root() const {
  return StoreGroup(std::make_shared<StoreGroup::GroupHandle>(
      Hdf5Id(H5Gopen2(handle_->id.get(), "/", H5P_DEFAULT), H5Gclose, "open the store")));
}

std::string_view Store::finish_bytes() {
  if (handle_->id.get() >= 0) {
    check_status(H5Fflush(handle_->id.get(), H5F_SCOPE_GLOBAL), "collect the store");
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
