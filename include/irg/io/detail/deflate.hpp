// SPDX-License-Identifier: MIT
// DEFLATE compression (RFC 1951) in the zlib wrapping (RFC 1950): matches found through hash chains, blocks with
// prefix codes of their own, stored blocks where those are shorter. Integers only: the same bytes everywhere.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/scalar.hpp>
#include <irg/io/detail/checksum.hpp>

namespace irg::detail::inline IRG_ABI {

// Where the same bytes stood before: the search of DEFLATE's compressor, through chains of equal hashes.

inline constexpr std::size_t window_size = 32768;
inline constexpr int shortest_match = 4, longest_match = 258;  // the format allows 3, which seldom pays in pictures

/// How hard to look for matches.
struct deflate_effort {
  int candidates = 0;         // earlier places looked at per position; 0 stores the data as it is
  int improve_below = 1;      // a match shorter than this is dropped for a longer one that starts a byte later
  int content = longest_match;  // a match of this length ends the search
};

/// Eight bytes as a number, the first the lowest; compilers make one load of it.
IRG_INLINE constexpr std::uint64_t eight_bytes(const std::uint8_t* p) noexcept {
  return std::uint64_t{p[0]} | std::uint64_t{p[1]} << 8 | std::uint64_t{p[2]} << 16 | std::uint64_t{p[3]} << 24 |
         std::uint64_t{p[4]} << 32 | std::uint64_t{p[5]} << 40 | std::uint64_t{p[6]} << 48 | std::uint64_t{p[7]} << 56;
}
IRG_INLINE constexpr std::uint32_t four_bytes(const std::uint8_t* p) noexcept {
  return std::uint32_t{p[0]} | std::uint32_t{p[1]} << 8 | std::uint32_t{p[2]} << 16 | std::uint32_t{p[3]} << 24;
}

/// How many bytes from a and b on are equal, `limit` at most.
IRG_INLINE constexpr int common_length(const std::uint8_t* a, const std::uint8_t* b, int limit) noexcept {
  int n = 0;
  for (; n + 8 <= limit; n += 8) {
    const std::uint64_t difference = eight_bytes(a + n) ^ eight_bytes(b + n);
    if (difference != 0) return n + std::countr_zero(difference) / 8;
  }
  while (n < limit && a[n] == b[n]) ++n;
  return n;
}

/// A copy of earlier output: `length` bytes from `distance` bytes back; none when length is 0.
struct match {
  int length = 0;
  std::size_t distance = 0;
};

/// Finds earlier occurrences of the bytes at a position. Positions are kept modulo 2^16 (Position's range): a distance
/// read back from them may be stale, but a match is believed only after its bytes were compared.
template <class Position = std::uint16_t>
class match_finder {
public:
  constexpr explicit match_finder(std::span<const std::uint8_t> data)
      : data_(data.data()), size_(data.size()), shift_(32 - minimum(static_cast<int>(std::bit_width(data.size())), 15)),
        mask_(data.size() < window_size ? std::bit_ceil(data.size() + 1) - 1 : window_size - 1),
        newest_(std::size_t{1} << (32 - shift_), Position{0}), older_(mask_ + 1, Position{0}) {}

  /// Makes the position known to later searches.
  IRG_INLINE constexpr void insert(std::size_t position) noexcept {
    if (size_ - position < 4) return;
    Position& newest = newest_[hash(position)];
    older_[position & mask_] = newest;
    newest = static_cast<Position>(position);
  }

  /// The longest match at a position among those longer than `than`; the nearest of equals.
  constexpr match longer(std::size_t position, int than, const deflate_effort& effort) const noexcept {
    if (size_ - position < 4) return {};
    const int limit = size_ - position < longest_match ? static_cast<int>(size_ - position) : longest_match;
    const std::uint8_t* here = data_ + position;
    match best{than < shortest_match ? shortest_match - 1 : than, 0};
    if (best.length >= limit) return {};
    std::size_t last = 0;
    Position candidate = newest_[hash(position)];
    for (int i = 0; i < effort.candidates; ++i, candidate = older_[candidate & mask_]) {
      const std::size_t distance = static_cast<Position>(position - candidate);
      if (distance <= last || distance > window_size || distance > position) break;
      last = distance;
      const std::uint8_t* there = here - distance;
      if (there[best.length] != here[best.length] || four_bytes(there) != four_bytes(here)) continue;
      const int length = common_length(there, here, limit);
      if (length <= best.length) continue;
      best = {length, distance};
      if (length == limit || length >= effort.content) break;
    }
    return best.distance == 0 ? match{} : best;
  }

private:
  IRG_INLINE constexpr std::size_t hash(std::size_t position) const noexcept {
    return (four_bytes(data_ + position) * 2654435769u) >> shift_;  // Knuth's multiplicative hash
  }

