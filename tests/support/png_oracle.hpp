// SPDX-License-Identifier: MIT
// A PNG and zlib decoder for the tests: every step as the specifications spell it, bit by bit, without a table and
// without a line of the encoder. It also tells what the stream was made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>

namespace test {

using bytes = std::vector<std::uint8_t>;

/// What a DEFLATE stream holds, and what was seen on the way.
struct inflated {
  const char* error = nullptr;
  bytes data;
  std::size_t consumed = 0;
  int stored_blocks = 0, dynamic_blocks = 0, longest_code = 0, longest_match = 0, shortest_match = 999;
  std::size_t farthest = 0;
};

class inflater {
public:
  explicit inflater(std::span<const std::uint8_t> in) : in_(in) {}

  inflated run() {
    for (bool last = false; !last && out_.error == nullptr;) {
      last = bits(1) == 1;
      const unsigned type = bits(2);
      if (type == 0)
        stored();
      else if (type == 2)
        dynamic();
      else
        fail("block type");
    }
    out_.consumed = (at_ + 7) / 8;
    return out_;
  }

private:
  // A code in canonical order: for each length the first of its words, and the symbols that have one, in order.
  struct code {
    unsigned first[16] = {};
    std::vector<unsigned> symbols[16];
  };

  void fail(const char* why) {
    if (out_.error == nullptr) out_.error = why;
  }
  unsigned bits(int count) {
    unsigned n = 0;
    for (int i = 0; i < count; ++i, ++at_) {
      if (at_ / 8 >= in_.size()) return fail("end of stream"), 0;
      n |= static_cast<unsigned>(in_[at_ / 8] >> (at_ % 8) & 1) << i;
    }
    return n;
  }
  code make_code(const std::vector<unsigned>& length) {
    code c;
    unsigned next = 0, kraft = 0;
    for (unsigned l = 1; l <= 15; ++l) {
      c.first[l] = next <<= 1;
      for (std::size_t s = 0; s < length.size(); ++s)
        if (length[s] == l) {
          c.symbols[l].push_back(static_cast<unsigned>(s));
          ++next;
          kraft += 1u << (15 - l);
          if (static_cast<int>(l) > out_.longest_code) out_.longest_code = static_cast<int>(l);
        }
    }
    if (kraft != 1u << 15) fail("code is not complete");
    return c;
  }
  unsigned symbol(const code& c) {
    unsigned value = 0;
    for (unsigned l = 1; l <= 15 && out_.error == nullptr; ++l) {
      value = value << 1 | bits(1);
      if (value >= c.first[l] && value - c.first[l] < c.symbols[l].size()) return c.symbols[l][value - c.first[l]];
    }
    return fail("no such code"), 0;
  }
  void stored() {
    ++out_.stored_blocks;
    at_ = (at_ + 7) / 8 * 8;
    const unsigned count = bits(16), inverse = bits(16);
    if (count + inverse != 65535) return fail("stored length");
    for (unsigned i = 0; i < count; ++i) out_.data.push_back(static_cast<std::uint8_t>(bits(8)));
  }
  void dynamic() {
    ++out_.dynamic_blocks;
    const unsigned literals = bits(5) + 257, distances = bits(5) + 1, sent = bits(4) + 4;
    if (literals > 286 || distances > 30) return fail("too many symbols");
    static constexpr unsigned order[] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    std::vector<unsigned> run_lengths(19, 0), lengths;
    for (unsigned i = 0; i < sent; ++i) run_lengths[order[i]] = bits(3);
    const code runs = make_code(run_lengths);
    while (lengths.size() < literals + distances && out_.error == nullptr) {
      const unsigned s = symbol(runs);
      if (s < 16) {
        lengths.push_back(s);
        continue;
      }
      if (s == 16 && lengths.empty()) return fail("nothing to repeat");
      const unsigned what = s == 16 ? lengths.back() : 0;
      const unsigned count = s == 16 ? 3 + bits(2) : s == 17 ? 3 + bits(3) : 11 + bits(7);
      lengths.insert(lengths.end(), count, what);
    }
    if (lengths.size() != literals + distances) return fail("lengths");
    const auto split = lengths.begin() + static_cast<std::ptrdiff_t>(literals);
    body(make_code({lengths.begin(), split}), make_code({split, lengths.end()}));
  }
  void body(const code& literal, const code& distance) {
    static constexpr unsigned length_base[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                               31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    static constexpr int length_bits[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                          2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    static constexpr unsigned distance_base[] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                                 33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                                 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    while (out_.error == nullptr) {
      const unsigned s = symbol(literal);
      if (s == 256) return;
      if (s < 256) {
        out_.data.push_back(static_cast<std::uint8_t>(s));
        continue;
      }
      const unsigned length = length_base[s - 257] + bits(length_bits[s - 257]);
      const unsigned d = symbol(distance);
      const std::size_t back = distance_base[d] + bits(d < 4 ? 0 : static_cast<int>(d) / 2 - 1);
      if (back > out_.data.size()) return fail("distance");
      if (static_cast<int>(length) > out_.longest_match) out_.longest_match = static_cast<int>(length);
      if (static_cast<int>(length) < out_.shortest_match) out_.shortest_match = static_cast<int>(length);
      if (back > out_.farthest) out_.farthest = back;
      for (unsigned i = 0; i < length; ++i) out_.data.push_back(out_.data[out_.data.size() - back]);
    }
  }

  std::span<const std::uint8_t> in_;
  std::size_t at_ = 0;  // in bits
  inflated out_;
};

/// The data of a zlib stream, its header, checksum and length verified.
inline inflated unzip(std::span<const std::uint8_t> in) {
  inflated out;
  if (in.size() < 6 || in[0] != 0x78 || (in[0] * 256 + in[1]) % 31 != 0 || (in[1] & 0x20) != 0)
    return out.error = "zlib header", out;
  out = inflater(in.subspan(2)).run();
  if (out.error != nullptr) return out;
  std::uint64_t a = 1, b = 0;
  for (const std::uint8_t byte : out.data) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  std::uint64_t stated = 0;
  if (in.size() != out.consumed + 6) return out.error = "length of the stream", out;
  for (std::size_t i = in.size() - 4; i < in.size(); ++i) stated = stated << 8 | in[i];
  if (stated != (b << 16 | a)) out.error = "Adler-32";
  return out;
}

/// A decoded PNG file of 8 bits per channel, one picture or an animation of pictures that replace each other.
struct decoded_png {
  const char* error = nullptr;
  int colour_type = -1, data_chunks = 0, srgb_chunks = 0;
  unsigned filters = 0;  // bit f: some row has filter f
  irg::image<irg::rgba8> picture;
  unsigned frames = 0, repeats = 0;  // as the animation states them; no frames: it is none
  std::vector<double> seconds;       // of each frame
  std::vector<irg::image<irg::rgba8>> shown;
};

/// The remainder of the message over GF(2), a bit at a time.
inline std::uint32_t slow_crc(std::span<const std::uint8_t> in) {
  std::uint32_t c = 0xffffffffu;
  for (const std::uint8_t byte : in)
    for (int i = 0; i < 8; ++i) {
      const bool odd = ((c ^ static_cast<std::uint32_t>(byte >> i)) & 1) != 0;
      c = (c >> 1) ^ (odd ? 0xedb88320u : 0);
    }
  return ~c;
}

inline void unfilter(bytes& rows, std::size_t count, std::size_t height, std::size_t pixel, unsigned& filters) {
  const auto at = [&](std::size_t y, std::size_t i) -> std::uint8_t& { return rows[y * (count + 1) + 1 + i]; };
  for (std::size_t y = 0; y < height; ++y) {
    const int filter = rows[y * (count + 1)];
    filters |= 1u << filter;
    for (std::size_t i = 0; i < count; ++i) {
      const int a = i < pixel ? 0 : at(y, i - pixel), b = y == 0 ? 0 : at(y - 1, i);
      const int c = i < pixel || y == 0 ? 0 : at(y - 1, i - pixel);
      const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
      const int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      const int predicted[] = {0, a, b, (a + b) / 2, paeth};
      at(y, i) = static_cast<std::uint8_t>(at(y, i) + predicted[filter]);
    }
  }
}

/// The picture in a PNG file, every chunk's order and checksum verified.
inline decoded_png decode_png(std::span<const std::uint8_t> file) {
  decoded_png out;
  const auto number = [&](std::size_t i) {
    return std::uint32_t{file[i]} << 24 | std::uint32_t{file[i + 1]} << 16 | std::uint32_t{file[i + 2]} << 8 |
           file[i + 3];
  };
  static constexpr std::uint8_t signature[] = {137, 80, 78, 71, 13, 10, 26, 10};
  for (std::size_t i = 0; i < 8; ++i)
    if (file.size() < 8 || file[i] != signature[i]) return out.error = "signature", out;
  std::size_t width = 0, height = 0, at = 8;
  bytes stream;
  std::vector<bytes> later;   // streams of the frames after the first
  std::uint32_t sequence = 0;
  for (bool ended = false; !ended;) {
    if (file.size() - at < 12 || file.size() - at - 12 < number(at)) return out.error = "chunk", out;
    const std::size_t length = number(at);
    const auto checked = file.subspan(at + 4, length + 4), data = checked.subspan(4);
    if (slow_crc(checked) != number(at + 8 + length)) return out.error = "CRC", out;
    const std::string_view name(reinterpret_cast<const char*>(checked.data()), 4);
    if ((name == "IHDR") != (at == 8)) return out.error = "IHDR is not first", out;
    if (name == "IHDR") {
      width = number(at + 8);
      height = number(at + 12);
      out.colour_type = data[9];
      if (length != 13 || data[8] != 8 || data[10] != 0 || data[11] != 0 || data[12] != 0)
        return out.error = "IHDR", out;
    } else if (name == "sRGB") {
      if (length != 1 || data[0] > 3 || out.data_chunks > 0) return out.error = "sRGB", out;
      ++out.srgb_chunks;
    } else if (name == "acTL") {
      if (length != 8 || out.data_chunks > 0 || out.frames != 0) return out.error = "acTL", out;
      out.frames = number(at + 8);
      out.repeats = number(at + 12);
      if (out.frames == 0) return out.error = "no frames", out;
    } else if (name == "fcTL") {
      const bool first = out.seconds.empty();
      if (length != 26 || out.frames == 0 || first != (out.data_chunks == 0)) return out.error = "fcTL", out;
      if (number(at + 8) != sequence++) return out.error = "sequence", out;
      if (number(at + 12) != width || number(at + 16) != height || number(at + 20) != 0 || number(at + 24) != 0)
        return out.error = "part of a frame", out;
      const int times = data[20] * 256 + data[21], of = data[22] * 256 + data[23];
      out.seconds.push_back(static_cast<double>(times) / (of == 0 ? 100 : of));
      if (data[24] != 0 || data[25] != 0) return out.error = "frame is not replaced", out;
      if (!first) later.emplace_back();
    } else if (name == "fdAT") {
      if (length < 4 || later.empty() || number(at + 8) != sequence++) return out.error = "fdAT", out;
      later.back().insert(later.back().end(), data.begin() + 4, data.end());
    } else if (name == "IDAT") {
      if (!later.empty() || (out.frames != 0 && out.seconds.empty())) return out.error = "IDAT", out;
      ++out.data_chunks;
      stream.insert(stream.end(), data.begin(), data.end());
    } else if (name == "IEND") {
      ended = true;
      if (length != 0 || at + 12 != file.size()) return out.error = "IEND", out;
    } else {
      return out.error = "unknown chunk", out;
    }
    at += length + 12;
  }
  const std::size_t channels = out.colour_type == 0 ? 1 : out.colour_type == 2 ? 3 : out.colour_type == 4 ? 2 : 4;
  const auto decode = [&](const bytes& compressed) {
    irg::image<irg::rgba8> picture(static_cast<int>(width), static_cast<int>(height));
    inflated rows = unzip(compressed);
    if (rows.error != nullptr) return out.error = rows.error, picture;
    if (rows.data.size() != height * (1 + channels * width)) return out.error = "number of bytes", picture;
    for (std::size_t y = 0; y < height; ++y)
      if (rows.data[y * (1 + channels * width)] > 4) return out.error = "filter", picture;
    unfilter(rows.data, channels * width, height, channels, out.filters);
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t x = 0; x < width; ++x) {
        const std::uint8_t* p = &rows.data[y * (1 + channels * width) + 1 + channels * x];
        const bool colour = channels >= 3, opacity = channels == 2 || channels == 4;
        picture(static_cast<int>(x), static_cast<int>(y)) =
            irg::rgba8{p[0], p[colour ? 1 : 0], p[colour ? 2 : 0], opacity ? p[channels - 1] : std::uint8_t{255}};
      }
    return picture;
  };
  out.picture = decode(stream);
  if (out.frames == 0) return out;
  out.shown.push_back(out.picture);
  for (const bytes& frame : later) out.shown.push_back(decode(frame));
  if (out.error == nullptr && (out.shown.size() != out.frames || out.seconds.size() != out.frames))
    out.error = "number of frames";
  return out;
}

}  // namespace test
