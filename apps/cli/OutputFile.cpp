#include "OutputFile.h"

#include "Failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <mutex>

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

namespace swellray::cli
{

namespace
{

// What a signal handler may touch: names in fixed storage.
struct Unfinished
{
  std::atomic<bool> used{ false };
  char path[4096] = {};
};
std::array<Unfinished, 32> unfinished;
std::mutex remembering;

struct Writer
{
  std::atomic<bool> used{ false };
  std::atomic<bool> parked{ false };
  pthread_t thread{};

  bool isThis() const { return this->used && pthread_equal(this->thread, pthread_self()) != 0; }
};
std::array<Writer, 32> writers;
std::atomic<bool> stopping{ false };

// To park a thread; nothing else here uses signals of this kind.
int parkSignal()
{
  return SIGRTMIN + 3;
}

void park(int)
{
  for (Writer& writer : writers)
  {
    if (writer.isThis())
    {
      writer.parked = true;
    }
  }
  for (;;)
  {
    pause();
  }
}

// A thread that went on writing would make its file again after it was removed.
void parkWriters()
{
  for (const Writer& writer : writers)
  {
    if (writer.used && !writer.isThis())
    {
      pthread_kill(writer.thread, parkSignal());
    }
  }
  // Into the wait come those that a slow disk holds; one that has ended is no writer any more.
  constexpr int longest = 10000;
  constexpr timespec aMillisecond{ 0, 1000000 };
  const auto writes = [](const Writer& writer) { return writer.used && !writer.parked && !writer.isThis(); };
  for (int waited = 0; waited < longest && std::any_of(writers.begin(), writers.end(), writes); ++waited)
  {
    nanosleep(&aMillisecond, nullptr);
  }
}

void removeUnfinished(int signal)
{
  while (stopping.exchange(true))
  {
    pause(); // another thread is at it
  }
  parkWriters();
  for (const Unfinished& file : unfinished)
  {
    if (file.used)
    {
      unlink(file.path);
    }
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

int remember(const std::string& path)
{
  const std::lock_guard<std::mutex> lock(remembering);
  for (std::size_t i = 0; i < unfinished.size(); ++i)
  {
    if (!unfinished[i].used && path.size() < sizeof unfinished[i].path)
    {
      std::memcpy(unfinished[i].path, path.c_str(), path.size() + 1);
      unfinished[i].used = true;
      return static_cast<int>(i);
    }
  }
  return -1;
}

int claimWriter()
{
  const std::lock_guard<std::mutex> lock(remembering);
  for (std::size_t i = 0; i < writers.size(); ++i)
  {
    if (!writers[i].used)
    {
      writers[i].thread = pthread_self();
      writers[i].parked = false;
      writers[i].used = true;
      return static_cast<int>(i);
    }
  }
  return -1;
}

void forget(int slot)
{
  if (slot >= 0)
  {
    unfinished[static_cast<std::size_t>(slot)].used = false;
  }
}

}

OutputFile::OutputFile(const std::string& path, const std::vector<std::string>& inputs)
  : Path(path)
  , Target(path)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::exists(this->Target, ignored))
  {
    if (!fs::is_regular_file(this->Target, ignored))
    {
      throw WorkError(fmt::format("cannot write '{}': it is not a regular file", path));
    }
    for (const std::string& input : inputs)
    {
      if (fs::equivalent(this->Target, input, ignored))
      {
        throw WorkError(fmt::format("'{}' is an input of this call; choose another file to write", path));
      }
    }
    if (access(path.c_str(), W_OK) != 0)
    {
      throw WorkError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
    }
    // Renaming onto a link would replace the link.
    this->Target = fs::canonical(this->Target);
  }
  this->Temporary =
    (this->Target.parent_path() / fmt::format(".{}.{}", this->Target.filename().string(), getpid())).string();
  this->Slot = remember(this->Temporary);
  const int file = open(this->Temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0)
  {
    const int error = errno;
    forget(this->Slot);
    throw WorkError(fmt::format("cannot write '{}': {}", path, std::strerror(error)));
  }
  close(file);
}

OutputFile::~OutputFile()
{
  if (!this->Temporary.empty())
  {
    unlink(this->Temporary.c_str());
  }
  forget(this->Slot);
}

WritingThread::WritingThread()
  : Slot(claimWriter())
{
  if (stopping)
  {
    park(0); // too late to be asked to
  }
}

WritingThread::~WritingThread()
{
  if (this->Slot >= 0)
  {
    writers[static_cast<std::size_t>(this->Slot)].used = false;
  }
}

UnfinishedFile::UnfinishedFile(const std::string& path)
  : Slot(path.empty() ? -1 : remember(path))
{
}

UnfinishedFile::~UnfinishedFile()
{
  forget(this->Slot);
}

void OutputFile::fail(const std::string& reason) const
{
  throw WorkError(fmt::format("cannot write '{}': {}", this->Path, reason));
}

void OutputFile::commit()
{
  const int file = open(this->Temporary.c_str(), O_RDONLY | O_CLOEXEC);
  const bool stored = file >= 0 && fsync(file) == 0;
  const int error = errno;
  if (file >= 0)
  {
    close(file);
  }
  if (!stored)
  {
    this->fail(std::strerror(error));
  }
  if (rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
  {
    this->fail(std::strerror(errno));
  }
  this->Temporary.clear();
}

void installSignalHandlers()
{
  static const WritingThread main;
  std::signal(parkSignal(), park);
  std::signal(SIGINT, removeUnfinished);
  std::signal(SIGTERM, removeUnfinished);
  std::signal(SIGHUP, removeUnfinished);
  std::signal(SIGXFSZ, SIG_IGN);
}

}
