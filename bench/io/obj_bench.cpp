// SPDX-License-Identifier: MIT
// Bodies read from memory: OBJ beside tinyobjloader where it is installed, and PLY. ns per byte: 1 is 1000 MB/s.
// Wrong are numbers of the body that differ from what was written. The limit finds the ends of the lines.
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/io/obj.hpp>
#include <irg/io/obj_write.hpp>
#include <irg/io/ply.hpp>

#include "support/measure.hpp"
#include "../tests/support/random.hpp"

#if defined(IRG_HAVE_TINYOBJ)
#include <sstream>

#include <tiny_obj_loader.h>
#endif

namespace {

using namespace bench;

/// A bumpy sheet of triangles, with so many digits behind the point.
irg::mesh<double> make_sheet(int side, double digits, bool attributes) {
  irg::mesh<double> m;
  test::random r(20);
  const auto number = [&](double scale) { return static_cast<double>(r.integer(-1000, 1000)) / digits * scale; };
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) {
      const double bump = number(1);
      m.positions.push_back({static_cast<double>(x) / 8 + bump, static_cast<double>(y) / 8, bump});
      if (!attributes) continue;
      m.normals.push_back({bump, -bump, 1});
      m.texcoords.push_back({static_cast<double>(x) / side, static_cast<double>(y) / side});
    }
  const auto corner = [&](int x, int y) {
    const auto v = static_cast<std::uint32_t>(y * (side + 1) + x);
    return attributes ? irg::mesh_corner{v, v, v} : irg::mesh_corner{v};
  };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      for (const irg::mesh_corner& c : {corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)}) m.corners.push_back(c);
      m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
      for (const irg::mesh_corner& c : {corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)}) m.corners.push_back(c);
      m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
    }
  return m;
}

template <class T>
struct task {
  irg::mesh<double> written;
  std::string bytes;
  irg::mesh<T> read;
};

template <class T>
errors judged(const task<T>& t) {
  double wrong = t.read.positions.size() == t.written.positions.size() ? 0 : 1;
  for (std::size_t v = 0; wrong == 0 && v < t.read.positions.size(); ++v)
    for (int i = 0; i < 3; ++i) wrong += t.read.positions[v][i] == static_cast<T>(t.written.positions[v][i]) ? 0 : 1;
  wrong += t.read.corners == t.written.corners ? 0 : 1;
  errors e;
  e.wrong = wrong;
  if (wrong != 0) e.broken = "what was written is read";
  return e;
}

std::string as_text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

template <class T, class Read>
void add(const contest& what, const std::string& name, const irg::mesh<double>& written, const std::string& bytes,
         Read read) {
  task<T>& t = keep(task<T>{written, bytes, {}});
  enter(what, {name, [&t, read] { t.read = *read(t.bytes); }, [&t] { return judged(t); }});
}

/// The tasks one after the other: what reading in pieces costs one thread.
struct one_by_one {
  template <class Task>
  void operator()(std::size_t count, Task&& task) const {
    irg::sequential{}(count, task);
  }
};

/// Two threads count by the wall.
void add_threads(const contest& what, const irg::mesh<double>& written, const std::string& bytes) {
  task<double>& t = keep(task<double>{written, bytes, {}});
  enter(what, {"irg:two threads",
               {},
               [&t] { return judged(t); },
               "by the wall",
               true,
               [&t] {
                 const auto start = std::chrono::steady_clock::now();
                 t.read = *irg::read_obj<double>(t.bytes, {}, irg::parallel{2});
                 return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
               }});
}

void enter_sheet(const std::string& name, int side, double digits, bool attributes) {
  const irg::mesh<double> m = make_sheet(side, digits, attributes);
  const std::string text = as_text(*irg::encode_obj(m));
  const contest what{"read_obj", name + build_suffix(), "byte", static_cast<std::int64_t>(text.size()),
                     "",         "limit:lines"};
  add<double>(what, "irg", m, text, [](std::string_view s) { return irg::read_obj<double>(s); });
  add<float>(what, "irg:float", m, text, [](std::string_view s) { return irg::read_obj<float>(s); });
  add<double>(what, "irg:in pieces", m, text,
              [](std::string_view s) { return irg::read_obj<double>(s, {}, one_by_one{}); });
  add_threads(what, m, text);
  const std::string& lines = keep(std::string(text));
  std::size_t& count = keep(std::size_t{0});
  enter(what, {"limit:lines", [&lines, &count] {
                 count = 0;
                 for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; ++at) ++count;
               }});
#if defined(IRG_HAVE_TINYOBJ)
  enter(what, {"tinyobjloader",
               [&lines] {
                 tinyobj::attrib_t attributes_read;
                 std::vector<tinyobj::shape_t> shapes;
                 std::vector<tinyobj::material_t> materials;
                 std::string warning, error;
                 std::istringstream in(lines);
                 tinyobj::LoadObj(&attributes_read, &shapes, &materials, &warning, &error, &in, nullptr, false);
               },
               {},
               "floats, not correctly rounded"});
#endif
}

template <class Encode, class Read>
void enter_bytes(const std::string& kernel, const irg::mesh<double>& m, Encode encode, Read read) {
  const std::string bytes = as_text(*encode(m));
  const contest what{kernel, "sheet" + build_suffix(), "byte", static_cast<std::int64_t>(bytes.size()), "", ""};
  add<double>(what, "irg", m, bytes, read);
}

}  // namespace

int main(int argc, char** argv) {
  const int side = smoke() ? 30 : 400;
  enter_sheet("short numbers", side, 1000, false);
  enter_sheet("all digits", side, 3000, false);
  enter_sheet("normals and texture coordinates", side, 1000, true);
  const irg::mesh<double> sheet = make_sheet(side, 3000, false);
  using irg::mesh_encoding;
  for (const auto& [name, e] : {std::pair{"read_ply ascii", mesh_encoding::text},
                                std::pair{"read_ply little endian", mesh_encoding::little_endian}})
    enter_bytes(
        name, sheet, [e = e](const auto& m) { return irg::encode_ply(m, e); },
        [](std::string_view s) { return irg::read_ply<double>(s); });
  return run_benchmarks(argc, argv);
}
