// SPDX-License-Identifier: MIT
#include <irg/io/detail/deflate.hpp>

#include <algorithm>
#include <cstring>
#include <utility>

#ifdef IRG_HAVE_PNG
#include <zlib.h>
#endif

#include "support/check_both.hpp"
#include "support/png_oracle.hpp"
#include "support/random.hpp"

namespace d = irg::detail;
using test::bytes;

namespace {

constexpr d::deflate_effort stored{0, 0, 0}, fast{8, 8, 64}, good{64, 64, 258}, greedy{1, 1, 4};

// What both oracles agree on; its error is set when they do not, or when the data came back changed.
test::inflated round_trip(const bytes& data, const d::deflate_effort& effort) {
  const bytes stream = d::zlib_compress(data, effort);
  test::inflated out = test::unzip(stream);
  if (out.error == nullptr && out.data != data) out.error = "other data";
#ifdef IRG_HAVE_PNG
  bytes unzipped(data.size() + 1);
  uLongf count = static_cast<uLongf>(unzipped.size());
  if (uncompress(unzipped.data(), &count, stream.data(), static_cast<uLong>(stream.size())) != Z_OK)
    out.error = "zlib refuses";
  unzipped.resize(count);
  if (unzipped != data) out.error = "zlib finds other data";
#endif
  return out;
}

bytes noise(std::size_t count, std::uint64_t seed) {
  test::random random(seed);
  bytes data(count);
  for (std::uint8_t& b : data) b = static_cast<std::uint8_t>(random.next());
  return data;
}

// The fewest bits any code of limited length needs, by trying all lengths.
template <std::size_t N>
std::uint64_t fewest_bits(const std::array<std::uint32_t, N>& frequency, int limit, std::size_t symbol = 0,
                          int room = -1) {
  if (room < 0) room = 1 << limit;
  if (symbol == N) return 0;
  std::uint64_t best = ~std::uint64_t{0} / 2;
  if (frequency[symbol] == 0) return fewest_bits(frequency, limit, symbol + 1, room);
  for (int l = 1; l <= limit; ++l) {
    const int left = room - (1 << (limit - l));
    if (left < 0) continue;
    best = std::min(
        best, frequency[symbol] * static_cast<std::uint64_t>(l) + fewest_bits(frequency, limit, symbol + 1, left));
  }
  return best;
}

template <std::size_t N>
std::uint64_t bits_of(const std::array<std::uint32_t, N>& frequency, const std::array<std::uint8_t, N>& length) {
  std::uint64_t n = 0;
  for (std::size_t s = 0; s < N; ++s) n += std::uint64_t{frequency[s]} * length[s];
  return n;
}

template <std::size_t N>
constexpr int kraft(const std::array<std::uint8_t, N>& length) {
  int sum = 0;
  for (const int l : length) sum += l == 0 ? 0 : 1 << (15 - l);
  return sum;
}

constexpr auto fibonacci = [] {
  std::array<std::uint32_t, 24> f{1, 1};
  for (std::size_t i = 2; i < f.size(); ++i) f[i] = f[i - 1] + f[i - 2];
  return f;
}();

}  // namespace

TEST_CASE("checksums: the values every specification prints") {
  constexpr std::uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  constexpr std::uint8_t name[] = {'W', 'i', 'k', 'i', 'p', 'e', 'd', 'i', 'a'};
  CHECK_BOTH(d::crc32(digits) == 0xcbf43926u);
  CHECK_BOTH(d::crc32({}) == 0u);
  CHECK_BOTH(d::crc32(std::span(digits).subspan(4), d::crc32(std::span(digits).first(4))) == 0xcbf43926u);
  CHECK_BOTH(d::adler32(name) == 0x11e60398u);
  CHECK_BOTH(d::adler32({}) == 1u);
  // The sum stands at its greatest, 65520, when a stretch of 255s begins: what forces the remainder every 5552 bytes.
  bytes high(255, 255);
  high.push_back(239);
  high.resize(5552, 0);
  high.resize(20000, 255);
  const bytes random = noise(70000, 1);
  std::uint64_t a = 1, b = 0;
  for (const std::uint8_t byte : high) a = (a + byte) % 65521, b = (b + a) % 65521;
  CHECK(d::adler32(high) == (b << 16 | a));
  CHECK(d::crc32(random) == test::slow_crc(random));
}

