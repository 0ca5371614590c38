#include "Commands.h"
#include "Failure.h"
#include "FieldValues.h"
#include "FilterRun.h"
#include "FrameSeries.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "OutputFile.h"
#include "Pipeline.h"
#include "SeaImages.h"
#include "SeaOptions.h"
#include "TimeSeriesOption.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSwellSea.h>
#include <vtkSwellSeaFunction.h>

#include <memory>

namespace swellray::cli
{

namespace
{

constexpr const char* Group = "Sea surface";

// Heights beyond are cut off in an image of whole numbers, standard deviations.
constexpr double ImageRange = 5.0;

void setUp(vtkSwellSea* sea, const Request& request)
{
  const SpectrumRequest& state = request.spectrum;
  const SeaRequest& patch = request.sea;
  sea->SetShape(static_cast<int>(state.shape));
  sea->SetSignificantHeight(state.height.value_or(sea->GetSignificantHeight()));
  sea->SetPeakPeriod(state.peakPeriod.value_or(sea->GetPeakPeriod()));
  sea->SetDirectionFrom(state.directionFrom.value_or(sea->GetDirectionFrom()));
  sea->SetPeakedness(state.peakedness);
  sea->SetWind(state.wind.value_or(0.0));
  sea->SetFetch(state.fetch.value_or(0.0));
  sea->SetSpread(patch.spread.value_or(sea->GetSpread()));
  sea->SetSpreading(
    static_cast<int>(patch.spreading.value_or(patch.spread ? SeaSpreading::CosinePower : SeaSpreading::Hasselmann)));
  sea->SetDepth(request.rays.wave.offshoreDepth);
  sea->SetGravity(request.rays.wave.gravity);
  sea->SetComponents(patch.components);
  sea->SetSharpness(patch.sharpness);
  sea->SetTurbulence(patch.turbulence);
  sea->SetTile(patch.tile);
  sea->SetSize(patch.size);
  sea->SetSpacing(patch.spacing.value_or(0.0));
  sea->SetSeed(patch.seed);
  sea->SetTime(patch.time.value_or(0.0));
  sea->SetImagePixels(patch.heightImage.empty() && patch.normalImage.empty() ? 0 : patch.pixels);
  if (request.output.file.empty() && !patch.spacing)
  {
    sea->SetSpacing(patch.size); // no mesh is wanted
  }
}

void saySea(vtkPolyData* mesh, const Console& console)
{
  const auto value = [&](const char* name) { return fieldNumber(mesh, name).value_or(0.0); };
  console.say(fmt::format("sea      Hs {:.3g} m, Tp {:.3g} s; trochoids up to {:.3g} Hz",
                value("SignificantWaveHeight"), value("PeakPeriod"), value("HighestFrequency")) +
    (value("TurbulenceAmplitude") > 0.0 ? fmt::format(", then turbulence of {:.3g} m times {:.3g} an octave",
                                            value("TurbulenceAmplitude"), value("TurbulenceMultiplier"))
                                        : ""));
}

void checkSea(Request& request)
{
  checkSeaState(request.spectrum);
  const SeaRequest& sea = request.sea;
  const bool byHeight = request.spectrum.height.has_value();
  if (byHeight == request.spectrum.wind.has_value())
  {
    throw UsageError("a sea is given in one of two ways: --hs and --tp, or --wind");
  }
  if (!request.spectrum.directionFrom)
  {
    throw UsageError("sea needs --direction DEG");
  }
  if (request.output.file.empty() && sea.heightImage.empty() && sea.normalImage.empty() && sea.picture.empty())
  {
    throw UsageError("sea has nothing to write: give -o FILE.vtp, -o FILE.pvd with --times, --height-map FILE, "
                     "--normal-map FILE or --picture FILE");
  }
  if (sea.time && sea.times)
  {
    throw UsageError("--time and --times exclude each other; leave out one of the two");
  }
  const bool series = isSeries(request.output.file);
  if ((!request.output.file.empty() || sea.times) && series != sea.times.has_value())
  {
    throw UsageError(series ? "a .pvd series needs --times T0:T1:DT" : "--times needs a series to write: -o FILE.pvd");
  }
  if (sea.times && !(sea.heightImage.empty() && sea.normalImage.empty() && sea.picture.empty()))
  {
    throw UsageError("--times makes a series of meshes; images and pictures are of one --time");
  }
  if (sea.spread && sea.spreading && *sea.spreading != SeaSpreading::CosinePower &&
    *sea.spreading != SeaSpreading::WrappedNormal)
  {
    throw UsageError("--spread is that of --spreading cosine or normal; leave out one of the two");
  }
  if (request.spectrum.shape == SpectrumShape::Tma && !std::isfinite(request.rays.wave.offshoreDepth))
  {
    throw UsageError("--shape tma needs --depth M");
  }
  if (sea.spacing && *sea.spacing > sea.size)
  {
    throw UsageError("--spacing must be at most --size");
  }
  checkDifferentFiles({ { "--output", request.output.file }, { "--height-map", sea.heightImage },
    { "--normal-map", sea.normalImage }, { "--picture", sea.picture } });
}

void runSea(const Request& request, Console& console)
{
  const SeaRequest& patch = request.sea;
  std::vector<std::unique_ptr<OutputFile>> files;
  const auto open = [&](const std::string& path) -> OutputFile*
  {
    return path.empty() ? nullptr
                        : files.emplace_back(std::make_unique<OutputFile>(path, std::vector<std::string>())).get();
  };
  OutputFile* const mesh = open(request.output.file);
  const OutputFile* const heights = open(patch.heightImage);
  const OutputFile* const normals = open(patch.normalImage);
  const OutputFile* const picture = open(patch.picture);
  vtkNew<vtkSwellSea> sea;
  setUp(sea, request);
  if (patch.times)
  {
    const auto make = [&](std::size_t, double time)
    {
      sea->SetTime(time);
      runFilter(sea, "sea", console);
      return sea->GetOutput();
    };
    std::vector<FrameSeries> series{ { mesh, make } };
    writeFrames(series, *patch.times, request, console, 1,
      [&](vtkDataSet* made) { saySea(vtkPolyData::SafeDownCast(made), console); });
  }
  else
  {
    runFilter(sea, "sea", console);
    saySea(sea->GetOutput(), console);
    vtkImageData* image = vtkImageData::SafeDownCast(sea->GetOutputDataObject(1));
    if (mesh)
    {
      writeFrame(sea->GetOutput(), *mesh, request, console);
    }
    if (heights)
    {
      const double range = 0.25 * ImageRange * fieldNumber(sea->GetOutput(), "SignificantWaveHeight").value_or(1.0);
      writeHeightImage(image, range, request, *heights);
      console.say(fmt::format("heights  {:.6g} to {:.6g} m from black to white", -range, range));
    }
    if (normals)
    {
      writeNormalImage(image, request, *normals);
    }
    if (picture)
    {
      writeSeaPicture(sea->GetFunction(), request, *picture, console);
    }
  }
  std::string written;
  for (const auto& file : files)
  {
    file->commit();
    written += (written.empty() ? "" : " and ") + file->path();
  }
  console.say("wrote    " + written);
}

OptionSpec wholeOption(const char* name, const char* help, const char* standard, int& target, int least, int most)
{
  OptionSpec spec{ name, "N", help, standard, Group, false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, longName, least, most](const std::string& typed)
  { target = static_cast<int>(parseWhole(longName, typed, least, most)); };
  return spec;
}

}

CommandSpec seaSpec(Request& request)
{
  CommandSpec spec{ "sea", "the surface of a sea away from the shore: mesh, textures, picture, in motion", false, {},
    {} };
  SeaRequest& sea = request.sea;
  OptionSpec pictureSize{ "--picture-size", "WxH", "pixels of the picture", "800x450", Group, false, {} };
  pictureSize.set = [&sea](const std::string& typed) { sea.pictureSize = parseSize("--picture-size", typed); };
  const auto image = [](const char* name, const char* help, std::string& target) {
    return outputFile(name, help, target, { ".png", ".tif" });
  };
  spec.options = { outputFile("-o,--output", "surface, .vtp, or series, .pvd", request.output.file, { ".vtp", ".pvd" }),
    image("--height-map", "heights as an image, .png (16 bits) or .tif (metres)", sea.heightImage),
    image("--normal-map", "normals as an image (bump map), .png or .tif", sea.normalImage),
    outputFile("--picture", "the sea as seen from above it, .png", sea.picture, { ".png" }),
    flag("--compress", "compress the files (smaller, slower)", "Output", request.output.compress) };
  add(spec.options, seaStateOptions(request.spectrum, "Sea"));
  const char* state = "Sea";
  add(spec.options,
    { spreadOption(sea.spread, state),
      choice("--spreading", "of the directions: by frequency (hasselmann, or thon as printed in 2000), or by --spread",
        "hasselmann; with --spread cosine", state, sea.spreading,
        std::vector<std::pair<std::string, SeaSpreading>>{ { "hasselmann", SeaSpreading::Hasselmann },
          { "thon", SeaSpreading::Thon }, { "cosine", SeaSpreading::CosinePower },
          { "normal", SeaSpreading::WrappedNormal } }) });
  add(spec.options, uniformDepthOptions(request.rays.wave, state));
  add(spec.options,
    { number("--size", "M", "side of the patch, m", "200", Group, sea.size, PositiveMetres),
      number("--spacing", "M", "distance of the points of the mesh, m", "a 256th of the side", Group, sea.spacing,
        PositiveMetres),
      wholeOption("--pixels", "pixels a side of the images", "512", sea.pixels, 2, 8192),
      flag("--tile", "the surface repeats over the patch, so that images and meshes can be laid side by side", Group,
        sea.tile),
      number("--time", "S", "time, s", "0", Group, sea.time, { "seconds" }), timesOption(sea.times, Group),
      wholeOption("--components", "waves of greatest amplitude, drawn one by one", "256", sea.components, 1, 4096),
      number("--sharpness", "S", "factor on the steepness that sharpens their crests", "1", Group, sea.sharpness,
        NonNegativeNumber),
      choice("--turbulence", "the shorter waves as turbulence", "on", Group, sea.turbulence,
        std::vector<std::pair<std::string, bool>>{ { "on", true }, { "off", false } }),
      wholeOption("--seed", "what is random is drawn from this", "1", sea.seed, 0, 2'000'000'000),
      number("--eye", "M", "height of the eye of the picture above the mean level, m", "8", Group, sea.eyeHeight,
        PositiveMetres),
      number("--look", "DEG", "where the picture looks, degrees clockwise from north", "where the sea comes from",
        Group, sea.lookDirection, Degrees),
      pictureSize });
  spec.examples = "  swellray sea --hs 3 --tp 9 --direction 240 -o sea.vtp\n"
                  "  swellray sea --wind 12 --direction 240 --times 0:20:0.1 -o sea.pvd\n"
                  "  swellray sea --hs 1 --tp 5 --direction 240 --tile --size 200 --pixels 1024 --height-map h.tif "
                  "--normal-map n.png\n"
                  "  swellray sea --wind 15 --direction 240 --picture sea.png --picture-size 1280x720\n"
                  "A series that was broken off goes on where it was when the same call is made again.\n";
  spec.check = checkSea;
  spec.run = runSea;
  return spec;
}

}
