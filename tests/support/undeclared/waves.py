"""Waves in closed form for make_waves.py, in mm, s, kPa and kg; with e^(i w t) for time, so that waves run and die along
e^(-i k . x). A body is seen at `points` (a row each); every function gives the displacement there, three components."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu
from scipy.special import spherical_jn, spherical_yn

DENSITY = 1e-6


def directions(rng, count):
    d = rng.normal(size=(count, 3))
    return d / np.linalg.norm(d, axis=1)[:, None]


def amplitudes(rng, count):
    return rng.normal(size=count) + 1j * rng.normal(size=count)


def wavenumber(omega, modulus):
    return np.sqrt(DENSITY * omega ** 2 / (modulus + 0j))


def plane_waves(points, omega, modulus, rng, count=14):
    """Shear waves from all sides, each polarised across its way."""
    field = np.zeros((len(points), 3), complex)
    k = wavenumber(omega, modulus)
    for d, a in zip(directions(rng, count), amplitudes(rng, count)):
        m = np.cross(d, directions(rng, 1)[0])
        field += a * m / np.linalg.norm(m) * np.exp(-1j * k * (points @ d))[:, None]
    return field


def fibre_waves(points, omega, across, along, axis, rng, slow_too, count=14):
    """In a transversely isotropic incompressible body: waves polarised across fibre and way run by the modulus
    across + (along - across) cos^2 of the angle between; those polarised in the plane of both by the modulus along."""
    field = np.zeros((len(points), 3), complex)
    for d, a in zip(directions(rng, count), amplitudes(rng, count)):
        m = np.cross(axis, d)
        m /= np.linalg.norm(m)
        field += a * m * np.exp(-1j * wavenumber(omega, across + (along - across) * (axis @ d) ** 2) * (points @ d))[:, None]
        if slow_too:
            field += amplitudes(rng, 1)[0] * np.cross(d, m) * np.exp(-1j * wavenumber(omega, along) * (points @ d))[:, None]
    return field


def compression(points, omega, longitudinal, rng, count=5):
    """Gradients of potentials with k . k = density w^2 / M, which decay along one axis and oscillate along another."""
    field = np.zeros((len(points), 3), complex)
    k2 = DENSITY * omega ** 2 / longitudinal
    for d, a in zip(directions(rng, count), amplitudes(rng, count)):
        e = np.cross(d, directions(rng, 1)[0])
        e /= np.linalg.norm(e)
        decay = rng.uniform(1 / 120, 1 / 50)
        vector = decay * d + 1j * np.sqrt(decay ** 2 + k2) * e
        field += a / np.linalg.norm(vector) * vector * np.exp(points @ vector)[:, None]
    return field


def scattered(points, omega, outside, inside, centre, radius, ways):
    """Scalar waves along `ways` past a sphere of another modulus (Anderson 1950), one after the other: the field and modulus times
    its normal derivative are continuous."""
    k, q = wavenumber(omega, outside), wavenumber(omega, inside)
    n = np.arange(int(max(abs(k), abs(q)) * radius) + 14)
    h = lambda order, z, derivative=False: spherical_jn(order, z, derivative) - 1j * spherical_yn(order, z, derivative)
    j_out, j_in, h_out = spherical_jn(n, k * radius), spherical_jn(n, q * radius), h(n, k * radius)
    dj_out, dj_in, dh_out = (outside * k * spherical_jn(n, k * radius, True), inside * q * spherical_jn(n, q * radius, True),
                             outside * k * h(n, k * radius, True))
    turn = (2 * n + 1) * (-1j) ** n
    determinant = h_out * dj_in - dh_out * j_in
    reflected, taken = turn * (dj_out * j_in - j_out * dj_in) / determinant, turn * (dj_out * h_out - j_out * dh_out) / determinant
    away = points - centre
    r = np.maximum(np.linalg.norm(away, axis=1), 1e-6)
    within = r < radius
    radial = np.empty((len(n), len(r)), complex)
    for m in n:
        radial[m, ~within] = reflected[m] * h(m, k * r[~within])
        radial[m, within] = taken[m] * spherical_jn(m, q * r[within])
    for way in ways:
        cosine = np.clip(away @ way / r, -1, 1)
        field = np.where(within, 0, np.exp(-1j * k * (away @ way)))
        before, legendre = np.zeros_like(cosine), np.ones_like(cosine)
        for m in n:
            field = field + radial[m] * legendre
            before, legendre = legendre, ((2 * m + 1) * cosine * legendre - m * before) / (m + 1)
        yield field


def sphere_waves(points, omega, outside, inside, centre, radius, rng, count=4):
    ways, strengths = zip(*((directions(rng, count), amplitudes(rng, count)) for _ in range(3)))
    waves = scattered(points, omega, outside, inside, centre, radius, np.concatenate(ways))
    field = np.zeros((len(points), 3), complex)
    for k, (a, wave) in enumerate(zip(np.concatenate(strengths), waves)):
        field[:, k // count] += a * wave
    return field


def in_a_slice(shape, spacing, omega, modulus, rng, finer=4):
    """A slice of a body that is alike through all slices, shaken at its border across the slice: div(G grad u) + density w^2 u
    = 0 by finite volumes on a grid `finer` times finer. `modulus` of places (two columns) within 0 .. extent."""
    nx, ny = finer * (shape[0] - 1) + 1, finer * (shape[1] - 1) + 1
    h = spacing / finer
    number = np.arange(nx * ny).reshape(nx, ny)
    x, y = np.meshgrid(h * np.arange(nx), h * np.arange(ny), indexing="ij")
    centre = np.array([h * (nx - 1) / 2, h * (ny - 1) / 2])
    border = np.zeros((nx, ny), bool)
    border[[0, -1], :] = border[:, [0, -1]] = True
    rows, columns, values = [], [], []

    def couple(one, other, g):
        for a, b in ((one, other), (other, one)):
            rows.extend([a, a])
            columns.extend([b, a])
            values.extend([g / h ** 2, -g / h ** 2])

    couple(number[:-1].ravel(), number[1:].ravel(), modulus(np.c_[(x[:-1] + h / 2).ravel(), y[:-1].ravel()]))
    couple(number[:, :-1].ravel(), number[:, 1:].ravel(), modulus(np.c_[x[:, :-1].ravel(), (y[:, :-1] + h / 2).ravel()]))
    rows, columns, values = np.concatenate(rows), np.concatenate(columns), np.concatenate(values).astype(complex)
    matrix = coo_matrix((values, (rows, columns)), shape=(nx * ny, nx * ny)).tocsr()
    matrix.setdiag(matrix.diagonal() + DENSITY * omega ** 2)
    free, held = number[~border], number[border]
    k = wavenumber(omega, np.mean(modulus(centre[None])))
    shaken = np.zeros(nx * ny, complex)
    for angle, a in zip(rng.uniform(0, 2 * np.pi, 8), amplitudes(rng, 8)):
        way = np.array([np.cos(angle), np.sin(angle)])
        shaken += a * np.exp(-1j * k * ((np.c_[x.ravel(), y.ravel()] - centre) @ way))
    u = shaken.copy()
    u[free] = splu(matrix[free][:, free].tocsc()).solve(-(matrix[free][:, held] @ shaken[held]))
    return u.reshape(nx, ny)[::finer, ::finer]
