// CGAL takes seconds to compile: nothing else of soundings includes it.
#include "bathymetry/NaturalNeighbours.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/natural_neighbor_coordinates_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

namespace swellray
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Structure>;
using Weights = std::vector<std::pair<Delaunay::Vertex_handle, double>>;

// Next to an edge of the convex hull the area taken from its ends grows without bound and its digits are lost.
constexpr double RimOfEdge = 1e-7;

struct KeepVertex
{
  using result_type = std::pair<Delaunay::Vertex_handle, double>;
  result_type operator()(const result_type& weighted) const { return weighted; }
};

double distance(const Point& a, const Point& b)
{
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

double mean(const Weights& weights, double sum, const std::vector<double>& values)
{
  double value = 0.0;
  for (const auto& [vertex, weight] : weights)
  {
    value += weight * values[vertex->info()];
  }
  return value / sum;
}

// Share of the way from a to b at which a point on the edge between them lies; NaN where it lies off the edge.
double onEdge(const Point& p, const Point& a, const Point& b)
{
  const double length = distance(a, b);
  const double along = ((p.x() - a.x()) * (b.x() - a.x()) + (p.y() - a.y()) * (b.y() - a.y())) / (length * length);
  const double across = ((p.x() - a.x()) * (b.y() - a.y()) - (p.y() - a.y()) * (b.x() - a.x())) / (length * length);
  const bool lies = std::abs(across) <= RimOfEdge && along >= -RimOfEdge && along <= 1.0 + RimOfEdge;
  return lies ? std::clamp(along, 0.0, 1.0) : std::numeric_limits<double>::quiet_NaN();
}

}

struct NaturalNeighbours::Impl
{
  Delaunay triangulation;
  std::vector<Delaunay::Vertex_handle> vertices; // one a place; none where it was removed

  bool onHull(Delaunay::Vertex_handle vertex) const
  {
    const auto first = this->triangulation.incident_vertices(vertex);
    auto next = first;
    do
    {
      if (this->triangulation.is_infinite(next))
      {
        return true;
      }
    } while (++next != first);
    return false;
  }
};

struct NaturalNeighbours::Walk::Impl
{
  const Delaunay& triangulation;
  Delaunay::Face_handle face;
  Weights weights;

  // The edge of the hull that p lies on, of the face found for it.
  bool rim(const Point& p, Delaunay::Face_handle found, const std::vector<double>& values, Estimate& estimate) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const auto a = found->vertex(Delaunay::ccw(i));
      const auto b = found->vertex(Delaunay::cw(i));
      if (this->triangulation.is_infinite(a) || this->triangulation.is_infinite(b) ||
        !(this->triangulation.is_infinite(found) || this->triangulation.is_infinite(found->neighbor(i))))
      {
        continue;
      }
      const double share = onEdge(p, a->point(), b->point());
      if (!std::isnan(share))
      {
        estimate.value = (1.0 - share) * values[a->info()] + share * values[b->info()];
        estimate.distance = std::min(distance(p, a->point()), distance(p, b->point()));
        return true;
      }
    }
    return false;
  }
};

NaturalNeighbours::NaturalNeighbours(const std::vector<glm::dvec2>& places)
  : Data(std::make_unique<Impl>())
{
  if (places.size() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw std::runtime_error(
      "it has " + std::to_string(places.size()) + " soundings, more than can be gridded at once");
  }
  std::vector<std::pair<Point, std::uint32_t>> points;
  points.reserve(places.size());
  for (const glm::dvec2& place : places)
  {
    points.emplace_back(Point(place.x, place.y), static_cast<std::uint32_t>(points.size()));
  }
  Delaunay& triangulation = this->Data->triangulation;
  triangulation.insert(points.begin(), points.end());
  if (triangulation.dimension() < 2)
  {
    throw std::runtime_error(places.size() < 3
        ? "it has soundings at " + std::to_string(places.size()) + " places; a seafloor needs at least 3"
        : "its " + std::to_string(places.size()) + " soundings lie on one line: no seafloor can be made of them");
  }
  this->Data->vertices.resize(places.size());
  for (auto vertex = triangulation.finite_vertices_begin(); vertex != triangulation.finite_vertices_end(); ++vertex)
  {
    this->Data->vertices[vertex->info()] = vertex;
  }
}

NaturalNeighbours::~NaturalNeighbours() = default;

NaturalNeighbours::Walk::Walk(const NaturalNeighbours& places)
  : Data(new Impl{ places.Data->triangulation, Delaunay::Face_handle(), {} })
{
}

