// What rpict leaves of a picture when a signal ends it: everything that it has traced so far.
//
// The file begins as a RADIANCE picture does, with a header that has the view and a resolution line, so that
// getinfo and people can read what it is; its FORMAT is one that no other program takes. Then follow the
// values, as raw floats of this machine, of all pixels traced. Pixels between them are not kept: they follow
// from these.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "common/views/view.h"
#include "rt/programs/pixel_tracer.h"

namespace infra {

struct PartialFrame {
    View view;  ///< set up, to the last bit
    double pixel_aspect = 1;
    int width = 0, height = 0;
    /// Its rows at the top that were taken over from an unfinished picture, in the channels of the output.
    Picture finished_rows;
    Frame frame;              ///< the rest; without `traced`, nothing is known
    std::string fingerprint;  ///< of all that the picture depends on; empty: not known
};

/// "name.partial": where it is kept for a picture of this name.
std::string partial_name(const std::string& output);

/// Writes it, with these lines in the header. Threads may trace pixels of the frame meanwhile; those that are
/// whole are written.
///   throws  Error when the device is full
void write_partial(std::FILE* file, const PartialFrame& partial, const std::vector<std::string>& lines);
/// The same, atomically.
void write_partial(const std::string& path, const PartialFrame& partial,
                   const std::vector<std::string>& lines);

/// Whether a file begins as one.
bool is_partial(const std::string& path);

/// The fingerprint in such a file, "" where there is none. throws Error if it cannot be read
std::string partial_fingerprint(const std::string& path);

/// channels  of the picture to be, which bounds the memory that a damaged file can ask for
/// throws    Error for a file that is missing, damaged, from a machine that stores numbers otherwise, or of
///           other channels
PartialFrame read_partial(const std::string& path, const Channels& channels);

}  // namespace infra
