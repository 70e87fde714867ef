#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Growth of a plane crack in an infinite body under uniform tension that takes the shape K gives it, to seven digits:
a reference for fronts that are no ellipses, and what they have against ellipses that stay ones.

    tests/bench/free_front.py [A/C M C_END ..]     Paris' law with the exponent M, from the half-axes A/C and 1

Needs numpy. K1 along a front changes with a small advance da by the weight function Z of the crack (Rice 1989,
"Weight function theory for three-dimensional elastic crack analysis", ASTM STP 1020), which itself changes with it
(Rice 1989; Bower and Ortiz 1990, J. Mech. Phys. Solids 38; Lazarus 2003, Int. J. Fract. 122):

    dK(s0)     = dK*(s0)     + 1/(2 pi) PV int Z(s0, s) K(s)     (da(s) - da*(s)) ds
    dZ(s0, s1) = dZ*(s0, s1) + 1/(2 pi) PV int Z(s0, s) Z(s, s1) (da(s) - da*(s)) ds

where * is what the front does when it is moved, turned and made larger (by a part e) as a whole so that s0 (and s1) go
where they go: then dK* = e K/2 and dZ* = -2 e Z. Here a front is a closed curve z(t) in the complex plane with points
evenly spread in its parameter t, and Z = W / (4 sin^2((t - t')/2)) with a smooth W, W = 1/|z'|^2 on the diagonal. The
principal values follow by Fourier's series: those of 1/(4 sin^2) are -pi |k|, those of cot are 2 pi i sgn(k), and the
product of two poles is a sum of single ones. All errors then fall exponentially with the number of points; steps are
Runge and Kutta's fourth-order ones. It begins with a circle, K = 2 sqrt(a/pi) and Z = 1/chord^2, made an ellipse
by pulling its points in, which is compared with Irwin's K (1962) all round.
"""
import sys

import numpy as np

CASES = ((0.5, 3, (1.05, 1.15, 1.5)), (0.5, 4, (1.15, 1.5)), (2 / 3, 3, (1.15,)), (0.2, 3, (1.15,)), (0.2, 4, (1.15,)))
STABLE = 2.0  # of Runge and Kutta's steps: largest rate at which a wave dies times the step; the limit is 2.78


def of_waves(n, factor):
    """The matrix that multiplies each wave exp(i k t) of n values by factor(k)."""
    k = np.fft.fftfreq(n, 1.0 / n)
    by = factor(k)
    if n % 2 == 0 and np.iscomplexobj(by):
        by[n // 2] = 0.0  # an odd factor has no value at the highest wave
    return np.fft.ifft(by[:, None] * np.fft.fft(np.eye(n), axis=0), axis=0).real


class Front:
    """A crack of radius 1 to begin with; z: points, K: at them, W: see above."""

    def __init__(self, n):
        t = 2.0 * np.pi * np.arange(n) / n
        self.absolute = of_waves(n, np.abs)
        self.hilbert = of_waves(n, lambda k: 1j * np.sign(k))
        self.slope = of_waves(n, lambda k: 1j * k)
        off = 0.5 * (t[None, :] - t[:, None])
        np.fill_diagonal(off, 1.0)
        self.cot = 1.0 / np.tan(off)
        np.fill_diagonal(self.cot, 0.0)
        self.z, self.K, self.W = np.exp(1j * t), np.full(n, 2.0 / np.sqrt(np.pi)), np.ones((n, n))

    def copy(self):
        other = Front(len(self.z))
        other.z, other.K, other.W = self.z.copy(), self.K.copy(), self.W.copy()
        return other

    def frame(self, z):
        """|z'| and the outward normals."""
        dz = self.slope @ z
        return np.abs(dz), -1j * dz / np.abs(dz)

    def rates(self, state, V):
        """Of z, K and W when the points move by V (complex, their velocities)."""
        z, K, W = state
        speed, normal = self.frame(z)
        W = 0.5 * (W + W.T)
        np.fill_diagonal(W, 1.0 / speed**2)
        v = (normal.conj() * V).real
        # da - da*, da* a shift by V(s0): nothing of K and Z changes with that
        AK = self.absolute * W * (K * speed)[None, :]
        dK = -0.5 * (AK @ v - V.real * (AK @ normal.real) - V.imag * (AK @ normal.imag))
        # da* = Re(conj(normal) (T + B z)), which takes both points with it; B = e + i times the turn
        apart = z[None, :] - z[:, None]
        np.fill_diagonal(apart, 1.0)
        B = (V[None, :] - V[:, None]) / apart
        np.fill_diagonal(B, 0.0)
        T = V[:, None] - B * z[:, None]
        parts = ((v, 1.0), (normal.real, -T.real), (normal.imag, -T.imag), ((normal.conj() * z).real, -B.real),
                 ((normal.conj() * 1j * z).real, -B.imag))
        AW, HW = self.absolute * W, self.hilbert * W
        double = sum(factor * (AW @ ((speed * f)[:, None] * W)) for f, factor in parts)
        single = sum(factor * (HW @ ((speed * f)[:, None] * W)) for f, factor in parts)
        dW = -0.5 * (double + double.T) - 0.5 * self.cot * (single.T - single) - 2.0 * B.real * W
        return V, dK, dW

    def step(self, h, velocity):
        """On by h; velocity(state) of the points. Returns K at the first one at the four stages."""
        def rate(state):
            return self.rates(state, velocity(state))

        def on(state, by, k):
            return [x + by * d for x, d in zip(state, k)]

        state = [self.z, self.K, self.W]
        states = [state]
        k = [rate(state)]
        for by in (0.5 * h, 0.5 * h, h):
            states.append(on(state, by, k[-1]))
            k.append(rate(states[-1]))
        self.z, self.K, self.W = (x + h / 6.0 * (a + 2.0 * b + 2.0 * c + d) for x, a, b, c, d in zip(state, *k))
        np.fill_diagonal(self.W, 1.0 / self.frame(self.z)[0]**2)
        return np.array([s[1][0] for s in states])


def irwin(a, c, phi):
    """K of an ellipse, stress 1, at its parametric angle from the axis c (a <= c)."""
    t = (np.arange(2000) + 0.5) * np.pi / 4000.0
    E = 0.5 * np.pi * np.mean(np.hypot(np.sin(t), a / c * np.cos(t)))
    return np.sqrt(np.pi * a) / E * (np.sin(phi)**2 + (a / c * np.cos(phi))**2)**0.25


def ellipse(ratio, n, steps):
    """A front with the half-axes 1 and ratio, and the largest error of its K."""
    front = Front(n)
    for _ in range(steps):
        front.step(np.log(ratio) / steps, lambda state: 1j * state[0].imag)
    phi = np.angle(front.z.real + 1j * front.z.imag / ratio)
    return front, np.abs(front.K / irwin(ratio, 1.0, phi) - 1.0).max()


def grown(front, m, last, steps):
    """N until the longer half-axis is `last` (da/dN = K^m), a/c, and how far the front then is within the ellipse."""
    front = front.copy()
    n = len(front.z)
    cycles, c = 0.0, front.z[0].real

    def velocity(state):
        return front.frame(state[0])[1] * (state[1] / state[1][0])**m

    while c < last - 1e-12:
        speed = front.frame(front.z)[0]
        stiff = 0.25 * m * n * ((front.K / front.K[0])**m / speed).max()
        h = min((last - front.z[0].real) / max(1, round(steps * (last - c) / (last - 1.0))), STABLE / stiff, last - c)
        K = front.step(h, velocity)
        cycles += h / 6.0 * (K**-float(m) @ (1.0, 2.0, 2.0, 1.0))
        c += h
    a, c = front.z[n // 4].imag, front.z[0].real
    return cycles, a / c, (1.0 - np.abs(front.z.real / c + 1j * front.z.imag / a)).max()


def ode(a, m, last, steps=400):
    """The same of an ellipse that stays one, by K at the ends of its axes."""
    def rate(y, c):
        K_a, K_c = irwin(y[0], c, 0.5 * np.pi), irwin(y[0], c, 0.0)
        return np.array([(K_a / K_c)**m, K_c**-float(m)])

    h, y = (last - 1.0) / steps, np.array([a, 0.0])
    for i in range(steps):
        c = 1.0 + i * h
        k1 = rate(y, c)
        k2 = rate(y + 0.5 * h * k1, c + 0.5 * h)
        k3 = rate(y + 0.5 * h * k2, c + 0.5 * h)
        y = y + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + rate(y + h * k3, c + h))
    return y[1], y[0] / last


def main():
    cases = CASES
    if len(sys.argv) > 3:
        cases = ((float(sys.argv[1]), int(sys.argv[2]), tuple(float(x) for x in sys.argv[3:])),)
    print(f"{'a/c':>6}{'m':>3}{'c':>6}{'N free':>12}{'a/c':>10}{'within':>9}{'N ellipse':>12}{'a/c':>10}"
          f"{'free':>8}   uncertain: N, a/c; K at first")
    for ratio, m, lasts in cases:
        n = 96 if ratio > 0.35 else 160
        fine, wrong = ellipse(ratio, n, 80)
        coarse, _ = ellipse(ratio, 2 * n // 3, 40)
        for last in lasts:
            N, shape, within = grown(fine, m, last, 60)
            N_coarse, shape_coarse, _ = grown(coarse, m, last, 30)
            N_ellipse, shape_ellipse = ode(ratio, m, last)
            print(f"{ratio:6.3g}{m:3d}{last:6.3g}{N:12.7f}{shape:10.6f}{100 * within:7.2f} %{N_ellipse:12.7f}"
                  f"{shape_ellipse:10.6f}{100 * (N / N_ellipse - 1):+7.2f} %   {abs(N / N_coarse - 1):.0e}, "
                  f"{abs(shape / shape_coarse - 1):.0e}; {wrong:.0e}")


if __name__ == "__main__":
    main()
