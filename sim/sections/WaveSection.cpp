#include "sim/sections/WaveSection.h"

#include "sim/forms/FormValues.h"
#include "sim/forms/NearestWord.h"
#include "sim/sections/GonzatoLeSaecSection.h"
#include "sim/sections/JeschkeSection.h"
#include "sim/sections/LinearSections.h"
#include "sim/sections/OrbitSections.h"
#include "sim/sections/PeacheySection.h"
#include "sim/sections/VortexSection.h"

#include <stdexcept>

namespace swellray
{

namespace
{

// What these factors may be: wider than any use, finite in every formula.
constexpr double Largest = 100.0;
constexpr double Smallest = 1e-6;

FormKey key(std::string name, std::string unit, std::string description, double value, double low, double high)
{
  return { std::move(name), "", std::move(unit), std::move(description), value, low, high, {}, "" };
}

FormDescription section(
  std::string name, std::string summary, std::string formula, std::string source, std::vector<FormKey> keys)
{
  return { std::move(name), std::move(summary), std::move(formula), std::move(source), std::move(keys), 0.0, 10.0 };
}

std::vector<FormKey> orbitKeys()
{
  const OrbitFactors factors;
  return { key("k0", "1/m", "influence of the depth on the tilt of the orbits", factors.tilt, 0.0, Largest),
    key("kx", "1/m", "enlargement of the major axis in shallow water", factors.major, Smallest, Largest),
    key("kz", "1/m", "reduction of the minor axis in shallow water", factors.minor, Smallest, Largest) };
}

FormKey variationKey()
{
  return key(
    "variation", "wavelengths", "largest delay of the breaking of single waves, different for each", 0.2, 0.0, 1.0);
}

std::vector<FormDescription> describeSections()
{
  std::vector<FormKey> gonzatoKeys = orbitKeys();
  const GonzatoLeSaecSection::Parameters gonzato;
  gonzatoKeys.push_back(
    key("stretch", "H", "stretch of crests along the orbits, St_max", gonzato.stretch, 0.0, Largest));
  gonzatoKeys.push_back(key("ks", "1/H", "influence of the depth on the stretch", gonzato.stretchDepth, 0.0, Largest));
  gonzatoKeys.push_back(
    key("kd", "1/H", "influence of the depth on the fall of crests", gonzato.displacementDepth, 0.0, Largest));
  const PeacheySection::Parameters peachey;
  const VortexSection::Parameters vortex;
  return {
    section("airy", "sine", "up = H/2 cos Phi", "Airy 1845", {}),
    section("gerstner", "trochoid within the disc K R <= 1", "along = -R sin Phi, up = K R^2/2 + R cos Phi",
      "Gerstner 1804", {}),
    section("biesel", "ellipses that tilt with the bed", "R coth(kh) along, R across, sin alpha = sin beta/cosh(kh)",
      "Biesel 1952", {}),
    section("fournier-reeves", "Biesel's ellipses made easy; loops in shallow water",
      "Sx = 1/(1 - exp(-kx h)), Sz = Sx (1 - exp(-kz h)), sin alpha = sin beta exp(-k0 h)", "Fournier and Reeves 1986",
      orbitKeys()),
    section("gonzato-lesaec", "ellipses within the disc; crests stretched and falling forward",
      "R Sx <= 1/K; Stretch exp(-ks h/H) and Displacement exp(-kd h/H)", "Gonzato and Le Saec 1997",
      std::move(gonzatoKeys)),
    section("peachey", "sine to sharp crests by steepness, steep fronts in shallow water",
      "up = H/2 w(u), u to a power where depth is small", "Peachey 1986",
      { key("steepest", "-", "H/L from which on crests are sharp", peachey.steepest, 1e-3, 1.0),
        key("asymmetry", "-", "how much more than 1 the power is in shallow water", peachey.asymmetry, 0.0, 2.0) }),
    section("jeschke", "hump that grows round, breaks into a tube and collapses",
      "cosine, exponential function, rotation and scaling (table 1)", "Jeschke, Birkholz and Schumann 2003",
      { variationKey() }),
    section("vortex", "trochoid that curls around a vortex ahead of its crest",
      "vortex 1.73 to 4.43 times as long as wide, by the slope of the bed", "Lake, Reagin and Van Drasek 2005",
      { key("threshold", "-", "H/L beyond which a wave curls in any depth", vortex.threshold, 1e-3, 10.0),
        key("steepness", "-", "steepness of a breaking wave's trochoid", vortex.steepness, 0.0, 0.99),
        variationKey() }),
  };
}

OrbitFactors orbitFactors(const FormValues& values)
{
  return { values["k0"], values["kx"], values["kz"] };
}

std::unique_ptr<WaveSection> makeNamed(const FormDescription& description, const std::string& keys)
{
  if (description.keys.empty() && !keys.empty())
  {
    throw std::invalid_argument("wave section '" + description.name + "' takes no keys, not '" + keys + "'");
  }
  const FormValues values(description, keys, "wave section");
  const std::string& name = description.name;
  if (name == "airy")
  {
    return std::make_unique<AirySection>();
  }
  if (name == "gerstner")
  {
    return std::make_unique<GerstnerSection>();
  }
  if (name == "biesel")
  {
    return std::make_unique<BieselSection>();
  }
  if (name == "fournier-reeves")
  {
    return std::make_unique<FournierReevesSection>(orbitFactors(values));
  }
  if (name == "gonzato-lesaec")
  {
    return std::make_unique<GonzatoLeSaecSection>(
      GonzatoLeSaecSection::Parameters{ orbitFactors(values), values["stretch"], values["ks"], values["kd"] });
  }
  if (name == "peachey")
  {
    return std::make_unique<PeacheySection>(PeacheySection::Parameters{ values["steepest"], values["asymmetry"] });
  }
  if (name == "jeschke")
  {
    return std::make_unique<JeschkeSection>(values["variation"]);
  }
  return std::make_unique<VortexSection>(
    VortexSection::Parameters{ values["threshold"], values["steepness"], values["variation"] });
}

}

SectionPoint WaveSection::at(const CrestState& crest, const SectionPlace& place) const
{
  SectionPoint point;
  this->displace(crest,
    { 1, &place.phase, &place.height, &place.wavenumber, &place.depth, &place.slope, &place.ripeness },
    { &point.along, &point.up, &point.alongRate, &point.upRate });
  return point;
}

const std::vector<FormDescription>& waveSections()
{
  static const std::vector<FormDescription> sections = describeSections();
  return sections;
}

std::unique_ptr<WaveSection> makeWaveSection(const std::string& spec)
{
  const auto colon = spec.find(':');
  const std::string name = spec.substr(0, colon);
  std::vector<std::string> names;
  for (const FormDescription& description : waveSections())
  {
    if (description.name == name)
    {
      return makeNamed(description, colon == std::string::npos ? std::string() : spec.substr(colon + 1));
    }
    names.push_back(description.name);
  }
  throw std::invalid_argument("unknown wave section '" + name + "'; did you mean '" + nearestWord(name, names) + "'?");
}

}
