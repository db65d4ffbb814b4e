#pragma once

#include "demens/base/vector3.hpp"

namespace demens::contact {

// The history of a contact is a row of numbers, of which each stage has its own. Where they lie is for the
// caller to say: `state[k]` is a reference to number k.

//! The history of a contact as a record of its own.
struct HistoryRecord
{
    double* numbers;

    DEMENS_INLINE DEMENS_FUNCTION double& operator[](int k) const { return numbers[k]; }
};

template <int n, class State>
DEMENS_INLINE DEMENS_FUNCTION void load_scalars(State const& state, int first, double (&scalars)[n + 1])
{
    for (int k = 0; k < n; ++k)
        scalars[k] = state[first + k];
}

template <int n, class State>
DEMENS_INLINE DEMENS_FUNCTION void store_scalars(State const& state, int first,
                                                 double const (&scalars)[n + 1])
{
    for (int k = 0; k < n; ++k)
        state[first + k] = scalars[k];
}

template <class State>
DEMENS_INLINE DEMENS_FUNCTION Vector3 load_vector(State const& state, int first)
{
    return {state[first], state[first + 1], state[first + 2]};
}

template <class State>
DEMENS_INLINE DEMENS_FUNCTION void store_vector(State const& state, int first, Vector3 const& v)
{
    state[first] = v.x;
    state[first + 1] = v.y;
    state[first + 2] = v.z;
}

//! The old value of an entry, which becomes the new one.
template <class State>
DEMENS_INLINE DEMENS_FUNCTION double exchange(State const& state, int at, double value)
{
    double const old = state[at];
    state[at] = value;
    return old;
}
template <class State>
DEMENS_INLINE DEMENS_FUNCTION Vector3 exchange(State const& state, int first, Vector3 const& value)
{
    Vector3 const old = load_vector(state, first);
    store_vector(state, first, value);
    return old;
}

} // namespace demens::contact
