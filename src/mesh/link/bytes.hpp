// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Values as bytes for another process of the same program on the same machine.
class ByteWriter {
public:
  /// Appends the bytes of a value without pointers.
  template <class T> void write_value(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  /// Appends a list: its number of values, then their bytes.
  template <class T> void write_list(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    write_value(values.size());
    if (!values.empty()) {
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
  }
  /// Appends a text: its number of bytes, then these.
  void write_text(std::string_view value) {
    write_value(value.size());
    bytes_ += value;
  }
  /// Appends a list: its number of items, then of each what `write` appends.
  template <class List, class Write> void write_items(const List& items, Write&& write) {
    write_value(items.size());
    for (const auto& item : items) {
      write(item);
    }
  }
  /// Appends a list of texts: their number, then each.
  void write_texts(const std::vector<std::string>& values) {
    write_items(values, [&](const std::string& value) { write_text(value); });
  }
  /// Appends the coordinates of a point.
  template <int dim> void write_point(const Eigen::Matrix<double, dim, 1>& x) {
    for (const double coordinate : x) {
      write_value(coordinate);
    }
  }
  [[nodiscard]] std::string release() { return std::move(bytes_); }

private:
  std::string bytes_;
};

/// Reads them back, from whoever wrote them: what does not fit makes it unsound, never more.
class ByteReader {
public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  /// The next value; zero where too few bytes are left, which makes the reader unsound.
  template <class T> T read_value() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    copy(&value, sizeof value);
    return value;
  }
  /// The next list; empty where its number of values does not fit what is left.
  template <class T> std::vector<T> read_list() {
    const auto count = read_value<std::size_t>();
    if (count > rest_.size() / sizeof(T)) {
      sound_ = false;
      return {};
    }
    std::vector<T> values(count);
    if (count > 0) {
      copy(values.data(), count * sizeof(T));
    }
    return values;
  }
  /// The next text; empty where its length does not fit what is left.
  std::string read_text() {
    const auto count = read_value<std::size_t>();
    if (count > rest_.size()) {
      sound_ = false;
      return {};
    }
    std::string value(rest_.substr(0, count));
    rest_.remove_prefix(count);
    return value;
  }
  /// The next list, of items that `read` returns one after another, as far as the bytes are sound.
  template <class Read> auto read_items(Read&& read) {
    std::vector<decltype(read())> items;
    for (auto count = read_value<std::size_t>(); count > 0 && sound_; --count) {
      items.push_back(read());
    }
    return items;
  }
  /// The next list of texts, as far as the bytes are sound.
  std::vector<std::string> read_texts() {
    return read_items([&] { return read_text(); });
  }
  /// The next point.
  template <int dim> Eigen::Matrix<double, dim, 1> read_point() {
    Eigen::Matrix<double, dim, 1> x;
    for (double& coordinate : x) {
      coordinate = read_value<double>();
    }
    return x;
  }
  [[nodiscard]] bool is_valid() const { return sound_; }
  [[nodiscard]] bool at_end() const { return sound_ && rest_.empty(); }

private:
  void copy(void* into, std::size_t size) {
    if (!sound_ || size > rest_.size()) {
      sound_ = false;
      return;
    }
    std::memcpy(into, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
  bool sound_ = true;
};

} // namespace spricka::mesh