  const std::uint8_t* data_;
  std::size_t size_;
  int shift_;
  std::size_t mask_;
  std::vector<Position> newest_;  // by hash
  std::vector<Position> older_;   // by position modulo the window
};

// Prefix codes of limited length, as DEFLATE uses them: optimal lengths from frequencies, canonical codes from lengths.

/// A canonical prefix code over the symbols 0 to N - 1.
/// shape   length 0: the symbol has no code; bits stand in the order they are sent, the lowest first
template <std::size_t N>
struct prefix_code {
  std::array<std::uint8_t, N> length{};
  std::array<std::uint16_t, N> bits{};
};

/// Code lengths, none above `limit`, that need the fewest bits for these frequencies.
/// needs   two or more frequencies > 0 and at most 2^limit of them; limit <= 15; a sum below 2^32 / limit
/// exact   an optimal code; equal frequencies are ordered by symbol
/// cost    O(N * limit), and O(N^2) short steps of sorting
/// source  Larmore and Hirschberg 1990 (package-merge)
template <std::size_t N>
constexpr std::array<std::uint8_t, N> limited_code_lengths(const std::array<std::uint32_t, N>& frequency,
                                                           int limit) noexcept {
  std::array<std::size_t, N> order{};  // the used symbols, rarest first
  std::size_t used = 0;
  for (std::size_t symbol = 0; symbol < N; ++symbol) {
    if (frequency[symbol] == 0) continue;
    std::size_t k = used++;
    for (; k > 0 && frequency[order[k - 1]] > frequency[symbol]; --k) order[k] = order[k - 1];
    order[k] = symbol;
  }
  IRG_EXPECTS(used >= 2 && used <= std::size_t{1} << limit && limit <= 15);

  // Row by row, merge the symbols with the pairs of the row before, by weight. is_symbol keeps what each item was.
  const std::size_t wanted = 2 * used - 2;
  std::array<std::array<bool, 2 * N>, 15> is_symbol;
  std::array<std::array<std::uint32_t, 2 * N>, 2> weights;
  std::size_t size_before = 0;
  for (std::size_t row = 0; row < static_cast<std::size_t>(limit); ++row) {
    const auto& before = weights[(row + 1) % 2];
    auto& weight = weights[row % 2];
    std::size_t size = 0, symbol = 0, pair = 0;
    while (size < wanted && (symbol < used || pair + 1 < size_before)) {
      const bool pair_is_lighter =
          pair + 1 < size_before && symbol < used && before[pair] + before[pair + 1] < frequency[order[symbol]];
      is_symbol[row][size] = symbol < used && !pair_is_lighter;
      if (is_symbol[row][size]) {
        weight[size++] = frequency[order[symbol++]];
      } else {
        weight[size++] = before[pair] + before[pair + 1];
        pair += 2;
      }
    }
    size_before = size;
  }

  // Unpack from the last row: every symbol met makes its code one bit longer, every pair asks for two items above.
  std::array<std::uint8_t, N> length{};
  std::size_t items = wanted;
  for (std::size_t row = static_cast<std::size_t>(limit); row-- > 0;) {
    std::size_t symbols = 0;
    for (std::size_t i = 0; i < items; ++i)
      if (is_symbol[row][i]) ++length[order[symbols++]];
    items = 2 * (items - symbols);
  }
  return length;
}

/// The canonical code with these lengths.
/// needs   lengths that fulfil Kraft's inequality, none above 15
/// source  RFC 1951, 3.2.2
template <std::size_t N>
constexpr prefix_code<N> canonical_code(const std::array<std::uint8_t, N>& length) noexcept {
  std::array<std::uint32_t, 16> next{};
  for (const std::uint8_t l : length) ++next[l];
  next[0] = 0;
  std::uint32_t first = 0;
  for (std::uint32_t& n : next) {
    const std::uint32_t count = n;
    n = first;
    first = (first + count) << 1;
  }
  prefix_code<N> code{length, {}};
  for (std::size_t symbol = 0; symbol < N; ++symbol) {
    std::uint32_t value = length[symbol] == 0 ? 0 : next[length[symbol]]++;
    for (int bit = 0; bit < length[symbol]; ++bit, value >>= 1)
      code.bits[symbol] = static_cast<std::uint16_t>((std::uint32_t{code.bits[symbol]} << 1) | (value & 1));
  }
  return code;
}

// Whatever touches the output is a template over its container: where a debugging std::vector is no constexpr type, a
// plain constexpr function could not even be declared.

/// Appends bits to bytes, the lowest bit first.
template <class Bytes>
class bit_writer {
public:
  constexpr explicit bit_writer(Bytes& out) noexcept : out_(out) {}

