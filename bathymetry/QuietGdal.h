#pragma once

#include <string>

namespace swellray
{

/**
 * While it lives, GDAL prints nothing from this thread; what it has to say is in lastError(). Registers GDAL's
 * formats on first use.
 */
class QuietGdal
{
public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;

  /** GDAL's last message in one line, or `otherwise` where it said nothing. */
  static std::string lastError(const std::string& otherwise);

  /** True where GDAL reported a failure since the last call of forget(). */
  static bool failed();

  static void forget();
};

}
