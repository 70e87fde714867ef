// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

/// Scripts and styles that pages carry within them; the build makes strings of the files
/// (cmake/embed_texts.cmake).
namespace spricka::report::embedded {

/// three.js as Debian ships it, and its lines of several pixels, as packed_text() makes them
/// (pack_library.cpp).
extern const std::string_view packed_library;

extern const std::string_view data_script;
extern const std::string_view surface_script;
extern const std::string_view camera_script;
extern const std::string_view colours_script;
extern const std::string_view scene_script;
extern const std::string_view panel_script;
extern const std::string_view readings_script;
extern const std::string_view view_script;
extern const std::string_view curves_script;
extern const std::string_view view_style;

} // namespace spricka::report::embedded
