// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/view.hpp"

#include "report/drawing/table.hpp"
#include "report/view/embedded.hpp"
#include "report/view/packed_text.hpp"
#include "report/view/view_data.hpp"

#include <fmt/format.h>

#include <initializer_list>

namespace spricka::report {
namespace {

/// Functions of several files, known to each other alone.
std::string own_script(std::initializer_list<std::string_view> parts) {
  std::string text = "<script>\n(() => {\n\"use strict\";\n";
  for (const std::string_view part : parts) {
    text += part;
  }
  return text + "})();\n</script>\n";
}

/// What scripts find by its id and unpack; the letters of packed text can end no element.
std::string packed_element(std::string_view id, std::string_view packed) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, packed);
}

} // namespace

std::string view_section(const model::Model& model, const results::RunResult& run) {
  const ViewData data = make_view_data(model, run);
  if (data.json.empty()) {
    return {};
  }
  std::string html = fmt::format(
      "<section id=\"view\" class=\"screen\">\n<h2>View</h2>\n<style>{}</style>\n"
      "<noscript><p class=\"note\">Without scripts the pictures below are all there is to see."
      "</p></noscript>\n<p class=\"note\" id=\"view-word\"></p>\n<div id=\"view-stage\"></div>\n",
      embedded::view_style);
  if (!data.left_out.empty()) {
    html += fmt::format("<p class=\"note\">{}</p>\n", escape_xml(data.left_out));
  }
  html += packed_element("view-data", packed_text(data.json, base::RepetitionSearch::runs));
  html += "<!-- three.js, the drawing library of the view: MIT licence, threejs.org/license -->\n";
  html += packed_element("view-library", embedded::packed_library);
  html += own_script({embedded::data_script, embedded::surface_script, embedded::camera_script,
                      embedded::colours_script, embedded::scene_script, embedded::panel_script,
                      embedded::readings_script, embedded::view_script});
  return html + "</section>\n";
}

std::string curve_script(const std::string& page) {
  return page.find("<g class=\"plot\"") == std::string::npos
             ? std::string()
             : own_script({embedded::curves_script});
}

} // namespace spricka::report
