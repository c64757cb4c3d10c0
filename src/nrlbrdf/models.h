// Analytic BRDFs tabulated on a grid, for tests and for generators of example tables, and the .brdf writer.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "nrlbrdf/table.h"
#include "nrlbrdf/wavelength_band.h"

namespace infra {

/// Nodes of a table; the defaults are the shape the format was first used with.
struct GridCounts {
    int theta_i = 20;
    int phi = 20;
    int theta_r = 40;
};

/// f [1/sr] at angles in radians: theta in 0..pi/2, phi in 0..2 pi, mirror direction at phi = pi.
using BrdfFunction = std::function<double(double theta_i, double phi, double theta_r)>;

/// The function at every node. Reciprocal only as far as the function is and theta_i and theta_r have equal
/// counts.
BrdfGrid tabulate(const BrdfFunction& f, const GridCounts& counts = {});

/// f = reflectance / pi.
BrdfFunction lambertian(double reflectance);

/// Lambertian plus a lobe Gaussian in the slope tan(delta) of the half vector, reciprocal and bounded:
///   f = diffuse/pi + specular exp(-tan^2 delta / alpha^2) / (4 pi alpha^2)
/// Its reflectance is about diffuse + specular cos^2(theta), for small alpha.
///   alpha   RMS slope, > 0
///   source  Ward, SIGGRAPH 1992, eq. 5a without its 1/sqrt(cos cos), which has no bound at grazing angles
BrdfFunction gaussian_lobe(double diffuse, double specular, double alpha);

/// Lambertian plus a cosine power around the mirror direction, reciprocal:
///   f = diffuse/pi + specular (n + 2) / (2 pi) max(0, cos gamma)^n, gamma between wi and the mirrored wo
///   source  Lafortune and Willems, "Using the Modified Phong Reflectance Model", CW 197 (1994), eq. 6
BrdfFunction phong_lobe(double diffuse, double specular, double exponent);

/// Writes a grid (phi_origin 0 or pi) as a .brdf file with the largest D that fits, one number of nine digits
/// for each value, so that reading it gives the same values bit for bit. `comment`, if any, becomes its first
/// lines; `band` the wavelengths it states. The file appears whole or not at all.
///   throws  infra::Error when the file cannot be written
void write_table(const std::string& path, const BrdfGrid& grid, std::string_view comment = {},
                 const std::optional<WavelengthBand>& band = {});

}  // namespace infra
