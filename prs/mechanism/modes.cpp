#include "prs/mechanism/modes.h"

#include <Spectra/MatOp/SparseCholesky.h>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsSolver.h>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "prs/indices.h"
#include "prs/mechanism/full_structure.h"
#include "prs/mechanism/linearised.h"
#include "prs/threads/kinematics.h"

namespace prs {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using fe::Dof;
using Sparse = Eigen::SparseMatrix<double>;

enum class Share { screw, roller, nut, masses };

struct Freedom {
  int node = 0;
  Dof dof = Dof::u;
};

/// Quadratic form 1/2 q'matrix q over some freedoms of nodes: of mass or of prestress.
struct Quadratic {
  Share share;
  std::vector<Freedom> freedoms;
  MatrixXd matrix;
};

Eigen::Matrix4d hermite(double a, double b, double c, double d, double e, double f, double l) {
  Eigen::Matrix4d m;
  m << a, b * l, c, d * l, b * l, e * l * l, -d * l, f * l * l, c, -d * l, a, -b * l, d * l, f * l * l, -b * l,
      e * l * l;
  return m;
}

/// Mass of a beam in bending over displacements and rotations: cubic shapes (Przemieniecki 1968, chapter 11).
Eigen::Matrix4d bending_mass(double per_length, double rotary, double l) {
  return per_length * l / 420.0 * hermite(156.0, 22.0, 54.0, -13.0, 4.0, -3.0, l) +
         rotary / (30.0 * l) * hermite(36.0, 3.0, -36.0, 3.0, 4.0, -1.0, l);
}
Eigen::Matrix4d prestress_of(double tension, double l) {
  return tension / (30.0 * l) * hermite(36.0, 3.0, -36.0, 3.0, 4.0, -1.0, l);
}

/// Matrices of the vibrating mechanism.
class Vibration {
 public:
  Vibration(const Vibrating& v, const Modes& wanted) : v_(v), wanted_(wanted), f_(v.model) {
    std::erase_if(f_.present, [&](const FullModel::Roller& r) { return contains(v.loads.idle_rollers, r.number); });
    if (wanted.axial_support.at != AxialSupport::At::nut) f_.housing.axial = 0.0;
    s_ = full_structure(f_, mesh());
    for (fe::Constraint& c : s_.model.constraints) c.offset = 0.0;
    for (fe::ElasticLink& l : s_.model.elastic_links) l.rest = 0.0;
    hold_screw();
    if (v.structure.screw.drive) add_drive(*v.structure.screw.drive);
    for (const auto k : indices(s_.rollers)) add_roller(k);
    add_body(s_.screw, f_.screw, Share::screw);
    add_body(s_.nut, f_.nut, Share::nut);
    for (const ExtraMass& m : v.structure.masses) add_mass(m);
    const Linearised linear = linearised(f_, v.loads);
    tangents_ = linear.tangent;
    equations_.emplace(s_.model);
    set_matrices();
  }

  ModesResult solve() const;

 private:
  const Material& material(Share s) const {
    return v_.materials[s == Share::screw ? Part::screw : s == Share::nut ? Part::nut : Part::roller];
  }

  FullMesh mesh() const {
    FullMesh m;
    m.longest = 2.0 * f_.sector.roller_radius;
    for (const FullModel::Roller& r : v_.model.present)
      for (std::vector<double>* of : {&m.screw, &m.nut}) of->insert(of->end(), r.contact_x.begin(), r.contact_x.end());
    for (const BodyPiece& p : f_.nut) m.nut.insert(m.nut.end(), {p.from, p.to});
    for (const ExtraMass& x : v_.structure.masses)
      (x.carrier == ExtraMass::Carrier::screw ? m.screw : m.nut).push_back(x.position);
    if (v_.structure.screw.drive) m.screw.push_back(v_.structure.screw.drive->position);
    return m;
  }
  const SpatialNode& at(const std::vector<SpatialNode>& nodes, double x) const {
    return *std::ranges::min_element(nodes, {}, [&](const SpatialNode& n) { return std::abs(n.x - x); });
  }

