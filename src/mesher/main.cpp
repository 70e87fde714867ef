// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/serve.hpp"

// spricka-mesher: gmsh in a process of its own, asked by spricka through a socket.

#ifdef SPRICKA_GMSH_LIBRARIES
#include <array>
#include <cstdio>

#include <dlfcn.h>

namespace {

// What gmsh needs, each library before those that need it, and gmsh itself. Loaded one by one they
// look for names in what they need themselves; all at once each would look through all ninety.
constexpr auto libraries = std::to_array<const char*>({SPRICKA_GMSH_LIBRARIES});

} // namespace

int main(int argc, char** argv) {
  for (const char* const library : libraries) {
    dlopen(library, RTLD_LAZY | RTLD_LOCAL); // without one the module loads it, or tells
  }
  void* const module = dlopen("$ORIGIN/spricka-mesher.so", RTLD_LAZY | RTLD_LOCAL);
  void* const serve = module == nullptr ? nullptr : dlsym(module, "spricka_serve_as_mesher");
  if (serve == nullptr) {
    std::fprintf(stderr, "spricka-mesher: %s\n", dlerror());
    return 1;
  }
  return reinterpret_cast<decltype(&spricka_serve_as_mesher)>(serve)(argc, argv);
}
#else
int main(int argc, char** argv) {
  return spricka_serve_as_mesher(argc, argv);
}
#endif

#ifdef __SANITIZE_ADDRESS__
// Where a script ends the program itself leaks would be looked for, which the sandbox forbids.
extern "C" const char* __asan_default_options() { // NOLINT(bugprone-reserved-identifier)
  return "detect_leaks=0";
}
#endif
