// SPDX-License-Identifier: MIT
// DEFLATE decompression (RFC 1951) in the zlib wrapping (RFC 1950), into at most so many bytes as the caller allows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/io/detail/checksum.hpp>

namespace irg::detail::inline IRG_ABI {

/// Bits of bytes, the lowest first. Behind the end stand zeros, and `overrun` tells that some were used.
struct bit_reader {
  const std::uint8_t* at = nullptr;
  const std::uint8_t* last = nullptr;
  std::uint64_t pending = 0;
  int count = 0;
  bool overrun = false;

  /// At least 48 bits, unless fewer are left.
  IRG_INLINE constexpr void refill() noexcept {
    for (; count <= 56 && at != last; count += 8) pending |= std::uint64_t{*at++} << count;
  }
  IRG_INLINE constexpr std::uint32_t peek(int n) const noexcept {
    return static_cast<std::uint32_t>(pending & ((std::uint64_t{1} << n) - 1));
  }
  IRG_INLINE constexpr void drop(int n) noexcept {
    overrun = overrun || n > count;
    count = n > count ? 0 : count - n;
    pending >>= n;
  }
  /// needs   n <= 16
  IRG_INLINE constexpr std::uint32_t take(int n) noexcept {
    if (count < n) refill();
    const std::uint32_t bits = peek(n);
    drop(n);
    return bits;
  }
  constexpr void skip_to_byte() noexcept { drop(count % 8); }
};

/// A canonical prefix code over at most N symbols, for reading.
template <int N>
class prefix_decoder {
public:
  /// Takes the lengths of the symbols' words, 0 for none; says whether they are a code. Only a code of one word of one
  /// bit, or of none, may be incomplete.
  constexpr bool build(std::span<const std::uint8_t> lengths) noexcept {
    words_ = {};
    quick_ = {};
    for (const std::uint8_t length : lengths) ++words_[length];
    words_[0] = 0;
    int free_words = 1, longest = 0;
    for (int length = 1; length <= 15; ++length) {
      free_words = 2 * free_words - words_[static_cast<std::size_t>(length)];
      if (free_words < 0) return false;
      if (words_[static_cast<std::size_t>(length)] != 0) longest = length;
    }
    if (free_words > 0 && longest > 1) return false;
    std::array<std::uint16_t, 16> next{};
    for (std::size_t length = 1; length < 15; ++length)
      next[length + 1] = static_cast<std::uint16_t>(next[length] + words_[length]);
    for (std::size_t s = 0; s < lengths.size(); ++s)
      if (lengths[s] != 0) symbols_[next[lengths[s]]++] = static_cast<std::uint16_t>(s);
    fill_quick();
    return true;
  }

  /// The next symbol; -1 when no word stands there.
  IRG_INLINE constexpr int symbol(bit_reader& in) const noexcept {
    if (in.count < 15) in.refill();
    const std::uint16_t entry = quick_[in.peek(quick_bits)];
    if (entry == 0) return long_symbol(in);
    in.drop(entry & 15);
    return entry >> 4;
  }

private:
  static constexpr int quick_bits = 9;

  /// Words of up to quick_bits bits, found by the bits that come next: symbol * 16 + length.
  constexpr void fill_quick() noexcept {
    std::uint32_t word = 0;
    std::size_t at = 0;
    for (int length = 1; length <= quick_bits; ++length, word <<= 1)
      for (int k = 0; k < words_[static_cast<std::size_t>(length)]; ++k, ++word, ++at) {
        std::uint32_t reversed = 0;
        for (int bit = 0; bit < length; ++bit) reversed |= (word >> bit & 1) << (length - 1 - bit);
        for (std::uint32_t i = reversed; i < quick_.size(); i += std::uint32_t{1} << length)
          quick_[i] = static_cast<std::uint16_t>(symbols_[at] << 4 | length);
      }
  }