  void hold_screw() {
    const AxialSupport& a = wanted_.axial_support;
    const int node = item_at(s_.screw, s_.loaded).y_plane;
    if (a.at == AxialSupport::At::screw) s_.model.constraints.push_back({node, Dof::u, {}, 0.0});
    if (a.at == AxialSupport::At::screw_spring)
      s_.model.elastic_links.push_back({{{node, Dof::u, 1.0}}, 0.0, a.stiffness});
  }

  /// Adds a drive; the twist of the screw is u of separate nodes.
  void add_drive(const Drive& drive) {
    const Material& steel = material(Share::screw);
    const double shear = steel.youngs_modulus / (2.0 * (1.0 + steel.poisson_ratio));
    for (const auto i : indices(s_.screw)) {
      twist_.push_back(s_.model.add_node());
      if (i == 0) continue;
      const double l = s_.screw[i].x - s_.screw[i - 1].x;
      const double polar =
          2.0 * section_at(f_.screw, 0.5 * (s_.screw[i].x + s_.screw[i - 1].x)).bending / steel.youngs_modulus;
      s_.model.bars.push_back({twist_[i - 1], twist_[i], {shear * polar, l}});
      const double mass = *steel.density * polar * l / 6.0;
      masses_.push_back({Share::screw,
                         {{twist_[i - 1], Dof::u}, {twist_[i], Dof::u}},
                         Eigen::Matrix2d{{2.0 * mass, mass}, {mass, 2.0 * mass}}});
    }
    const int held = twist_at(drive.position);
    if (drive.stiffness == kRigid)
      s_.model.fixed_supports.push_back({held, Dof::u});
    else
      s_.model.elastic_supports.push_back({held, Dof::u, drive.stiffness});
    add_point(Share::masses, {{held, Dof::u}}, VectorXd::Ones(1), drive.inertia);

    const Interface along = sliding_interface(v_.mechanism.type);
    const double advance = v_.mechanism.lead / (2.0 * std::numbers::pi);
    const double epsilon = v_.slip_ratio;
    const double gear = static_cast<double>(v_.mechanism.starts.screw) / v_.mechanism.starts.roller;
    const double spin = epsilon + gear * (along == Interface::screw ? -epsilon : epsilon - 1.0);
    const double orbit = epsilon * f_.centre_distance;
    const double inertia = (roller_mass() * orbit * orbit + roller_inertia() * spin * spin) / f_.threads();
    for (const auto r : indices(s_.rollers))
      for (const auto k : indices(f_.present[r].contact_x)) {
        const int node = twist_at(f_.present[r].contact_x[k]);
        item_at(s_.model.form_springs, s_.rollers[r].spring(along, k))
            .approach.push_back({node, Dof::u, -f_.sense() * f_.sector.cosine[along] * advance});
        add_point(Share::roller, {{node, Dof::u}}, VectorXd::Ones(1), inertia);
      }
  }
  int twist_at(double x) const { return item_at(twist_, &at(s_.screw, x) - s_.screw.data()); }

  /// Integral of a rigidity times density/E over a roller, by length of threads and ends.
  double over_roller(double threads, double ends) const {
    const double length = f_.roller_ends.last - f_.roller_ends.first - 2.0 * f_.sector.end_length;
    const Material& steel = material(Share::roller);
    return *steel.density / steel.youngs_modulus * (threads * length + 2.0 * ends * f_.sector.end_length);
  }
  double roller_mass() const { return over_roller(f_.sector.thread.axial, f_.sector.end.axial); }
  double roller_inertia() const { return 2.0 * over_roller(f_.sector.thread.bending, f_.sector.end.bending); }

  /// Adds mass (form q)^2.
  void add_point(Share share, std::vector<Freedom> freedoms, const VectorXd& form, double mass) {
    if (mass > 0.0) masses_.push_back({share, std::move(freedoms), mass * form * form.transpose()});
  }

