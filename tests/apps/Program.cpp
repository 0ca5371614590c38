#include "Program.h"

#include <cstdlib>

#include <sys/wait.h>
#include <unistd.h>

ScratchFolder::ScratchFolder(const std::string& name)
  : Path(std::filesystem::temp_directory_path() / ("swellray-" + name + "-" + std::to_string(getpid())))
{
  std::filesystem::create_directories(this->Path);
}

ScratchFolder::~ScratchFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->Path, ignored);
}

int runSwellray(const std::string& arguments)
{
  const int status = std::system((SWELLRAY_PROGRAM " " + arguments + " > /dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
