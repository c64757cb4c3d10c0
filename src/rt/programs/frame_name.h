// Names of the files of a sequence of pictures: a number for each.
#pragma once

#include <string>

namespace infra {

/// Whether a name has a place for the number of the picture, as printf writes whole numbers: "%d", "%03d".
bool has_frame_number(const std::string& pattern);

/// The name of one picture's file: its number in that place, "%%" as one '%', everything else as it is.
std::string frame_name(const std::string& pattern, int number);

/// A file that says by being there that its picture is taken: made empty, and gone again unless kept. Several
/// programs may so share the work on one sequence.
class FrameClaim {
  public:
    /// throws Error when the file can be neither found nor made
    explicit FrameClaim(const std::string& path);
    FrameClaim(const FrameClaim&) = delete;
    FrameClaim& operator=(const FrameClaim&) = delete;
    ~FrameClaim();

    /// Whether this claim is the one that made the file, or has taken it over.
    bool granted() const { return granted_; }

    /// Takes over a claim whose program has ended: the file is still empty, and nobody has locked it.
    /// Returns granted().
    bool take_over();
    /// Tells take_over() of other programs that this one lives, where the file system knows locks.
    void lock();

    /// The file holds the picture now.
    void keep() { kept_ = true; }

  private:
    std::string path_;
    bool granted_ = false;
    bool kept_ = false;
    int file_ = -1;  // while it is locked
};

}  // namespace infra