  /// Adds a bar and a beam in one plane, with mass and prestress.
  void add_piece(Share share, int first, int second, double l, const RollerSection<double>& section, double tension,
                 bool has_bar) {
    const Material& steel = material(share);
    const double per_stiffness = *steel.density / steel.youngs_modulus;
    const double per_length = per_stiffness * section.axial;
    if (has_bar) {
      const double sixth = per_length * l / 6.0;
      masses_.push_back(
          {share, {{first, Dof::u}, {second, Dof::u}}, Eigen::Matrix2d{{2.0 * sixth, sixth}, {sixth, 2.0 * sixth}}});
    }
    const std::vector<Freedom> bending{{first, Dof::v}, {first, Dof::theta}, {second, Dof::v}, {second, Dof::theta}};
    masses_.push_back({share, bending, bending_mass(per_length, per_stiffness * section.bending, l)});
    if (wanted_.prestress && tension != 0.0) prestress_.push_back({share, bending, prestress_of(tension, l)});
  }

  /// Force along x on the threads of a part of the model, before x [N].
  double pushed_before(double x, const std::function<double(std::size_t, std::size_t)>& force) const {
    double sum = 0.0;
    for (const auto r : indices(f_.present))
      for (const auto k : indices(f_.present[r].contact_x))
        if (f_.present[r].contact_x[k] < x) sum += force(r, k);
    return sum;
  }
  double axial_load(Interface i, std::size_t r, std::size_t k) const {
    return f_.sense() * f_.sector.cosine[i] * item_at(v_.loads.normal_load[i], f_.present[r].number)[k];
  }
  double tension_at(Share share, double x) const {
    if (!wanted_.prestress) return 0.0;
    const double load = f_.sense() * f_.axial_force;
    if (share == Share::screw)
      return -load + pushed_before(x, [&](std::size_t r, std::size_t k) { return axial_load(Interface::screw, r, k); });
    return (x > f_.thrust ? load : 0.0) -
           pushed_before(x, [&](std::size_t r, std::size_t k) { return axial_load(Interface::nut, r, k); });
  }

  void add_body(const std::vector<SpatialNode>& nodes, const std::vector<BodyPiece>& pieces, Share share) {
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const SpatialNode &a = nodes[i - 1], &b = nodes[i];
      const double middle = 0.5 * (a.x + b.x), l = b.x - a.x;
      const RollerSection<double>& section = section_at(pieces, middle);
      const double tension = tension_at(share, middle);
      add_piece(share, a.y_plane, b.y_plane, l, section, tension, true);
      add_piece(share, a.z_plane, b.z_plane, l, section, tension, false);
    }
  }

  void add_roller(std::size_t k) {
    const FullStructure::Roller& r = s_.rollers[k];
    const double first = f_.roller_ends.first + f_.sector.end_length;
    const double last = f_.roller_ends.last - f_.sector.end_length;
    for (std::size_t i = 1; i < r.nodes.size(); ++i) {
      const double middle = 0.5 * (r.x[i - 1] + r.x[i]);
      double tension = 0.0;
      for (std::size_t t = 0; wanted_.prestress && t < f_.present[k].contact_x.size(); ++t)
        if (f_.present[k].contact_x[t] < middle)
          tension += axial_load(Interface::nut, k, t) - axial_load(Interface::screw, k, t);
      const bool end = middle < first || middle > last;
      add_piece(Share::roller, r.nodes[i - 1], r.nodes[i], r.x[i] - r.x[i - 1], end ? f_.sector.end : f_.sector.thread,
                tension, true);
    }
    const double azimuth = f_.present[k].azimuth;
    for (const auto ring : up_to(2)) {
      std::vector<Freedom> freedoms;
      if (const SpatialNode* seat = s_.seats[ring])
        freedoms.insert(freedoms.end(), {{seat->y_plane, Dof::v}, {seat->z_plane, Dof::v}});
      if (const int offset = s_.rings[ring]; offset >= 0)
        freedoms.insert(freedoms.end(), {{offset, Dof::u}, {offset, Dof::v}});
      VectorXd across(static_cast<Index>(freedoms.size()));
      for (Index i = 0; i < across.size(); ++i) across[i] = i % 2 == 0 ? -std::sin(azimuth) : std::cos(azimuth);
      add_point(Share::roller, freedoms, across, freedoms.empty() ? 0.0 : 0.5 * roller_mass());
    }
  }

