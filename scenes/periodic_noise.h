// Noise that repeats: the stuff of the procedural textures. From an integer hash and polynomials alone, so it
// has the same bits everywhere.
#pragma once

#include <cstdint>

namespace crevice {

// In [0,1], 24 bits: unrelated from one (x, y, seed) to the next.
double hashed(int x, int y, std::uint32_t seed);

// Gradient noise (Perlin 2002) of lattice spacing 1 that repeats every `period` > 0 in x and in y: in [-1,1],
// 0 at lattice points, smooth to the second derivative. |x|, |y| < 2^30.
double periodic_noise(double x, double y, int period, std::uint32_t seed);

// Octaves of it, each of twice the frequency and half the height: about [-1,1]. `period` is the first one's.
double fractal_noise(double x, double y, int period, int octaves, std::uint32_t seed);

// One scattered point a lattice cell (Worley 1996), repeating every `period` cells.
struct NearestCell {
    double distance;         // to the nearest point, cells
    double border;           // to the line half-way between the two nearest, cells; 0 on it
    std::uint32_t identity;  // of the nearest, for hashed()
};
NearestCell nearest_cell(double x, double y, int period, std::uint32_t seed);

}  // namespace crevice
