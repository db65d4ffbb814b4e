#include "tao_calib/design/fractional_factorial.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

namespace demens::tao_calib {
namespace {

constexpr char letters[] = "ABCDEFGHJKLMNOPQRSTUVWXYZ";
constexpr int max_factors = 20;
constexpr std::size_t max_search_work = 20'000'000; //!< words looked at

void check_count(int factors)
{
    if (factors < 1 || factors > max_factors)
        throw InputError(
            fmt::format("a two-level factorial takes 1 to {} factors, not {}: screen or fix some first",
                        max_factors, factors));
}

int factor_of(char letter, int factors, std::string const& generator)
{
    auto const* place = std::find(letters, letters + factors, letter);
    if (place == letters + factors)
        throw InputError(fmt::format("generator \"{}\": `{}` is not one of the factors {}", generator, letter,
                                     std::string(letters, letters + factors)));
    return static_cast<int>(place - letters);
}

Word word_of(std::string const& text, int factors, std::string const& generator)
{
    Word word;
    for (char letter : text) {
        if (letter == '-')
            word.sign = -word.sign;
        else
            word.letters ^= 1u << factor_of(letter, factors, generator);
    }
    return word;
}

//! Products of all non-empty subsets.
std::vector<Word> products_of(std::vector<Word> const& words)
{
    std::vector<Word> products;
    for (Word word : words) {
        auto const count = products.size();
        products.push_back(word);
        for (std::size_t i = 0; i < count; ++i)
            products.push_back(products[i] * word);
    }
    return products;
}

//! How many words there are of each length: what fractions are ranked by, fewest short words first.
std::vector<int> word_lengths(std::vector<Word> const& words, int factors)
{
    std::vector<int> counts(factors + 1, 0);
    for (Word word : words)
        ++counts[word.length()];
    return counts;
}

bool by_length_and_letters(Word a, Word b)
{
    return a.length() != b.length() ? a.length() < b.length() : a.text() < b.text();
}

//! Depth-first search for generators of which no product is shorter than the wanted resolution.
class GeneratorSearch
{
  public:
    GeneratorSearch(int factors, int free, int resolution)
        : factors_(factors), free_(free), resolution_(resolution)
    {
        for (std::uint32_t mask = 1; mask < (1u << free); ++mask)
            if (std::popcount(mask) >= resolution - 1)
                choices_.push_back({mask});
        std::sort(choices_.begin(), choices_.end(), by_length_and_letters);
        extend(0, {});
    }

    std::vector<Word> const& best() const { return best_; } //!< empty: there is none

  private:
    void extend(std::size_t first_choice, std::vector<Word> const& relation)
    {
        int const next = free_ + static_cast<int>(chosen_.size());
        if (next == factors_) {
            auto lengths = word_lengths(relation, factors_);
            if (best_.empty() || lengths < best_lengths_) {
                best_ = chosen_;
                best_lengths_ = std::move(lengths);
            }
            return;
        }
        for (std::size_t i = first_choice; i < choices_.size() && work_ < max_search_work; ++i) {
            Word const word = choices_[i] * Word{1u << next};
            auto longer = relation;
            longer.push_back(word);
            for (Word other : relation)
                longer.push_back(other * word);
            work_ += longer.size();
            if (std::any_of(longer.begin(), longer.end(), [&](Word w) { return w.length() < resolution_; }))
                continue;
            chosen_.push_back(choices_[i]);
            extend(i + 1, longer);
            chosen_.pop_back();
        }
    }

