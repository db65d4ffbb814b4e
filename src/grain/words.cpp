#include "demens/grain/words.hpp"

namespace demens {

template <>
std::vector<Word<grain::SizeMeasure>> const& words_of()
{
    using enum grain::SizeMeasure;
    static std::vector<Word<grain::SizeMeasure>> const words = {{equivalent, "volume_equivalent"},
                                                                {largest_feret, "largest_feret"},
                                                                {smallest_feret, "smallest_feret"},
                                                                {square_sieve, "square_sieve"},
                                                                {round_sieve, "round_sieve"}};
    return words;
}

template <>
std::vector<Word<grain::ShareOf>> const& words_of()
{
    using enum grain::ShareOf;
    static std::vector<Word<grain::ShareOf>> const words = {{mass, "mass"}, {number, "number"}};
    return words;
}

} // namespace demens
