#include "bathymetry/SoundingReport.h"

#include "bathymetry/Text.h"

#include <cmath>

namespace swellray
{

namespace
{

constexpr int CoordinateDigits = 10;

std::string at(const glm::dvec2& place)
{
  return text(place.x, CoordinateDigits) + ", " + text(place.y, CoordinateDigits);
}

std::string words(const SoundingReport::LeftOut& error)
{
  return text(error.rms, 3) + " m rms, " + text(error.largest, 3) + " m at most (at " + at(error.place) + ")";
}

}

std::string SoundingReport::summary() const
{
  std::string line = std::to_string(this->used) + " about " + text(this->meanDistance, 3) + " m apart, on a grid of " +
    text(this->spacing, 4) + " m by natural neighbours";
  if (std::isfinite(this->maxGap))
  {
    line += "; holes where none is within " + text(this->maxGap, 3) + " m";
  }
  if (this->single.count > 0)
  {
    line += "; left-out error " + text(this->single.rms, 3) + " m rms";
  }
  if (this->outliers > 0)
  {
    line +=
      "; " + std::to_string(this->outliers) + " outliers " + (this->outliersDropped ? "dropped" : "(--drop-outliers)");
  }
  return line;
}

std::vector<std::pair<std::string, std::string>> SoundingReport::lines() const
{
  std::vector<std::pair<std::string, std::string>> result;
  const auto add = [&result](const std::string& label, const std::string& said) { result.emplace_back(label, said); };

  add("Soundings",
    std::to_string(this->count) + " with a value" +
      (this->missing > 0 ? ", " + std::to_string(this->missing) + " without" : "") +
      (this->cells > 0 ? ", in " + std::to_string(this->cells) + " cells" : "") + ", about " +
      text(this->meanDistance, 3) + " m apart");
  if (this->duplicates > 0)
  {
    add("Duplicates",
      std::to_string(this->duplicates) + " at the place of another, up to " + text(this->duplicateSpread, 3) +
        " m apart in elevation: their mean is taken");
  }
  if (this->outliers > 0)
  {
    add("Outliers",
      std::to_string(this->outliers) + " far off their neighbours, by up to " + text(this->worstOutlier, 3) +
        " m (at " + at(this->worstOutlierPlace) +
        "): " + (this->outliersDropped ? "dropped" : "kept; --drop-outliers drops them"));
  }
  add("Gridded",
    "by natural neighbours, " + text(this->spacing, 4) + " m apart" +
      (this->spacingChosen ? " (about the distance of the soundings)" : ""));
  if (std::isfinite(this->maxGap))
  {
    add("Max gap",
      text(this->maxGap, 3) + " m from the nearest sounding" +
        (this->maxGapChosen ? " (from the distance of the soundings)" : "") + "; further off is a hole");
  }
  if (this->single.count > 0)
  {
    add("Left-out error", words(this->single) + ", each sounding foretold by the others");
  }
  if (this->tenth.count > 0)
  {
    add("Cross-validation",
      words(this->tenth) + ", each tenth foretold by the others, in patches of " + text(this->patch, 3) + " m");
  }
  return result;
}

}
