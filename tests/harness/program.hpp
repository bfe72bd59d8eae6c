// Runs the built program as its users do: words in, status and output back.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rasterdiff::test {

struct Outcome {
  int status = -1;  ///< exit status; -1 if a signal ended it
  std::string out, err;

  [[nodiscard]] std::string lastErrorLine() const;
};

/// The program beside this test program's folder.
[[nodiscard]] Outcome runProgram(const std::vector<std::string>& words);

/// A folder that is emptied for each test and removed after it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

[[nodiscard]] std::string readAll(const std::filesystem::path& path);
void writeAll(const std::filesystem::path& path, const std::string& text);

}  // namespace rasterdiff::test
