// SPDX-License-Identifier: MIT
// What the example programs share: options, numbers, and the one way they fail: one line on standard error, exit 2.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/math/decimal.hpp>

namespace program {

/// Ends the program: `NAME: what is wrong` and exit 2. Control characters, of a file's name say, become question marks,
/// so that the message stays one line.
[[noreturn]] inline void fail(std::string_view name, std::string_view what) {
  std::string line = std::string(name) + ": " + std::string(what);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  std::fprintf(stderr, "%s\n", line.c_str());
  std::exit(2);
}

/// The words of a command line, taken one by one.
class command_line {
public:
  command_line(int argc, char** argv, std::string_view name, std::string_view help)
      : name_(name), words_(argv + (argc > 0), argv + argc) {
    for (const std::string_view word : words_)
      if (word == "--help" || word == "-h") {
        std::fwrite(help.data(), 1, help.size(), stdout);
        std::exit(0);
      }
  }

  bool done() const { return next_ >= words_.size(); }
  std::string_view take() { return words_[next_++]; }

  /// The word after an option; an option's value may begin with a minus sign.
  std::string_view value_of(std::string_view option) {
    if (done()) fail("option " + std::string(option) + " needs a value");
    return take();
  }

  /// The value of an option that names a file.
  std::string file_of(std::string_view option) {
    const std::string_view name = value_of(option);
    if (name.empty()) fail("option " + std::string(option) + " needs a file's name");
    return std::string(name);
  }

  /// The name of a file, which is no option.
  std::string take_file() {
    const std::string_view word = take();
    if (word.starts_with('-')) refuse(word);
    return std::string(word);
  }

  [[noreturn]] void fail(std::string_view what) const { program::fail(name_, what); }

  /// One line on standard error beside a result that may surprise.
  void hint(std::string_view what) const {
    std::fprintf(stderr, "%s: %s\n", std::string(name_).c_str(), std::string(what).c_str());
  }

  /// Ends the program because of a word that it does not know.
  [[noreturn]] void refuse(std::string_view word) const {
    if (word.starts_with('-')) fail("unknown option '" + std::string(word) + "'; --help lists them");
    fail("unexpected word '" + std::string(word) + "'; --help tells how");
  }

  /// One of a list of words, as its place in the list.
  std::size_t choice(std::string_view option, const std::vector<std::string_view>& supported) {
    const std::string_view word = value_of(option);
    std::string list;
    for (std::size_t i = 0; i < supported.size(); ++i) {
      if (supported[i] == word) return i;
      list += (i ? ", " : "") + std::string(supported[i]);
    }
    fail("option " + std::string(option) + " does not support '" + std::string(word) + "'; supported: " + list);
  }

  /// Exactly `count` numbers, separated by commas.
  std::vector<double> numbers(std::string_view option, std::size_t count) {
    const std::string_view text = value_of(option);
    std::vector<double> out;
    const char *p = text.data(), *end = p + text.size();
    while (out.size() < count) {
      const auto n = irg::parse_decimal<double>(p, end);
      if (n.status == irg::decimal_status::none || n.status == irg::decimal_status::overflow) break;
      out.push_back(n.value);
      p = n.end;
      if (out.size() == count || p == end || *p != ',') break;
      ++p;
    }
    if (out.size() != count || p != end)
      fail("option " + std::string(option) + " needs " +
           (count == 1 ? std::string("a number") : std::to_string(count) + " numbers separated by commas") + ", not '" +
           std::string(text) + "'");
    return out;
  }

  /// A whole number in a range.
  int integer(std::string_view option, int low, int high) {
    const double n = numbers(option, 1)[0];
    if (!(n >= low && n <= high) || n != static_cast<int>(n))
      fail("option " + std::string(option) + " needs a whole number from " + std::to_string(low) + " to " +
           std::to_string(high));
    return static_cast<int>(n);
  }

private:
  std::string_view name_;
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
};

/// `what: FILE:LINE:COLUMN`, in files that are no text `what: FILE, byte N`, the place left out where there is none.
inline std::string with_place(const irg::parse_error& e, std::string_view file) {
  std::string text = std::string(e.message) + ": " + std::string(file);
  if (e.line > 0) text += ":" + std::to_string(e.line) + ":" + std::to_string(e.column);
  if (e.line == 0 && e.column > 0) text += ", byte " + std::to_string(e.column);
  return text;
}

}  // namespace program
