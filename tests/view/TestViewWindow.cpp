#include "Scene.h"

#include "apps/drawing/VirtualDisplay.h"
#include "apps/view/ViewWindow.h"

#include <gtest/gtest.h>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkPNGReader.h>
#include <vtkPolyData.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include <unistd.h>

using namespace swellray::view;
namespace fs = std::filesystem;

namespace
{

const WaveControls BayWave{ 3.0, 90.0, 0.4, 0.0 };

/** A window on the bay, and the events of a user. */
class ViewWindowTest : public testing::Test
{
protected:
  void SetUp() override
  {
    if (std::getenv("ASAN_OPTIONS") || std::getenv("TSAN_OPTIONS"))
    {
      GTEST_SKIP() << "sanitizers see into the software driver of OpenGL";
    }
    try
    {
      this->Display.emplace();
    }
    catch (const std::runtime_error& error)
    {
      GTEST_SKIP() << error.what();
    }
    this->Folder = fs::temp_directory_path() / ("swellray-view-" + std::to_string(getpid()));
    fs::create_directories(this->Folder);
    ViewSetup setup;
    setup.model = this->Bay.setup();
    setup.controls = BayWave;
    setup.ranges = rangesAround(BayWave, 5.0);
    setup.title = "bay";
    setup.size = { 800, 560 };
    setup.folder = this->Folder;
    setup.name = "bay";
    this->Window = std::make_unique<ViewWindow>(setup);
    ASSERT_TRUE(this->rest());
  }

  void TearDown() override
  {
    this->Window.reset();
    // Pictures to be looked at go where this says.
    const char* keep = std::getenv("SWELLRAY_KEEP_PICTURES");
    if (keep && fs::exists(this->Folder))
    {
      fs::create_directories(keep);
      const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
      for (const auto& file : fs::directory_iterator(this->Folder))
      {
        fs::copy(
          file, fs::path(keep) / (name + "-" + file.path().filename().string()), fs::copy_options::overwrite_existing);
      }
    }
    std::error_code none;
    fs::remove_all(this->Folder, none);
  }

  // Until the waves of the controls and their sea are drawn.
  bool rest()
  {
    const bool refined = waitUntil(
      [&]
      {
        this->Window->tick(0.0);
        return this->Window->model().isRefined() &&
          this->Window->model().waves().controls == this->Window->panel().values();
      });
    return refined &&
      waitUntil(
        [&]
        {
          this->Window->tick(0.0);
          return this->Window->model().surface().surface || !this->Window->model().surface().failure.empty();
        });
  }

  void at(const Pixel& place)
  {
    this->Window->interactor()->SetEventInformation(static_cast<int>(place.x), static_cast<int>(place.y));
  }

  void press(const Pixel& place)
  {
    this->at(place);
    this->Window->interactor()->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  }

  void moveTo(const Pixel& place)
  {
    this->at(place);
    this->Window->interactor()->InvokeEvent(vtkCommand::MouseMoveEvent);
  }

  void release() { this->Window->interactor()->InvokeEvent(vtkCommand::LeftButtonReleaseEvent); }

  void click(const Pixel& place)
  {
    this->press(place);
    this->release();
  }

  void key(const char* name)
  {
    this->Window->interactor()->SetKeySym(name);
    this->Window->interactor()->InvokeEvent(vtkCommand::KeyPressEvent);
    this->Window->interactor()->InvokeEvent(vtkCommand::CharEvent);
    this->Window->tick(0.0);
  }

  bool says(const std::string& words) const
  {
    for (const PanelLine& line : this->Window->lines())
    {
      if (line.label.find(words) != std::string::npos)
      {
        return true;
      }
    }
    return false;
  }

  // A pixel of the view where the scene is: the middle of the land and the water.
  Pixel middle() const { return { 0.5 * (this->Window->panel().width() + 800.0), 260.0 }; }

  std::size_t files(const char* ending) const
  {
    std::size_t count = 0;
    for (const auto& file : fs::directory_iterator(this->Folder))
    {
      count += file.path().extension() == ending ? 1 : 0;
    }
    return count;
  }

  Scene Bay{ "bay" };
  std::optional<swellray::drawing::VirtualDisplay> Display;
  fs::path Folder;
  std::unique_ptr<ViewWindow> Window;
};

// Colours of a picture, as whole numbers.
std::set<int> colorsOf(const fs::path& path, int size[2])
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  size[0] = image->GetDimensions()[0];
  size[1] = image->GetDimensions()[1];
  std::set<int> colors;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      colors.insert(pixel[0] << 16 | pixel[1] << 8 | pixel[2]);
    }
  }
  return colors;
}

}

