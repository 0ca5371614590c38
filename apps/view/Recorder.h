#pragma once

#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

class vtkRenderWindow;

namespace swellray::view
{

/** Writes what a window shows: pictures, and a movie. Files appear whole or not at all. */
class Recorder
{
public:
  /** Pictures a second of a movie. */
  static constexpr int Rate = 25;

  /**
   * @param folder where files are put, under the next free of the names NAME-1.png, NAME-2.png, ...
   * @param name without folder and ending
   */
  Recorder(vtkRenderWindow* window, const std::filesystem::path& folder, const std::string& name);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /** Write a .png of what was drawn last. @return what came of it, in a line */
  std::string takePicture();

  /** Begin a movie, .ogv. @return what came of it, in a line */
  std::string begin();

  /** Add what was drawn last to the movie. The window must keep its size. @return false: the movie ended there */
  bool addFrame();

  /** End the movie. @return what came of it, in a line; empty where there was none */
  std::string end();

  bool isRecording() const { return this->Movie != nullptr; }

private:
  std::filesystem::path freeName(const char* ending) const;
  std::filesystem::path hiddenName(const std::filesystem::path& path) const;

  vtkRenderWindow* Window;
  std::filesystem::path Folder;
  std::string Name;
  vtkSmartPointer<vtkOggTheoraWriter> Movie;
  std::filesystem::path MoviePath;
  int MovieSize[2] = { 0, 0 };
  int Frames = 0;
};

}
