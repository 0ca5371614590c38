#include "apps/cli/OutputFile.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
using swellray::cli::OutputFile;
using swellray::cli::WritingThread;

namespace
{

constexpr int Threads = 6;

// Writes files until it is stopped.
[[noreturn]] void writeForEver(const fs::path& folder)
{
  swellray::cli::installSignalHandlers();
  std::vector<std::thread> threads;
  for (int t = 0; t < Threads; ++t)
  {
    threads.emplace_back(
      [&folder, t]
      {
        const WritingThread writing;
        for (;;)
        {
          OutputFile file((folder / ("file" + std::to_string(t))).string(), {});
          std::ofstream(file.temporary(), std::ios::trunc) << std::string(10000, 'x');
          file.commit();
        }
      });
  }
  threads.front().join();
  _exit(0);
}

class OutputFileTest : public testing::Test
{
protected:
  void SetUp() override { fs::create_directory(this->Folder); }
  void TearDown() override { fs::remove_all(this->Folder); }

  const fs::path Folder = fs::temp_directory_path() / ("swellray_output_" + std::to_string(getpid()));
};

}

TEST_F(OutputFileTest, leavesNothingHiddenWhenThreadsAreStopped)
{
  // Often, as what could go wrong takes a microsecond.
  for (int attempt = 0; attempt < 60; ++attempt)
  {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0)
    {
      writeForEver(this->Folder);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10 + attempt / 4));
    kill(child, attempt % 2 == 0 ? SIGINT : SIGTERM);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), attempt % 2 == 0 ? SIGINT : SIGTERM);
    for (const auto& entry : fs::directory_iterator(this->Folder))
    {
      ASSERT_NE(entry.path().filename().string().front(), '.') << entry.path() << ", attempt " << attempt;
      ASSERT_EQ(entry.file_size(), 10000u) << entry.path();
    }
  }
}
