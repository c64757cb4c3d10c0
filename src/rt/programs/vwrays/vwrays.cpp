#include "rt/programs/vwrays/vwrays.h"

#include <cmath>
#include <cstdio>

#include "common/error.h"
#include "common/format.h"
#include "common/random.h"
#include "common/views/lens.h"
#include "rt/programs/vwrays/depth_file.h"
#include "rt/programs/vwrays/settings.h"

namespace infra {
namespace {

struct ViewRay {
    Vec3 origin{0};
    Vec3 direction{0};
};

class RayPrinter {
  public:
    explicit RayPrinter(const VwraysSettings& settings) : s_(settings) {
        if (!s_.depth_file.empty()) depths_.emplace(s_.depth_file, s_.order);
    }

    void print_picture() {
        for (int scan = 0; scan < s_.order.scanline_count(); ++scan)
            for (int step = 0; step < s_.order.scanline_length(); ++step) {
                const PixelPlace place = s_.order.place(scan, step);
                print_pixel(place.column + 0.5, s_.order.height - place.row - 0.5);
            }
    }

    /// Pixels as they are asked for, counted from the lower left corner.
    void print_asked() {
        double x, y;
        int numbers;
        while ((numbers = std::scanf("%lf %lf", &x, &y)) == 2) print_pixel(x + 0.5, y + 0.5);
        if (numbers != EOF || !std::feof(stdin))
            throw Error(Location{"standard input"}, "expected pairs of numbers, x and y of a pixel");
    }

  private:
    /// x, y: in pixels, from the lower left corner of the picture.
    void print_pixel(double x, double y) {
        const float depth = depths_ ? depths_->at(x, y) : 0.0f;
        for (int i = 0; i < s_.repeats; ++i) print(ray(x, y, depth));
        if (s_.unbuffered) std::fflush(stdout);
    }

    double jitter() { return s_.pixel_jitter > 0 ? s_.pixel_jitter * (0.5 - random_.uniform()) : 0.0; }

    // All zero where the view has no ray.
    ViewRay ray(double x, double y, float depth) {
        ViewRay result;
        double reach = 0;
        const double across = (x + jitter()) / s_.order.width, up = (y + jitter()) / s_.order.height;
        if (!view_ray(s_.view, across, up, result.origin, result.direction, reach)) return {};
        if (s_.lens_diameter > 0 && !move_on_lens(s_.view, s_.lens_diameter,
                                                  {random_.uniform(), random_.uniform(), random_.uniform()},
                                                  result.origin, result.direction))
            return {};
        if (depths_) {
            result.origin += result.direction * static_cast<double>(depth);
            result.direction = -result.direction;
            // Light rays of a whole picture are as long as the way to the viewer.
            if (!s_.pixels_from_input) result.direction *= static_cast<double>(depth);
        } else if (std::isfinite(reach)) {
            result.direction *= reach;
        }
        return result;
    }

    template <class Number>
    void print_raw(const ViewRay& ray) {
        Number values[6];
        for (int i = 0; i < 3; ++i) {
            values[i] = static_cast<Number>(ray.origin[i]);
            values[3 + i] = static_cast<Number>(ray.direction[i]);
        }
        std::fwrite(values, sizeof values, 1, stdout);
    }

    void print(const ViewRay& ray) {
        if (s_.format == NumberFormat::floats) {
            print_raw<float>(ray);
        } else if (s_.format == NumberFormat::doubles) {
            print_raw<double>(ray);
        } else {
            const Vec3 &o = ray.origin, &d = ray.direction;
            std::printf("%.5e %.5e %.5e %.5e %.5e %.5e\n", o.x, o.y, o.z, d.x, d.y, d.z);
        }
    }

    const VwraysSettings& s_;
    std::optional<DepthFile> depths_;
    RandomStream random_{0, 0};
};

}  // namespace

int vwrays(int argc, char** argv) {
    const auto settings = read_vwrays_settings(argc, argv);
    if (!settings) return 0;
    if (settings->only_dimensions) {
        std::printf("-x %d -y %d%s\n", settings->order.width, settings->order.height,
                    settings->view.aft > 1e-6 ? " -ld+" : "");
        return 0;
    }
    RayPrinter printer(*settings);
    if (settings->pixels_from_input)
        printer.print_asked();
    else
        printer.print_picture();
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        throw Error(Location{"standard output"}, "cannot write rays");
    return 0;
}

}  // namespace infra
