// SPDX-License-Identifier: MIT
// Reads conformance vectors (docs/raster/conformance.md has the grammar). Whatever is not in the grammar is an error.
#pragma once

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <irg/core/sinks.hpp>
#include <irg/raster/window.hpp>

namespace test {

struct conformance_vertex {
  std::int64_t x = 0, y = 0;  // in 1/256
};

/// One case; what its kind does not have stays as it is here.
struct conformance_case {
  std::string name, kind, ties, ends, rule;
  irg::cell from, to;
  std::vector<std::vector<conformance_vertex>> rings;
  irg::cell_window window;
  std::vector<std::vector<std::int64_t>> items;
};

struct conformance_file {
  std::vector<conformance_case> cases;
  std::string error = "empty";  // of the first thing that is wrong; "" when nothing is
};

class conformance_reader {
public:
  explicit conformance_reader(const std::string& path) {
    std::ifstream in(path);
    if (!in) {
      out_.error = "cannot be read";
      return;
    }
    std::string line, text;
    while (std::getline(in, line)) text += line.substr(0, line.find('#')) + "\n";
    words_.str(text);
    out_.error.clear();
    expect("irg-conformance");
    expect("1");
    std::string word;
    while (out_.error.empty() && words_ >> word) {
      if (word == "case")
        read_case();
      else
        fail("case, not " + word);
    }
    if (out_.error.empty() && out_.cases.empty()) out_.error = "has no cases";
  }

  const conformance_file& file() const { return out_; }

private:
  void fail(const std::string& what) {
    if (out_.error.empty())
      out_.error = what + " expected" + (out_.cases.empty() ? "" : " in case " + out_.cases.back().name);
  }
  std::string word() {
    std::string w;
    if (!(words_ >> w)) fail("a word");
    return w;
  }
  void expect(const std::string& wanted) {
    if (word() != wanted) fail(wanted);
  }
  std::int64_t number() {
    std::int64_t n = 0;
    if (out_.error.empty() && !(words_ >> n)) fail("a number");
    return n;
  }
  int small() {
    const std::int64_t n = number();
    if (n != static_cast<int>(n)) fail("a number of 32 bits");
    return static_cast<int>(n);
  }
  irg::cell cell() {
    const int x = small();
    return {x, small()};
  }

  void read_case() {
    out_.cases.emplace_back();
    conformance_case& c = out_.cases.back();
    c.name = word();
    c.kind = word();
    const std::size_t item_size = c.kind == "line" ? 2 : c.kind == "fill" ? 3 : c.kind == "tiling" ? 4 : 0;
    if (item_size == 0) return fail("line, fill or tiling");
    for (std::string key = word(); key != "expect" && out_.error.empty(); key = word()) {
      if (key == "from")
        c.from = cell();
      else if (key == "to")
        c.to = cell();
      else if (key == "ties")
        c.ties = word();
      else if (key == "ends")
        c.ends = word();
      else if (key == "rule")
        c.rule = word();
      else if (key == "window") {
        const irg::cell first = cell(), last = cell();
        c.window = {first.x, first.y, last.x, last.y};
      } else if (key == "ring") {
        c.rings.emplace_back();
        for (std::int64_t n = number(); n > 0 && out_.error.empty(); --n) {
          const std::int64_t x = number();
          c.rings.back().push_back({x, number()});
        }
      } else
        fail("a key, not " + key);
    }
    for (std::int64_t n = number(); n > 0 && out_.error.empty(); --n) {
      c.items.emplace_back();
      for (std::size_t k = 0; k < item_size; ++k) c.items.back().push_back(number());
    }
    expect("end");
  }

  std::istringstream words_;
  conformance_file out_;
};

}  // namespace test
