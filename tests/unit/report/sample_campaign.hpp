#pragma once

#include "ensemble/session.hpp"

namespace demens::report::test {

//! A campaign with known numbers: two experiments, two replicates each, three factors, three targets; a
//! design of four points with one failed run, then a search wave of two points with an analysis; point 4 is
//! the best.
ensemble::Campaign sample_campaign();
//! The same while its first wave is under way: five of 16 runs have ended, one of them failed, nothing is
//! analysed.
ensemble::Campaign campaign_under_way();
//! The same before any run is planned.
ensemble::Campaign new_campaign();
//! The same with so many replicates of the four points of its design, 8 runs each, and no search.
ensemble::Campaign campaign_of_many_runs(int replicates);
//! Two snapshots and a series; the particles stand on a grid, 12 by 5 by 10 of them.
ensemble::RunDetails sample_details(int run);

} // namespace demens::report::test
