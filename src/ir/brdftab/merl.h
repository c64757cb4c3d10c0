// Measured isotropic BRDFs in the binary format of the MERL database: three int32 (90, 90, 180: theta_h,
// theta_d, phi_d), then all red values, all green, all blue, as little-endian doubles with phi_d fastest.
// Values times 1/1500, 1.15/1500, 1.66/1500 are f [1/sr]; negative ones were not measured.
//   source  Matusik, Pfister, Brand and McMillan, "A Data-Driven Reflectance Model", SIGGRAPH 2003, and the
//           database's description of its files
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace infra::ir {

enum class MerlChannel { red, green, blue, mean };

/// Immutable. Values stand for the centres of their cells; between them f is linear in (sqrt theta_h,
/// theta_d, phi_d), so that it never leaves their range. phi_d and phi_d + pi are one by reciprocity, phi_d
/// and -phi_d because the surface has no direction of its own: of these the mean is taken.
class MerlTable {
  public:
    static constexpr int theta_h_count = 90, theta_d_count = 90, phi_d_count = 180;

    /// Takes the bytes of a file; `name` stands for it in errors.
    ///   throws  Error for other counts, a wrong size, a value not finite, a channel without a measurement
    MerlTable(std::string_view bytes, MerlChannel channel, const std::string& name);

    /// f [1/sr], angles in radians.
    double operator()(double theta_i, double phi, double theta_r) const;

    /// Cells not measured, which got the value of the nearest measured one in theta_d at the same theta_h and
    /// phi_d, else in theta_h.
    std::size_t filled() const { return filled_; }

  private:
    static constexpr std::size_t cell(int h, int d, int p) {
        return (static_cast<std::size_t>(h) * theta_d_count + static_cast<std::size_t>(d)) * phi_d_count +
               static_cast<std::size_t>(p);
    }
    void fill(const std::string& name);
    void average_sides();

    std::vector<float> values_;
    std::size_t filled_ = 0;
};

}  // namespace infra::ir
