// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_front.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace spricka::test {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int steps_of_move = 3;
constexpr int steps_to_flatten = 12;
/// Places between two points at which K is looked up.
constexpr int looks = 64;

Eigen::VectorXd real(const Eigen::VectorXcd& z) {
  return z.real();
}
Eigen::VectorXd imag(const Eigen::VectorXcd& z) {
  return z.imag();
}

} // namespace

ExactFront::ExactFront(int points) {
  const Eigen::Index n = points;
  absolute_ = hilbert_ = slope_ = cot_ = Eigen::MatrixXd::Zero(n, n);
  now_ = {.z = Places(n),
          .K = Eigen::VectorXd::Constant(n, 2.0 / std::sqrt(pi)),
          .W = Eigen::MatrixXd::Ones(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    now_.z[i] = std::polar(1.0, 2.0 * pi * static_cast<double>(i) / points);
    for (Eigen::Index j = 0; j < n; ++j) {
      const double off = 2.0 * pi * static_cast<double>(i - j) / points;
      for (int k = 1; k <= points / 2; ++k) {
        const bool highest = 2 * k == points;
        absolute_(i, j) += (highest ? 1.0 : 2.0) / points * k * std::cos(k * off);
        hilbert_(i, j) -= (highest ? 0.0 : 2.0) / points * std::sin(k * off);
        slope_(i, j) -= (highest ? 0.0 : 2.0) / points * k * std::sin(k * off);
      }
      cot_(i, j) = i == j ? 0.0 : -1.0 / std::tan(0.5 * off);
    }
  }
}

ExactFront::State ExactFront::rates(const State& at, const Places& velocity) const {
  const Eigen::Index n = at.z.size();
  const Places dz = slope_ * at.z;
  const Eigen::VectorXd speed = dz.cwiseAbs();
  const Places normal = Complex(0.0, -1.0) * dz.cwiseQuotient(speed.cast<Complex>());
  const Eigen::VectorXd v = real(normal.conjugate().cwiseProduct(velocity));
  Eigen::MatrixXd W = 0.5 * (at.W + at.W.transpose());
  W.diagonal() = speed.cwiseAbs2().cwiseInverse();
  const Eigen::MatrixXd AW = absolute_.cwiseProduct(W);
  const Eigen::MatrixXd HW = hilbert_.cwiseProduct(W);
  const Eigen::VectorXd weight = at.K.cwiseProduct(speed);
  State rate{.z = velocity, .K = {}, .W = {}};
  rate.K = -0.5 * (AW * weight.cwiseProduct(v) -
                   real(velocity).cwiseProduct(AW * weight.cwiseProduct(real(normal))) -
                   imag(velocity).cwiseProduct(AW * weight.cwiseProduct(imag(normal))));
  Eigen::MatrixXcd turn = Eigen::MatrixXcd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      turn(i, j) = i == j ? Complex(0.0) : (velocity[j] - velocity[i]) / (at.z[j] - at.z[i]);
    }
  }
  const Eigen::MatrixXcd shift = velocity.replicate(1, n) - turn.cwiseProduct(at.z.replicate(1, n));
  const Places across = normal.conjugate().cwiseProduct(at.z);
  const std::array<Eigen::VectorXd, 5> part{v, real(normal), imag(normal), real(across),
                                            -imag(across)};
  const std::array<Eigen::MatrixXd, 5> factor{Eigen::MatrixXd::Ones(n, n), -shift.real(),
                                              -shift.imag(), -turn.real(), -turn.imag()};
  Eigen::MatrixXd twice = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd once = twice;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Eigen::MatrixXd right = speed.cwiseProduct(part[k]).asDiagonal() * W;
    twice += factor[k].cwiseProduct(AW * right);
    once += factor[k].cwiseProduct(HW * right);
  }
  rate.W = -0.5 * (twice + twice.transpose()) - 0.5 * cot_.cwiseProduct(once.transpose() - once) -
           2.0 * turn.real().cwiseProduct(W);
  return rate;
}

template <class Velocity> void ExactFront::step(double h, const Velocity& velocity) {
  const auto on = [this](double by, const State& rate) {
    return State{now_.z + by * rate.z, now_.K + by * rate.K, now_.W + by * rate.W};
  };
  const auto rate = [&](const State& at) { return rates(at, velocity(at)); };
  const State k1 = rate(now_);
  const State k2 = rate(on(0.5 * h, k1));
  const State k3 = rate(on(0.5 * h, k2));
  const State k4 = rate(on(h, k3));
  now_.z += h / 6.0 * (k1.z + 2.0 * k2.z + 2.0 * k3.z + k4.z);
  now_.K += h / 6.0 * (k1.K + 2.0 * k2.K + 2.0 * k3.K + k4.K);
  now_.W += h / 6.0 * (k1.W + 2.0 * k2.W + 2.0 * k3.W + k4.W);
}

void ExactFront::flatten(double ratio) {
  for (int i = 0; i < steps_to_flatten; ++i) {
    step(std::log(ratio) / steps_to_flatten,
         [](const State& at) { return Places(Complex(0.0, 1.0) * at.z.imag().cast<Complex>()); });
  }
}

void ExactFront::move_to(const mesh::FrontCurve& curve) {
  const Eigen::Index n = now_.z.size();
  Places way(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const base::Vec3 x(now_.z[i].real(), now_.z[i].imag(), 0.0);
    const base::Vec3 to = curve.at(curve.nearest_length(x)).x;
    way[i] = Complex(to.x(), to.y()) - now_.z[i];
  }
  // A spline's third derivative jumps: without the waves that the points hardly show.
  Places smooth = Places::Zero(n);
  for (Eigen::Index k = -n / 3; k <= n / 3; ++k) {
    Places wave(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      wave[i] = std::polar(1.0, 2.0 * pi * static_cast<double>(k * i) / static_cast<double>(n));
    }
    smooth += wave * (wave.dot(way) / static_cast<double>(n));
  }
  for (int i = 0; i < steps_of_move; ++i) {
    step(1.0 / steps_of_move, [&](const State&) { return smooth; });
  }
}

double ExactFront::K_at(const base::Vec3& x) const {
  const Eigen::Index n = now_.z.size();
  Eigen::Index near = 0;
  (now_.z.array() - Complex(x.x(), x.y())).abs().minCoeff(&near);
  double least = std::numeric_limits<double>::infinity();
  double K = 0.0;
  for (int look = -looks; look <= looks; ++look) {
    // Fourier's series through all points, at a place between two.
    Complex z = 0.0;
    double here = 0.0;
    const double place = static_cast<double>(near) + static_cast<double>(look) / looks;
    for (Eigen::Index j = 0; j < n; ++j) {
      const double off = pi * (place - static_cast<double>(j)) / static_cast<double>(n);
      const double weight =
          std::abs(std::sin(off)) < 1e-12
              ? 1.0
              : std::sin(static_cast<double>(n) * off) / std::tan(off) / static_cast<double>(n);
      z += weight * now_.z[j];
      here += weight * now_.K[j];
    }
    if (std::abs(z - Complex(x.x(), x.y())) < least) {
      least = std::abs(z - Complex(x.x(), x.y()));
      K = here;
    }
  }
  return K;
}

} // namespace spricka::test
