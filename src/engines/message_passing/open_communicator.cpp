// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/message_passing/mpi_communicator.hpp"
#include "solve/engine_exports.hpp"
#include "solve/engine_module.hpp"

#include <cstdio>
#include <exception>

const char* spricka_engine_abi() {
  return spricka::solve::engine_abi();
}

spricka::solve::Communicator* spricka_open_communicator(char* trouble, std::size_t size) {
  try {
    return new spricka::engines::MpiCommunicator(); // NOLINT: the caller owns it
  } catch (const std::exception& why) {
    std::snprintf(trouble, size, "%s", why.what()); // NOLINT(cppcoreguidelines-pro-type-vararg)
    return nullptr;
  }
}
