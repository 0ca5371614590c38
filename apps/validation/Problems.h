#pragma once

#include "Case.h"
#include "CircularForms.h"
#include "CurrentRays.h"
#include "DesignedRays.h"
#include "EllipticShoal.h"
#include "GridRun.h"
#include "StraightForms.h"
#include "TrappedRay.h"

/** The problems behind the cases, each for any parameters. */
namespace swellray::validation
{

/** A ray from (x0, 0) over straight contours, depth h(x), towards the shore at x = 0. */
struct Beach
{
  std::string name;
  std::string title;
  std::string formula;
  std::string spec; ///< of the built-in form, without a scene
  reference::Depth depth;
  double period = 10.0;       ///< s
  double x0 = 0.0;            ///< m
  double theta0 = 0.0;        ///< degrees from the shore normal
  double nearest = 0.0;       ///< m, x of the last place
  bool plane = false;         ///< a bed that a spline reproduces
  double coarsest = 0.0;      ///< spacing of the coarsest grid, m
  double nearestOnGrid = 0.0; ///< m, x of the last place compared on grids
  double gridFrom = -100.0;   ///< m, x where the grids begin, the formula being smooth from there on
};

Outcome runBeach(const Beach& beach, const Setting& setting);

/** The dispersion relation for these periods, s, in depths of 1 cm to 10 km. */
Outcome runDispersion(const std::vector<double>& periods, const Setting& setting);

/** Waves from deep water onto a plane beach by the whole tracer, launch included. */
struct DeepBeach
{
  double slope = 0.02;
  std::vector<double> periods; ///< s
  std::vector<double> angles;  ///< in deep water, degrees from the shore normal
};

Outcome runDeepToDepth(const DeepBeach& beach, const Setting& setting);

/** Long waves where h = h0 (x/x0)^power or h0 (r/r0)^power: a curve known in shallow water. */
struct Shallow
{
  reference::DesignedRay curve; ///< the same one as at finite period, where only phase and time differ
  double power = 1.0;
  double depth = 0.0; ///< h0, m
  bool circular = false;
};

Outcome runShallow(const Shallow& shallow, const Setting& setting);

/** First breaking on a plane beach. */
struct Breaking
{
  double period = 0.0; ///< s
  double height = 0.0; ///< in deep water, m
  double theta0 = 0.0; ///< in deep water, degrees
  double slope = 0.0;
  double gamma = 0.0;
};

Outcome runBreaking(const std::vector<Breaking>& waves, const Setting& setting);
Outcome runTrapped(const reference::TrappedRay& exact, const Setting& setting);

/** Rays along +x over a circular shoal or island, from (x0, b). */
struct Circular
{
  std::string name;
  std::string title;
  std::string formula;
  reference::CircularForm form;
  double period = 10.0; ///< s
  double x0 = 0.0;      ///< m
  std::vector<double> b;
};

Outcome runCircular(const Circular& circular, const Setting& setting);
Outcome runCircularCaustic(const Circular& circular, const Setting& setting);

/** Rays over a seafloor made for them, on grids of the given order and spacings (m). */
struct DesignGrid
{
  GridOrder order = GridOrder::Curved;
  std::vector<double> spacings;
};

Outcome runDesign(const std::vector<reference::DesignedRay>& rays, const DesignGrid& grid, const Setting& setting);

/** Rays along +x over an elliptic shoal, from x = from at the given y, m. */
struct Elliptic
{
  std::string spec; ///< of the built-in form, without a scene
  reference::EllipticShoal shoal;
  double period = 1.0; ///< s
  double from = -10.0;
  std::vector<double> y;
};

Outcome runElliptic(const Elliptic& elliptic, const Setting& setting);

/** A ray across or back from a shear jet along y. */
struct JetProblem
{
  double speed = 0.0; ///< V0, m/s
  double width = 0.0; ///< w, m
  reference::CurrentScene scene;
  double from = 0.0;  ///< x of the start, m
  double angle = 0.0; ///< of the wavenumber, degrees from +x
};

Outcome runJet(const JetProblem& jet, const Setting& setting);

/** Rays along +x from (from, b) into an eddy around the origin. */
struct EddyProblem
{
  double speed = 0.0;  ///< U0, m/s
  double radius = 0.0; ///< R, m
  reference::CurrentScene scene;
  double from = 0.0; ///< m
  std::vector<double> b;
};

Outcome runEddy(const EddyProblem& eddy, const Setting& setting);

/** Waves along a current along +x that grows to each of the speeds, m/s. */
struct CollinearProblem
{
  reference::CurrentScene scene;
  std::vector<double> speeds;
  double width = 200.0; ///< length over which the current grows, m
};

Outcome runCollinear(const CollinearProblem& collinear, const Setting& setting);

}
