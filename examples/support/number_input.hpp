// SPDX-License-Identifier: MIT
// Numbers that the example programs read from standard input or a file, and the place of every number that is wrong.
#pragma once

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include <irg/math/decimal.hpp>

#include "command_line.hpp"

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#define PROGRAM_HAS_ISATTY 1
#endif

namespace program {

/// The numbers of a text, one by one: separated by white space, `#` starts a comment to the end of the line. Whatever is
/// wrong ends the program with `NAME: what is wrong: FILE:LINE:COLUMN`; lines and columns (bytes) count from 1. The
/// text is read as it is needed, so that endless input ends with its first wrong number.
class number_input {
public:
  /// Reads the file, or standard input when the path is empty.
  number_input(const command_line& line, const std::string& path)
      : program_(line), name_(path.empty() ? "stdin" : path), file_(path.empty() ? stdin : open(path)) {
#ifdef PROGRAM_HAS_ISATTY
    terminal_ = path.empty() && isatty(fileno(stdin)) != 0;
#endif
    next_ = next_byte();
    if (next_ == 0xEF) skip_byte_order_mark();
  }
  number_input(const number_input&) = delete;
  number_input& operator=(const number_input&) = delete;
  ~number_input() {
    if (file_ != stdin) std::fclose(file_);
  }

  /// Asks for what comes next, on standard error, when standard input is a terminal and the line is used up.
  static void prompt_if_terminal(std::string_view text, std::string_view path) {
#ifdef PROGRAM_HAS_ISATTY
    if (path.empty() && isatty(fileno(stdin)) != 0) {
      std::fwrite(text.data(), 1, text.size(), stderr);
      std::fflush(stderr);
    }
#else
    static_cast<void>(text), static_cast<void>(path);
#endif
  }

  /// The next number, a whole one from low to high.
  /// needs   `what` names it in messages
  int integer(std::string_view what, int low = std::numeric_limits<int>::min(),
              int high = std::numeric_limits<int>::max()) {
    const std::string& word = take(what);
    const char* const end = word.data() + word.size();
    const auto n = irg::parse_integer<std::int64_t>(word.data(), end);
    if (n.status == irg::decimal_status::none || n.end != end) {
      const auto real = irg::parse_decimal<double>(word.data(), end);
      const bool number = real.status != irg::decimal_status::none && real.end == end;
      fail_at_word(std::string(what) + (number ? " is not a whole number, '" : " is not a number, '") + shown(word) +
                   "'");
    }
    if (n.status != irg::decimal_status::ok || n.value < low || n.value > high)
      fail_at_word(std::string(what) + " is out of range, " + shown(word) + " is not from " + std::to_string(low) +
                   " to " + std::to_string(high));
    return static_cast<int>(n.value);
  }

  /// The next number, decimal and finite.
  double number(std::string_view what) {
    const std::string& word = take(what);
    const char* const end = word.data() + word.size();
    const auto n = irg::parse_decimal<double>(word.data(), end);
    if (n.status == irg::decimal_status::none || n.end != end)
      fail_at_word(std::string(what) + " is not a number, '" + shown(word) + "'");
    if (n.status == irg::decimal_status::overflow) fail_at_word(std::string(what) + " is too large, " + shown(word));
    return n.value;
  }

  /// Whether no number follows.
  bool at_end() {
    skip_blanks();
    return next_ == EOF;
  }

  /// Refuses numbers that nobody asked for. On a terminal the end of the line is the end.
  void expect_end() {
    if (terminal_) {
      while (next_ == ' ' || next_ == '\t' || next_ == '\r') advance();
      if (next_ == '\n') return;
    }
    if (at_end()) return;
    read_word();
    fail_at_word("nothing more is expected, but there is '" + shown(word_) + "'");
  }

  /// Ends the program with the place of the number that was read last: for what only its user can judge.
  [[noreturn]] void fail_at_word(std::string_view what) const { fail_at(what, word_line_, word_column_); }

private:
  static constexpr std::size_t longest_word = std::size_t{1} << 20;

  std::FILE* open(const std::string& path) const {
    std::error_code failed;
    if (std::filesystem::is_directory(path, failed)) program_.fail("path is a directory, not a file: " + path);
    errno = 0;
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) program_.fail((errno == ENOENT ? "file does not exist: " : "file cannot be opened: ") + path);
    return file;
  }

  [[noreturn]] void fail_at(std::string_view what, std::size_t line, std::size_t column) const {
    program_.fail(std::string(what) + ": " + name_ + ":" + std::to_string(line) + ":" + std::to_string(column));
  }

  static std::string shown(const std::string& word) { return word.size() <= 40 ? word : word.substr(0, 37) + "..."; }

  int next_byte() {
    const int byte = std::getc(file_);
    if (byte == EOF && std::ferror(file_) != 0) fail_at("input cannot be read", line_, column_);
    return byte;
  }

  // A carriage return alone ends a line, too; one before a line feed belongs to it.
  void advance() {
    const int left = next_;
    next_ = next_byte();
    if (left == '\n' || (left == '\r' && next_ != '\n')) {
      ++line_;
      column_ = 1;
    } else {
      ++column_;
    }
  }

  void skip_byte_order_mark() {
    for (const int byte : {0xEF, 0xBB, 0xBF}) {
      if (next_ != byte) fail_at("input begins with a byte that is no text", 1, 1);
      next_ = next_byte();
    }
  }

  bool at_blank() const { return next_ == ' ' || (next_ >= '\t' && next_ <= '\r'); }

  void skip_blanks() {
    while (at_blank() || next_ == '#') {
      if (next_ == '#')
        while (next_ != EOF && next_ != '\n' && next_ != '\r') advance();
      else
        advance();
    }
  }

  void read_word() {
    word_line_ = line_;
    word_column_ = column_;
    word_.clear();
    for (; next_ != EOF && next_ != '#' && !at_blank(); advance()) {
      word_.push_back(static_cast<char>(next_));
      if (word_.size() > longest_word) fail_at_word("a number has more than a million characters");
    }
  }

  const std::string& take(std::string_view what) {
    skip_blanks();
    if (next_ == EOF) fail_at(std::string(what) + " is missing", line_, column_);
    read_word();
    return word_;
  }

  const command_line& program_;
  std::string name_;
  std::FILE* file_;
  bool terminal_ = false;
  int next_ = EOF;
  std::size_t line_ = 1, column_ = 1, word_line_ = 1, word_column_ = 1;
  std::string word_;
};

}  // namespace program