TEST_CASE("code lengths: by hand, and against all codes there are") {
  CHECK_BOTH(d::limited_code_lengths(std::array<std::uint32_t, 4>{1, 1, 2, 4}, 15) ==
             std::array<std::uint8_t, 4>{3, 3, 2, 1});
  CHECK_BOTH(d::limited_code_lengths(std::array<std::uint32_t, 4>{1, 1, 2, 4}, 2) ==
             std::array<std::uint8_t, 4>{2, 2, 2, 2});
  CHECK_BOTH(d::limited_code_lengths(std::array<std::uint32_t, 3>{0, 9, 1}, 15) ==
             std::array<std::uint8_t, 3>{0, 1, 1});
  test::random random(7);
  int wrong = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::array<std::uint32_t, 6> f{};
    for (std::uint32_t& n : f)
      n = static_cast<std::uint32_t>(random.integer(0, 1) * random.integer(1, 1 << random.integer(0, 10)));
    f[0] = f[5] = 3;  // two symbols at least
    for (int limit = 3; limit <= 5; ++limit) {
      const auto length = d::limited_code_lengths(f, limit);
      wrong += kraft(length) != 1 << 15 || *std::max_element(length.begin(), length.end()) > limit ||
               bits_of(f, length) != fewest_bits(f, limit);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("code lengths: Fibonacci frequencies would need 23 bits") {
  constexpr auto unlimited = [] {  // Huffman's code of these frequencies is a comb
    std::array<std::uint8_t, 24> l{};
    for (std::size_t i = 0; i < 24; ++i) l[i] = static_cast<std::uint8_t>(i == 0 ? 23 : 24 - i);
    return l;
  }();
  constexpr auto length = d::limited_code_lengths(fibonacci, 15);
  CHECK_BOTH(kraft(length) == 1 << 15);
  CHECK_BOTH(*std::max_element(length.begin(), length.end()) == 15);
  CHECK(bits_of(fibonacci, length) > bits_of(fibonacci, unlimited));
  CHECK(d::limited_code_lengths(fibonacci, 15) == length);
  // Rarer symbols never have the shorter code.
  CHECK_BOTH(std::is_sorted(length.rbegin(), length.rend()));
}

TEST_CASE("a block of Fibonacci frequencies uses all 15 bits and comes back") {
  bytes data;  // the end of the block is the sequence's first 1
  for (std::size_t s = 1; s < 21; ++s) data.insert(data.end(), fibonacci[s], static_cast<std::uint8_t>(3 * s + 40));
  test::random random(3);
  for (std::size_t i = data.size(); i > 1; --i)
    std::swap(data[i - 1], data[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(i) - 1))]);
  std::vector<d::token> tokens;
  for (const std::uint8_t b : data) tokens.push_back({b, 0});
  bytes stream;
  d::bit_writer out(stream);
  d::write_block(out, tokens, data, d::last_block::yes);
  out.fill_byte();
  const test::inflated back = test::inflater(stream).run();
  CHECK(back.error == nullptr);
  CHECK(back.data == data);
  CHECK(back.longest_code == 15);
  CHECK(round_trip(data, good).error == nullptr);
}

