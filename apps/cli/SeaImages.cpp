#include "SeaImages.h"

#include "Console.h"
#include "OutputFile.h"
#include "Request.h"

#include "sim/Angles.h"
#include "sim/SeaSurface.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkSwellSeaFunction.h>
#include <vtkTIFFWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace swellray::cli
{

namespace
{

void write(vtkImageData* image, const OutputFile& file, const std::string& about, const Request& request)
{
  vtkSmartPointer<vtkImageWriter> writer;
  if (std::filesystem::path(file.path()).extension() == ".png")
  {
    auto png = vtkSmartPointer<vtkPNGWriter>::New();
    png->AddText("Software", "Swellray " SWELLRAY_VERSION);
    png->AddText("Description", about.c_str());
    png->AddText("CommandLine", request.commandLine.c_str());
    writer = png;
  }
  else
  {
    writer = vtkSmartPointer<vtkTIFFWriter>::New();
  }
  writer->SetInputData(image);
  writer->SetFileName(file.temporary().c_str());
  writer->Write();
  std::error_code none;
  if (writer->GetErrorCode() != vtkErrorCode::NoError || std::filesystem::file_size(file.temporary(), none) == 0)
  {
    file.fail("the disk is full, or files may not get so large");
  }
}

vtkNew<vtkImageData> likeImage(vtkImageData* image, vtkDataArray* values)
{
  vtkNew<vtkImageData> made;
  made->SetDimensions(image->GetDimensions());
  made->GetPointData()->SetScalars(values);
  return made;
}

unsigned char byteOf(double share)
{
  return static_cast<unsigned char>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

// Radius of the sun, and of its edge in a picture, rad.
constexpr double SunRadius = 0.0047;
constexpr double SunEdge = 0.0015;

// Light of the sun itself, and a gleam around it.
double sunLight(const glm::dvec3& direction, const glm::dvec3& sun)
{
  const double away = std::acos(std::clamp(glm::dot(direction, sun), -1.0, 1.0));
  return 60.0 * std::clamp((SunRadius + SunEdge - away) / SunEdge, 0.0, 1.0) + 0.8 * std::exp(-away / 0.02);
}

// Light of the sky, linear, from a direction above the horizon.
glm::dvec3 skyLight(const glm::dvec3& direction, const glm::dvec3& sun)
{
  const glm::dvec3 zenith(0.10, 0.24, 0.55);
  const glm::dvec3 horizon(0.62, 0.72, 0.80);
  const double up = std::max(direction.z, 0.0);
  const double towards = std::max(glm::dot(direction, sun), 0.0);
  return horizon + (zenith - horizon) * std::pow(up, 0.45) + glm::dvec3(0.35, 0.28, 0.18) * std::pow(towards, 12.0);
}

}

void writeHeightImage(vtkImageData* image, double range, const Request& request, const OutputFile& file)
{
  auto* heights = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("SurfaceHeight"));
  if (std::filesystem::path(file.path()).extension() != ".png")
  {
    write(likeImage(image, heights), file, "", request);
    return;
  }
  vtkNew<vtkUnsignedShortArray> levels;
  levels->SetNumberOfValues(heights->GetNumberOfTuples());
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    const double share = 0.5 + 0.5 * static_cast<double>(heights->GetValue(i)) / range;
    levels->SetValue(i, static_cast<unsigned short>(std::lround(65535.0 * std::clamp(share, 0.0, 1.0))));
  }
  write(likeImage(image, levels), file, fmt::format("heights from {:g} to {:g} m", -range, range), request);
}

void writeNormalImage(vtkImageData* image, const Request& request, const OutputFile& file)
{
  auto* normals = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("Normals"));
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(normals->GetNumberOfTuples());
  for (vtkIdType i = 0; i < normals->GetNumberOfValues(); ++i)
  {
    colours->SetValue(i, byteOf(0.5 + 0.5 * static_cast<double>(normals->GetValue(i))));
  }
  write(likeImage(image, colours), file, "normals: x, y and z from -1 to 1", request);
}

