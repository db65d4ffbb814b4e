#pragma once

#include "gap/catalogue/entry.hpp"
#include "gap/catalogue/settings.hpp"

namespace demens::gap {

// One effect a file, in the order in which they are listed.

CatalogueEntry fill_mass();
CatalogueEntry drum_speed();
CatalogueEntry drum_tilt();
CatalogueEntry lean();
CatalogueEntry vibration();
CatalogueEntry gate();
CatalogueEntry filling_history();
CatalogueEntry rest();
CatalogueEntry cover_motion();
CatalogueEntry slot_width();
CatalogueEntry size_scale();
CatalogueEntry fines();
CatalogueEntry shape();
CatalogueEntry grain_density();
CatalogueEntry wall_friction();
CatalogueEntry cover_friction();
CatalogueEntry wall_adhesion();
CatalogueEntry slice_length();
CatalogueEntry van_der_waals();
CatalogueEntry liquid_bridges();
CatalogueEntry area_cohesion();
CatalogueEntry charge();
CatalogueEntry softening();
CatalogueEntry static_above_kinetic();
CatalogueEntry friction_weakening();
CatalogueEntry friction_drift();
CatalogueEntry rolling_damping();
CatalogueEntry viscoelastic();
CatalogueEntry restitution();
CatalogueEntry air_drag();
CatalogueEntry camera_angle();
CatalogueEntry picture_scale();
CatalogueEntry picture_threshold();
CatalogueEntry balance_scale();
CatalogueEntry balance_delay();
CatalogueEntry time_base();

} // namespace demens::gap
