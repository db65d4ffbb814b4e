#pragma once

#include <filesystem>
#include <string>

namespace demens::tao_calib {

enum class FitFormat
{
    text,
    csv,
    json
};

//! What `demens fit FILE.toml` prints, and whether it answers what the file asks.
struct FitAnswer
{
    std::string output;
    bool complete; //!< every response with a target is fitted
};

//! Fits the table that the file names. MPI must be initialised. \throws InputError
FitAnswer fit_table(std::filesystem::path const& file, FitFormat format = FitFormat::text);

} // namespace demens::tao_calib