void writeSeaPicture(vtkSwellSeaFunction* sea, const Request& request, const OutputFile& file, Console& console)
{
  const int width = request.sea.pictureSize[0];
  const int height = request.sea.pictureSize[1];
  constexpr double FieldOfView = radians(60.0);
  constexpr double Farthest = 30000.0; // m; about the horizon of a ship
  constexpr double Haze = 12000.0;     // m over which light falls to a third
  const double pixel = 2.0 * std::tan(0.5 * FieldOfView) / width;
  // Against the waves unless told: they come towards the eye.
  const double look =
    radians(90.0 - request.sea.lookDirection.value_or(request.spectrum.directionFrom.value_or(270.0)));
  const glm::dvec3 ahead(std::cos(look), std::sin(look), 0.0);
  const glm::dvec3 right(std::sin(look), -std::cos(look), 0.0);
  const glm::dvec3 sun = glm::normalize(ahead + 0.45 * right + glm::dvec3(0.0, 0.0, 0.35));
  const glm::dvec3 eye(0.0, 0.0, request.sea.eyeHeight);
  const glm::dvec3 water(0.010, 0.055, 0.070);
  constexpr double Tilt = -0.12; // the horizon above the middle

  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(width) * height);
  constexpr int Bands = 20;
  for (int band = 0; band < Bands; ++band)
  {
    vtkSMPTools::For(height * band / Bands, height * (band + 1) / Bands, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          for (int column = 0; column < width; ++column)
          {
            const double u = (column + 0.5 - 0.5 * width) * pixel;
            const double v = (static_cast<double>(row) + 0.5 - 0.5 * height) * pixel + Tilt;
            const glm::dvec3 ray = glm::normalize(ahead + u * right + glm::dvec3(0.0, 0.0, v));
            const glm::dvec3 horizon = skyLight(glm::normalize(glm::dvec3(ray.x, ray.y, 0.01)), sun);
            const glm::dvec3 sunColour(1.0, 0.89, 0.67);
            glm::dvec3 light = ray.z > 0.0 ? skyLight(ray, sun) + sunLight(ray, sun) * sunColour : horizon;
            const double distance = sea->March(&eye.x, &ray.x, Farthest, pixel);
            if (distance >= 0.0)
            {
              const glm::dvec3 place = eye + distance * ray;
              const glm::dvec3 normal =
                sea->GetSurface()->normal({ place.x, place.y }, sea->GetTime(), distance * pixel);
              const double facing = std::clamp(-glm::dot(normal, ray), 0.0, 1.0);
              // Schlick's approximation, for water.
              const double mirrored = 0.02 + 0.98 * std::pow(1.0 - facing, 5.0);
              glm::dvec3 reflected = ray - 2.0 * glm::dot(normal, ray) * normal;
              reflected.z = std::abs(reflected.z);
              // Small waves spread the sun that they mirror.
              const double glitter = 9.0 * std::pow(std::max(glm::dot(reflected, sun), 0.0), 900.0);
              const glm::dvec3 seen = mirrored * (skyLight(reflected, sun) + glitter * sunColour) +
                (1.0 - mirrored) * water * (1.0 + 1.5 * std::max(0.0, 0.5 + 0.3 * place.z));
              const double clear = std::exp(-distance / Haze);
              light = clear * seen + (1.0 - clear) * horizon;
            }
            for (int c = 0; c < 3; ++c)
            {
              // Highlights are held back smoothly; then the gamma of screens.
              const double shown = light[c] / (1.0 + 0.35 * light[c]);
              colours->SetTypedComponent(row * width + column, c, byteOf(std::pow(shown * 1.15, 1.0 / 2.2)));
            }
          }
        }
      });
    console.progress("picture", (band + 1.0) / Bands);
  }
  console.endProgress();
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(colours);
  write(image, file, "a sea by ray marching", request);
}

}
