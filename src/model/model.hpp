// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"
#include "base/id.hpp"
#include "base/source.hpp"
#include "base/units.hpp"
#include "model/growth_test.hpp"
#include "model/mesh.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// The model: plain data, as the deck describes it, after all references are resolved. Lengths,
/// forces and stresses are in deck units (stress = force / length^2), angles in radians. Every
/// entity keeps the place in the deck that made it. Nothing here knows a card.
namespace spricka::model {

struct Net {
  std::string name; ///< empty: what stands outside every $NET
  base::Span span;
};

/// Isotropic, linear elastic.
struct Material {
  std::string name;
  double E = 0.0;     ///< Young's modulus [stress]
  double nu = 0.0;    ///< Poisson's ratio
  double rho = 0.0;   ///< density
  double alpha = 0.0; ///< thermal expansion [1/K]
  base::Span span;
};

enum class State { plane_stress, plane_strain, axisymmetric, solid };

struct Property {
  base::ElementSetId elements;
  base::MaterialId material;
  State state = State::plane_stress;
  double thickness = 1.0; ///< [length]
  base::Span span;
};

/// Dependent freedoms follow others by an MPC; no card says so, the ties do.
enum class FreedomClass { local, external, suppressed, prescribed, dependent };

struct Freedom {
  FreedomClass cls = FreedomClass::suppressed;
  std::array<bool, 3> dof{}; ///< x y z
  base::NodeSetId nodes;
  base::Span span;
};

/// A tie between freedoms: sum of coefficient * displacement = rhs.
struct Equation {
  struct Term {
    double coefficient = 0.0;
    base::NodeId node;
    int dof = 0; ///< 0 x, 1 y, 2 z
  };
  std::vector<Term> terms; ///< each freedom once, coefficients not zero
  double rhs = 0.0;
  base::Span span;
};
/// Slave nodes tied to the master faces by their shape functions.
struct Transition {
  base::NodeSetId slave;
  base::FaceSetId master;
  base::Span span;
};
/// Slave nodes that move as one rigid body.
struct RigidTie {
  base::NodeSetId slave;
  base::Span span;
};
using Mpc = std::variant<Equation, Transition, RigidTie>;

enum class LoadType {
  force,        ///< per node of a node set [force]
  resultant,    ///< total over a face or element set [force]
  traction,     ///< per area of a face set [stress]
  pressure,     ///< against the outer normal of a face set [stress]
  body,         ///< per volume of an element set [force/length^3]
  bearing,      ///< pin on a bore given by its resultant [force]
  displacement, ///< values of prescribed freedoms [length]
  temperature   ///< [K]
};
enum class BearingShape { uniform, cosine };

struct Load {
  LoadType type = LoadType::force;
  BearingShape shape = BearingShape::uniform;
  base::NodeSetId nodes; ///< exactly one of the three sets is valid
  base::ElementSetId elements;
  base::FaceSetId faces;
  std::vector<base::Expression> value; ///< 1 to 3 components, fields of x y z
  base::Span span;
};
struct LoadCase {
  std::string name;
  std::vector<Load> loads;
};

enum class RigidShape { line, arc };

/// A rigid target in the plane.
struct Rigid {
  std::string name;
  RigidShape shape = RigidShape::line;
  base::Vec3 first = base::Vec3::Zero();  ///< first point of a line, centre of an arc
  base::Vec3 second = base::Vec3::Zero(); ///< second point of a line; the body is on the left
  double radius = 0.0;                    ///< of an arc, negative for a bore [length]
  base::Span span;
};

enum class ContactType { unilateral, bonded };
enum class Pairing { node, segment };
enum class Recovery { lumped, consistent };

struct Contact {
  std::string name;
  base::FaceSetId slave;
  base::FaceSetId master; ///< invalid where the other surface is `rigid`
  base::RigidId rigid;
  ContactType type = ContactType::unilateral;
  /// Declared normal gap, used exactly instead of the faceted geometry [length]: GAP = +g,
  /// INTERFERENCE = -d, DIAMETRAL = -d/2. Empty: measured from the geometry.
  std::optional<double> gap;
  double mu = 0.0;
  Pairing pairing = Pairing::segment;
  Recovery recovery = Recovery::lumped;
  base::Span span;
};

enum class CrackKind { path, free, front };
enum class CrackState { stress, strain, automatic };

struct Crack {
  std::string name;
  CrackKind kind = CrackKind::path;
  base::NodeSetId path;           ///< ordered nodes: from the mouth (path), of the front (front)
  base::NetId net;                ///< the net a free crack cuts
  std::vector<base::Vec3> points; ///< free crack: from the mouth (or first tip) on
  bool smooth = false;            ///< free crack: a smooth curve through the points
  std::optional<double> angle;    ///< free crack with one point [rad], from +x
  std::optional<double> a0;       ///< first length [length]
  int normal = 1;                 ///< of the plane of a 3D crack: 0 x, 1 y, 2 z
  CrackState state = CrackState::automatic;
  bool faces_in_contact = true;
  double mu = 0.0;
  /// Its lips, "C1.LEFT" and "C1.RIGHT", seen along the crack: empty in the host, filled in the
  /// mesh of each length. One of them stays empty on a symmetry line.
  base::FaceSetId left, right;
  base::Span span;
};

enum class Join { conforming, transition };

/// How the patch round a tip is made; what is empty follows the crack (see mesh/cut/patch.hpp).
struct TipNet {
  base::CrackId crack;
  std::optional<double> radius; ///< of the rosette [length]
  std::optional<double> size;   ///< of the tip elements [length]
  int rings = 5;
  int sectors = 24; ///< of a full circle
  bool quarter_point = true;
  Join join = Join::conforming;
  bool patch = true;
  std::optional<double> tolerance; ///< of K, as a part of it
  double finer = 1.0;              ///< divides the sizes of the patch's elements
  base::Span span;
};

struct Vce {
  base::CrackId crack;
  std::optional<double> shift; ///< finite shift in tip element sizes; empty: analytic derivative
  std::vector<int> domains;    ///< rings that move rigidly, one value of K each; empty: default
  bool opening = false;        ///< K from the opening of the faces beside it, as a check
  base::Span span;
};

struct ApplyLoad {
  base::CaseId load_case;
  double factor = 1.0;
};
struct ApplyFit {
  base::ContactId contact;
  double factor = 1.0;
};
struct Mount {
  base::ContactId contact;
};
struct Dismount {
  base::ContactId contact;
};
using Action = std::variant<ApplyLoad, ApplyFit, Mount, Dismount>;

struct Step {
  std::string name;
  int substeps = 1; ///< 0: as many as the shear of contacts that rub needs
  std::vector<Action> actions;
  base::Span span;
};

/// A straight path through loads and fits: (1 - t) times those at the end of step `from` and t
/// times those of step `to`, t from 0 to `beyond`. Nothing is mounted or dismounted in between.
struct LoadPath {
  std::string name;
  base::StepId from;
  base::StepId to;
  double beyond = 1.0;
  base::Span span;
};

/// A history of places t on a load path; one pass through it is the unit of life.
struct Spectrum {
  std::string name;
  std::size_t path = 0;                      ///< of Model::load_paths
  bool sequence = false;                     ///< turning points; else cycles
  std::vector<std::array<double, 3>> cycles; ///< low t, high t, count
  std::vector<double> turning_points;        ///< t, in their order
  base::Span span;
};

enum class GrowthLaw { increment, paris, walker, forman, nasgro, table };
enum class GrowthDirection { path, hoop, k2_zero };
enum class History { restart, carry_on };
enum class Mounted { each, first };

/// Constants of a growth law as the deck gives them: K in `k_unit`, lengths in `a_unit`.
struct LawConstants {
  double C = 0.0;
  double m = 0.0;
  double p = 0.0;
  double q = 0.0;
  double alpha = 2.0;          ///< constraint factor of NASGRO
  double stress_ratio = 0.3;   ///< largest stress over flow stress, NASGRO
  double threshold = 0.0;      ///< of delta K [stress intensity]
  std::optional<double> k_c;   ///< fracture toughness [stress intensity]; stops the growth
  double k_unit = 1.0;         ///< one KUNIT [stress intensity]
  double a_unit = 1.0;         ///< one AUNIT [length]
  std::vector<double> delta_k; ///< law table: ascending, in KUNIT
  std::vector<double> growth;  ///< [delta_k] da/dN, in AUNIT per cycle
};

struct Growth {
  GrowthLaw law = GrowthLaw::increment;
  GrowthDirection direction = GrowthDirection::path;
  std::vector<base::CrackId> cracks; ///< empty: all
  base::StepId kmax;
  base::StepId kmin;
  std::optional<std::size_t> spectrum; ///< of Model::spectra, in place of the two steps
  History history = History::restart;
  Mounted mounted = Mounted::each;
  std::vector<double> lengths; ///< law increment [length]
  LawConstants constants;
  std::optional<double> largest_advance; ///< of an increment [length]
  std::optional<double> last_length;     ///< stops the growth [length]
  std::optional<double> cycles;          ///< stops the growth; passes of a spectrum
  double tolerance = 1e-3;               ///< of the cycles, as a part of them
  std::optional<double> flow_stress;     ///< of the ligament, whose plastic limit stops the growth
  bool corrected = false;                ///< K with the error bar's bias taken out
  base::Span span;
};

enum class OutputFormat { vtu, csv, json };
enum class OutputEvery { step, increment, end };

struct OutputRequest {
  std::string quantity; ///< U, S, CPRESS, K, REACTION
  std::string name;     ///< set, contact or crack
  base::Span span;
};
struct Output {
  std::string file;
  OutputFormat format = OutputFormat::csv;
  OutputEvery every = OutputEvery::step;
  std::vector<OutputRequest> requests;
  base::Span span;
};

/// One line of $CHECK: `quantity(arguments) = value REL|ABS tolerance SOURCE 'text'`.
struct Check {
  std::string quantity;                                     ///< upper case, "S.XX.MIN"
  std::vector<std::variant<std::string, double>> arguments; ///< names upper case, or numbers
  double value = 0.0;
  double tolerance = 0.0;
  bool relative = true;
  std::string source;
  base::Span span;
};

/// Files of the state of a run; each may be empty.
struct Restart {
  std::string read;
  std::optional<int> at; ///< increment to continue from; empty: the last one
  std::string write;
  int every = 1; ///< increments between states
  base::Span span;
};

/// One $SWEEP card: the parameters that vary together and the values they take, row by row.
struct Sweep {
  std::vector<std::string> parameters;     ///< one, or two with WITH; as the deck writes them
  std::vector<std::vector<double>> values; ///< [row][parameter]
  base::Span span;
};

struct Control {
  int max_iterations = 100;
  double tolerance = 1e-8;
  int threads = 0; ///< 0: as many as there are cores
};

/// A card that is understood but whose analysis this version does not have.
struct Unavailable {
  std::string what;
  base::Span span;
};

struct Model {
  std::string title;
  base::UnitSystem units;
  std::vector<std::pair<std::string, double>> parameters;

