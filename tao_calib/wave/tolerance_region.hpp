#pragma once

#include "tao_calib/wave/uncertainty.hpp"

namespace demens::tao_calib {

//! Parameter sets that straight lines inside the region connect.
struct RegionPart
{
    Eigen::VectorXd lower, upper; //!< [k] extent, own units
    double share;                 //!< of the sets found
};

//! Where all responses with a tolerance are predicted within it; where none has one, the sets that the
//! targets allow at 95 %.
struct ToleranceRegion
{
    bool by_tolerance = false;
    double share = 0;              //!< of the feasible range of the free factors
    std::vector<RegionPart> parts; //!< the largest first; none: no such set was found
};

//! Found by random sets over the whole range and around the minima. The assessment must be fitted, `known`
//! its uncertainty.
ToleranceRegion tolerance_region(Assessment const& assessment, FactorUncertainty const& known,
                                 std::uint64_t seed);

} // namespace demens::tao_calib