TEST_F(ViewWindowTest, RaysFollowTheSlider)
{
  const SliderShape slider = this->Window->panel().sliders()[0];
  this->press({ slider.knob, slider.y });
  for (int i = 1; i <= 10; ++i)
  {
    this->moveTo({ slider.knob + 4.0 * i, slider.y });
    ASSERT_TRUE(waitUntil(
      [&]
      {
        this->Window->tick(0.01);
        return this->Window->model().waves().controls == this->Window->panel().values();
      }));
  }
  this->release();
  ASSERT_TRUE(this->rest());
  EXPECT_GT(this->Window->panel().values().period, BayWave.period);
  EXPECT_EQ(this->Window->model().waves().controls, this->Window->panel().values());
  this->key("s");
}

TEST_F(ViewWindowTest, CompassTurnsTheWaves)
{
  const CompassShape compass = this->Window->panel().compass();
  const auto rim = [&](double x, double y) {
    return Pixel{ compass.center.x + 0.8 * compass.radius * x, compass.center.y + 0.8 * compass.radius * y };
  };
  this->press(rim(1.0, 0.0));
  this->moveTo(rim(0.8, 0.3));
  this->moveTo(rim(0.7071, 0.7071));
  this->release();
  ASSERT_TRUE(this->rest());
  EXPECT_EQ(this->Window->model().waves().controls.directionFrom, 45.0);
  EXPECT_FALSE(this->says("No waves"));
  // Turned away from the sea there are no waves, and the panel says why.
  this->press(rim(-1.0, 0.0));
  this->release();
  for (int i = 0; i < 5 && this->Window->panel().values().directionFrom < 270.0; ++i)
  {
    this->Window->interactor()->InvokeEvent(vtkCommand::MouseWheelForwardEvent); // pixels are a degree or so
  }
  ASSERT_TRUE(this->rest());
  EXPECT_TRUE(this->says("No waves"));
}

TEST_F(ViewWindowTest, ClickTellsTheWaves)
{
  this->key("t");
  this->click(this->middle());
  ASSERT_TRUE(waitUntil(
    [&]
    {
      this->Window->tick(0.0);
      return this->Window->model().wavesAt().has_value();
    }));
  this->Window->tick(0.0);
  // From above the middle of the view is the middle of the scene: 15 m east of the origin and near the x axis.
  const WavesAt at = *this->Window->model().wavesAt();
  constexpr double Pixels = 8.0; // m: some pixels, and the height of the window's middle
  EXPECT_NEAR(at.x, 15.0, Pixels);
  EXPECT_NEAR(at.y, 0.0, Pixels);
  EXPECT_GT(at.depth, 0.0);
  EXPECT_TRUE(this->says("Wave height"));
  EXPECT_TRUE(this->says("The ray that came"));
  this->key("s");
}

TEST_F(ViewWindowTest, DragTurnsTheSceneAndTellsNothing)
{
  double before[3];
  this->Window->scene().renderer()->GetActiveCamera()->GetPosition(before);
  this->press(this->middle());
  this->moveTo({ this->middle().x + 60.0, this->middle().y + 10.0 });
  this->release();
  this->Window->tick(0.0);
  double after[3];
  this->Window->scene().renderer()->GetActiveCamera()->GetPosition(after);
  EXPECT_GT(std::abs(after[0] - before[0]), 1.0);
  EXPECT_EQ(this->Window->panel().values(), BayWave);
  this->Window->tick(0.1);
  EXPECT_FALSE(this->Window->model().wavesAt());
}

TEST_F(ViewWindowTest, WheelZoomsTheSceneAndStepsTheSliders)
{
  const double before = this->Window->scene().renderer()->GetActiveCamera()->GetDistance();
  this->at(this->middle());
  this->Window->interactor()->InvokeEvent(vtkCommand::MouseWheelForwardEvent);
  EXPECT_LT(this->Window->scene().renderer()->GetActiveCamera()->GetDistance(), before);
  const SliderShape tide = this->Window->panel().sliders()[3];
  this->at({ tide.knob, tide.y });
  this->Window->interactor()->InvokeEvent(vtkCommand::MouseWheelBackwardEvent);
  ASSERT_TRUE(this->rest());
  EXPECT_LT(this->Window->model().waves().controls.waterLevel, 0.0);
}

TEST_F(ViewWindowTest, SeaMovesUntilItIsStopped)
{
  ASSERT_TRUE(waitUntil(
    [&]
    {
      this->Window->tick(0.05);
      return this->Window->model().surface().time > 0.2;
    }));
  this->key("space");
  const double stopped = this->Window->time();
  this->Window->tick(1.0);
  EXPECT_EQ(this->Window->time(), stopped);
  this->key("space");
  this->Window->tick(1.0);
  EXPECT_EQ(this->Window->time(), stopped + 1.0);
}