  /// needs   count <= 56, bits < 2^count
  IRG_INLINE constexpr void put(std::uint64_t bits, int count) {
    pending_ |= bits << count_;
    for (count_ += count; count_ >= 8; count_ -= 8, pending_ >>= 8) out_.push_back(static_cast<std::uint8_t>(pending_));
  }
  constexpr void fill_byte() {
    if (count_ > 0) put(0, 8 - count_);
  }
  constexpr void append(std::span<const std::uint8_t> bytes) { out_.insert(out_.end(), bytes.begin(), bytes.end()); }

private:
  Bytes& out_;
  std::uint64_t pending_ = 0;
  int count_ = 0;
};

/// A literal byte (distance 0) or a match.
struct token {
  std::uint16_t value = 0;  // the byte, or the match's length
  std::uint16_t distance = 0;
};

/// A number as the format writes it: a symbol, then some of the number's own low bits.
struct symbol_and_rest {
  std::size_t symbol = 0;
  std::uint32_t rest = 0;
  int rest_bits = 0;
};

// Both alphabets cut [2^k, 2^(k+1)) into 2^split equal parts, each one symbol.
IRG_INLINE constexpr symbol_and_rest split_number(std::uint32_t n, int split) noexcept {
  const int rest_bits = static_cast<int>(std::bit_width(n)) - 1 - split;
  if (rest_bits <= 0) return {n, 0, 0};
  return {(static_cast<std::size_t>(rest_bits) << split) + (n >> rest_bits), n & ((1u << rest_bits) - 1), rest_bits};
}
IRG_INLINE constexpr symbol_and_rest length_symbol(int length) noexcept {
  if (length == longest_match) return {285, 0, 0};
  symbol_and_rest s = split_number(static_cast<std::uint32_t>(length - 3), 2);
  s.symbol += 257;
  return s;
}
IRG_INLINE constexpr symbol_and_rest distance_symbol(std::uint32_t distance) noexcept {
  return split_number(distance - 1, 1);
}

inline constexpr std::size_t end_of_block = 256;
using literal_counts = std::array<std::uint32_t, 286>;
using distance_counts = std::array<std::uint32_t, 30>;

/// Lengths at most 15 for these counts; a code has at least two symbols, as decoders want it.
template <std::size_t N>
constexpr prefix_code<N> code_for(std::array<std::uint32_t, N> counts, int limit) noexcept {
  std::size_t used = 0;
  for (const std::uint32_t c : counts) used += c != 0 ? 1 : 0;
  for (std::size_t s = 0; used < 2; ++s) {
    if (counts[s] != 0) continue;
    counts[s] = 1;
    ++used;
  }
  return canonical_code(limited_code_lengths(counts, limit));
}

/// One block's two codes and the compact form in which they are sent.
/// A template over how many symbols there are, so that including this header makes no codes.
template <class Bytes, std::size_t Literals = 286, std::size_t Distances = 30, std::size_t Runs = 19>
class block_codes {
public:
  constexpr block_codes(const std::array<std::uint32_t, Literals>& literals,
                        const std::array<std::uint32_t, Distances>& distances)
      : literal(code_for(literals, 15)), distance(code_for(distances, 15)) {
    for (std::size_t s = 0; s < 286; ++s) body_bits_ += std::uint64_t{literals[s]} * literal.length[s];
    for (std::size_t s = 0; s < 30; ++s) body_bits_ += std::uint64_t{distances[s]} * distance.length[s];
    for (std::size_t s = 265; s < 285; ++s) body_bits_ += std::uint64_t{literals[s]} * ((s - 261) / 4);
    for (std::size_t s = 4; s < 30; ++s) body_bits_ += std::uint64_t{distances[s]} * ((s - 2) / 2);

    while (literal_count_ > 257 && literal.length[literal_count_ - 1] == 0) --literal_count_;
    while (distance_count_ > 1 && distance.length[distance_count_ - 1] == 0) --distance_count_;
    shorten_lengths();
    std::array<std::uint32_t, Runs> counts{};
    for (std::size_t i = 0; i < run_count_; ++i) ++counts[runs_[i].symbol];
    run_code_ = code_for(counts, 7);
    while (run_length_count_ > 4 && run_code_.length[sent_order[run_length_count_ - 1]] == 0) --run_length_count_;
  }

