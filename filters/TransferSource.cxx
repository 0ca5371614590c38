#include "TransferSource.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <utility>

namespace swellray
{

namespace
{

/** Fowler, Noll and Vo's hash FNV-1a of numbers, 64 bits. */
class NumberHash
{
public:
  void add(double value)
  {
    const double plainZero = value == 0.0 ? 0.0 : value;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &plainZero, sizeof bits);
    for (int byte = 0; byte < 8; ++byte)
    {
      this->Value = (this->Value ^ ((bits >> (8 * byte)) & 0xff)) * 1099511628211ULL;
    }
  }

  std::string text() const
  {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(this->Value));
    return digits;
  }

private:
  std::uint64_t Value = 14695981039346656037ULL;
};

std::string entry(const char* name, double value)
{
  char text[80];
  std::snprintf(text, sizeof text, "%s %.10g", name, value);
  return text;
}

std::string hashOf(vtkImageData* seafloor, vtkDataArray* elevation)
{
  NumberHash hash;
  for (int i = 0; i < 3; ++i)
  {
    hash.add(seafloor->GetOrigin()[i]);
    hash.add(seafloor->GetSpacing()[i]);
    hash.add(seafloor->GetDimensions()[i]);
  }
  for (vtkIdType i = 0; i < elevation->GetNumberOfTuples(); ++i)
  {
    hash.add(elevation->GetComponent(i, 0));
  }
  return hash.text();
}

std::string hashOf(const Current& current)
{
  constexpr int Side = 65;
  const Rectangle bounds = current.bounds();
  NumberHash hash;
  for (int i = 0; i < Side * Side; ++i)
  {
    const glm::dvec2 share(static_cast<double>(i % Side) / (Side - 1), static_cast<double>(i / Side) / (Side - 1));
    const glm::dvec2 velocity = current.velocity(bounds.low + share * bounds.size());
    hash.add(velocity.x);
    hash.add(velocity.y);
  }
  return hash.text();
}

}

std::vector<std::string> describeScene(vtkImageData* seafloor, vtkDataArray* elevation, const BackwardOptions& options,
  std::size_t frequencies, std::size_t directions, std::size_t perDirection)
{
  const char* const edges[] = { "contours", "edge", "none" };
  std::vector<std::string> scene{ "seafloor " + hashOf(seafloor, elevation), entry("water level", options.waterLevel),
    entry("gravity", options.gravity), entry("tolerance", options.tolerance),
    entry("aground depth", options.agroundDepth), entry("offshore depth", options.offshoreDepth),
    std::string("edge ") + edges[static_cast<int>(options.edge)],
    options.shoreNormal ? entry("shore normal", *options.shoreNormal) : "shore normal of the scene",
    options.current ? "current " + hashOf(*options.current) : "current none", entry("friction", options.friction),
    entry("frequencies", static_cast<double>(frequencies)), entry("directions", static_cast<double>(directions)),
    entry("rays a direction", static_cast<double>(perDirection)) };
  if (options.map)
  {
    scene.emplace_back("earth ellipsoid");
  }
  return scene;
}

TransferTable readTransferTableIfThere(const std::string& file)
{
  std::error_code none;
  return std::filesystem::exists(file, none) ? readTransferTable(file) : TransferTable();
}

void completeTransferTable(const std::string& file, TransferTable& table, const std::vector<std::string>& scene,
  const SpectralRays& rays, const BackwardTracer& tracer, const std::vector<glm::dvec2>& places,
  const Execution& execution, const std::string& history)
{
  if (!table.places.empty() || !table.scene.empty())
  {
    requireScene(file, table, scene);
  }
  table.scene = scene;
  table.rays = rays;
  const auto key = [](const glm::dvec2& p) { return std::make_pair(p.x, p.y); };
  std::map<std::pair<double, double>, std::size_t> rows;
  for (std::size_t i = 0; i < table.places.size(); ++i)
  {
    rows.emplace(key(table.places[i].place), i);
  }
  std::vector<glm::dvec2> missing;
  for (const glm::dvec2& place : places)
  {
    if (rows.emplace(key(place), table.places.size() + missing.size()).second)
    {
      missing.push_back(place);
    }
  }

  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds BetweenWrites(20);
  Clock::time_point written = Clock::now();
  bool going = true;
  std::size_t done = 0;
  // Batches of work enough for many threads, and short enough to be told and kept.
  constexpr std::size_t Batch = 64;
  while (done < missing.size() && going)
  {
    const std::size_t end = std::min(done + Batch, missing.size());
    const std::size_t total = missing.size();
    Execution part = execution;
    part.progress = [&, from = done, count = end - done](double share)
    {
      going =
        execution.report((static_cast<double>(from) + share * static_cast<double>(count)) / static_cast<double>(total));
      return going;
    };
    auto traced = traceOrigins(tracer, rays,
      { missing.begin() + static_cast<std::ptrdiff_t>(done), missing.begin() + static_cast<std::ptrdiff_t>(end) },
      part);
    if (!going)
    {
      break;
    }
    std::move(traced.begin(), traced.end(), std::back_inserter(table.places));
    done = end;
    if (!file.empty() && Clock::now() - written > BetweenWrites && done < missing.size())
    {
      writeTransferTable(file, table, history);
      written = Clock::now();
    }
  }
  if (!file.empty() && done > 0)
  {
    writeTransferTable(file, table, history);
  }
  if (done < missing.size())
  {
    return;
  }
  std::vector<SpectralOrigins> asked;
  asked.reserve(places.size());
  for (const glm::dvec2& place : places)
  {
    asked.push_back(table.places[rows.at(key(place))]);
  }
  table.places = std::move(asked);
}

}