  IRG_NOINLINE constexpr int long_symbol(bit_reader& in) const noexcept {
    int word = 0, first = 0, at = 0;
    for (int length = 1; length <= 15; ++length) {
      const int count = words_[static_cast<std::size_t>(length)];
      word |= static_cast<int>(in.pending >> (length - 1) & 1);
      if (word - first < count) {
        in.drop(length);
        return symbols_[static_cast<std::size_t>(at + word - first)];
      }
      at += count;
      first = (first + count) << 1;
      word <<= 1;
    }
    return -1;
  }

  std::array<int, 16> words_{};  // how many there are of each length
  std::array<std::uint16_t, static_cast<std::size_t>(N)> symbols_{};  // by length, then by number
  std::array<std::uint16_t, 1 << quick_bits> quick_{};
};

/// Decompresses one stream; `message` says why when it does not.
template <class Bytes>
class inflater {
public:
  constexpr inflater(std::span<const std::uint8_t> in, std::size_t limit) noexcept
      : in_{in.data(), in.data() + in.size()}, most_(limit) {}

  Bytes out{};
  const char* message = nullptr;

  /// Reads a zlib stream; says whether it was whole, its sum right, and nothing behind it.
  constexpr bool zlib() {
    const std::uint32_t method = in_.take(8), flags = in_.take(8);
    if ((method & 15) != 8 || method >> 4 > 7 || (method * 256 + flags) % 31 != 0 || (flags & 32) != 0)
      return fail("compressed data do not begin as a zlib stream");
    for (bool last = false; !last;) {
      last = in_.take(1) != 0;
      if (!block(in_.take(2))) return false;
    }
    out.resize(size_, std::uint8_t{0});
    in_.skip_to_byte();
    std::uint32_t stated = 0;
    for (int i = 0; i < 4; ++i) stated = stated << 8 | in_.take(8);
    if (in_.overrun) return fail("compressed data are cut off");
    if (stated != adler32(out)) return fail("checksum of the compressed data is wrong");
    return (in_.count == 0 && in_.at == in_.last) || fail("compressed data go on after their end");
  }

private:
  constexpr bool fail(const char* why) noexcept {
    message = in_.overrun ? "compressed data are cut off" : why;
    return false;
  }

  constexpr bool block(std::uint32_t kind) {
    if (kind == 0) return stored();
    if (kind == 3) return fail("compressed data hold a block of no known kind");
    if (kind == 1 && !codes_are_fixed_)  // made once for all blocks that follow each other: a block may have ten bits
      fixed_codes();
    else if (kind == 2 && !sent_codes())
      return false;
    codes_are_fixed_ = kind == 1;
    return body();
  }

  /// Makes room for more bytes, in steps that follow the data, not what somebody claims; false beyond the limit.
  constexpr bool room(std::size_t count) {
    if (count > most_ - size_) return fail("compressed data are longer than the picture");
    if (out.size() - size_ >= count) return true;
    const std::size_t wanted = 2 * (size_ + count) + 4096;
    out.resize(wanted < most_ ? wanted : most_, std::uint8_t{0});
    return true;
  }

  constexpr bool stored() {
    in_.skip_to_byte();
    const std::uint32_t length = in_.take(16), inverse = in_.take(16);
    if (in_.overrun || (length ^ inverse) != 65535) return fail("stored block states two lengths");
    if (!room(length)) return false;
    std::uint32_t i = 0;
    for (; i < length && in_.count > 0; ++i) out[size_++] = static_cast<std::uint8_t>(in_.take(8));
    if (static_cast<std::size_t>(in_.last - in_.at) < length - i) return in_.overrun = true, fail("");
    for (; i < length; ++i) out[size_++] = *in_.at++;
    return true;
  }

