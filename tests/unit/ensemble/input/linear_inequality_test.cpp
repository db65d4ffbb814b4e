#include "ensemble/input/linear_inequality.hpp"

#include "demens/base/error.hpp"

#include <gtest/gtest.h>

namespace demens::ensemble::input {
namespace {

//! Parses with the variables a, b and c.d.
LinearInequality parse(std::string const& text)
{
    return parse_linear_inequality(text, 3, [](std::string const& name) -> std::size_t {
        std::vector<std::string> const names = {"a", "b", "c.d"};
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == name)
                return i;
        throw InputError("no variable " + name);
    });
}

void expect(std::string const& text, std::vector<double> const& coefficients, double bound)
{
    auto const inequality = parse(text);
    EXPECT_EQ(inequality.coefficients, coefficients) << text;
    EXPECT_EQ(inequality.bound, bound) << text;
}

TEST(LinearInequality, BringsAllVariablesToTheLeft)
{
    expect("a <= b", {1, -1, 0}, 0);
    expect("a >= b", {-1, 1, 0}, 0);
    expect("2*a - b <= 0.5", {2, -1, 0}, 0.5);
    expect("1 + a <= 3", {1, 0, 0}, 2);
    expect("-a+b*3>=c.d/4 - 1e-1", {1, -3, 0.25}, 0.1);
    expect("a + a <= 2*3*b", {2, -6, 0}, 0);
    expect("0.1 <= a", {-1, 0, 0}, -0.1);
}

TEST(LinearInequality, RefusesWhatIsNotLinear)
{
    for (char const* text :
         {"a*b <= 1", "1/a <= 2", "a", "a < b", "a == b", "a <= b <= 1", "2a <= 1", "", "<= 1", "a + <= 1",
          "a <=", "1 <= 2", "a - a <= 1", "a/0 <= 1", "x <= 1", "a <= 1e999", "(a) <= 1"})
        EXPECT_THROW(parse(text), InputError) << text;
}

} // namespace
} // namespace demens::ensemble::input
