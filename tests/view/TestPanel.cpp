#include "apps/view/Panel.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace swellray::view;

namespace
{

Panel makePanel()
{
  const WaveControls controls{ 10.0, 270.0, 1.0, 0.0 };
  ControlRanges ranges;
  ranges.period = { 2.0, 50.0, 0.1, true };
  ranges.direction = { 0.0, 360.0, 1.0, false };
  ranges.height = { 0.1, 10.0, 0.01, true };
  ranges.waterLevel = { -1.0, 1.0, 0.02, false };
  Panel panel(controls, ranges);
  panel.resize(1280, 800);
  return panel;
}

Pixel knobOf(const Panel& panel, Control control)
{
  const SliderShape shape = panel.sliders()[static_cast<std::size_t>(control)];
  return { shape.knob, shape.y };
}

// A place on the rim of the compass.
Pixel rimAt(const Panel& panel, double degrees)
{
  const CompassShape shape = panel.compass();
  const double turn = degrees * 3.14159265358979 / 180.0;
  return { shape.center.x + 0.9 * shape.radius * std::sin(turn), shape.center.y + 0.9 * shape.radius * std::cos(turn) };
}

}

TEST(Panel, SlidersMoveTheirOwnValue)
{
  const Control all[] = { Control::Period, Control::Direction, Control::Height, Control::WaterLevel };
  for (const Control control : all)
  {
    Panel panel = makePanel();
    const WaveControls before = panel.values();
    Pixel at = knobOf(panel, control);
    ASSERT_TRUE(panel.press(at));
    EXPECT_EQ(panel.held(), control);
    EXPECT_FALSE(panel.drag(at)); // pressing a knob moves nothing
    at.x -= 40.0;
    at.y += 100.0; // the mouse may leave the track
    EXPECT_TRUE(panel.drag(at));
    EXPECT_NEAR(knobOf(panel, control).x, at.x, 2.0); // to the step of the slider
    EXPECT_TRUE(panel.release());
    EXPECT_FALSE(panel.drag(knobOf(panel, control)));
    const WaveControls& after = panel.values();
    EXPECT_EQ(after.period != before.period, control == Control::Period);
    EXPECT_EQ(after.directionFrom != before.directionFrom, control == Control::Direction);
    EXPECT_EQ(after.height != before.height, control == Control::Height);
    EXPECT_EQ(after.waterLevel != before.waterLevel, control == Control::WaterLevel);
  }
}

TEST(Panel, CompassTurnsWhereTheMouseIs)
{
  Panel panel = makePanel();
  ASSERT_TRUE(panel.press(rimAt(panel, 270.0)));
  for (const double from : { 300.0, 0.0, 45.0, 90.0, 181.0 })
  {
    EXPECT_TRUE(panel.drag(rimAt(panel, from)));
    EXPECT_EQ(panel.values().directionFrom, from);
    EXPECT_EQ(panel.compass().directionFrom, from);
  }
  const Pixel hub = panel.compass().center;
  EXPECT_FALSE(panel.drag(hub)); // where no direction is
}

TEST(Panel, LeavesTheSceneToTheScene)
{
  Panel panel = makePanel();
  EXPECT_FALSE(panel.press({ panel.width() + 1.0, 400.0 }));
  EXPECT_FALSE(panel.release());
  EXPECT_FALSE(panel.turnWheel({ panel.width() + 1.0, 400.0 }, 1));
  // Between the controls the panel has the mouse all the same.
  EXPECT_TRUE(panel.press({ 5.0, 5.0 }));
  EXPECT_FALSE(panel.held());
}

TEST(Panel, WheelGoesStepByStep)
{
  Panel panel = makePanel();
  EXPECT_TRUE(panel.turnWheel(knobOf(panel, Control::Period), 1));
  EXPECT_EQ(panel.values().period, 10.1);
  EXPECT_TRUE(panel.turnWheel(panel.compass().center, -1));
  EXPECT_EQ(panel.values().directionFrom, 269.0);
  for (int i = 0; i < 200; ++i)
  {
    panel.turnWheel(knobOf(panel, Control::WaterLevel), 1);
  }
  EXPECT_EQ(panel.values().waterLevel, 1.0);
}

TEST(Panel, FitsIntoWindowsOfAnySize)
{
  for (const int height : { 200, 600, 1080, 2160 })
  {
    Panel panel = makePanel();
    panel.resize(2 * height, height);
    for (const SliderShape& shape : panel.sliders())
    {
      EXPECT_LT(shape.left, shape.right);
      EXPECT_LT(shape.right, panel.width());
      EXPECT_GE(shape.knob, shape.left);
      EXPECT_LE(shape.knob, shape.right);
    }
    const CompassShape compass = panel.compass();
    EXPECT_LT(compass.center.y + compass.radius, height);
    EXPECT_GT(compass.center.y - compass.radius, panel.sliders()[0].y);
    if (height >= 600)
    {
      EXPECT_GT(panel.wordsTop(), 0.25 * height); // room for words
    }
  }
}