NaturalNeighbours::Walk::~Walk() = default;

NaturalNeighbours::Estimate NaturalNeighbours::Walk::at(const glm::dvec2& point, const std::vector<double>& values)
{
  const Delaunay& triangulation = this->Data->triangulation;
  const Point p(point.x, point.y);
  Estimate estimate;
  Delaunay::Locate_type where = Delaunay::OUTSIDE_AFFINE_HULL;
  int index = 0;
  this->Data->face = triangulation.locate(p, where, index, this->Data->face);
  const Delaunay::Face_handle face = this->Data->face;
  if (where == Delaunay::VERTEX)
  {
    estimate.value = values[face->vertex(index)->info()];
    return estimate;
  }
  if (this->Data->rim(p, face, values, estimate))
  {
    return estimate;
  }
  if (triangulation.is_infinite(face))
  {
    estimate.value = std::numeric_limits<double>::quiet_NaN();
    return estimate;
  }
  Weights& weights = this->Data->weights;
  weights.clear();
  const auto found =
    CGAL::natural_neighbor_coordinates_2(triangulation, p, std::back_inserter(weights), KeepVertex(), face);
  estimate.value = mean(weights, found.second, values);
  estimate.distance = std::numeric_limits<double>::infinity();
  for (const auto& [vertex, weight] : weights)
  {
    estimate.distance = std::min(estimate.distance, distance(p, vertex->point()));
  }
  return estimate;
}

NaturalNeighbours::Estimate NaturalNeighbours::leftOut(std::size_t place, const std::vector<double>& values) const
{
  const Delaunay::Vertex_handle left = this->Data->vertices[place];
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (left == Delaunay::Vertex_handle() || this->Data->onHull(left))
  {
    return { none, none };
  }
  Weights weights;
  const auto found =
    CGAL::natural_neighbor_coordinates_2(this->Data->triangulation, left, std::back_inserter(weights), KeepVertex());
  if (!found.third)
  {
    return { none, none };
  }
  Estimate estimate{ mean(weights, found.second, values), 0.0 };
  for (const auto& [vertex, weight] : weights)
  {
    estimate.distance += weight / found.second * distance(left->point(), vertex->point());
  }
  return estimate;
}

void NaturalNeighbours::neighboursOf(std::size_t place, std::vector<std::uint32_t>& neighbours) const
{
  neighbours.clear();
  const Delaunay::Vertex_handle vertex = this->Data->vertices[place];
  if (vertex == Delaunay::Vertex_handle())
  {
    return;
  }
  const auto first = this->Data->triangulation.incident_vertices(vertex);
  auto next = first;
  do
  {
    if (!this->Data->triangulation.is_infinite(next))
    {
      neighbours.push_back(next->info());
    }
  } while (++next != first);
}

void NaturalNeighbours::remove(std::size_t place)
{
  this->Data->triangulation.remove(this->Data->vertices[place]);
  this->Data->vertices[place] = Delaunay::Vertex_handle();
}

void NaturalNeighbours::restore(std::size_t place, const glm::dvec2& point)
{
  this->Data->vertices[place] = this->Data->triangulation.insert(Point(point.x, point.y));
  this->Data->vertices[place]->info() = static_cast<std::uint32_t>(place);
}

std::vector<NaturalNeighbours::Triangle> NaturalNeighbours::triangles() const
{
  std::vector<Triangle> result;
  result.reserve(this->Data->triangulation.number_of_faces());
  const Delaunay& triangulation = this->Data->triangulation;
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face)
  {
    const Point& a = face->vertex(0)->point();
    const Point& b = face->vertex(1)->point();
    const Point& c = face->vertex(2)->point();
    Triangle triangle;
    triangle.area = 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
    triangle.radius = distance(a, b) * distance(b, c) * distance(c, a) / (4.0 * triangle.area);
    if (triangle.area > 0.0)
    {
      result.push_back(triangle);
    }
  }
  return result;
}

double NaturalNeighbours::rmsSlope(const std::vector<double>& values) const
{
  double squares = 0.0;
  double count = 0.0;
  const Delaunay& triangulation = this->Data->triangulation;
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge)
  {
    const auto a = edge->first->vertex(Delaunay::ccw(edge->second));
    const auto b = edge->first->vertex(Delaunay::cw(edge->second));
    const double slope = (values[a->info()] - values[b->info()]) / distance(a->point(), b->point());
    squares += slope * slope;
    count += 1.0;
  }
  return std::sqrt(squares / count);
}

}
