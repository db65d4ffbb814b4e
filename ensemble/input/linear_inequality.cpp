#include "ensemble/input/linear_inequality.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

namespace demens::ensemble::input {
namespace {

constexpr char const* form = "; write a linear inequality such as \"kinetic_friction <= static_friction\" or "
                             "\"2*a - b <= 0.5\"";

//! A linear function of the variables.
struct LinearSum
{
    std::vector<double> coefficients;
    double constant = 0;
};

//! Recursive descent over `sum (<=|>=) sum`, `sum = [-] term {(+|-) term}`, `term = factor {* factor | /
//! number}`.
class Parser
{
  public:
    Parser(std::string const& text, std::size_t variables,
           std::function<std::size_t(std::string const&)> const& variable_index)
        : text_(text), variables_(variables), variable_index_(variable_index)
    {
    }

    LinearInequality inequality()
    {
        auto left = sum();
        bool const greater = accept(">=");
        if (!greater && !accept("<="))
            throw InputError(std::string(at_end() ? "has no <= or >=" : "expected <= or >= before ") +
                             rest() + form);
        auto right = sum();
        if (!at_end())
            throw InputError("does not go on with " + rest() + form);
        if (greater)
            std::swap(left, right);

        LinearInequality result{left.coefficients, right.constant - left.constant};
        for (std::size_t k = 0; k < variables_; ++k)
            result.coefficients[k] -= right.coefficients[k];
        if (std::all_of(result.coefficients.begin(), result.coefficients.end(),
                        [](double c) { return c == 0; }))
            throw InputError(std::string("no factor is left in it") + form);
        return result;
    }

  private:
    LinearSum sum()
    {
        LinearSum total{std::vector<double>(variables_), 0};
        double sign = accept("-") ? -1 : 1;
        for (bool more = true; more;) {
            add_term(total, sign);
            if (accept("+"))
                sign = 1;
            else if (accept("-"))
                sign = -1;
            else
                more = false;
        }
        return total;
    }

    void add_term(LinearSum& total, double sign)
    {
        double number = sign;
        std::optional<std::size_t> variable;
        for (bool divide = false;;) {
            if (auto const value = accept_number()) {
                number = divide ? number / *value : number * *value;
            } else {
                auto const name = accept_name();
                if (name.empty())
                    throw InputError((at_end()
                                          ? "ends where a number or a factor is expected"
                                          : "has " + rest() + " where a number or a factor is expected") +
                                     form);
                if (variable || divide)
                    throw InputError("is not linear at \"" + name + "\"" + form);
                variable = variable_index_(name);
            }
            if (accept("*"))
                divide = false;
            else if (accept("/"))
                divide = true;
            else
                break;
        }
        if (!std::isfinite(number))
            throw InputError(std::string("divides by zero or has a number beyond all bounds") + form);
        (variable ? total.coefficients[*variable] : total.constant) += number;
    }

    bool accept(std::string const& symbol)
    {
        skip_blanks();
        if (text_.compare(position_, symbol.size(), symbol) != 0)
            return false;
        position_ += symbol.size();
        return true;
    }

    std::optional<double> accept_number()
    {
        skip_blanks();
        double value = 0;
        auto const* const begin = text_.data() + position_;
        if (at_end() || !(std::isdigit(static_cast<unsigned char>(*begin)) || *begin == '.'))
            return {};
        auto const [end, failure] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (failure != std::errc{})
            return {};
        position_ += static_cast<std::size_t>(end - begin);
        return value;
    }

    //! A factor's name or its dotted path.
    std::string accept_name()
    {
        skip_blanks();
        auto const begin = position_;
        while (position_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[position_])) ||
                                            text_[position_] == '_' || text_[position_] == '.'))
            ++position_;
        return text_.substr(begin, position_ - begin);
    }

    void skip_blanks()
    {
        while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_])))
            ++position_;
    }

    bool at_end()
    {
        skip_blanks();
        return position_ == text_.size();
    }

    std::string rest() { return at_end() ? "" : "\"" + text_.substr(position_) + "\""; }

    std::string const& text_;
    std::size_t variables_;
    std::function<std::size_t(std::string const&)> const& variable_index_;
    std::size_t position_ = 0;
};

} // namespace

LinearInequality parse_linear_inequality(std::string const& text, std::size_t variables,
                                         std::function<std::size_t(std::string const&)> const& variable_index)
{
    return Parser(text, variables, variable_index).inequality();
}

} // namespace demens::ensemble::input
