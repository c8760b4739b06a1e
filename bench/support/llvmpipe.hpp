// SPDX-License-Identifier: MIT
// The peer: Mesa's software rasterizer llvmpipe through OSMesa, drawing one indexed mesh. Three numbers of a vertex reach
// its fragments: a colour, or what a fragment shader of the caller's makes of them.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>

#include <GL/glext.h>

#include <cstdlib>
#include <cstdint>
#include <string>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/draw_triangles.hpp>

namespace bench {

class llvmpipe {
public:
  /// What a fragment shader finds: the vertices' own three numbers as v, their positions as p.
  static constexpr const char* colour_alone =
      "#version 120\nvarying vec3 v;\nvoid main() { gl_FragColor = vec4(v, 1.0); }\n";

  /// threads = 0 draws on the calling thread. Call before any other use of GL in the process.
  llvmpipe(int width, int height, int threads, const char* fragment = colour_alone) : picture_(width, height) {
    setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
    const int attributes[] = {
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS, 0, OSMESA_ACCUM_BITS, 0, 0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    ok_ = context_ && make_current();
    if (!ok_) return;
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    const char* vertex =
        "#version 120\nattribute vec3 position; attribute vec3 c; uniform mat4 m; varying vec3 v, p;\n"
        "void main() { gl_Position = m * vec4(position, 1.0); v = c; p = position; }\n";
    program_ = glCreateProgram();
    for (const auto& [kind, source] : {std::pair{GL_VERTEX_SHADER, vertex}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
      const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
      glShaderSource(shader, 1, &source, nullptr);
      glCompileShader(shader);
      glAttachShader(program_, shader);
    }
    glBindAttribLocation(program_, 0, "position");
    glBindAttribLocation(program_, 1, "c");
    glLinkProgram(program_);
    glUseProgram(program_);
    glEnable(GL_DEPTH_TEST);
    glViewport(0, 0, width, height);
  }
  ~llvmpipe() {
    if (context_) OSMesaDestroyContext(context_);
  }
  llvmpipe(const llvmpipe&) = delete;
  llvmpipe& operator=(const llvmpipe&) = delete;

  bool ok() const { return ok_; }
  /// Where there are several, before each of them is drawn with.
  bool make_current() {
    return OSMesaMakeCurrent(context_, picture_.data(), GL_UNSIGNED_BYTE, picture_.width(), picture_.height());
  }
  std::string renderer() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }
  const irg::image<irg::rgba8>& picture() const { return picture_; }

  void load(const std::vector<irg::point<float, 3>>& positions, const std::vector<irg::rgb<float>>& colours,
            const std::vector<irg::triangle_indices>& triangles, const irg::mat<float, 4, 4>& to_clip) {
    if (buffers_[0] == 0) glGenBuffers(3, buffers_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof positions[0]), positions.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(colours.size() * sizeof colours[0]), colours.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof triangles[0]),
                 triangles.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    count_ = static_cast<GLsizei>(3 * triangles.size());
    // irg's depth is 1 near and 0 far, GL clips -w <= z <= w: z' = w - 2z keeps near in front.
    float m[16];
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) m[4 * c + r] = r == 2 ? to_clip(3, c) - 2 * to_clip(2, c) : to_clip(r, c);
    glUniformMatrix4fv(glGetUniformLocation(program_, "m"), 1, GL_FALSE, m);
  }

  void set(const char* name, const irg::vec<float, 3>& value) {
    glUniform3f(glGetUniformLocation(program_, name), value.x, value.y, value.z);
  }

  /// A texture of linear bytes with all its levels, which repeats and is sampled trilinearly.
  void load_texture(const irg::image<irg::rgba8>& texels) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texels.width(), texels.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
  }

  /// Clear, draw, finish.
  void draw(bool cull, irg::rgb<float> background) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(background.r, background.g, background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_elements(cull);
  }

  /// Clear the depth, draw the depth alone, finish.
  void draw_depth(bool cull) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw_elements(cull);
  }

  /// Clear colour and depth, finish.
  void clear(irg::rgb<float> background) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(background.r, background.g, background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glFinish();
  }

  /// The depths as irg has them, 1 near and 0 far, the upper row first.
  void read_depth(float* to) const {
    const int width = picture_.width(), height = picture_.height();
    for (int y = 0; y < height; ++y) {
      float* row = to + std::ptrdiff_t{y} * width;
      glReadPixels(0, height - 1 - y, width, 1, GL_DEPTH_COMPONENT, GL_FLOAT, row);
      for (int x = 0; x < width; ++x) row[x] = 1 - row[x];
    }
  }

private:
  void draw_elements(bool cull) {
    if (cull)
      glEnable(GL_CULL_FACE);
    else
      glDisable(GL_CULL_FACE);
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    glFinish();
  }

  irg::image<irg::rgba8> picture_;
  OSMesaContext context_ = nullptr;
  GLuint program_ = 0;
  GLuint buffers_[3]{};
  GLsizei count_ = 0;
  bool ok_ = false;
};

}  // namespace bench