  constexpr void fixed_codes() noexcept {
    std::array<std::uint8_t, 288> lengths{};
    for (std::size_t s = 0; s < 288; ++s)
      lengths[s] = static_cast<std::uint8_t>(s < 144 ? 8 : s < 256 ? 9 : s < 280 ? 7 : 8);
    literals_.build(lengths);
    std::array<std::uint8_t, 32> fives{};
    for (std::uint8_t& length : fives) length = 5;
    distances_.build(fives);
  }

  constexpr bool sent_codes() {
    constexpr std::array<std::uint8_t, 19> order = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    const std::size_t literals = in_.take(5) + 257, distances = in_.take(5) + 1, sent = in_.take(4) + 4;
    if (literals > 286 || distances > 30) return fail("block has more symbols than there are");
    std::array<std::uint8_t, 19> run_lengths{};
    for (std::size_t i = 0; i < sent; ++i) run_lengths[order[i]] = static_cast<std::uint8_t>(in_.take(3));
    prefix_decoder<19> runs;
    if (!runs.build(run_lengths)) return fail("code of a block is none");
    std::array<std::uint8_t, 316> lengths{};
    for (std::size_t i = 0; i < literals + distances;) {
      const int s = runs.symbol(in_);
      if (s < 0 || in_.overrun) return fail("code of a block is none");
      if (s < 16) {
        lengths[i++] = static_cast<std::uint8_t>(s);
        continue;
      }
      if (s == 16 && i == 0) return fail("block repeats a length before the first one");
      const std::uint8_t repeated = s == 16 ? lengths[i - 1] : std::uint8_t{0};
      std::size_t count = s == 16 ? 3 + in_.take(2) : s == 17 ? 3 + in_.take(3) : 11 + in_.take(7);
      if (count > literals + distances - i) return fail("block has more lengths than symbols");
      for (; count > 0; --count) lengths[i++] = repeated;
    }
    const std::span<const std::uint8_t> all = lengths;
    if (lengths[256] == 0 || !literals_.build(all.first(literals)) ||
        !distances_.build(all.subspan(literals, distances)))
      return fail("code of a block is none");
    return true;
  }

  constexpr bool body() {
    for (;;) {
      const int s = literals_.symbol(in_);
      if (s < 0 || in_.overrun) return fail("compressed data hold a word of no code");
      if (s == 256) return true;
      if (s < 256) {
        if (size_ == out.size() && !room(1)) return false;
        out[size_++] = static_cast<std::uint8_t>(s);
      } else if (!match(static_cast<std::uint32_t>(s - 257))) {
        return false;
      }
    }
  }

  /// The number that a symbol and the bits behind it write: as split_number takes it apart.
  constexpr std::uint32_t joined(std::uint32_t symbol, int split) noexcept {
    const std::uint32_t parts = std::uint32_t{1} << split;
    if (symbol < 2 * parts) return symbol;
    const int rest_bits = static_cast<int>(symbol >> split) - 1;
    return ((parts + symbol % parts) << rest_bits) + in_.take(rest_bits);
  }

  constexpr bool match(std::uint32_t length_symbol) {
    if (length_symbol > 28) return fail("compressed data hold a word of no code");
    const std::size_t length = length_symbol == 28 ? 258 : joined(length_symbol, 2) + 3;
    const int s = distances_.symbol(in_);
    if (s < 0 || s > 29) return fail("compressed data hold a word of no code");
    const std::size_t distance = joined(static_cast<std::uint32_t>(s), 1) + 1;
    if (in_.overrun || distance > size_) return fail("compressed data repeat what stands before their beginning");
    if (!room(length)) return false;
    std::uint8_t* to = out.data() + size_;
    const std::uint8_t* from = to - distance;
    for (std::size_t i = 0; i < length; ++i) to[i] = from[i];
    size_ += length;
    return true;
  }

  bit_reader in_;
  std::size_t most_, size_ = 0;
  bool codes_are_fixed_ = false;
  prefix_decoder<288> literals_{};
  prefix_decoder<32> distances_{};
};

}  // namespace irg::detail::inline IRG_ABI
