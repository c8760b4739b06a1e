// SPDX-License-Identifier: MIT
#include <irg/io/file.hpp>

#include <filesystem>
#include <system_error>
#include <vector>

#include <doctest/doctest.h>

#if defined(__unix__)
#include <csignal>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace {

namespace fs = std::filesystem;

/// A folder that goes when the test ends.
struct scratch {
  fs::path path;
  scratch() {
    std::string name = (fs::temp_directory_path() / "irg_file_test_").string();
    for (int i = 0;; ++i) {
      path = name + std::to_string(i);
      if (fs::create_directory(path)) break;
    }
  }
  ~scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
  std::size_t entries() const {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(path)) ++n;
    return n;
  }
};

std::string why_unread(const std::string& path) {
  const auto r = irg::load_file(path);
  REQUIRE(!r);
  CHECK(r.error().line == 0);
  CHECK(r.error().column == 0);
  return r.error().message;
}
std::string why_unwritten(const std::string& path, std::string_view bytes) {
  const auto saved = irg::save_file(path, bytes);
  return saved ? "" : saved.error().message;
}

}  // namespace

TEST_CASE("file: what is written is read") {
  const scratch folder;
  for (const std::size_t size : {1u, 2u, 65535u, 65536u, 65537u, 131072u, 1000003u}) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 7 + i / 256);
    CHECK(why_unwritten(folder / "a", bytes).empty());
    const auto r = irg::load_file(folder / "a");
    REQUIRE(r);
    CHECK(*r == bytes);
    CHECK(folder.entries() == 1);
  }
  const std::vector<std::uint8_t> raw = {0, 255, 10, 13, 26};
  CHECK(irg::save_file(folder / "a", raw));
  CHECK(*irg::load_file(folder / "a") == std::string("\0\xFF\n\r\x1A", 5));
}

TEST_CASE("file: what cannot be read is said in a sentence") {
  const scratch folder;
  CHECK(why_unread(folder / "missing") == "file does not exist");
  CHECK(why_unread("") == "file does not exist");
  CHECK(why_unread(folder.path.string()) == "path is a directory, not a file");
  CHECK(why_unwritten(folder / "empty", "").empty());
  CHECK(why_unread(folder / "empty") == "file is empty");
  CHECK(why_unread((folder / "empty") + "/inside") == "a part of the path is not a directory");
#if defined(__unix__)
  if (geteuid() != 0) {
    CHECK(why_unwritten(folder / "closed", "x").empty());
    fs::permissions(folder / "closed", fs::perms::none);
    CHECK(why_unread(folder / "closed") == "permission to open the file is denied");
  } else {
    MESSAGE("skipped: the superuser may read every file");
  }
  CHECK(why_unread(std::string(10000, 'x')) == "file cannot be opened");
  if (fs::exists("/proc/self/mem")) CHECK(why_unread("/proc/self/mem") == "file cannot be read");
  CHECK(why_unread("/dev/null") == "file is empty");
#endif
}

TEST_CASE("file: a failed write leaves everything as it was") {
  const scratch folder;
  CHECK(why_unwritten(folder / "a", "old").empty());
  CHECK(why_unwritten(folder / "no/such/folder", "x") == "folder of the file does not exist");
  CHECK(why_unwritten(folder.path.string(), "x") == "path is a directory, not a file");
  CHECK(why_unwritten((folder / "a") + "/b", "x") == "a part of the path is not a directory");
  CHECK(folder.entries() == 1);
  CHECK(*irg::load_file(folder / "a") == "old");
#if defined(__unix__)
  if (fs::exists("/dev/full")) CHECK(why_unwritten("/dev/full", "x") == "not all bytes could be written");
  CHECK(why_unwritten("/dev/null", "x").empty());
  CHECK(!fs::is_regular_file("/dev/null"));  // written to, not replaced
  // A full disk, as far as a process can have one to itself.
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  const std::string why = why_unwritten(folder / "a", std::string(100'000, 'x'));
  REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
  std::signal(SIGXFSZ, SIG_DFL);
  CHECK(why == "not all bytes could be written");
  CHECK(folder.entries() == 1);
  CHECK(*irg::load_file(folder / "a") == "old");
#endif
}

TEST_CASE("file: a writer takes a name of its own and follows links") {
  const scratch folder;
  CHECK(why_unwritten(folder / "a.0.part", "another writer's").empty());
  CHECK(why_unwritten(folder / "a", "new").empty());
  CHECK(*irg::load_file(folder / "a.0.part") == "another writer's");
  CHECK(*irg::load_file(folder / "a") == "new");
#if defined(__unix__)
  fs::create_symlink(folder / "a", folder / "link");
  CHECK(why_unwritten(folder / "link", "through").empty());
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(*irg::load_file(folder / "a") == "through");
#endif
  CHECK(folder.entries() == 3 - (fs::exists(folder / "link") ? 0 : 1));
}
