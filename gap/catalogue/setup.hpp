#pragma once

#include "ensemble/input/campaign_input.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! What effects find in a campaign: its grains, its walls, the keys of its rigs.
class Setup
{
  public:
    explicit Setup(ensemble::CampaignInput const& input);

    //! Materials of grains, each once.
    std::vector<std::string> const& grains() const { return grains_; }
    //! Paths such as `contact.a_b` of the tables of grains among themselves.
    std::vector<std::string> contacts_among_grains() const;
    //! Those of grains with walls: of side walls and floors, or of covers (end walls of a drum, windows of a
    //! box) that are of another material.
    std::vector<std::string> contacts_with_walls() const { return contacts_with(walls_); }
    std::vector<std::string> contacts_with_covers() const { return contacts_with(covers_); }

    //! The base value at a path: a number that is given (and not -1, which stands for what follows from
    //! others), or none.
    std::optional<double> number(std::string const& path) const;
    std::optional<std::string> word(std::string const& path) const;
    bool has(std::string const& path) const { return input_->base_value(path).has_value(); }
    //! Paths `experiment.NAME.key` of all experiments where it is given and not 0.
    std::vector<std::string> given_in_experiments(std::string const& key) const;
    //! The same where the key is there, whatever its value.
    std::vector<std::string> in_experiments(std::string const& key) const;
    //! Whether a size distribution has grains that are not spheres.
    bool has_shapes() const;
    //! Radius of the grain of mean volume, of all size distributions [m]; 0 where none is named.
    double mean_radius() const;
    //! Density of the first grains [kg/m^3].
    double density() const;
    //! How long a shear wave takes around half of the grain of mean volume [s].
    double wave_time() const;

  private:
    std::vector<std::string> contacts_with(std::vector<std::string> const& others) const;

    ensemble::CampaignInput const* input_;
    std::vector<std::string> grains_, walls_, covers_;
};

} // namespace demens::gap
