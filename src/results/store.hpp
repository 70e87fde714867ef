// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/named_columns.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Files of named arrays and tables in folders (HDF5), as h5py and pandas read them. The same
/// content always makes the same bytes: no times are kept. The library writes in memory
/// only, since it does not survive a full disk; who writes the bytes to a file takes care of that.
namespace spricka::results {

/// A file that cannot be written or read, or does not hold what it should.
class StoreError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A folder in a store. All functions throw StoreError.
class StoreGroup {
public:
  /// The folder of that name: opened, or made if there is none and the store is being written.
  [[nodiscard]] StoreGroup group(const std::string& name) const;
  /// Whether the folder holds a folder or an array of that name.
  [[nodiscard]] bool has_member(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> names() const; ///< ascending

  /// Arrays of rows with `columns` numbers each; one column makes an array of one dimension.
  void write(const std::string& name, std::span<const double> values, std::size_t columns = 1);
  /// The same of whole numbers, 64 bits each.
  void write(const std::string& name, std::span<const std::int64_t> values,
             std::size_t columns = 1);
  /// An array of texts, all as long as the longest, filled up with zeros.
  void write(const std::string& name, std::span<const std::string> values);
  /// One compound value a row, a member for each column.
  void write(const std::string& name, const ColumnTable& table);
  /// Gives the folder an attribute: one number beside the arrays.
  void set_attribute(const std::string& name, double value); ///< an attribute
  /// The same of a whole number, 64 bits.
  void set_attribute(const std::string& name, std::int64_t value);
  /// The same of a text.
  void set_attribute(const std::string& name, std::string_view value);

  /// An array of real numbers, row after row; fails for one of another kind.
  [[nodiscard]] std::vector<double> read_reals(const std::string& name) const;
  /// An array of whole numbers, row after row; fails for one of another kind.
  [[nodiscard]] std::vector<std::int64_t> read_integers(const std::string& name) const;
  /// An array of texts of one fixed length, zeros at their ends taken off.
  [[nodiscard]] std::vector<std::string> read_texts(const std::string& name) const;
  /// A table that `write` has written: names and values of all columns.
  [[nodiscard]] ColumnTable read_table(const std::string& name) const;
  // Attributes.
  /// A real number that is an attribute of the folder.
  [[nodiscard]] double real_attribute(const std::string& name) const;
  /// A whole number that is an attribute of the folder.
  [[nodiscard]] std::int64_t integer_attribute(const std::string& name) const;
  /// A text that is an attribute of the folder.
  [[nodiscard]] std::string text_attribute(const std::string& name) const;

private:
  friend class Store;
  struct GroupHandle;
  explicit StoreGroup(std::shared_ptr<GroupHandle> handle) : handle_(std::move(handle)) {}
  std::shared_ptr<GroupHandle> handle_;
};

class Store {
public:
  /// A new store, to be written.
  static Store in_memory();
  /// A store to be read, of the bytes of a file, which are copied. Throws StoreError.
  static Store from_bytes(std::string_view bytes);

  /// A store to be read, in a file that stays where it is: what is asked for is read, and nothing
  /// else, whatever the size of the file. It must not be replaced in place meanwhile. Throws
  /// StoreError.
  static Store from_file(const std::filesystem::path& file);

  [[nodiscard]] StoreGroup root() const;
  /// Ends the writing: the bytes of the file, which live as long as the store.
  [[nodiscard]] std::string_view finish_bytes();

private:
  struct StoreHandle;
  explicit Store(std::shared_ptr<StoreHandle> handle) : handle_(std::move(handle)) {}
  std::shared_ptr<StoreHandle> handle_;
};

/// Version of the HDF5 library that the program runs with, "major.minor.release".
std::string store_library_version();

} // namespace spricka::results
