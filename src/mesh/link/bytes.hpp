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
  /// Appends fields one after another, each by its type: the bytes of a value without pointers; of
  /// a text or a list the number of its members, then these; the coordinates of a point.
  template <class... Field> void exchange_fields(const Field&... values) { (append(values), ...); }
  /// Appends a list: its number of items, then of each what `write` appends.
  template <class List, class Write> void exchange_list(const List& list, Write&& write) {
    append(list.size());
    for (const auto& item : list) {
      write(item);
    }
  }
  [[nodiscard]] std::string release() { return std::move(bytes_); }

private:
  template <class T> void append(const T& value) {
    static_assert(!std::is_pointer_v<T> && !std::is_convertible_v<T, std::string_view>);
    if constexpr (std::is_trivially_copyable_v<T>) {
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    } else {
      for (const double coordinate : value) {
        append(coordinate);
      }
    }
  }
  template <class T> void append(const std::vector<T>& list) {
    if constexpr (!std::is_trivially_copyable_v<T>) {
      exchange_list(list, [&](const T& item) { append(item); });
    } else {
      append(list.size());
      if (!list.empty()) {
        bytes_.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
      }
    }
  }
  void append(const std::string& text) {
    append(text.size());
    bytes_ += text;
  }

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
  /// Reads fields as ByteWriter appends them: values as read_value; texts and lists are empty where
  /// their length does not fit what is left, lists of lists, texts or points end there.
  template <class... Field> void exchange_fields(Field&... values) { (read(values), ...); }
  /// Reads a list, of items that `read_item` fills one after another, as far as the bytes are
  /// sound.
  template <class List, class ReadItem> void exchange_list(List& list, ReadItem&& read_item) {
    list.clear();
    for (auto count = read_value<std::size_t>(); count > 0 && sound_; --count) {
      read_item(list.emplace_back());
    }
  }
  [[nodiscard]] bool at_end() const { return sound_ && rest_.empty(); }

private:
  template <class T> void read(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = read_value<char>() != 0;
    } else if constexpr (std::is_trivially_copyable_v<T>) {
      value = read_value<T>();
    } else {
      for (double& coordinate : value) {
        read(coordinate);
      }
    }
  }
  template <class T> void read(std::vector<T>& list) {
    if constexpr (!std::is_trivially_copyable_v<T>) {
      exchange_list(list, [&](T& item) { read(item); });
    } else {
      list.resize(read_count(sizeof(T)));
      if (!list.empty()) {
        copy(list.data(), list.size() * sizeof(T));
      }
    }
  }
  void read(std::string& text) {
    const std::size_t count = read_count(1);
    text = rest_.substr(0, count);
    rest_.remove_prefix(count);
  }

  /// The next number of members of `size` bytes each; 0 where they do not fit what is left.
  std::size_t read_count(std::size_t size) {
    const auto count = read_value<std::size_t>();
    const bool fits = count <= rest_.size() / size;
    sound_ = sound_ && fits;
    return fits ? count : 0;
  }
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
