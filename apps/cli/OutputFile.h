#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swellray::cli
{

/**
 * A file that appears whole or not at all: written under a hidden name beside it and renamed when it is
 * complete. The hidden file is removed when this goes without commit(), and by SIGINT and SIGTERM.
 */
class OutputFile
{
public:
  /**
   * Create the hidden file, so that a folder that cannot be written is known before the work.
   * @param inputs files of this call that must not be written over
   * @throws WorkError naming the path and the reason
   */
  OutputFile(const std::string& path, const std::vector<std::string>& inputs);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /** The path as the user gave it. */
  const std::string& path() const { return this->Path; }

  /** Where to write. */
  const std::string& temporary() const { return this->Temporary; }

  /**
   * Bring what was written to the disk and give it its name.
   * @throws WorkError where that fails
   */
  void commit();

  /** @throws WorkError: the file could not be written, for this reason */
  [[noreturn]] void fail(const std::string& reason) const;

private:
  std::string Path;
  std::filesystem::path Target;
  std::string Temporary;
  int Slot = -1;
};

/** A hidden file that is written by others: removed by SIGINT and SIGTERM while this is there. */
class UnfinishedFile
{
public:
  /** @param path empty: none */
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

private:
  int Slot = -1;
};

/**
 * A thread that writes files, while this is there: SIGINT and SIGTERM hold it before they remove what it writes. The one that
 * installs the handlers is one of its own accord.
 */
class WritingThread
{
public:
  WritingThread();
  ~WritingThread();
  WritingThread(const WritingThread&) = delete;
  WritingThread& operator=(const WritingThread&) = delete;

private:
  int Slot = -1;
};

/** Remove unfinished files on SIGINT and SIGTERM; let a write past the size limit fail instead of killing us. */
void installSignalHandlers();

}
