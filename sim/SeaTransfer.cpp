#include "sim/SeaTransfer.h"

#include <Eigen/Core>

#include <limits>
#include <stdexcept>

namespace swellray
{

SeaTransfer::SeaTransfer(const SpectralRays& rays, const SpectralGrid& offshore,
  const std::vector<SpectralOrigins>& places, std::optional<double> gamma, const Execution& execution)
  : Offshore(offshore)
  , FrequencyWeights(offshore.frequencyWeights())
  , Gamma(gamma)
{
  offshore.validate();
  SpectralSeaOptions{ rays, gamma ? BreakingRule::Gamma : BreakingRule::None, gamma }.validate();
  const std::size_t count = places.size();
  const std::size_t nodes = offshore.size();
  for (const SpectralOrigins& place : places)
  {
    this->Depths.push_back(place.depth);
    this->Wet.push_back(!place.headings.empty());
  }
  this->Weights.assign(nodes * count * 3, 0.0);
  execution.forRange(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t p = begin; p < end; ++p)
      {
        const std::vector<double> sums = SpectralTransfer(rays, offshore, places[p]).frequencyWeights();
        for (std::size_t node = 0; node < nodes; ++node)
        {
          for (std::size_t i = 0; i < 3; ++i)
          {
            this->Weights[(node * count + p) * 3 + i] = sums[3 * node + i];
          }
        }
      }
    });
}

std::vector<PlaceSea> SeaTransfer::apply(const std::vector<double>& densities, std::size_t count) const
{
  if (densities.size() != count * this->Offshore.size())
  {
    throw std::invalid_argument("the spectra offshore do not have the size of their grid");
  }
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
  using Eigen::Index;
  const std::size_t places = this->Depths.size();
  const std::size_t frequencies = this->Offshore.frequencies.size();
  const std::size_t directions = this->Offshore.headings.size();
  const auto rows = static_cast<Index>(3 * places);
  const double none = std::numeric_limits<double>::quiet_NaN();

  std::vector<PlaceSea> result(places * count);
  // A block of seas at a time, so that the sums of a block stay small.
  constexpr std::size_t Block = 64;
  Matrix sums;                                // [frequency: columns of the block][place, 3]
  std::vector<double> place(3 * frequencies); // of one place and sea
  for (std::size_t first = 0; first < count; first += Block)
  {
    const std::size_t block = std::min(Block, count - first);
    sums.resize(rows, static_cast<Index>(frequencies * block));
    for (std::size_t f = 0; f < frequencies; ++f)
    {
      const Eigen::Map<const Matrix> weights(
        this->Weights.data() + f * directions * places * 3, rows, static_cast<Index>(directions));
      const Eigen::Map<const Matrix, 0, Eigen::OuterStride<>> seas(
        densities.data() + first * this->Offshore.size() + f * directions, static_cast<Index>(directions),
        static_cast<Index>(block), Eigen::OuterStride<>(static_cast<Index>(this->Offshore.size())));
      sums.middleCols(static_cast<Index>(f * block), static_cast<Index>(block)).noalias() = weights * seas;
    }
    for (std::size_t s = 0; s < block; ++s)
    {
      for (std::size_t p = 0; p < places; ++p)
      {
        PlaceSea& sea = result[(first + s) * places + p];
        sea.depth = this->Depths[p];
        sea.known = this->Wet[p];
        if (!sea.known)
        {
          sea.parameters = { none, none, none, none, none, none, none };
          continue;
        }
        for (std::size_t f = 0; f < frequencies; ++f)
        {
          for (std::size_t i = 0; i < 3; ++i)
          {
            place[3 * f + i] = sums(static_cast<Index>(3 * p + i), static_cast<Index>(f * block + s));
          }
        }
        sea.parameters = seaParameters(this->Offshore.frequencies, this->FrequencyWeights, place.data());
        if (this->Gamma && sea.parameters.significantHeight > *this->Gamma * sea.depth)
        {
          // The spectrum is scaled as a whole: all but the height stays.
          sea.breaking = true;
          sea.parameters.significantHeight = *this->Gamma * sea.depth;
        }
      }
    }
  }
  return result;
}

}