TEST_CASE("every length and every distance has its symbol") {
  int wrong = 0;
  for (int length = 3; length <= 258; ++length) {
    std::vector<d::token> tokens = {{7, 0}, {static_cast<std::uint16_t>(length), 1}};
    const bytes data(static_cast<std::size_t>(length) + 1 + 400, 7);  // so long that no stored block is chosen
    for (int i = 0; i < 400; ++i) tokens.push_back({7, 0});
    bytes stream;
    d::bit_writer out(stream);
    d::write_block(out, tokens, data, d::last_block::yes);
    out.fill_byte();
    const test::inflated back = test::inflater(stream).run();
    wrong += back.error != nullptr || back.data != data || back.longest_match != length || back.stored_blocks != 0;
  }
  CHECK(wrong == 0);
  for (std::uint32_t distance = 1; distance <= 32768; ++distance) {
    const d::symbol_and_rest s = d::distance_symbol(distance);
    // RFC 1951: pairs of symbols share a number of bits and follow each other without a gap.
    std::uint32_t base = 1;
    for (std::size_t k = 0; k < s.symbol; ++k) base += 1u << (k < 4 ? 0 : k / 2 - 1);
    wrong += base + s.rest != distance || s.rest_bits != (s.symbol < 4 ? 0 : static_cast<int>(s.symbol) / 2 - 1) ||
             s.symbol > 29 || s.rest >> s.rest_bits != 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("hand-made extremes come back") {
  for (const d::deflate_effort& effort : {stored, greedy, fast, good}) {
    CAPTURE(effort.candidates);
    CHECK(round_trip({}, effort).error == nullptr);
    for (std::size_t n = 1; n < 40; ++n) {
      CHECK(round_trip(bytes(n, 0), effort).error == nullptr);
      CHECK(round_trip(noise(n, n), effort).error == nullptr);
    }
    for (const std::size_t n :
         {257u, 258u, 259u, 260u, 261u, 262u, 263u, 516u, 517u, 65534u, 65535u, 65536u, 131070u, 131071u})
      CHECK(round_trip(bytes(n, 200), effort).error == nullptr);
    bytes all;
    for (int k = 0; k < 3 * 256; ++k) all.push_back(static_cast<std::uint8_t>(k * 37));
    CHECK(round_trip(all, effort).error == nullptr);
    bytes alternating(5000);
    for (std::size_t i = 0; i < alternating.size(); ++i) alternating[i] = static_cast<std::uint8_t>(i % 3);
    CHECK(round_trip(alternating, effort).error == nullptr);
  }
}

TEST_CASE("a run becomes matches of 258, one byte back") {
  const test::inflated run = round_trip(bytes(100000, 5), good);
  CHECK(run.error == nullptr);
  CHECK(run.longest_match == 258);
  CHECK(run.farthest == 1);
  CHECK(d::zlib_compress(bytes(100000, 5), fast).size() < 200);
}

TEST_CASE("the window reaches back 32768 bytes, not one more") {
  for (const std::size_t distance : {32766u, 32767u, 32768u, 32769u, 32770u, 65536u, 65537u, 98304u}) {
    CAPTURE(distance);
    bytes data = noise(distance, 11);
    data.insert(data.end(), data.begin(), data.begin() + 200);
    for (const d::deflate_effort& effort : {fast, good}) {
      const test::inflated back = round_trip(data, effort);
      CHECK(back.error == nullptr);
      CHECK(back.farthest <= 32768);
      // The last block's bytes are found again, in one match of 200, exactly when they are within reach.
      if (distance <= 32768)
        CHECK((back.longest_match == 200 && back.farthest == distance));
      else
        CHECK(back.longest_match < 200);
    }
  }
}

TEST_CASE("what cannot be compressed grows by five bytes per 65535 at most") {
  for (const std::size_t n : {1u, 100u, 65535u, 65536u, 200000u}) {
    const bytes data = noise(n, n);
    for (const d::deflate_effort& effort : {stored, fast, good}) {
      const test::inflated back = round_trip(data, effort);
      CHECK(back.error == nullptr);
      CHECK(back.dynamic_blocks == 0);
      // A block of tokens ends before 65535 bytes: one more header per 32768 bytes.
      CHECK(d::zlib_compress(data, effort).size() <= n + 6 + 5 * (n / 32768 + 1));
    }
  }
  CHECK(round_trip(noise(65535, 2), stored).stored_blocks == 1);
  CHECK(round_trip(noise(65536, 2), stored).stored_blocks == 2);
}

TEST_CASE("random mixtures come back, over many blocks") {
  test::random random(99);
  for (int trial = 0; trial < 60; ++trial) {
    bytes data;
    const std::int64_t pieces = random.integer(1, 40);
    for (std::int64_t k = 0; k < pieces; ++k) {
      const auto n = static_cast<std::size_t>(random.integer(0, 3000));
      switch (random.integer(0, 3)) {
        case 0: data.insert(data.end(), n, static_cast<std::uint8_t>(random.next())); break;
        case 1:
          for (std::size_t i = 0; i < n; ++i) data.push_back(static_cast<std::uint8_t>(random.next()));
          break;
        case 2:
          for (std::size_t i = 0; i < n; ++i) data.push_back(static_cast<std::uint8_t>(random.next() % 3));
          break;
        default:  // a copy of earlier bytes, which may overlap what it makes
          if (data.empty()) break;
          for (std::size_t from = static_cast<std::size_t>(random.next()) % data.size(), i = 0; i < n; ++i)
            data.push_back(data[from + i]);
      }
    }
    for (const d::deflate_effort& effort : {greedy, fast, good}) CHECK(round_trip(data, effort).error == nullptr);
  }
  const bytes long_text = [] {
    bytes t;
    test::random r(5);
    while (t.size() < 400000) t.push_back(static_cast<std::uint8_t>(r.next() % (1 + r.next() % 97)));
    return t;
  }();
  const test::inflated back = round_trip(long_text, fast);
  CHECK(back.error == nullptr);
  CHECK(back.dynamic_blocks > 4);
}

TEST_CASE("more effort does not cost bytes on data with structure") {
  bytes data;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) data.push_back(static_cast<std::uint8_t>((x * x + y * y) / 700));
  const std::size_t at_once = d::zlib_compress(data, fast).size(), patient = d::zlib_compress(data, good).size();
  CHECK(patient <= at_once);
  CHECK(at_once < data.size() / 4);
}

namespace {
template <std::size_t N>
constexpr bool compresses_to(const std::array<std::uint8_t, N>& data, const bytes& expected) {
  return d::zlib_compress(data, fast) == expected;
}
constexpr std::array<std::uint8_t, 300> ramp = [] {
  std::array<std::uint8_t, 300> a{};
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = static_cast<std::uint8_t>(i / 25 * i);
  return a;
}();
constexpr std::size_t ramp_size = d::zlib_compress(ramp, fast).size();
constexpr std::array<std::uint8_t, ramp_size> ramp_stream = [] {
  std::array<std::uint8_t, ramp_size> a{};
  const bytes b = d::zlib_compress(ramp, fast);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i];
  return a;
}();
}  // namespace

TEST_CASE("constant evaluation gives the same bytes") {
  CHECK(compresses_to(ramp, bytes(ramp_stream.begin(), ramp_stream.end())));
  CHECK(test::unzip(ramp_stream).error == nullptr);
  static_assert(d::zlib_compress({}, good) == bytes{0x78, 0x01, 0x01, 0x00, 0x00, 0xff, 0xff, 0x00, 0x00, 0x00, 0x01});
}
