// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/multigrid/petsc_session.hpp"

#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

#include <petscsys.h>

namespace spricka::engines {

namespace {

std::mutex& petsc_in_use() {
  static std::mutex mutex;
  return mutex;
}

bool mpi_started_here = false;

// MPI complains of a process that ends without.
void end_petsc() {
  int ended = 0;
  MPI_Finalized(&ended);
  if (ended != 0) {
    return; // a run over several machines has ended it: PETSc may not ask it for anything
  }
  PetscFinalize();
  if (mpi_started_here) {
    MPI_Finalize();
  }
}

void start_petsc() {
  int started = 0;
  MPI_Initialized(&started);
  if (started == 0) {
    int level = 0;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level) != MPI_SUCCESS) {
      throw std::runtime_error("MPI, which PETSc needs, does not start");
    }
    mpi_started_here = true;
  }
  // Else the ranks of a run over several machines would wait for each other here.
  PETSC_COMM_WORLD = MPI_COMM_SELF;
  PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
  PetscOptionsSetValue(nullptr, "-skip_petscrc", "true");
  throw_if_petsc_failed(PetscInitializeNoArguments());
  throw_if_petsc_failed(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
  std::atexit(end_petsc);
}

} // namespace

PetscSession::PetscSession() : lock_(petsc_in_use()) {
  static const bool started = [] {
    start_petsc();
    return true;
  }();
  static_cast<void>(started);
}

void throw_if_petsc_failed(PetscErrorCode code) {
  if (code == 0) {
    return;
  }
  if (code == PETSC_ERR_MEM) {
    throw std::bad_alloc();
  }
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw std::runtime_error("PETSc: " +
                           (text == nullptr ? std::to_string(code) : std::string(text)));
}

} // namespace spricka::engines
