// SPDX-License-Identifier: MIT
// The studio with its files: what the program's script and its window have in common.
#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/io/image_file.hpp>
#include <irg/io/mesh_file.hpp>
#include "studio_file.hpp"
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/raster/image.hpp>
#include "studio_picture.hpp"

#include "../support/command_line.hpp"

namespace program {

/// A studio, and the sentence that its picture shows.
class studio_session {
public:
  studio_session(int width, int height) : picture_(width, height) {}

  const irg::studio<double>& state() const { return state_; }

  /// Does what a line asks for; empty, or why it cannot be, and then the studio is as it was.
  std::string run(const irg::studio_command<double>& c) {
    const std::string why = done(c);
    if (c.action != irg::studio_action::picture) sentence_ = why;  // a picture shows what the line before it said
    return why;
  }

  /// The picture of one view, or of both.
  irg::image<irg::rgba8>& draw(std::optional<irg::studio_view> view = std::nullopt) {
    if (view)
      irg::draw_studio_view(picture_.view(), state_, *view, memory_);
    else
      irg::draw_studio(picture_.view(), state_, memory_, sentence_);
    return picture_;
  }
  /// Draws a view into a part of another picture.
  void draw(irg::image_view<irg::rgba8> part, irg::studio_view view) {
    irg::draw_studio_view(part, state_, view, memory_);
  }
  void resize(int width, int height) { picture_ = irg::image<irg::rgba8>(width, height); }

  /// Why the line before this could not be; empty if it could.
  const std::string& sentence() const { return sentence_; }
  /// What a line that is none is answered with.
  void refuse(const std::string& why) { sentence_ = why; }

  /// Writes a picture; empty, or why it cannot be.
  std::string write_picture(const std::string& file, const irg::image<irg::rgba8>& picture) {
    return wrote(file, irg::save_image(file, picture));
  }

  /// Removes the files that were written.
  void remove_files() const {
    for (const std::string& file : written_) std::remove(file.c_str());
  }
  const std::string& failed_to_write() const { return failed_; }

private:
  std::string done(const irg::studio_command<double>& c) {
    const std::string file(c.file);
    switch (c.action) {
      case irg::studio_action::event: {
        const irg::studio_status status = irg::apply_event(state_, c.event);
        return status == irg::studio_status::done ? "" : irg::sentence_of(status);
      }
      case irg::studio_action::load: return load(file, c.name);
      case irg::studio_action::restore: {
        const auto bytes = irg::load_file(file);
        if (!bytes) return with_place(bytes.error(), file);
        auto s = irg::read_studio<double>(std::string_view(*bytes));
        if (!s) return with_place(s.error(), file);
        state_ = *std::move(s);
        return "";
      }
      case irg::studio_action::save: {
        auto bytes = irg::encode_studio(state_);
        if (!bytes) return bytes.error().message;
        return wrote(file, irg::save_file(file, std::span<const std::uint8_t>(*bytes)));
      }
      case irg::studio_action::picture: {
        if (!irg::image_format_of_name(file)) return "the picture's name must end in .png, .ppm or .svg: " + file;
        return write_picture(file, draw(c.view));
      }
    }
    return "";
  }

  std::string wrote(const std::string& file, const irg::result<void>& saved) {
    if (!saved) return failed_ = std::string(saved.error().message) + ": " + file;
    written_.push_back(file);
    return "";
  }

  /// All bodies of a file, or none.
  std::string load(const std::string& file, const irg::part_name& name) {
    std::vector<irg::stored_body<double>> bodies;
    if (std::optional<irg::mesh<double>> shape = built_in(file)) {
      bodies.push_back(irg::store_body(name.empty() ? irg::part_name(file) : name, *shape));
    } else {
      const auto bytes = irg::load_file(file);
      if (!bytes) return with_place(bytes.error(), file);
      const std::string_view text(*bytes);
      const std::size_t slash = file.find_last_of("/\\") + 1;
      const irg::part_name stem(file.substr(slash, file.find_last_of('.') - slash));
      if (irg::mesh_format_of(text) == irg::mesh_format::body_xml) {
        auto read = irg::read_body_xml<double>(text);
        if (!read) return with_place(read.error(), file);
        bodies = *std::move(read);
        if (!name.empty() && bodies.size() == 1) bodies[0].name = name;
        for (auto& b : bodies)
          if (b.name.empty()) b.name = stem;
      } else {
        const auto named = irg::mesh_format_of_name(file);
        const auto read = named ? irg::read_mesh<double>(text, *named) : irg::read_mesh<double>(text);
        if (!read) return with_place(read.error(), file);
        bodies.push_back(irg::store_body(name.empty() ? stem : name, *read));
      }
    }
    irg::studio<double> next = state_;
    for (auto& b : bodies)
      if (const auto status = irg::apply_event(next, irg::load_body<double>{std::move(b)});
          status != irg::studio_status::done)
        return std::string(irg::sentence_of(status)) + ": " + file;
    state_ = std::move(next);
    return "";
  }

  static std::optional<irg::mesh<double>> built_in(const std::string& name) {
    if (name == "teapot") return irg::shape_teapot<double>();
    if (name == "cube") return irg::shape_cube<double>();
    if (name == "sphere") return irg::shape_sphere<double>();
    if (name == "torus") return irg::shape_torus<double>();
    return std::nullopt;
  }

  irg::studio<double> state_;
  irg::studio_memory<double> memory_;
  irg::image<irg::rgba8> picture_;
  std::string sentence_, failed_;
  std::vector<std::string> written_;
};

}  // namespace program