TEST_F(ViewWindowTest, KeysShowAndHide)
{
  using Part = SceneView::Part;
  const std::pair<const char*, Part> keys[] = { { "1", Part::Rays }, { "3", Part::Surface }, { "4", Part::Seafloor } };
  for (const auto& [name, part] : keys)
  {
    EXPECT_TRUE(this->Window->scene().isShown(part)) << name;
    this->key(name);
    EXPECT_FALSE(this->Window->scene().isShown(part)) << name;
    this->key(name);
    EXPECT_TRUE(this->Window->scene().isShown(part)) << name;
  }
  // Crests stand still, and would cut through a sea that moves.
  this->Window->tick(0.5);
  this->Window->tick(0.5);
  EXPECT_FALSE(this->Window->scene().isShown(Part::Crests));
  this->key("3");
  EXPECT_TRUE(this->Window->scene().isShown(Part::Crests));
  this->key("2");
  EXPECT_FALSE(this->Window->scene().isShown(Part::Crests));
}

TEST_F(ViewWindowTest, TakesPictures)
{
  this->key("h");
  this->key("s");
  this->key("h");
  this->key("s");
  EXPECT_EQ(this->Window->status(), "wrote bay-2.png");
  ASSERT_EQ(this->files(".png"), 2U);
  int size[2];
  // A window without its scene has a handful of colours.
  EXPECT_GT(colorsOf(this->Folder / "bay-2.png", size).size(), 2000U);
  EXPECT_EQ(size[0], 800);
  EXPECT_EQ(size[1], 560);
}

TEST_F(ViewWindowTest, RecordsAMovie)
{
  this->key("m");
  constexpr int Frames = 5;
  for (int i = 0; i < Frames; ++i)
  {
    const double before = this->Window->model().surface().time;
    ASSERT_TRUE(waitUntil(
      [&]
      {
        this->Window->tick(10.0); // however slow the machine, the movie goes on by its own rate
        return this->Window->model().surface().time != before;
      }));
  }
  EXPECT_NEAR(this->Window->model().surface().time, Frames / 25.0, 1.01 / 25.0);
  EXPECT_EQ(this->files(".ogv"), 1U); // under its hidden name
  this->key("m");
  EXPECT_EQ(this->Window->status().rfind("wrote bay-1.ogv", 0), 0U) << this->Window->status();
  EXPECT_GT(fs::file_size(this->Folder / "bay-1.ogv"), 5000U);
}

TEST_F(ViewWindowTest, SaysWhereItCannotWrite)
{
  fs::remove_all(this->Folder);
  this->key("s");
  EXPECT_EQ(this->Window->status(), "cannot write bay-1.png");
  this->key("m");
  EXPECT_EQ(this->Window->status(), "cannot write bay-1.ogv");
}

TEST_F(ViewWindowTest, RunsUntilItIsClosed)
{
  vtkNew<vtkCallbackCommand> close;
  int events = 0;
  close->SetClientData(&events);
  close->SetCallback(
    [](vtkObject* caller, unsigned long, void* count, void*)
    {
      constexpr int Enough = 5;
      auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
      if (++*static_cast<int*>(count) == Enough)
      {
        interactor->SetKeySym("q");
        interactor->InvokeEvent(vtkCommand::KeyPressEvent);
      }
    });
  this->Window->interactor()->AddObserver(vtkCommand::TimerEvent, close, 2.0F);
  this->Window->run();
  EXPECT_GE(events, 5);
  EXPECT_GT(this->Window->time(), 0.0); // the sea has moved meanwhile
}

TEST_F(ViewWindowTest, ReplaysRecordedEvents)
{
  // A slider that is dragged and the compass that is turned, as vtkInteractorEventRecorder writes them.
  const SliderShape height = this->Window->panel().sliders()[2];
  const CompassShape compass = this->Window->panel().compass();
  const auto line = [](const char* event, double x, double y)
  {
    return std::string(event) + " " + std::to_string(static_cast<int>(x)) + " " + std::to_string(static_cast<int>(y)) +
      " 0 0 0 0\n";
  };
  const double east = compass.center.x + 0.8 * compass.radius;
  const std::string events = "# StreamVersion 1.1\n" + line("LeftButtonPressEvent", height.knob, height.y) +
    line("MouseMoveEvent", height.knob + 30.0, height.y) +
    line("LeftButtonReleaseEvent", height.knob + 30.0, height.y) +
    line("LeftButtonPressEvent", east, compass.center.y) +
    line("MouseMoveEvent", east, compass.center.y + 0.8 * compass.radius) +
    line("LeftButtonReleaseEvent", east, compass.center.y + 0.8 * compass.radius);
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(this->Window->interactor());
  recorder->ReadFromInputStringOn();
  recorder->SetInputString(events.c_str());
  recorder->Play();
  ASSERT_TRUE(this->rest());
  const WaveControls& controls = this->Window->model().waves().controls;
  EXPECT_GT(controls.height, BayWave.height);
  EXPECT_EQ(controls.directionFrom, 45.0);
  EXPECT_EQ(controls.period, BayWave.period);
}
