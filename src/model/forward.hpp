// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Names of the model, for headers that hand it on without looking into it.
namespace spricka::model {

enum class CrackState;
enum class FreedomClass;
enum class State;
struct Check;
struct Contact;
struct Equation;
struct Growth; // NOLINT(bugprone-forward-declaration-namespace): results has one of its own
struct Load;
struct LoadCase;
struct Material;
struct Mesh;
struct Model;
struct Output;
struct Property;
struct Rigid;
struct Spectrum;
struct Step;
struct TipNet;

} // namespace spricka::model
