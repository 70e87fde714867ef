// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// All that the program spricka-mesher does once gmsh is loaded: locks itself in and answers what
/// spricka asks through the socket that is descriptor 3, until nobody asks any more. The arguments
/// are those of the program: the memory that it may use [bytes] and the process of spricka. Returns
/// its exit code, 2 where it was not started by spricka.
extern "C" __attribute__((visibility("default"))) int spricka_serve_as_mesher(int argc,
                                                                              char** argv);
