#pragma once

#include "demens/base/contract.hpp"
#include "demens/base/macros.hpp"

#include <algorithm>
#include <cstddef>
#include <new>
#include <tuple>
#include <type_traits>

namespace demens::contact {

//! One of several laws of a kind: as std::variant, and it can be visited on a device, too.
template <class... Laws>
class OneOf
{
  public:
    static constexpr std::size_t count = sizeof...(Laws);
    template <std::size_t k>
    using Law = std::tuple_element_t<k, std::tuple<Laws...>>;

    static_assert((std::is_trivially_copyable_v<Laws> && ...), "laws are copied to devices byte by byte");

    //! The law number `index` of the list, made from these arguments.
    template <class... Arguments>
    explicit OneOf(std::size_t index, Arguments const&... arguments) : index_(index)
    {
        DEMENS_EXPECT(index < count, "the list of laws is that of the enumeration");
        make<0>(arguments...);
    }

    //! Number of the law in the list.
    DEMENS_FUNCTION std::size_t index() const { return index_; }

    //! What `visitor` makes of the law; it returns the same type for all of them.
    DEMENS_RUNS_WHERE_ITS_ARGUMENT_DOES
    template <std::size_t k = 0, class Visitor>
    DEMENS_FUNCTION decltype(auto) visit(Visitor&& visitor) const
    {
        if constexpr (k + 1 < count)
            if (index_ != k)
                return visit<k + 1>(static_cast<Visitor&&>(visitor));
        return visitor(*std::launder(reinterpret_cast<Law<k> const*>(bytes_)));
    }

    //! The law number k, which it must be.
    template <std::size_t k>
    DEMENS_FUNCTION Law<k> const& get() const
    {
        DEMENS_EXPECT(index_ == k, "the law that is there");
        return *std::launder(reinterpret_cast<Law<k> const*>(bytes_));
    }

  private:
    template <std::size_t k, class... Arguments>
    void make(Arguments const&... arguments)
    {
        if constexpr (k + 1 < count)
            if (index_ != k)
                return make<k + 1>(arguments...);
        new (bytes_) Law<k>(arguments...);
    }

    std::size_t index_;
    alignas(Laws...) unsigned char bytes_[std::max({sizeof(Laws)...})] = {};
};

} // namespace demens::contact
