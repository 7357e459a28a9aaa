#pragma once

#include "visibility/scene/result_file.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

/// The program as a user runs it.
namespace visibility::test {

namespace fs = std::filesystem;

/// A folder of its own for each test case, removed afterwards.
class Folder {
public:
  Folder()
  {
    std::string name = (fs::temp_directory_path() / "visibility-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(std::string const& name) const { return (path_ / name).string(); }
  std::string write(std::string const& name, std::string const& text) const
  {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
  }
  std::size_t files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator{}));
  }

private:
  fs::path path_;
};

struct Run {
  int exit_code;
  std::string out, err;
};

inline Run visibility_command(Folder const& folder, std::string const& arguments)
{
  std::string const out = folder / "stdout", err = folder / "stderr";
  int const status =
    std::system((VISIBILITY_COMMAND " " + arguments + " >" + out + " 2>" + err + " </dev/null").c_str());
  auto const read = [](std::string const& file) {
    std::ifstream in(file);
    std::string const text{std::istreambuf_iterator<char>(in), {}};
    fs::remove(file);
    return text;
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
}

inline bool is_one_line(std::string const& text) { return !text.empty() && text.find('\n') == text.size() - 1; }

}  // namespace visibility::test