  /// The bits of the block without its first three.
  constexpr std::uint64_t bits() const noexcept {
    std::uint64_t n = 14 + 3 * run_length_count_ + body_bits_;
    for (std::size_t i = 0; i < run_count_; ++i)
      n += run_code_.length[runs_[i].symbol] + static_cast<std::uint64_t>(runs_[i].rest_bits);
    return n;
  }

  constexpr void write_to(bit_writer<Bytes>& out) const {
    out.put(literal_count_ - 257, 5);
    out.put(distance_count_ - 1, 5);
    out.put(run_length_count_ - 4, 4);
    for (std::size_t i = 0; i < run_length_count_; ++i) out.put(run_code_.length[sent_order[i]], 3);
    for (std::size_t i = 0; i < run_count_; ++i) {
      out.put(run_code_.bits[runs_[i].symbol], run_code_.length[runs_[i].symbol]);
      out.put(runs_[i].rest, runs_[i].rest_bits);
    }
  }

  prefix_code<Literals> literal;
  prefix_code<Distances> distance;

private:
  static constexpr std::array<std::uint8_t, 19> sent_order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                              11, 4,  12, 3, 13, 2, 14, 1, 15};

  constexpr std::uint8_t length_at(std::size_t i) const noexcept {
    return i < literal_count_ ? literal.length[i] : distance.length[i - literal_count_];
  }
  // The lengths of both codes in one row, repetitions replaced by 16 (3 to 6 of the last), 17 and 18 (3 to 138 zeros).
  constexpr void shorten_lengths() noexcept {
    const std::size_t total = literal_count_ + distance_count_;
    for (std::size_t i = 0; i < total;) {
      const std::uint8_t length = length_at(i);
      std::size_t run = 1;
      while (i + run < total && run < 138 && length_at(i + run) == length) ++run;
      const bool repeats = i > 0 && length_at(i - 1) == length;
      if (length == 0 && run >= 11) {
        add_run(18, run - 11, 7);
      } else if (length == 0 && run >= 3) {
        add_run(17, run - 3, 3);
      } else if (length != 0 && repeats && run >= 3) {
        run = run < 6 ? run : 6;
        add_run(16, run - 3, 2);
      } else {
        run = 1;
        add_run(length, 0, 0);
      }
      i += run;
    }
  }
  constexpr void add_run(std::size_t symbol, std::size_t rest, int rest_bits) noexcept {
    runs_[run_count_++] = {symbol, static_cast<std::uint32_t>(rest), rest_bits};
  }

  std::size_t literal_count_ = 286, distance_count_ = 30, run_length_count_ = 19;
  std::array<symbol_and_rest, 316> runs_{};
  std::size_t run_count_ = 0;
  prefix_code<19> run_code_{};
  std::uint64_t body_bits_ = 0;
};

enum class last_block { no, yes };

