// Orderly end on SIGINT and SIGTERM: the first signal asks the program to stop; the second, or the lack
// of an answer, ends it.
#pragma once

namespace infra {

/// Whether a signal has asked the program to stop. Cheap enough to ask for every tile or scanline.
bool interrupted();

/// throws Error "interrupted" (exit status 3, as RADIANCE's for a signal) once interrupted() is true.
void throw_if_interrupted();

/// While it lives, SIGINT, SIGTERM and SIGHUP set interrupted(). A second one, or a guard that still lives
/// some seconds after the first (a pixel may take hours), removes the registered files and ends the program
/// by the signal. Signals that were ignored stay so. Uses SIGALRM. One at a time; programs make it in their
/// body.
class InterruptGuard {
  public:
    /// seconds: given to the program to answer; whoever has work to keep needs more.
    explicit InterruptGuard(unsigned seconds = 2);
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    ~InterruptGuard();
};

/// The program has seen the signal and is ending in good order: no time limit from here on.
void ending_in_order();

/// Registers a file for removal when a signal ends the program, until forgotten. The path is copied.
/// Thread-safe.
void remove_on_interrupt(const char* path);
void forget_on_interrupt(const char* path);

}  // namespace infra
