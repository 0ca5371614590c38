#pragma once

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace swellray::scene
{

/**
 * Which share of the sun is seen over a seafloor and the waves on it: heights on a grid, along which a line to the sun is
 * followed. Where the line clears everything by more than half the breadth of the sun it is 1, and 0 where it is below the
 * height of something by as much; in between it goes evenly.
 */
class SunShade
{
public:
  /**
   * @param seafloor point array Elevation, m
   * @param sun unit vector to it: east, north, up > 0
   */
  SunShade(vtkImageData* seafloor, const std::array<double, 3>& sun);

  /**
   * Let waves throw shadows too, in place of those before.
   * @param surface triangles
   */
  void setWaves(vtkPolyData* surface);

  /** Share of the sun that is seen from a place, 0 to 1; 1 outside of the seafloor. */
  double seenFrom(double x, double y, double z) const;

  /** The share at each point of the data, as the point array SunSeen. */
  void addTo(vtkPolyData* data) const;

  /** Side of a cell of the grid, m: shadows of what is smaller are lost. */
  double cell() const { return this->Cell; }

private:
  double heightAt(double x, double y) const;

  double Low[2] = { 0.0, 0.0 }; // of the grid, m
  double Cell = 1.0;
  vtkIdType Size[2] = { 0, 0 };
  bool Overhead = false;            // the sun
  double Towards[2] = { 0.0, 0.0 }; // unit vector, level, to the sun
  double Rise = 1.0;                // of a line to the sun
  double HalfBreadth = 0.0;         // of the sun, as a difference of rise
  double GroundTop = 0.0;           // m
  double Top = 0.0;                 // m
  std::vector<float> Ground;        // m, a row after the other
  std::vector<float> Heights;       // m, with the waves
};

}