/// Writes bytes as they are, in blocks of at most 65535.
template <class Bytes>
constexpr void write_stored(bit_writer<Bytes>& out, std::span<const std::uint8_t> bytes, last_block last) {
  do {
    const std::size_t count = bytes.size() < 65535 ? bytes.size() : 65535;
    out.put(last == last_block::yes && count == bytes.size() ? 1 : 0, 3);
    out.fill_byte();
    out.put(count | (count ^ 65535) << 16, 32);
    out.append(bytes.first(count));
    bytes = bytes.subspan(count);
  } while (!bytes.empty());
}

/// Writes one block: the tokens, or the bytes they stand for when those are shorter.
template <class Bytes>
constexpr void write_block(bit_writer<Bytes>& out, std::span<const token> tokens, std::span<const std::uint8_t> bytes,
                           last_block last) {
  literal_counts literals{};
  distance_counts distances{};
  literals[end_of_block] = 1;
  for (const token& t : tokens) {
    ++literals[t.distance == 0 ? t.value : length_symbol(t.value).symbol];
    if (t.distance != 0) ++distances[distance_symbol(t.distance).symbol];
  }
  const block_codes<Bytes> codes(literals, distances);
  const std::uint64_t stored_bits = (bytes.size() + 5 * (bytes.size() / 65535 + 1)) * 8;
  if (codes.bits() + 3 >= stored_bits) return write_stored(out, bytes, last);

  out.put(last == last_block::yes ? 5 : 4, 3);
  codes.write_to(out);
  for (const token& t : tokens) {
    if (t.distance == 0) {
      out.put(codes.literal.bits[t.value], codes.literal.length[t.value]);
      continue;
    }
    const symbol_and_rest l = length_symbol(t.value), d = distance_symbol(t.distance);
    out.put(codes.literal.bits[l.symbol] | std::uint64_t{l.rest} << codes.literal.length[l.symbol],
            codes.literal.length[l.symbol] + l.rest_bits);
    out.put(codes.distance.bits[d.symbol] | std::uint64_t{d.rest} << codes.distance.length[d.symbol],
            codes.distance.length[d.symbol] + d.rest_bits);
  }
  out.put(codes.literal.bits[end_of_block], codes.literal.length[end_of_block]);
}

/// Appends the DEFLATE stream of the data; it ends on a whole byte.
/// cost    time proportional to the data times effort.candidates; memory for 2^15 tokens and the search's 128 KiB
/// source  RFC 1951; Ziv and Lempel 1977
template <class Bytes>
constexpr void deflate(std::span<const std::uint8_t> data, const deflate_effort& effort, Bytes& bytes) {
  bit_writer out(bytes);
  if (effort.candidates == 0 || data.empty()) return write_stored(out, data, last_block::yes);

  constexpr std::size_t block_tokens = 32768;
  match_finder<> finder(data);
  std::vector<token> tokens;
  tokens.reserve(data.size() < block_tokens ? data.size() : block_tokens);
  std::size_t block_begin = 0, position = 0;
  match here = {};
  while (position < data.size()) {
    finder.insert(position);
    match next = {};
    if (here.length < effort.improve_below && position + 1 < data.size())
      next = finder.longer(position + 1, here.length, effort);
    if (here.length == 0 || next.length > here.length) {
      tokens.push_back({data[position++], 0});
      here = next;
    } else {
      tokens.push_back({static_cast<std::uint16_t>(here.length), static_cast<std::uint16_t>(here.distance)});
      const std::size_t end = position + static_cast<std::size_t>(here.length);
      while (++position < end) finder.insert(position);
      here = position < data.size() ? finder.longer(position, 0, effort) : match{};
    }
    if (tokens.size() == block_tokens && position < data.size()) {
      write_block(out, tokens, data.subspan(block_begin, position - block_begin), last_block::no);
      block_begin = position;
      tokens.clear();
    }
  }
  write_block(out, tokens, data.subspan(block_begin), last_block::yes);
  out.fill_byte();
}

/// The zlib stream of the data.
/// source  RFC 1950
template <class Bytes = std::vector<std::uint8_t>>
constexpr Bytes zlib_compress(std::span<const std::uint8_t> data, const deflate_effort& effort) {
  Bytes bytes = {0x78, 0x01};
  deflate(data, effort, bytes);
  const std::uint32_t sum = adler32(data);
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(sum >> shift));
  return bytes;
}

}  // namespace irg::detail::inline IRG_ABI