    int factors_, free_, resolution_;
    std::vector<Word> choices_, chosen_, best_;
    std::vector<int> best_lengths_;
    std::size_t work_ = 0;
};

} // namespace

int Word::length() const
{
    return std::popcount(letters);
}

std::string Word::text() const
{
    std::string result = sign < 0 ? "-" : "";
    for (int k = 0; k < max_factors; ++k)
        if (letters >> k & 1u)
            result += factor_letter(k);
    return result;
}

char factor_letter(int factor)
{
    return letters[factor];
}

FractionalFactorial::FractionalFactorial(int factors) : factors_(factors)
{
    check_count(factors);
}

FractionalFactorial::FractionalFactorial(int factors, std::vector<std::string> const& generators)
    : FractionalFactorial(factors)
{
    std::uint32_t generated = 0;
    for (std::string text : generators) {
        std::erase(text, ' ');
        if (text.size() < 4 || text[1] != '=')
            throw InputError(fmt::format("generator \"{}\" has to read like \"E=ABC\"", text));
        Generator const generator{factor_of(text[0], factors, text), word_of(text.substr(2), factors, text)};
        if (generator.word.length() < 2)
            throw InputError(fmt::format("generator \"{}\" makes two factors the same", text));
        if (generated >> generator.factor & 1u)
            throw InputError(fmt::format("factor {} has two generators", text[0]));
        generated |= 1u << generator.factor;
        generators_.push_back(generator);
    }
    for (auto const& generator : generators_)
        if (generator.word.letters & generated)
            throw InputError(fmt::format("generator \"{}={}\" uses a factor that is generated itself",
                                         factor_letter(generator.factor), generator.word.text()));
    if (!generators_.empty() && resolution() < 3)
        throw InputError("two generators are the same: their factors could not be told apart");
}

FractionalFactorial FractionalFactorial::of_best_resolution(int factors, int runs)
{
    FractionalFactorial result(factors);
    auto const size = static_cast<unsigned>(runs);
    if (runs < 2 || !std::has_single_bit(size))
        throw InputError(
            fmt::format("a two-level fraction has 2, 4, 8, 16, ... runs, not points = {}: take {} or {}",
                        runs, std::bit_floor(std::max(size, 2u)), std::bit_ceil(std::max(size, 2u))));
    int const free = std::countr_zero(size);
    if (free >= factors)
        return result;
    if (factors >= runs)
        throw InputError(fmt::format("{} runs cannot tell {} factors apart; {} are enough", runs, factors,
                                     std::bit_ceil(static_cast<unsigned>(factors + 1))));
    for (int resolution = free + 1; resolution >= 3; --resolution) {
        auto const words = GeneratorSearch(factors, free, resolution).best();
        if (words.empty())
            continue;
        for (Word word : words)
            result.generators_.push_back({free + static_cast<int>(result.generators_.size()), word});
        return result;
    }
    throw InputError(fmt::format("no two-level fraction of {} runs for {} factors", runs, factors));
}

FractionalFactorial FractionalFactorial::smallest_of_resolution_four(int factors)
{
    check_count(factors);
    // Resolution IV takes at least twice as many runs as factors, and so many are always enough.
    auto const runs = static_cast<int>(std::bit_ceil(2u * static_cast<unsigned>(factors)));
    return of_best_resolution(factors, std::min(runs, 1 << factors));
}

std::vector<std::string> FractionalFactorial::generators() const
{
    std::vector<std::string> texts;
    for (auto const& generator : generators_)
        texts.push_back(fmt::format("{}={}", factor_letter(generator.factor), generator.word.text()));
    return texts;
}

std::vector<Word> FractionalFactorial::defining_relation() const
{
    std::vector<Word> words;
    for (auto const& generator : generators_)
        words.push_back(generator.word * Word{1u << generator.factor});
    auto relation = products_of(words);
    std::sort(relation.begin(), relation.end(), by_length_and_letters);
    return relation;
}

int FractionalFactorial::resolution() const
{
    auto const relation = defining_relation();
    return relation.empty() ? 0 : relation.front().length();
}

std::vector<std::string> FractionalFactorial::aliases(int order) const
{
    std::vector<Word> effects;
    for (std::uint32_t mask = 1; mask < (1u << factors_); ++mask)
        if (std::popcount(mask) <= order)
            effects.push_back({mask});
    std::sort(effects.begin(), effects.end(), by_length_and_letters);

    auto const relation = defining_relation();
    std::vector<std::string> result;
    std::vector<std::uint32_t> listed;
    for (Word effect : effects) {
        if (std::find(listed.begin(), listed.end(), effect.letters) != listed.end())
            continue;
        std::vector<Word> same;
        for (Word word : relation)
            if ((effect * word).length() <= order)
                same.push_back(effect * word);
        if (same.empty())
            continue;
        std::sort(same.begin(), same.end(), by_length_and_letters);
        std::string text = effect.text();
        for (Word word : same) {
            text += " = " + word.text();
            listed.push_back(word.letters);
        }
        result.push_back(text);
    }
    return result;
}

Eigen::MatrixXd FractionalFactorial::coded() const
{
    std::vector<bool> is_free(factors_, true);
    for (auto const& generator : generators_)
        is_free[generator.factor] = false;
    Eigen::MatrixXd design(runs(), factors_);
    for (int run = 0; run < runs(); ++run) {
        int bit = 0;
        for (int k = 0; k < factors_; ++k)
            if (is_free[k])
                design(run, k) = run >> bit++ & 1 ? 1 : -1;
        for (auto const& generator : generators_) {
            double product = generator.word.sign;
            for (int k = 0; k < factors_; ++k)
                if (generator.word.letters >> k & 1u)
                    product *= design(run, k);
            design(run, generator.factor) = product;
        }
    }
    return design;
}

} // namespace demens::tao_calib
