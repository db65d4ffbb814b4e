#pragma once

#include <petsctao.h>

namespace demens::tao_calib {

//! Handles that PETSc destroys, released in any case and before it is finalised.
struct TaoHandles
{
    TaoHandles() = default;
    TaoHandles(TaoHandles const&) = delete;
    TaoHandles& operator=(TaoHandles const&) = delete;
    ~TaoHandles()
    {
        (void)TaoDestroy(&tao);
        (void)VecDestroy(&point);
        (void)VecDestroy(&residuals);
        (void)VecDestroy(&lower);
        (void)VecDestroy(&upper);
        (void)PetscOptionsDestroy(&options);
    }
    Tao tao = nullptr;
    Vec point = nullptr, residuals = nullptr, lower = nullptr, upper = nullptr;
    PetscOptions options = nullptr;
};

//! How TAO says that it ended, in words.
char const* in_words(TaoConvergedReason reason);

} // namespace demens::tao_calib
