#include "sim/Spray.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"
#include "sim/RayField.h"
#include "sim/Scramble.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

namespace swellray
{

namespace
{

// Slots in which particles are drawn, a period.
constexpr double Slots = 64.0;
constexpr double SlotPhase = 2.0 * Pi / Slots;

// An obstacle throws spray while the crest is within this of it, rad.
constexpr double ImpactPhase = 0.25 * Pi;

// The Gaussian is cut off, so that flights are bounded.
constexpr double WidestScatter = 3.0;

// Ends of neighbouring rays belong to one face where they are no further apart than this many widths of the tube there.
constexpr double WidestFace = 4.0;

// Strips whose work is handed out at once.
constexpr std::size_t StripsAtOnce = 64;

double between(double a, double b, double weight)
{
  return a + weight * (b - a);
}

/** Numbers drawn one after the other. */
class Draws
{
public:
  explicit Draws(std::uint64_t key)
    : State(key)
  {
  }

  double uniform() { return unitOf(this->State = scramble(this->State)); }

  // Box and Muller 1958: two at a time.
  std::array<double, 2> gaussians()
  {
    const double size = std::sqrt(-2.0 * std::log(1.0 - this->uniform()));
    const double turn = 2.0 * Pi * this->uniform();
    const double cut = std::min(size, WidestScatter);
    return { cut * std::cos(turn), cut * std::sin(turn) };
  }

private:
  std::uint64_t State;
};

}

glm::dvec3 elasticReflection(const glm::dvec3& direction, const glm::dvec3& normal)
{
  return direction - 2.0 * glm::dot(direction, normal) * normal;
}

glm::dvec3 faceNormal(const glm::dvec2& outward, double slope)
{
  return slope > 0.0 ? glm::normalize(glm::dvec3(slope * outward, 1.0)) : glm::dvec3(outward, 0.0);
}

double impactShare(double phase)
{
  return std::abs(phase) < ImpactPhase ? 0.5 * (1.0 + std::cos(Pi * phase / ImpactPhase)) : 0.0;
}

/** A place of a ray that is not one of its points. */
struct Spray::RayPlace
{
  StillPlace still;
  double ripeness = 0.0;
};

/** A stretch of crest or face between two rays during a slot of time. */
struct Spray::Slot
{
  std::array<Source, 2> first;  // on either ray, as it begins
  std::array<Source, 2> second; // as it ends
  double begin = 0.0;           // s
  double length = 0.0;          // m
  std::uint64_t key = 0;
  SpraySource source = SpraySource::Crest;
};

Spray::Spray(
  const WaveSurface& surface, const Seafloor& seafloor, const Obstacles* obstacles, const SprayOptions& options)
  : Surface(surface)
  , Options(options)
  , ImpactOf(surface.sheet().rayCount())
  , SlotTime(surface.options().period / Slots)
{
  options.validate();
  if (surface.hasOwnPhase())
  {
    throw std::invalid_argument("spray follows the traced phase; leave out the straight one");
  }
  this->findImpacts(seafloor, obstacles);
  this->findStrips();
  this->boundLife();
}

Spray::RayPlace Spray::onRay(std::size_t ray, double phase) const
{
  const SurfaceSheet& sheet = this->Surface.sheet();
  const auto first = static_cast<std::size_t>(sheet.Offsets[ray]);
  const auto last = static_cast<std::size_t>(sheet.Offsets[ray + 1]) - 1;
  const double* begin = sheet.Phase.data() + first;
  const double* next = std::upper_bound(begin, sheet.Phase.data() + last + 1, phase);
  const std::size_t b = std::min(last, first + static_cast<std::size_t>(next - begin));
  const std::size_t a = b > first ? b - 1 : first;
  const double span = sheet.Phase[b] - sheet.Phase[a];
  const double w = span > 0.0 ? std::clamp((phase - sheet.Phase[a]) / span, 0.0, 1.0) : 0.0;
  const auto linear = [&](const std::vector<double>& values) { return between(values[a], values[b], w); };
  const auto vector = [&](const std::vector<double>& values, std::size_t i)
  { return glm::dvec2(values[3 * i], values[3 * i + 1]); };
  RayPlace place;
  place.still.position = glm::mix(vector(sheet.Position, a), vector(sheet.Position, b), w);
  const glm::dvec2 toward = glm::mix(vector(sheet.Direction, a), vector(sheet.Direction, b), w);
  const double size = glm::length(toward);
  place.still.direction = size > 0.0 ? toward / size : vector(sheet.Direction, a);
  place.still.height = linear(sheet.Height);
  place.still.wavenumber = linear(sheet.Wavenumber);
  place.still.depth = linear(sheet.Depth);
  place.still.slope = linear(sheet.Slope);
  place.ripeness = between(this->Surface.ripeness(a), this->Surface.ripeness(b), w);
  return place;
}

double Spray::unbrokenHeight(const RayPlace& at, const BreakingStretch* stretch, std::size_t ray) const
{
  if (!stretch)
  {
    return at.still.height;
  }
  const StillPlace begin = this->onRay(ray, stretch->begin).still;
  const double g = this->Options.gravity;
  return begin.height *
    shoalingCoefficient(waveSpeeds(begin.wavenumber, begin.depth, g).groupSpeed,
      waveSpeeds(at.still.wavenumber, at.still.depth, g).groupSpeed);
}

double Spray::speedOf(std::size_t ray, double phase, double plunge) const
{
  const RayPlace at = this->onRay(ray, phase);
  const BreakingStretch* stretch = this->Surface.history(ray).stretchAt(phase);
  const double omega = 2.0 * Pi / this->Surface.options().period;
  const double speed = omega / at.still.wavenumber;
  const auto steepness = [&](const RayPlace& place)
  { return this->unbrokenHeight(place, stretch, ray) * place.still.wavenumber / (2.0 * Pi); };
  if (this->Options.steepest > 0.0)
  {
    return orbitalSpeed(steepness(at), this->Options.steepest, speed);
  }
  if (!stretch)
  {
    return at.ripeness * speed;
  }
  return plunge > 0.0
    ? orbitalSpeed(steepness(at),
        steepness(this->onRay(ray, std::max(stretch->begin, phase - plunge * stretch->plungePhase))), speed)
    : speed;
}

void Spray::findImpacts(const Seafloor& seafloor, const Obstacles* obstacles)
{
  const SurfaceSheet& sheet = this->Surface.sheet();
  for (std::size_t ray = 0; ray < sheet.rayCount(); ++ray)
  {
    const auto first = static_cast<std::size_t>(sheet.Offsets[ray]);
    const auto last = static_cast<std::size_t>(sheet.Offsets[ray + 1]);
    if (last < first + 2)
    {
      continue;
    }
    const auto place = [&](std::size_t i) { return glm::dvec2(sheet.Position[3 * i], sheet.Position[3 * i + 1]); };
    Impact impact;
    std::size_t at = last - 1;
    glm::dvec3 normal(0.0, 0.0, 1.0);
    const bool stopped = obstacles && !sheet.EndReasons.empty() &&
      sheet.EndReasons[ray] == static_cast<std::uint8_t>(EndReason::StoppedByObstacle);
    if (stopped)
    {
      // A little beyond its end the ray would be through the wall.
      PathPiece path;
      const glm::dvec2 way = place(at) - place(at - 1);
      path.coefficients[0] = place(at - 1);
      path.coefficients[1] = 1.5 * way;
      const auto hit = obstacles->firstHit(path);
      impact.strikes = hit.has_value();
      normal = hit ? faceNormal(hit->normal, hit->slope) : normal;
    }
    else
    {
      for (at = first + 1; at < last && !sheet.Shore[at]; ++at)
      {
      }
      if (at == last || sheet.Shore[first])
      {
        continue;
      }
      const glm::dvec2 gradient = seafloor.bed(place(at)).gradient;
      const double slope = glm::length(gradient);
      impact.strikes = slope >= this->Options.steepShore;
      normal = impact.strikes ? faceNormal(-gradient / slope, slope) : normal;
    }
    // The direction in which the wave came, not that along the shore.
    const glm::dvec3 direction(sheet.Direction[3 * at - 3], sheet.Direction[3 * at - 2], 0.0);
    const glm::dvec2 horizontal(normal);
    const double size = glm::length(horizontal);
    impact.directness = size > 0.0 ? -glm::dot(glm::dvec2(direction), horizontal) / size : 0.0;
    impact.strikes = impact.strikes && impact.directness > 0.0;
    if (!impact.strikes)
    {
      continue;
    }
    impact.place = place(at);
    impact.phase = sheet.Phase[at];
    impact.height = sheet.Height[at - 1];
    impact.groupTime = this->Surface.groupTime(at - 1);
    impact.away = elasticReflection(direction, normal);
    const BreakingStretch* stretch = this->Surface.history(ray).stretchAt(sheet.Phase[at - 1]);
    // A broken wave strikes with the speed that it had as it broke.
    impact.speed = stretch
      ? 2.0 * Pi / this->Surface.options().period / this->onRay(ray, stretch->begin).still.wavenumber
      : this->speedOf(ray, sheet.Phase[at - 1], 0.0);
    this->ImpactOf[ray] = impact;
    ++this->ImpactCount;
  }
}

void Spray::findStrips()
{
  const SurfaceSheet& sheet = this->Surface.sheet();
  const auto rayPoints = static_cast<std::int64_t>(sheet.rayPointCount());
  std::vector<std::uint32_t> rayOf(sheet.rayPointCount());
  std::vector<double> shorePhase(sheet.rayCount()); // where a ray runs aground, or ends
  for (std::size_t ray = 0; ray < sheet.rayCount(); ++ray)
  {
    const auto last = static_cast<std::size_t>(sheet.Offsets[ray + 1]);
    bool afloat = true;
    for (auto i = static_cast<std::size_t>(sheet.Offsets[ray]); i < last; ++i)
    {
      rayOf[i] = static_cast<std::uint32_t>(ray);
      afloat = afloat && !sheet.Shore[i];
      shorePhase[ray] = afloat || i == static_cast<std::size_t>(sheet.Offsets[ray]) ? sheet.Phase[i] : shorePhase[ray];
    }
  }
  // Triangles of one strip follow each other; what lies between two rays may still be interrupted.
  std::vector<Strip> strips;
  std::unordered_map<std::uint64_t, std::size_t> latest;
  for (const auto& triangle : sheet.Triangles)
  {
    if (*std::max_element(triangle.begin(), triangle.end()) >= rayPoints)
    {
      continue;
    }
    double low = sheet.Phase[static_cast<std::size_t>(triangle[0])];
    double high = low;
    for (const std::int64_t i : triangle)
    {
      low = std::min(low, sheet.Phase[static_cast<std::size_t>(i)]);
      high = std::max(high, sheet.Phase[static_cast<std::size_t>(i)]);
    }
    std::array<std::uint32_t, 3> rays{ rayOf[static_cast<std::size_t>(triangle[0])],
      rayOf[static_cast<std::size_t>(triangle[1])], rayOf[static_cast<std::size_t>(triangle[2])] };
    std::sort(rays.begin(), rays.end());
    const auto count = static_cast<std::size_t>(std::unique(rays.begin(), rays.end()) - rays.begin());
    if (count != 2)
    {
      continue; // where a ray comes in: a point of the crest
    }
    const std::uint64_t key = (static_cast<std::uint64_t>(rays[0]) << 32) | rays[1];
    const auto known = latest.find(key);
    if (known != latest.end() && low <= strips[known->second].end + SlotPhase)
    {
      Strip& strip = strips[known->second];
      strip.begin = std::min(strip.begin, low);
      strip.end = std::max(strip.end, high);
      continue;
    }
    latest[key] = strips.size();
    strips.push_back({ rays[0], rays[1], low, high });
  }
  for (const Strip& strip : strips)
  {
    Strip crest = strip;
    crest.end = std::min({ strip.end, shorePhase[strip.left], shorePhase[strip.right] });
    if (this->Options.steepest == 0.0)
    {
      double from = crest.end;
      double to = crest.begin;
      for (const std::size_t ray : { strip.left, strip.right })
      {
        for (const BreakingStretch& stretch : this->Surface.history(ray).stretches())
        {
          from = std::min(from, stretch.begin);
          to = std::max(to, stretch.end);
        }
      }
      crest.begin = std::max(crest.begin, from);
      crest.end = std::min(crest.end, to);
    }
    if (crest.begin < crest.end)
    {
      this->Crests.push_back(crest);
    }
    const Impact& left = this->ImpactOf[strip.left];
    const Impact& right = this->ImpactOf[strip.right];
    if (left.strikes && right.strikes && strip.end + Pi > std::max(left.phase, right.phase))
    {
      const double phase = std::min(strip.end, std::min(left.phase, right.phase));
      const double width =
        glm::distance(this->onRay(strip.left, phase).still.position, this->onRay(strip.right, phase).still.position);
      if (glm::distance(left.place, right.place) <= WidestFace * width)
      {
        this->Impacts.push_back(strip);
      }
    }
  }
}

void Spray::boundLife()
{
  const SurfaceSheet& sheet = this->Surface.sheet();
  double rise = 0.0;
  double highest = 0.0;
  for (std::size_t ray = 0; ray < sheet.rayCount(); ++ray)
  {
    for (auto i = static_cast<std::size_t>(sheet.Offsets[ray]); i < static_cast<std::size_t>(sheet.Offsets[ray + 1]);
         ++i)
    {
      highest = std::max(highest, sheet.Height[i]);
      if (!sheet.Shore[i] && (this->Options.steepest > 0.0 || sheet.Breaking[i]))
      {
        const BreakingStretch* stretch = this->Surface.history(ray).stretchAt(sheet.Phase[i]);
        const double plunge =
          stretch && stretch->plungePhase > 0.0 ? (sheet.Phase[i] - stretch->begin) / stretch->plungePhase : 0.0;
        rise = std::max(rise, WidestScatter * this->Options.scatter * this->speedOf(ray, sheet.Phase[i], plunge));
      }
    }
    const Impact& impact = this->ImpactOf[ray];
    rise = std::max(rise,
      (this->Options.rebound * std::max(0.0, impact.away.z) + WidestScatter * this->Options.scatter) * impact.speed);
  }
  // From a wave's height above still water to its trough.
  const double g = this->Options.gravity;
  this->Life = (rise + std::sqrt(rise * rise + 2.0 * g * 2.0 * highest)) / g;
}

Spray::Source Spray::crestSource(
  std::size_t ray, std::int64_t step, std::int64_t wave, const WaveSection& section) const
{
  const double phase = static_cast<double>(step) * SlotPhase;
  RayPlace at = this->onRay(ray, phase);
  const double unbroken = this->unbrokenHeight(at, this->Surface.history(ray).stretchAt(phase), ray);
  const double held = this->Surface.heightShare(ray, phase, wave);
  at.still.height *= held;
  at.ripeness *= held;
  const StillPlace& still = at.still;
  const CrestState crest = this->Surface.crest(ray, phase, wave, section);
  const SectionPoint moved =
    section.at(crest, { 0.0, still.height, still.wavenumber, still.depth, still.slope, at.ripeness });
  const BreakingStretch* stretch = this->Surface.history(ray).stretchAt(phase);
  Source source;
  source.position = this->Surface.move(still, moved).position;
  const double level = this->Surface.options().waterLevel;
  source.floor = level - std::min(0.5 * still.height, still.depth);
  // By the paper's steepness lower waves of a group are slower; by the trace they break later.
  const double speed = this->speedOf(ray, phase, crest.plunge) *
    (this->Options.steepest > 0.0 ? this->Surface.groupShare(ray, phase, wave) : 1.0);
  source.velocity = glm::dvec3(speed * still.direction, 0.0);
  source.scatter = this->Options.scatter * speed;
  if (this->Options.steepest > 0.0 || (stretch && crest.plunge > 0.0))
  {
    const double left = unbroken > 0.0 ? std::min(1.0, still.height / unbroken) : 0.0;
    const double faster = speed - 2.0 * Pi / this->Surface.options().period / still.wavenumber;
    source.rate = this->Options.rate * left * std::max(0.0, faster);
  }
  return source;
}

Spray::Source Spray::impactSource(const Impact& impact, std::int64_t step, std::int64_t wave) const
{
  // Phase of the surface at the obstacle.
  const double passed = static_cast<double>(step) * SlotPhase;
  const double phase = impact.phase - 2.0 * Pi * static_cast<double>(wave) - passed;
  const double level = this->Surface.options().waterLevel;
  const double share = this->Surface.options().groups.share(
    static_cast<double>(step) * this->SlotTime - impact.groupTime, this->Surface.options().period);
  const double height = share * impact.height;
  const double speed = share * impact.speed;
  Source source;
  source.position = { impact.place, level + 0.5 * height * std::cos(phase) };
  source.velocity = this->Options.rebound * speed * impact.away;
  source.scatter = this->Options.scatter * speed;
  source.floor = level - 0.5 * height;
  source.rate = this->Options.rate * speed * impact.directness * impactShare(phase);
  return source;
}

void Spray::throwSlot(const Slot& slot, double time, std::vector<SprayParticle>& out) const
{
  const auto& first = slot.first;
  const auto& second = slot.second;
  const double rate = 0.25 * (first[0].rate + first[1].rate + second[0].rate + second[1].rate);
  Draws draws(slot.key);
  const double expected = rate * slot.length * this->SlotTime;
  this->requireFew(expected);
  const auto count = static_cast<std::size_t>(expected + draws.uniform());
  const double g = this->Options.gravity;
  for (std::size_t i = 0; i < count; ++i)
  {
    Draws own(scramble(slot.key + 0x9e3779b97f4a7c15u * (i + 1)));
    const double across = own.uniform();
    const double later = own.uniform();
    SprayParticle particle;
    particle.age = time - slot.begin - later * this->SlotTime;
    if (!(particle.age >= 0.0 && particle.age <= this->Life))
    {
      continue;
    }
    const auto mix = [&](const auto& value)
    {
      return (1.0 - later) * ((1.0 - across) * value(first[0]) + across * value(first[1])) +
        later * ((1.0 - across) * value(second[0]) + across * value(second[1]));
    };
    const auto [x, y] = own.gaussians();
    const double z = own.gaussians()[0];
    const glm::dvec3 start = mix([](const Source& source) { return source.velocity; }) +
      mix([](const Source& source) { return source.scatter; }) * glm::dvec3(x, y, z);
    const double age = particle.age;
    particle.position = mix([](const Source& source) { return source.position; }) + age * start;
    particle.position.z -= 0.5 * g * age * age;
    if (particle.position.z < mix([](const Source& source) { return source.floor; }))
    {
      continue;
    }
    particle.velocity = start - glm::dvec3(0.0, 0.0, g * age);
    particle.source = slot.source;
    out.push_back(particle);
  }
}

void Spray::throwCrests(
  const Strip& strip, double time, const WaveSection& section, std::vector<SprayParticle>& out) const
{
  // Step m of the crest of wave n is reached in slot m - 64 n.
  const auto latest = static_cast<std::int64_t>(std::floor(time / this->SlotTime));
  const auto earliest = static_cast<std::int64_t>(std::floor((time - this->Life) / this->SlotTime));
  const auto firstStep = static_cast<std::int64_t>(std::floor(strip.begin / SlotPhase));
  const auto lastStep = static_cast<std::int64_t>(std::ceil(strip.end / SlotPhase));
  const auto slots = static_cast<double>(Slots);
  const auto waveOf = [&](std::int64_t numerator, bool up)
  {
    const double share = static_cast<double>(numerator) / slots;
    return static_cast<std::int64_t>(up ? std::ceil(share) : std::floor(share));
  };
  const std::array<std::size_t, 2> rays{ strip.left, strip.right };
  for (std::int64_t wave = waveOf(firstStep - latest, true); wave <= waveOf(lastStep - earliest, false); ++wave)
  {
    const std::int64_t shift = static_cast<std::int64_t>(Slots) * wave;
    std::array<Source, 2> before{};
    std::int64_t known = -1;
    bool any = false;
    for (std::int64_t step = std::max(firstStep, earliest + shift); step < std::min(lastStep, latest + shift + 1);
         ++step)
    {
      Slot slot;
      for (std::size_t side = 0; side < 2; ++side)
      {
        slot.first[side] = any && known == step ? before[side] : this->crestSource(rays[side], step, wave, section);
        slot.second[side] = this->crestSource(rays[side], step + 1, wave, section);
      }
      before = slot.second;
      known = step + 1;
      any = true;
      slot.length = 0.5 *
        (glm::distance(glm::dvec2(slot.first[0].position), glm::dvec2(slot.first[1].position)) +
          glm::distance(glm::dvec2(slot.second[0].position), glm::dvec2(slot.second[1].position)));
      slot.begin = static_cast<double>(step - shift) * this->SlotTime;
      slot.key = scramble(this->Options.seed ^
        scramble(strip.left ^
          scramble(
            strip.right ^ scramble(static_cast<std::uint64_t>(step) ^ scramble(static_cast<std::uint64_t>(wave))))));
      slot.source = SpraySource::Crest;
      this->throwSlot(slot, time, out);
    }
  }
}

void Spray::throwImpacts(const Strip& strip, double time, std::vector<SprayParticle>& out) const
{
  const std::array<const Impact*, 2> impacts{ &this->ImpactOf[strip.left], &this->ImpactOf[strip.right] };
  const auto latest = static_cast<std::int64_t>(std::floor(time / this->SlotTime));
  const auto earliest = static_cast<std::int64_t>(std::floor((time - this->Life) / this->SlotTime));
  const double middle = 0.5 * (impacts[0]->phase + impacts[1]->phase);
  Slot slot;
  slot.source = SpraySource::Obstacle;
  slot.length = glm::distance(impacts[0]->place, impacts[1]->place);
  for (std::int64_t step = earliest; step <= latest; ++step)
  {
    const auto wave =
      static_cast<std::int64_t>(std::round((middle - (static_cast<double>(step) + 0.5) * SlotPhase) / (2.0 * Pi)));
    for (std::size_t side = 0; side < 2; ++side)
    {
      slot.first[side] = this->impactSource(*impacts[side], step, wave);
      slot.second[side] = this->impactSource(*impacts[side], step + 1, wave);
    }
    slot.begin = static_cast<double>(step) * this->SlotTime;
    slot.key = scramble(
      ~this->Options.seed ^ scramble(strip.left ^ scramble(strip.right ^ scramble(static_cast<std::uint64_t>(step)))));
    this->throwSlot(slot, time, out);
  }
}

void Spray::requireFew(double particles) const
{
  if (!(particles <= static_cast<double>(this->Options.maxParticles)))
  {
    std::ostringstream message;
    message << "there would be more than " << this->Options.maxParticles
            << " particles of spray; take a lower rate of spray, or crop the scene";
    throw std::runtime_error(message.str());
  }
}

std::vector<SprayParticle> Spray::at(double time, const WaveSection& section, const Execution& execution) const
{
  const std::size_t strips = this->Crests.size() + this->Impacts.size();
  const std::size_t blocks = (strips + StripsAtOnce - 1) / StripsAtOnce;
  std::vector<std::vector<SprayParticle>> thrown(blocks);
  execution.forRange(blocks,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t block = begin; block < end; ++block)
      {
        for (std::size_t i = block * StripsAtOnce; i < std::min(strips, (block + 1) * StripsAtOnce); ++i)
        {
          if (i < this->Crests.size())
          {
            this->throwCrests(this->Crests[i], time, section, thrown[block]);
          }
          else
          {
            this->throwImpacts(this->Impacts[i - this->Crests.size()], time, thrown[block]);
          }
          this->requireFew(static_cast<double>(thrown[block].size()));
        }
      }
    });
  std::size_t count = 0;
  for (const auto& block : thrown)
  {
    count += block.size();
  }
  this->requireFew(static_cast<double>(count));
  std::vector<SprayParticle> particles;
  particles.reserve(count);
  for (const auto& block : thrown)
  {
    particles.insert(particles.end(), block.begin(), block.end());
  }
  return particles;
}

}
