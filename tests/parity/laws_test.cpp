// The contact laws as the device's compiler makes them, against the host's: the laws are written once.
#include "tests/parity/law_evaluation.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using namespace demens::parity;

constexpr int contacts = 200, moments_each = 60;

//! What the host's compiler makes of the laws, and their names.
struct Reference
{
    std::vector<Moment> moments = collisions(contacts, moments_each);
    std::vector<std::string> names{};
    std::vector<double> results{};

    Reference()
    {
        std::size_t const numbers = moments.size() * numbers_per_moment;
        for_each_law([&](std::string const& name, auto const& law) {
            names.push_back(name);
            results.resize(results.size() + numbers);
            double* to = results.data() + results.size() - numbers;
            for (int i = 0; i < contacts; ++i)
                evaluate_law(law, moments.data() + i * moments_each, moments_each,
                             to + i * moments_each * numbers_per_moment);
        });
    }

    //! Every result within `tolerance` of the largest of its law and kind.
    void expect_equal(std::vector<double> const& other, double tolerance) const
    {
        ASSERT_EQ(other.size(), results.size());
        std::size_t const numbers = results.size() / names.size();
        for (std::size_t law = 0; law < names.size(); ++law)
            for (std::size_t c = 0; c < numbers_per_moment; ++c) {
                double largest = 0, difference = 0;
                for (std::size_t k = law * numbers + c; k < (law + 1) * numbers; k += numbers_per_moment) {
                    largest = std::max(largest, std::abs(results[k]));
                    difference = std::max(difference, std::abs(results[k] - other[k]));
                    ASSERT_TRUE(std::isfinite(other[k])) << names[law];
                }
                EXPECT_LE(difference, tolerance * largest) << names[law] << ", number " << c;
            }
    }
};

TEST(Parity, EveryLawActs)
{
    Reference const reference;
    EXPECT_GE(reference.names.size(), 16u);
    std::size_t const numbers = reference.results.size() / reference.names.size();
    for (std::size_t law = 0; law < reference.names.size(); ++law) {
        double largest = 0;
        for (std::size_t k = 0; k < numbers; ++k)
            largest = std::max(largest, std::abs(reference.results[law * numbers + k]));
        EXPECT_GT(largest, 0) << reference.names[law] << " gives no force";
    }
}

TEST(Parity, DeviceCompilerOnTheHost)
{
    Reference const reference;
    reference.expect_equal(evaluated_by_device_compiler(reference.moments, contacts), 1e-13);
}

TEST(Parity, Device)
{
    if (!device_is_there())
        GTEST_SKIP() << "no CUDA device here: the kernels were compiled only";
    Reference const reference;
    reference.expect_equal(evaluated_on_device(reference.moments, contacts), 1e-11);
}

} // namespace
