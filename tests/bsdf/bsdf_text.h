// BSDF files written by tests.
#pragma once

#include <functional>
#include <sstream>
#include <string>

#include "bsdf/angle_basis.h"
#include "common/disk_square.h"

namespace infra::test {

/// A file around the blocks of its layer. structure: IncidentDataStructure.
inline std::string window_element(const std::string& structure, const std::string& blocks,
                                  const std::string& bases = "", const std::string& material = "") {
    return "<?xml "
           "version=\"1.0\"?>\n<WindowElement>\n<FileType>BSDF</FileType>\n<Optical>\n<Layer>\n<Material>" +
           material + "</Material>\n<DataDefinition>\n<IncidentDataStructure>" + structure +
           "</IncidentDataStructure>\n" + bases + "</DataDefinition>\n" + blocks +
           "</Layer>\n</Optical>\n</WindowElement>\n";
}

/// One block; tags: the angle bases.
inline std::string scattering_block(const std::string& wavelength, const std::string& direction,
                                    const std::string& tags, const std::string& data) {
    return "<WavelengthData>\n<Wavelength unit=\"Integral\">" + wavelength +
           "</Wavelength>\n<WavelengthDataBlock>\n<WavelengthDataDirection>" + direction +
           "</WavelengthDataDirection>\n" + tags + "<ScatteringData>\n" + data +
           "</ScatteringData>\n</WavelengthDataBlock>\n</WavelengthData>\n";
}

inline const std::string quarter_tags =
    "<ColumnAngleBasis>LBNL/Klems Quarter</ColumnAngleBasis>\n<RowAngleBasis>LBNL/Klems "
    "Quarter</RowAngleBasis>\n";
inline const std::string tree_tags = "<AngleBasis>LBNL/Shirley-Chiu</AngleBasis>\n";

/// f of the points of the unit disk that light heads for and leaves to.
using DiskFunction = std::function<double(const Point2& heading, const Point2& out)>;

/// A lobe around the direction that light heads for (straight through, or the mirror's), over a constant.
inline DiskFunction disk_lobe(double constant, double peak, double width2) {
    return [=](const Point2& a, const Point2& b) {
        const double dx = a[0] - b[0], dy = a[1] - b[1];
        return constant + peak * std::exp(-(dx * dx + dy * dy) / width2);
    };
}

/// The values of a quarter basis, Columns.
inline std::string quarter_values(const DiskFunction& f) {
    const AngleBasis& basis = *standard_angle_basis("LBNL/Klems Quarter");
    std::ostringstream text;
    for (int o = 0; o < basis.patch_count(); ++o) {
        for (int i = 0; i < basis.patch_count(); ++i) {
            const Vec3 a = basis.direction(i, 0.5, 0.5), b = basis.direction(o, 0.5, 0.5);
            text << f({a.x, a.y}, {b.x, b.y}) << ", ";
        }
        text << '\n';
    }
    return text.str();
}

/// A tree of rank 3 or 4 that divides down to `levels`, its last two grids of 2 along each side.
inline std::string tree_values(int rank, const DiskFunction& f, int levels) {
    std::ostringstream text;
    const std::function<void(const std::array<double, 4>&, double, int)> write =
        [&](const std::array<double, 4>& corner, double width, int level) {
            text << '{';
            for (unsigned n = 0; n < 1u << rank; ++n) {
                std::array<double, 4> at = corner;
                const bool grid = level == 1;
                for (int i = 0; i < rank; ++i) {
                    const int bit = grid ? rank - 1 - i : i;  // the first coordinate of a grid varies slowest
                    if (n >> bit & 1) at[static_cast<std::size_t>(i)] += 0.5 * width;
                }
                if (!grid) {
                    write(at, 0.5 * width, level - 1);
                    continue;
                }
                for (double& c : at) c += 0.25 * width;
                const Point2 heading =
                    rank == 3 ? Point2{std::max(0.0, 1 - 2 * at[0]), 0} : disk_of_square({at[0], at[1]});
                const std::size_t o = rank == 3 ? 1 : 2;
                text << f(heading, disk_of_square({at[o], at[o + 1]})) << ' ';
            }
            text << "}\n";
        };
    write({0, 0, 0, 0}, 1.0, levels);
    return text.str();
}

inline std::string matrix_file(const DiskFunction& reflection, const DiskFunction& transmission) {
    return window_element(
        "Columns",
        scattering_block("Visible", "Transmission Back", quarter_tags, quarter_values(transmission)) +
            scattering_block("Visible", "Reflection Back", quarter_tags, quarter_values(reflection)));
}

inline std::string tree_file(int rank, const DiskFunction& reflection, const DiskFunction& transmission) {
    return window_element(
        rank == 3 ? "TensorTree3" : "TensorTree4",
        scattering_block("Visible", "Transmission Back", tree_tags, tree_values(rank, transmission, 3)) +
            scattering_block("Visible", "Reflection Back", tree_tags, tree_values(rank, reflection, 3)));
}

}  // namespace infra::test
