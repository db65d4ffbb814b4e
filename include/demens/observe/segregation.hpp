#pragma once

#include "demens/base/vector3.hpp"

#include <array>
#include <map>

namespace demens::observe {

//! How far two kinds of particles are apart, from the share of the mass that the first has in cubic cells:
//! the variance of that share between the cells, each counted by its mass, over the largest possible one
//! (intensity of segregation, Danckwerts 1952). 1: no cell holds both; 0: the same share everywhere. Few
//! particles in a cell make it larger by chance.
class Segregation
{
  public:
    //! \param cell side of a cell [m]
    explicit Segregation(double cell) : cell_(cell) {}

    void add(Vector3 const& place, double mass, bool first_kind);
    //! NaN while there is only one kind.
    double intensity() const;

  private:
    struct Masses
    {
        double first = 0, all = 0;
    };
    double cell_;
    std::map<std::array<long, 3>, Masses> cells_;
};

} // namespace demens::observe
