// The camera: RADIANCE's six view types with shift, lift and clipping planes.
// Image coordinates run from 0,0 at the lower left corner to 1,1 at the upper right one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/vec.h"

namespace infra {

enum class ViewType : char {
    perspective = 'v',
    parallel = 'l',
    cylindrical = 'c',
    hemispherical = 'h',
    angular = 'a',
    planisphere = 's'
};

/// "perspective" for 'v' and so on.
const char* view_type_name(ViewType type);
/// The type of a letter, or nothing.
std::optional<ViewType> view_type_of(char letter);

/// Fill in the first group, then call set_up_view, then trace with view_ray.
struct View {
    ViewType type = ViewType::perspective;
    Vec3 point{0, 0, 0};
    Vec3 direction{0, 1, 0};  ///< unit length after set_up_view
    Vec3 up{0, 0, 1};         ///< unit length after set_up_view
    double distance = 1;      ///< length of the direction as given: the focal distance of -pd
    double horizontal = 45;   ///< degrees; scene units for a parallel view
    double vertical = 45;     ///< likewise
    double shift = 0;         ///< image widths that the centre moves to the right
    double lift = 0;          ///< image heights that it moves up
    double fore = 0;          ///< fore clipping distance, scene units
    double aft = 0;           ///< aft clipping distance; 0: none

    Vec3 image_x{};           ///< set by set_up_view: what one image width adds to the direction
    Vec3 image_y{};           ///< the same for one image height
    double image_width = 0;   ///< extent of the image plane at distance 1 (angle in radians for some types)
    double image_height = 0;  ///< likewise
};

/// Normalises the vectors and works out the image axes. Calling it again is harmless.
/// throws Error in RADIANCE's words ("illegal horizontal view size", "view up parallel to view direction",
/// ...)
void set_up_view(View& view);

/// The ray through image point (x, y): its origin (on the fore clipping surface), its unit direction, and how
/// far it may go from there (infinity without an aft plane). Returns false, leaving them alone, outside a
/// fisheye's image.
bool view_ray(const View& view, double x, double y, Vec3& origin, Vec3& direction, double& max_distance);

/// Where a point of the scene lands in the image: the inverse of view_ray.
struct ViewLocation {
    double x = 0, y = 0;   ///< image coordinates, also outside 0..1
    double distance = 0;   ///< from the fore clipping surface along the ray; negative behind it
    bool behind = false;   ///< behind the fore plane
    bool outside = false;  ///< not within the image
    bool beyond = false;   ///< past the aft plane
};
/// Nothing where no image point exists (the point abreast of a perspective view, the pole of a panorama).
std::optional<ViewLocation> view_locate(const View& view, const Vec3& point);

/// Height over width of the image, after set_up_view.
double view_aspect(const View& view);

/// Fits a resolution to a view: with pixel_aspect > 0 one of x and y shrinks so that height/width agrees with
/// the view; with 0 they stay and pixel_aspect is worked out. Never less than 1 pixel.
void fit_resolution(double view_aspect, double& pixel_aspect, int& x_resolution, int& y_resolution);

/// Crops to the part of the image between (x0,y0) and (x1,y1), in either order; throws Error as set_up_view.
void crop_view(View& view, double x0, double y0, double x1, double y1);

/// All parameters as options: " -vtv -vp 0 0 0 -vd 0 1 0 ... -vl 0", with a blank in front. "VIEW=" and this
/// is the header line of a picture.
std::string format_view(const View& view);

/// Reads the view options in a text, passing over anything else. Returns how many there were.
int parse_view(std::string_view text, View& view);

/// The first view option in a text that parse_view passes over, for it is misspelt or lacks numbers; "" if
/// none. A word that is no view option at all is none.
std::string bad_view_word(std::string_view text);

/// Whether a header line holds a view: "VIEW= ..." or the command line of a program that takes views, such as
/// rpict.
bool is_view_line(std::string_view line);

/// Reads the view of a picture or view file into `view` ("-" is the standard input): each view line changes
/// what it mentions. throws Error when the file cannot be read or holds no view.
void read_view_file(const std::string& path, View& view);

}  // namespace infra
