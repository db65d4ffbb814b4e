#pragma once

#include "gap/rehearsal/truth.hpp"
#include "gap/statistics/temperature.hpp"

#include <optional>
#include <string>
#include <vector>

namespace demens::gap {

//! Classes of an answer that are right: one, of a pair both.
std::vector<std::string> right_classes(CaseTruth const& truth);

//! How far an effect closed the gap of what was held out, as an answer has it.
struct AnsweredClosure
{
    bool at_floor;                               //!< before already, so that there is no ratio
    std::optional<double> closure, lower, upper; //!< [-]; none: not given
    std::optional<double> best_other;            //!< closure of the best decoy
};

//! Reads what `demens gap --json` says of a case.
class CaseAnswer
{
  public:
    explicit CaseAnswer(nlohmann::json document);

    //! Classes: none, unknown, the effects of the list. A pair counts for both of its effects by half.
    std::vector<std::string> const& classes() const { return classes_; }
    //! In the order of the classes.
    std::vector<double> const& probabilities() const { return probabilities_; }
    std::string const& first() const; //!< the most probable class
    //! Of all its hypotheses. None where the truth is not among them.
    std::optional<JudgedCase> judged(CaseTruth const& truth) const;
    std::string verdict() const;

    bool names_anything() const;
    //! Whether it names the effect, alone or in a group.
    bool names(std::string const& effect) const;
    //! Whether the effect, or one of a group with it, comes first.
    bool has_in_first_group(std::string const& effect) const;
    //! Whether it says that the measurements have nothing beyond the floor.
    bool sees_nothing() const;
    //! Whether it says that the cause is none of the list.
    bool is_unknown() const;
    //! What a simpler rule would have said: `cosine`, `criterion`, `refit`, or the prior, which says none.
    std::string by_rule(std::string const& rule) const;

    //! How far the effects of a truth stand out of the floor after recalibration [sigmas], by the signatures
    //! of the diagnosis: the root of the sum of squares over cells, less what recalibration absorbs. None
    //! where an effect is not on the list.
    std::optional<double> stands_out(CaseTruth const& truth) const;
    //! Cells that these effects truly move beyond what recalibration hides and the floor covers, by twice the
    //! standard deviation. None where an effect is not on the list.
    std::optional<std::vector<bool>> moved_cells(CaseTruth const& truth) const;
    //! Cells that are said to be beyond the floor.
    std::vector<bool> located_cells() const;

    //! None where the effect was not simulated on what is held out.
    std::optional<AnsweredClosure> closure_of(std::string const& effect) const;

  private:
    nlohmann::json const* effect_named(std::string const& name) const;

    nlohmann::json document_;
    std::vector<std::string> classes_;
    std::vector<double> probabilities_;
};

} // namespace demens::gap
