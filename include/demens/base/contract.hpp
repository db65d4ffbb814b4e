#pragma once

#include <cassert>

//! What must hold here whatever the input: checked in debug builds, nothing in release builds.
#if defined(NDEBUG)
#define DEMENS_EXPECT(condition, reason) static_cast<void>(0)
#else
#define DEMENS_EXPECT(condition, reason) assert((condition) && (reason))
#endif
