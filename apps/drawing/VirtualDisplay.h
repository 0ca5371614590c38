#pragma once

namespace swellray::drawing
{

/**
 * A display to draw on: the one that DISPLAY names, or an X server in memory (Xvfb) that lives as long as this.
 */
class VirtualDisplay
{
public:
  /** @throws std::runtime_error where no display answers and no Xvfb can be started */
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /** Whether the display that DISPLAY names answers; false where none is named. */
  static bool answers();

private:
  bool connect();
  void stop();

  void* Connection = nullptr; // to the display
  int Server = 0;             // process id; 0: none was started
};

}
