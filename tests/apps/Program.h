#pragma once

#include <filesystem>
#include <string>

/** An empty folder that goes away with this. */
class ScratchFolder
{
public:
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string operator/(const std::string& file) const { return (this->Path / file).string(); }

private:
  std::filesystem::path Path;
};

/** Run swellray with these words of a shell, its output thrown away; the exit code. */
int runSwellray(const std::string& arguments);
