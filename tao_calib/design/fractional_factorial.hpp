#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace demens::tao_calib {

//! A product of two-level factors: bit k stands for factor k.
struct Word
{
    std::uint32_t letters = 0;
    int sign = 1;

    int length() const;
    std::string text() const; //!< e.g. "ABCE", "-ABD"
    friend Word operator*(Word a, Word b) { return {a.letters ^ b.letters, a.sign * b.sign}; }
};

//! Letter of a factor: A, B, C, ... without I, which stands for the identity.
char factor_letter(int factor);

//! A regular two-level fraction of 2^(factors - generators) runs.
class FractionalFactorial
{
  public:
    //! Generators read "E=ABC" or "E=-ABC": a new factor as a product of the free ones. \throws InputError
    FractionalFactorial(int factors, std::vector<std::string> const& generators);
    //! The fraction of highest resolution, and among those with the fewest shortest words. \throws InputError
    static FractionalFactorial of_best_resolution(int factors, int runs);
    //! The smallest fraction that keeps main effects clear of products of two factors (resolution IV), or the
    //! full factorial.
    static FractionalFactorial smallest_of_resolution_four(int factors);

    int factors() const { return factors_; }
    int runs() const { return 1 << (factors_ - static_cast<int>(generators_.size())); }
    std::vector<std::string> generators() const; //!< as "E=ABC"
    //! All products that are the identity in this fraction, without I itself, shortest first.
    std::vector<Word> defining_relation() const;
    //! Length of the shortest of them; 0: the design is full, nothing aliases.
    int resolution() const;
    //! Effects that the design cannot tell apart, e.g. "AB = CE": main effects and products of up to `order`
    //! factors.
    std::vector<std::string> aliases(int order = 2) const;
    //! Levels -1 and +1, the first free factor changing fastest [runs x factors].
    Eigen::MatrixXd coded() const;

  private:
    struct Generator
    {
        int factor;
        Word word; //!< of free factors
    };
    explicit FractionalFactorial(int factors);

    int factors_;
    std::vector<Generator> generators_;
};

} // namespace demens::tao_calib
