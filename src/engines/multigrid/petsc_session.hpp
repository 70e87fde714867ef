// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <mutex>
#include <utility>

#include <petscpc.h>

namespace spricka::engines {

/// PETSc, started when it is first needed and ended with the process: on this process alone, even
/// under mpirun, with no signal handlers, output or settings files of its own. While one exists no
/// other thread uses PETSc, which is not made for several.
class PetscSession {
public:
  PetscSession();

private:
  std::unique_lock<std::mutex> lock_;
};

/// Throws std::bad_alloc where memory was short, std::runtime_error with what PETSc says otherwise.
void throw_if_petsc_failed(PetscErrorCode code);

/// Owns an object of PETSc; to be let go within a session.
template <class Object, PetscErrorCode (*destroy)(Object*)> class PetscHandle {
public:
  PetscHandle() = default;
  ~PetscHandle() { destroy(&object_); } // does nothing with a null
  PetscHandle(const PetscHandle&) = delete;
  PetscHandle& operator=(const PetscHandle&) = delete;

  [[nodiscard]] Object get() const { return object_; }
  Object* put() { return &object_; }

private:
  Object object_ = nullptr;
};

using PetscMatrix = PetscHandle<Mat, MatDestroy>;
using PetscVector = PetscHandle<Vec, VecDestroy>;
using PetscPreconditioner = PetscHandle<PC, PCDestroy>;
using PetscNullSpace = PetscHandle<MatNullSpace, MatNullSpaceDestroy>;

} // namespace spricka::engines
