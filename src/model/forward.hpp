// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Names of the model, for headers that hand it on without looking into it.
namespace spricka::model {

enum class CrackTipPlaneState;
enum class FreedomRole;
enum class StressState;
struct ResultCheck;
struct Contact;
struct ConstraintEquation;
struct CrackGrowthSettings; // NOLINT(bugprone-forward-declaration-namespace): results has one of
                            // its own
struct Load;
struct LoadCase;
struct ElasticMaterial;
struct Mesh;
struct Model;
struct OutputFileRequest;
struct ElementProperty;
struct RigidTarget;
struct SpectrumDefinition;
struct Step;
struct TipMeshSettings;

} // namespace spricka::model