  void add_mass(const ExtraMass& m) {
    const bool screw = m.carrier == ExtraMass::Carrier::screw;
    const SpatialNode& n = at(screw ? s_.screw : s_.nut, m.position);
    std::vector<Freedom> freedoms{{n.y_plane, Dof::u},
                                  {n.y_plane, Dof::v},
                                  {n.y_plane, Dof::theta},
                                  {n.z_plane, Dof::v},
                                  {n.z_plane, Dof::theta}};
    const bool twists = screw && !twist_.empty();
    if (twists) freedoms.push_back({twist_at(m.position), Dof::u});
    const auto point = [&](std::initializer_list<double> form, double mass) {
      const Eigen::Map<const VectorXd> all(form.begin(), 6);
      add_point(Share::masses, freedoms, all.head(twists ? 6 : 5), mass);
    };
    const Spatial& c = m.centre;
    point({1.0, 0.0, -c.y, 0.0, -c.z, 0.0}, m.mass);
    point({0.0, 1.0, c.x, 0.0, 0.0, -c.z}, m.mass);
    point({0.0, 0.0, 0.0, 1.0, c.x, c.y}, m.mass);
    if (twists) point({0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, m.inertia.x);
    point({0.0, 0.0, 0.0, 0.0, 1.0, 0.0}, m.inertia.y);
    point({0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, m.inertia.z);
  }

  void add_to(std::vector<Eigen::Triplet<double>>& entries, const Quadratic& q) const {
    std::vector<fe::NodalLoad> of(1);
    std::vector<std::vector<std::pair<int, double>>> terms(q.freedoms.size());
    for (const auto i : indices(terms)) {
      of[0] = {q.freedoms[i].node, q.freedoms[i].dof, 1.0};
      equations_->for_each_load(of, [&](int equation, double c) { terms[i].emplace_back(equation, c); });
    }
    for (const auto i : indices(terms))
      for (const auto j : indices(terms))
        for (const auto& [a, c] : terms[i])
          for (const auto& [b, d] : terms[j])
            if (a >= b) entries.emplace_back(a, b, c * d * q.matrix(static_cast<Index>(i), static_cast<Index>(j)));
  }

  /// Sets lower triangles, in units of each freedom that make the diagonal of K one.
  void set_matrices() {
    const int size = equations_->size();
    fe::SparseSymmetric tangent = equations_->linear_stiffness();
    equations_->secant_stiffness(tangents_, tangent);
    std::vector<Eigen::Triplet<double>> of_mass, of_stiffness;
    for (int j = 0; j < size; ++j)
      for (int k = fe::at(tangent.column_start, j); k < fe::at(tangent.column_start, j + 1); ++k)
        of_stiffness.emplace_back(j, fe::at(tangent.row, k), fe::at(tangent.value, k));
    for (const Quadratic& q : masses_) add_to(of_mass, q);
    for (const Quadratic& q : prestress_) add_to(of_stiffness, q);
    mass_.resize(size, size);
    stiffness_.resize(size, size);
    mass_.setFromTriplets(of_mass.begin(), of_mass.end());
    stiffness_.setFromTriplets(of_stiffness.begin(), of_stiffness.end());
    unit_ = stiffness_.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    mass_ = unit_.asDiagonal() * mass_ * unit_.asDiagonal();
    stiffness_ = unit_.asDiagonal() * stiffness_ * unit_.asDiagonal();
  }

  /// Computes the vectors of the largest 1/(omega^2 + shift).
  bool lowest(int count, double shift, MatrixXd& vectors) const;
  /// Number of omega^2 below a value, by the signs of a triangular factorization (Sylvester).
  Index modes_below(double square) const {
    const Eigen::SimplicialLDLT<Sparse> ldl(stiffness_ - square * mass_);
    return ldl.info() == Eigen::Success ? (ldl.vectorD().array() < 0.0).count() : 0;
  }
  Eigen::Matrix<double, Eigen::Dynamic, 3> rigid() const;
  Mode mode_of(const VectorXd& phi, double& square) const;

  const Vibrating& v_;
  const Modes& wanted_;
  FullModel f_;
  FullStructure s_;
  std::vector<int> twist_;  ///< Node of the twist at each node of the screw, with a drive.
  std::vector<double> tangents_;
  std::vector<Quadratic> masses_, prestress_;
  std::optional<fe::Equations> equations_;
  Sparse mass_, stiffness_;
  VectorXd unit_;
};

bool Vibration::lowest(int count, double shift, MatrixXd& vectors) const {
  const Sparse k = shift > 0.0 ? Sparse(stiffness_ + shift * mass_) : stiffness_;
  const auto size = static_cast<int>(k.rows());
  const int basis = std::max(2 * count + 1, count + 20);
  if (basis >= size) {
    const auto dense_of = [](const Sparse& lower) { return MatrixXd(MatrixXd(lower).selfadjointView<Eigen::Lower>()); };
    const MatrixXd full = dense_of(k);
    if (Eigen::LLT<MatrixXd>(full).info() != Eigen::Success) return false;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> dense(dense_of(mass_), full);
    vectors = dense.eigenvectors().rowwise().reverse().leftCols(std::min(count, size));
    return dense.info() == Eigen::Success;
  }
  Spectra::SparseSymMatProd<double> m(mass_);
  Spectra::SparseCholesky<double> factor(k);
  if (factor.info() != Spectra::CompInfo::Successful) return false;
  Spectra::SymGEigsSolver<Spectra::SparseSymMatProd<double>, Spectra::SparseCholesky<double>,
                          Spectra::GEigsMode::Cholesky>
      solver(m, factor, count, basis);
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, 1000, 1e-13);
  vectors = solver.eigenvectors();
  return vectors.cols() == count;
}

/// Unit displacements of all nodes, on every freedom.
Eigen::Matrix<double, Eigen::Dynamic, 3> Vibration::rigid() const {
  Eigen::Matrix<double, Eigen::Dynamic, 3> r =
      Eigen::Matrix<double, Eigen::Dynamic, 3>::Zero(fe::kDofsPerNode * s_.model.nodes, 3);
  const auto row = [](int node, Dof dof) { return fe::kDofsPerNode * node + static_cast<int>(dof); };
  for (const auto* body : {&s_.screw, &s_.nut})
    for (const SpatialNode& n : *body) {
      r(row(n.y_plane, Dof::u), 0) = 1.0;
      r(row(n.y_plane, Dof::v), 1) = 1.0;
      r(row(n.z_plane, Dof::v), 2) = 1.0;
    }
  for (const auto k : indices(s_.rollers))
    for (const int node : s_.rollers[k].nodes) {
      r(row(node, Dof::u), 0) = 1.0;
      r(row(node, Dof::v), 1) = std::cos(f_.present[k].azimuth);
      r(row(node, Dof::v), 2) = std::sin(f_.present[k].azimuth);
    }
  return r;
}

Mode Vibration::mode_of(const VectorXd& vector, double& square) const {
  const fe::State q(VectorXd(unit_.cwiseProduct(vector)));
  const auto at = [&](int node, Dof dof) { return equations_->displacement(q, node, dof); };
  const auto of_form = [&](const fe::LinearForm& form) {
    double sum = 0.0;
    for (const fe::Term& t : form) sum += t.coefficient * at(t.node, t.dof);
    return sum;
  };
  const auto values = [&](const Quadratic& k) {
    VectorXd x(static_cast<Index>(k.freedoms.size()));
    for (Index i = 0; i < x.size(); ++i) x[i] = at(item_at(k.freedoms, i).node, item_at(k.freedoms, i).dof);
    return x;
  };
  Mode mode;
  std::array<double, 4> kinetic{}, strain{};
  const Eigen::Matrix<double, Eigen::Dynamic, 3> r = rigid();
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (const Quadratic& m : masses_) {
    const VectorXd force = m.matrix * values(m);
    item_at(kinetic, m.share) += values(m).dot(force);
    for (Index i = 0; i < force.size(); ++i) {
      const Freedom& freedom = item_at(m.freedoms, i);
      moved += force[i] * r.row(fe::kDofsPerNode * freedom.node + static_cast<int>(freedom.dof)).transpose();
    }
  }
  const double mass = kinetic[0] + kinetic[1] + kinetic[2] + kinetic[3];
  mode.effective_mass = moved.cwiseAbs2() / mass;

  const int of_nut = s_.nut.front().y_plane, of_rollers = s_.rollers.front().nodes.front();
  for (const fe::BeamElement& b : s_.model.beams) {
    const std::array<double, 6> x{at(b.first, Dof::u),  at(b.first, Dof::v),  at(b.first, Dof::theta),
                                  at(b.second, Dof::u), at(b.second, Dof::v), at(b.second, Dof::theta)};
    const fe::BeamVector<double> force = fe::end_forces<double>(b.beam, {x[3] - x[0], x[4] - x[1], x[2], x[5]});
    const int node = std::max(b.first, b.second);
    const Share share = node < of_nut ? Share::screw : node < of_rollers ? Share::nut : Share::roller;
    item_at(strain, share) += force.dot(Eigen::Map<const fe::BeamVector<double>>(x.data()));
  }
  for (const fe::BarElement& b : s_.model.bars) {
    const double twist = at(b.second, Dof::u) - at(b.first, Dof::u);
    item_at(strain, Share::screw) += b.bar.stiffness() * twist * twist;
  }
  for (const FullStructure::Roller& roller : s_.rollers)
    for (const Interface i : kInterfaces)
      for (const auto k : indices(roller.contacts[i])) {
        const auto spring = static_cast<std::size_t>(roller.spring(i, k));
        const double w = of_form(s_.model.form_springs[spring].approach);
        mode.contact_strain[i] += tangents_[spring] * w * w;
      }
  for (const FullStructure::Guide& guide : s_.guides)
    if (guide.stop >= 0) {
      const auto stop = static_cast<std::size_t>(guide.stop);
      const double w = of_form(s_.model.form_springs[stop].approach);
      mode.support_strain += (tangents_[stop] + tangents_[stop + 1]) * w * w;
    }
  for (const fe::ElasticLink& link : s_.model.elastic_links) {
    const double stretch = of_form(link.form);
    mode.support_strain += link.stiffness * stretch * stretch;
  }
  for (const fe::ElasticSupport& support : s_.model.elastic_supports)
    mode.support_strain += support.stiffness * std::pow(at(support.node, support.dof), 2);
  for (const Quadratic& p : prestress_) mode.prestress += values(p).dot(p.matrix * values(p));
  const double all = strain[0] + strain[1] + strain[2] + mode.contact_strain.screw + mode.contact_strain.nut +
                     mode.support_strain + mode.prestress;
  square = all / mass;
  mode.frequency = std::sqrt(std::max(square, 0.0)) / (2.0 * std::numbers::pi);
  for (const Share s : {Share::screw, Share::roller, Share::nut}) {
    const Part part = s == Share::screw ? Part::screw : s == Share::nut ? Part::nut : Part::roller;
    mode.kinetic[part] = item_at(kinetic, s) / mass;
    mode.strain[part] = item_at(strain, s) / all;
  }
  mode.kinetic_of_masses = item_at(kinetic, Share::masses) / mass;
  for (const Interface i : kInterfaces) mode.contact_strain[i] /= all;
  mode.support_strain /= all;
  mode.prestress /= all;

  double largest = 0.0;
  const auto noted = [&](double value) {
    if (std::abs(value) > std::abs(largest)) largest = value;
    return value;
  };
  for (const Interface i : kInterfaces)
    for (const SpatialNode& n : i == Interface::screw ? s_.screw : s_.nut)
      mode.shape[i].push_back(
          {noted(at(n.y_plane, Dof::u)), noted(at(n.y_plane, Dof::v)), noted(at(n.z_plane, Dof::v))});
  mode.axial.assign(static_cast<std::size_t>(f_.rollers), 0.0);
  mode.radial = mode.axial;
  const double middle = 0.5 * (f_.roller_ends.first + f_.roller_ends.last);
  for (const auto k : indices(s_.rollers)) {
    const FullStructure::Roller& roller = s_.rollers[k];
    const auto next = std::upper_bound(roller.x.begin() + 1, roller.x.end() - 1, middle);
    const auto i = static_cast<std::size_t>(next - roller.x.begin());
    const int a = roller.nodes[i - 1], b = roller.nodes[i];
    const double l = roller.x[i] - roller.x[i - 1], t = (middle - roller.x[i - 1]) / l;
    const auto number = static_cast<std::size_t>(f_.present[k].number);
    mode.axial[number] = noted((1.0 - t) * at(a, Dof::u) + t * at(b, Dof::u));
    mode.radial[number] = noted(
        (1.0 - 3.0 * t * t + 2.0 * t * t * t) * at(a, Dof::v) + (t - 2.0 * t * t + t * t * t) * l * at(a, Dof::theta) +
        (3.0 * t * t - 2.0 * t * t * t) * at(b, Dof::v) + (t * t * t - t * t) * l * at(b, Dof::theta));
  }
  for (const Interface i : kInterfaces)
    for (std::vector<double>& point : mode.shape[i])
      for (double& value : point) value /= largest;
  for (std::vector<double>* list : {&mode.axial, &mode.radial})
    for (double& value : *list) value /= largest;
  return mode;
}

ModesResult Vibration::solve() const {
  ModesResult result;
  result.freedoms = equations_->size();
  result.prestressed = wanted_.prestress;
  result.orders = motion_orders(v_.mechanism, v_.slip_ratio);
  std::erase_if(result.orders, [](const MotionOrder& o) { return !(o.order > 0.0); });
  for (const int r : v_.loads.idle_rollers) result.idle_rollers.push_back(r + 1);
  for (const Interface i : kInterfaces)
    for (const SpatialNode& n : i == Interface::screw ? s_.screw : s_.nut) result.x[i].push_back(n.x);
  const Eigen::Matrix<double, Eigen::Dynamic, 3> r = rigid();
  for (const Quadratic& m : masses_) {
    Eigen::Matrix<double, Eigen::Dynamic, 3> own(m.matrix.rows(), 3);
    for (Index i = 0; i < own.rows(); ++i) {
      const Freedom& freedom = item_at(m.freedoms, i);
      own.row(i) = r.row(fe::kDofsPerNode * freedom.node + static_cast<int>(freedom.dof));
    }
    result.mass += (own.transpose() * m.matrix * own).diagonal();
  }
  const int most = std::min(wanted_.count, result.freedoms);
  const double unit = 1e-9 * stiffness_.diagonal().sum() / std::max(mass_.diagonal().sum(), 1e-300);
  // A buckled screw has modes with omega^2 < 0, which a shift moves above 0. Lanczos' method may find only one of two
  // modes of equal frequency: the missing number is then searched again.
  constexpr int kMostBuckled = 6, kMostTries = 6;
  double shift = 0.0;
  for (int extra = 0, tries = 0; tries < kMostTries; ++tries) {
    MatrixXd vectors;
    while (!lowest(std::min(most + extra, result.freedoms), shift, vectors)) {
      shift = shift == 0.0 ? unit : 100.0 * shift;
      extra = std::max(extra, kMostBuckled);
      if (shift > 1e12 * unit) {
        result.left_out = "the eigenvalue problem has no solution to rounding";
        return result;
      }
    }
    result.modes.clear();
    result.buckled = 0;
    for (Index k = 0; k < vectors.cols(); ++k) {
      double square = 0.0;
      Mode mode = mode_of(vectors.col(k), square);
      if (square > 0.0)
        result.modes.push_back(std::move(mode));
      else
        ++result.buckled;
    }
    std::ranges::sort(result.modes, {}, &Mode::frequency);
    if (static_cast<int>(result.modes.size()) > most) result.modes.resize(static_cast<std::size_t>(most));
    if (result.modes.empty() || vectors.cols() == result.freedoms) break;
    const double last = 2.0 * std::numbers::pi * result.modes.back().frequency * (1.0 - 1e-7);
    const auto found =
        std::ranges::count_if(result.modes, [&](const Mode& m) { return 2.0 * std::numbers::pi * m.frequency < last; });
    const auto missing = modes_below(last * last) - result.buckled - found;
    if (missing <= 0) break;
    extra += static_cast<int>(missing) + 2;
  }
  return result;
}

}  // namespace

ModesResult modes(const Vibrating& v, const Modes& wanted) { return Vibration(v, wanted).solve(); }

}  // namespace prs