  Mesh mesh; ///< the host: without cracks
  std::vector<Net> nets;
  std::vector<Material> materials;
  std::vector<Property> properties;
  std::vector<Freedom> freedoms;
  std::vector<Mpc> mpcs;
  std::vector<LoadCase> cases;
  std::vector<Rigid> rigids;
  std::vector<Contact> contacts;
  std::vector<Crack> cracks;
  std::vector<TipNet> tip_nets; ///< at most one for each crack
  std::vector<Vce> vces;        ///< at most one for each crack
  std::vector<Step> steps;
  std::optional<Growth> growth;
  std::vector<Output> outputs;
  std::vector<Check> checks;
  std::optional<Restart> restart;
  std::vector<Sweep> sweeps; ///< several multiply, the last varies fastest
  Control control;
  std::vector<std::string> tasks; ///< empty: the default chain
  std::vector<Unavailable> unavailable;
  std::vector<std::string> imported_files; ///< paths of what $IMPORT brought in
  std::vector<LoadPath> load_paths;
  std::vector<Spectrum> spectra;
  std::vector<GrowthTest> tests;

  [[nodiscard]] const Property& property_of(const Mesh& m, base::ElementId e) const {
    return properties[m.property[e.index()].index()];
  }
  [[nodiscard]] const Material& material_of(const Mesh& m, base::ElementId e) const {
    return materials[property_of(m, e).material.index()];
  }
};

/// Whether elements hardly change their volume, so that plain displacement elements lock: at
/// nu = 0.49 quadratic ones are still right to some 0.02 %, linear ones 6 % stiff (thick cylinder
/// of MacNeal and Harder, 12 elements through the wall).
inline bool nearly_incompressible(const Material& material, State state, bool quadratic) {
  return state != State::plane_stress && material.nu > (quadratic ? 0.49 : 0.4);
}

/// Whether the mesh is a section through bodies about the axis x = 0; then all of it is.
inline bool axisymmetric(const Model& model) {
  return !model.properties.empty() && model.properties.front().state == State::axisymmetric;
}

} // namespace spricka::model
