// Runs the program as its users do and collects what it says.
#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>

#include "firmware/temporary_folder.h"

namespace vitrine {

struct ProgramRun {
  int status = -1;  ///< exit status; 128 + signal when killed
  std::string out;
  std::string err;
};

inline std::string file_content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// `arguments` as a shell reads them.
inline ProgramRun run_program(const std::string& arguments) {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "out";
  const std::string err = folder.path() / "err";
  const std::string command = "'" VITRINE_PROGRAM "' " + arguments + " >" + out + " 2>" + err;
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), file_content(out),
          file_content(err)};
}

}  // namespace vitrine
